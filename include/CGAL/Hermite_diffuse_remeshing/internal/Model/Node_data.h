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

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace CGAL {
namespace Hermite_diffuse_remeshing {
namespace internal {

// A cubic has ten coefficients; few neighbours on one side determine it badly.
enum Soft_degree : unsigned char { CUBIC, DAMPED_CUBIC, QUADRATIC };

// What a fit needs to know of a node, in the 64 bytes of a cache line.
struct Node
{
  Vector position = Vector::Zero();
  Vector normal = Vector::Zero();        // unit, or zero: none
  double size = 0.;                      // mean distance to its ring
  float combined_share = 0.f;            // in [0,1]: of the weight of combined equations, see `Normal_fitter`
  Soft_degree soft_degree = CUBIC;
  bool is_singular = false;              // apex: a position only, no normal, no ring
  bool is_near_apex = false;             // singular, or next to a singular node
  bool is_tangent = false;               // on a line where two pieces meet tangentially, see `Tangent_nodes`

  bool has_normal() const { return normal != Vector::Zero(); }

  // Relative to the size, and of unit normals: coordinates are rounded to this where a body is ten thousand times as large.
  // Fits reproduce their nodes no better.
  static constexpr double rounding_of_planes = 1e-12;
  // Is p in the plane through the node with a normal?
  bool sees_in_plane(const Vector& p, const Vector& plane_normal) const
  {
    return std::abs((p - position).dot(plane_normal)) <= rounding_of_planes * size;
  }

  // Of the terms of order three near the node; a large one turns a cubic into a quadratic. Because the
  // ridge is blended over the face, the degree changes continuously. Tangent nodes at both ends of an edge may be alone
  // on it, and determine no terms across it: a fit that leaves these to rounding would not be believed there.
  double cubic_ridge() const
  {
    constexpr double ridge[] = {1e-9, 1e-2, 1.}, ridge_of_tangent_node = 3e-5;
    return is_tangent ? (std::max)(ridge[soft_degree], ridge_of_tangent_node) : ridge[soft_degree];
  }
};

// An apex has no normal, and nothing is smooth near it: measured on cones, cubics there are farther from
// the surface by a third.
inline Soft_degree soft_degree(const bool is_singular, const bool is_open, const int ring_size)
{
  if(is_singular || ring_size <= 3)
    return QUADRATIC;
  return is_open && ring_size == 4 ? DAMPED_CUBIC : CUBIC;
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
    node.soft_degree = soft_degree(node.is_singular, cut_mesh.is_open(i), ring.size());
  }
  for(int i = 0; i < cut_mesh.number_of_nodes(); ++i)
    if(nodes[i].is_singular)
    {
      nodes[i].is_near_apex = true;
      for(const int j : cut_mesh.ring(i))
        nodes[j].is_near_apex = true;
    }
  return nodes;
}

// tangent nodes with those of their neighbours that are on the line, sorted; see `Tangent_nodes`
typedef std::vector<std::pair<int, int> > Neighbors_on_lines;

// Calls `visit(corner, u, v)` for the corners of a node, with the sides that begin there.
template <typename Visit>
void visit_fan(const Indexed_triangles& surface, const Cut_mesh& cut_mesh, const int node, const Visit& visit)
{
  const Vector& p = surface.points[cut_mesh.vertex(node)];
  for(const int c : cut_mesh.corners(node))
    visit(c, Vector(surface.point(c / 3, next(c % 3)) - p), Vector(surface.point(c / 3, previous(c % 3)) - p));
}

// of u x v, for two sides that begin at a node:
// N. Max, Weights for computing vertex normals from facet normals, JGT 4(2), 1999
inline double max_weight(const Vector& u, const Vector& v)
{
  const double product = u.squaredNorm() * v.squaredNorm();
  return product > 0. ? 1. / product : 0.;
}

// from 0 at `none` to 1 at `all`
inline double ramp(const double value, const double none, const double all)
{
  return (std::min)(1., (std::max)(0., (value - none) / (all - none)));
}

// How much a node tells of another place, by the cosine of the angle between the normals. Around the tip of
// a cone a few nodes turn by the whole circle, and no polynomial over all of them is near the surface; those
// of the same side, farther from the tip, tell more. Measured on cones of half angles of 22 to 59
// degrees, normals next to the tip are twice as accurate as without, those of exponent 4 lie in between.
inline double agreement(const double cosine)
{
  const double c2 = cosine > 0. ? cosine * cosine : 0.;
  return c2 * c2 * c2 * c2;
}

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_MODEL_NODE_DATA_H
