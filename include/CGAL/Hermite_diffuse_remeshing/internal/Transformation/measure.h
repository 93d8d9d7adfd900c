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
#include <CGAL/Hermite_diffuse_remeshing/internal/Transformation/mesh_statistics.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <vector>

namespace CGAL {
namespace Hermite_diffuse_remeshing {
namespace internal {

// Qualities and sizes in one pass, which the request of a stop has to wait for. Returns the faces of low quality.
template <typename UserMesh, typename TriangleMesh>
std::vector<typename Working_mesh<UserMesh>::face_descriptor>
measure_faces(const Working_mesh<UserMesh>& mesh, Remeshing_report<TriangleMesh>& report)
{
  typedef typename Working_mesh<UserMesh>::face_descriptor face_descriptor;
  const auto& tm = mesh.tmesh();
  std::vector<face_descriptor> result;
  double sum = 0.;
  std::size_t number_of_edges = 0, number_within_2 = 0;
  report.number_of_faces = report.number_of_vertices = 0;
  report.smallest_quality = 1.;
  std::size_t number_of_remeshed = 0;
  for(const face_descriptor f : faces(tm))
  {
    ++report.number_of_faces;
    if(!mesh.is_remeshed(f))
      continue;
    ++number_of_remeshed;
    const Numbered_triangle t = mesh.triangle(f);
    const double q = quality(t.points[0], t.points[1], t.points[2]);
    report.smallest_quality = (std::min)(report.smallest_quality, q);
    sum += q;
    if(q < Low_quality_face<face_descriptor>::low_quality)
      result.push_back(f);
    for(const auto h : CGAL::halfedges_around_face(halfedge(f, tm), tm))
    {
      // an edge between two faces is counted at one of them
      if(!mesh.is_border_or_outside(opposite(h, tm)) && mesh.index(source(h, tm)) > mesh.index(target(h, tm)))
        continue;
      ++number_of_edges;
      number_within_2 += std::abs(std::log2(mesh.relative_length(h))) <= 1.;
    }
  }
  report.number_of_vertices = std::distance(vertices(tm).begin(), vertices(tm).end());
  report.mean_quality = sum / double((std::max)(std::size_t(1), number_of_remeshed));
  report.size_conformity = number_of_edges > 0 ? double(number_within_2) / double(number_of_edges) : 1.;
  return result;
}

template <typename UserMesh, typename TriangleMesh>
void fill_report(const Working_mesh<UserMesh>& mesh, const Deviations<UserMesh>& deviations,
                 Remeshing_report<TriangleMesh>& report)
{
  report.largest_deviation = deviations.largest;
  report.mean_deviation = deviations.mean;
  report.distance_of_model_from_input = deviations.model_distance;
  for(int i = 0; i < 3; ++i)
    report.point_of_largest_deviation[i] = deviations.point_of_largest[i];
  report.is_maximum_deviation_met = !std::isfinite(report.maximum_deviation)
                                 || (report.is_deviation_measured && deviations.largest <= report.maximum_deviation);
  for(const auto& entry : deviations.faces)
    if(entry.deviation > report.maximum_deviation)
    {
      report.faces_above_maximum_deviation.push_back(entry.face);
      report.deviation_obstacles.push_back(entry.obstacle);
    }

  report.number_of_splits = mesh.counts().splits;
  report.number_of_collapses = mesh.counts().collapses;
  report.number_of_flips = mesh.counts().flips;
  report.number_of_vertex_removals = mesh.counts().vertex_removals;
  report.number_of_relocations = mesh.counts().relocations;
}

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_MEASURE_H
