// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_MODEL_RISES_H
#define CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_MODEL_RISES_H

#include <CGAL/Hermite_diffuse_remeshing/internal/Model/Flat_regions.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Model/Node_data.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace CGAL {
namespace Hermite_diffuse_remeshing {
namespace internal {

// How far the surface turns away from a node's tangent plane over its edges, and over the flat regions of its facets: the
// farthest, and what is usual.
struct Rises
{
  double largest = 0., usual = 0.;
};

inline Rises find_rises(const Indexed_triangles& surface, const Cut_mesh& cut_mesh, const std::vector<Node>& nodes,
                        const Flat_regions& regions, const int i)
{
  Rises result;
  double curvature = 0., sum = 0.;
  for(const int j : cut_mesh.ring(i))
  {
    const Vector d = nodes[j].position - nodes[i].position;
    const double squared_length = d.squaredNorm(), rise = std::abs(nodes[i].normal.dot(d));
    if(!(squared_length > 0.))
      return Rises();
    result.largest = (std::max)(result.largest, rise);
    curvature = (std::max)(curvature, rise / squared_length);
    sum += 1. / squared_length;
  }
  result.usual = curvature * cut_mesh.ring(i).size() / sum;
  for(const int c : cut_mesh.corners(i))
  {
    const Vector normal = surface.area_vector(c / 3).stableNormalized();
    const double extent = std::sqrt(regions.area(c / 3, nodes[i].size) / 2.);
    result.largest = (std::max)(result.largest, extent * nodes[i].normal.cross(normal).norm());
  }
  return result;
}

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_MODEL_RISES_H
