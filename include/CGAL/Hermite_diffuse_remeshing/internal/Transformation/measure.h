// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_MEASURE_H
#define CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_MEASURE_H

#include <CGAL/Hermite_diffuse_remeshing/Remeshing_report.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Transformation/Deviation_meter.h>

#include <algorithm>
#include <cstddef>
#include <iterator>

namespace CGAL {
namespace Hermite_diffuse_remeshing {
namespace internal {

struct Quality_statistics
{
  double smallest = 1., mean = 0.;
};

template <typename IsSelected>
Quality_statistics measure_quality(const Indexed_triangles& triangles, const IsSelected& is_selected)
{
  Quality_statistics result;
  std::size_t number = 0;
  for(int f = 0; f < triangles.number_of_faces(); ++f)
  {
    if(!is_selected(f))
      continue;
    const double q = quality(triangles.point(f, 0), triangles.point(f, 1), triangles.point(f, 2));
    result.smallest = (std::min)(result.smallest, q);
    result.mean += q;
    ++number;
  }
  result.mean /= (std::max)(std::size_t(1), number);
  return result;
}

template <typename UserMesh>
Quality_statistics measure_quality(const Working_mesh<UserMesh>& mesh)
{
  Quality_statistics result;
  std::size_t number = 0;
  for(const auto f : faces(mesh.tmesh()))
  {
    if(!mesh.is_remeshed(f))
      continue;
    const auto h = halfedge(f, mesh.tmesh());
    const double q = quality(mesh.point(source(h, mesh.tmesh())), mesh.point(target(h, mesh.tmesh())),
                             mesh.point(target(next(h, mesh.tmesh()), mesh.tmesh())));
    result.smallest = (std::min)(result.smallest, q);
    result.mean += q;
    ++number;
  }
  result.mean /= (std::max)(std::size_t(1), number);
  return result;
}

// part of the edges with a length between half and twice their size
template <typename UserMesh>
double measure_size_conformity(const Working_mesh<UserMesh>& mesh)
{
  std::size_t number = 0, conforming = 0;
  for(const auto e : edges(mesh.tmesh()))
    if(mesh.is_inside(e))
    {
      const double length = mesh.relative_length(halfedge(e, mesh.tmesh()));
      ++number;
      conforming += length >= 0.5 && length <= 2.;
    }
  return double(conforming) / (std::max)(std::size_t(1), number);
}

template <typename UserMesh, typename TriangleMesh>
void fill_report(const Working_mesh<UserMesh>& mesh, const Deviations<UserMesh>& deviations,
                 Remeshing_report<TriangleMesh>& report)
{
  report.number_of_faces = std::distance(faces(mesh.tmesh()).begin(), faces(mesh.tmesh()).end());
  report.number_of_vertices = std::distance(vertices(mesh.tmesh()).begin(), vertices(mesh.tmesh()).end());
  const Quality_statistics quality = measure_quality(mesh);
  report.smallest_quality = quality.smallest;
  report.mean_quality = quality.mean;
  report.size_conformity = measure_size_conformity(mesh);

  report.largest_deviation = deviations.largest;
  report.mean_deviation = deviations.mean;
  for(int i = 0; i < 3; ++i)
    report.point_of_largest_deviation[i] = deviations.point_of_largest[i];
  report.is_maximum_deviation_met = report.is_deviation_measured && deviations.largest <= report.maximum_deviation;
  for(const auto& entry : deviations.faces)
    if(entry.deviation > report.maximum_deviation)
    {
      report.faces_above_maximum_deviation.push_back(entry.face);
      report.deviation_obstacles.push_back(entry.obstacle);
    }

  report.number_of_splits = mesh.counts().splits;
  report.number_of_collapses = mesh.counts().collapses;
  report.number_of_flips = mesh.counts().flips;
  report.number_of_relocations = mesh.counts().relocations;
}

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_MEASURE_H
