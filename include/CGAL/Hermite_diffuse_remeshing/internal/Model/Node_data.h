// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_MODEL_NODE_DATA_H
#define CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_MODEL_NODE_DATA_H

#include <CGAL/Hermite_diffuse_remeshing/internal/Classification/classify_vertices.h>

#include <vector>

namespace CGAL {
namespace Hermite_diffuse_remeshing {
namespace internal {

// What a fit needs to know of a node.
struct Node
{
  Vector position = Vector::Zero();
  Vector normal = Vector::Zero();        // unit, or zero: none
  double size = 0.;                      // mean distance to its ring
  double cubic_ridge = 0.;               // soft degree, see `soft_degree_ridge()`
  bool is_singular = false;              // apex: a position only, no normal, no ring

  bool has_normal() const { return normal != Vector::Zero(); }
};

// Ridge on the terms of order three near a node. A cubic has ten coefficients; few neighbours on
// one side determine it badly, and a large ridge turns it into a quadratic. So does an apex, which
// has no normal and near which nothing is smooth: measured on cones, cubics there are farther from
// the surface by a third. Because the ridge is blended over the face, the degree changes continuously.
inline double soft_degree_ridge(const bool is_singular, const bool is_open, const int ring_size)
{
  constexpr double none = 1e-9, some = 1e-2, quadratic = 1.;
  if(is_singular || ring_size <= 3)
    return quadratic;
  return is_open && ring_size == 4 ? some : none;
}

inline std::vector<Node> make_nodes(const Indexed_triangles& surface,
                                    const Cut_mesh& cut_mesh,
                                    const std::vector<Vertex_class>& vertex_classes)
{
  std::vector<Node> nodes(cut_mesh.number_of_nodes());
  for(int i = 0; i < cut_mesh.number_of_nodes(); ++i)
  {
    Node& node = nodes[i];
    node.position = surface.points[cut_mesh.vertex(i)];
    node.is_singular = vertex_classes[cut_mesh.vertex(i)] == APEX_VERTEX;
    const Index_range ring = cut_mesh.ring(i);
    for(const int j : ring)
      node.size += (surface.points[cut_mesh.vertex(j)] - node.position).norm();
    node.size /= ring.size();
    // all its neighbours coincide with it: there is no length to scale a fit with
    node.is_singular = node.is_singular || !(node.size > 0.);
    node.cubic_ridge = soft_degree_ridge(node.is_singular, cut_mesh.is_open(i), ring.size());
  }
  return nodes;
}

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_MODEL_NODE_DATA_H
