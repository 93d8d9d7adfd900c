// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_MODEL_END_TANGENTS_H
#define CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_MODEL_END_TANGENTS_H

#include <CGAL/Hermite_diffuse_remeshing/internal/Curves/chain_feature_edges.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Model/Node_data.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Hermite_diffuse_remeshing {
namespace internal {

// The unit tangents of the two feature curves that end at a node, between which its faces are.
struct End_tangents
{
  int node;
  std::array<Vector, 2> tangents;
  std::array<bool, 2> is_arc;                 // or a straight line
};

// At all corners between two curves one of which at least ends as an arc
inline std::vector<End_tangents> find_end_tangents(const Edge_table& edges, const Cut_mesh& cut_mesh,
                                                   const Feature_curves& curves)
{
  struct End { int node, curve; bool is_last; };
  std::vector<End> ends;
  const auto add = [&](const int vertex, const int edge, const int curve, const bool is_last)
  {
    for(int i = 0; i < edges.number_of_sides(edge); ++i)
    {
      const Face_side& side = edges.side(edge, i);
      for(const int corner : {side.side, next(side.side)})
        if(cut_mesh.vertex(cut_mesh.node(side.face, corner)) == vertex)
          ends.push_back({cut_mesh.node(side.face, corner), curve, is_last});
    }
  };
  for(std::size_t i = 0; i < curves.curves.size(); ++i)
  {
    const Feature_curve& curve = curves.curves[i];
    add(curve.vertices.front(), curve.edges.front(), static_cast<int>(i), false);
    add(curve.vertices.back(), curve.edges.back(), static_cast<int>(i), true);
  }
  std::stable_sort(ends.begin(), ends.end(), [](const End& a, const End& b) { return a.node < b.node; });

  std::vector<End_tangents> result;
  for(std::size_t i = 1; i < ends.size(); ++i)
  {
    if(ends[i].node != ends[i-1].node)
      continue;
    End_tangents at_node;
    at_node.node = ends[i].node;
    for(const int k : {0, 1})
    {
      const Feature_spline& spline = curves.curves[ends[i-1+k].curve].spline;
      at_node.tangents[k] = spline.end_tangent(ends[i-1+k].is_last);
      at_node.is_arc[k] = !spline.is_straight_at_end(ends[i-1+k].is_last);
    }
    if(at_node.is_arc[0] || at_node.is_arc[1])
      result.push_back(at_node);
  }
  return result;
}

// At the end of a strip all facets are on one side: their mean normal is behind that of a surface that turns, by half a
// facet's turn. A curve that ends there is fitted to more than one edge, and its tangent is one of the surface; along
// the other curve that ends there the slope stays as it is, as it may be the one over a long facet.
inline void correct_normals_at_ends(const std::vector<End_tangents>& ends, std::vector<Vector>& normals)
{
  // sines of the angle between two curves: of what is thinner the mean normal is not known across
  constexpr double no_sine = 0.3, sure_sine = 0.5;
  for(const End_tangents& end : ends)
  {
    Vector& normal = normals[end.node];
    const Vector old_normal = normal;
    for(const int k : {0, 1})
    {
      const Vector across = old_normal.cross(end.tangents[1-k]);
      const double sine = across.dot(end.tangents[k]), share = ramp(std::abs(sine), no_sine, sure_sine);
      if(end.is_arc[k] && share > 0.)
        normal -= share * old_normal.dot(end.tangents[k]) / sine * across;
    }
    normal.normalize();
  }
}

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_MODEL_END_TANGENTS_H
