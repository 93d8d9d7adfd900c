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
#include <cstddef>
#include <iterator>

namespace CGAL {
namespace Hermite_diffuse_remeshing {
namespace internal {

template <typename UserMesh, typename TriangleMesh>
void fill_report(const Working_mesh<UserMesh>& mesh, const Deviations<UserMesh>& deviations,
                 Remeshing_report<TriangleMesh>& report)
{
  report.number_of_faces = std::distance(faces(mesh.tmesh()).begin(), faces(mesh.tmesh()).end());
  report.number_of_vertices = std::distance(vertices(mesh.tmesh()).begin(), vertices(mesh.tmesh()).end());
  const Quality_statistics quality = measure_quality(mesh);
  report.smallest_quality = quality.smallest;
  report.mean_quality = quality.mean;
  report.size_conformity = measure_sizes(mesh, [](const auto) { return true; }).within_2;

  report.largest_deviation = deviations.largest;
  report.mean_deviation = deviations.mean;
  report.distance_of_model_from_input = deviations.model_distance;
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
