// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_MODEL_INTERPOLATION_WEIGHTS_H
#define CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_MODEL_INTERPOLATION_WEIGHTS_H

#include <CGAL/Hermite_diffuse_remeshing/internal/Model/Node_data.h>

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace CGAL {
namespace Hermite_diffuse_remeshing {
namespace internal {

struct Node_weight
{
  int node;
  double weight;
};

// The nodes that influence a point; a face of valences 6 has 12.
typedef boost::container::small_vector<Node_weight, 32> Node_weights;

// w_i of the paper's figure 5: the shape functions of the face applied to 1 at a corner and 1/2 at
// the nodes that share an edge with it. w_i is in [0,1], and 1 at node i only.
inline void add_node_weight(Node_weights& weights, const int node, const double weight)
{
  for(Node_weight& w : weights)
    if(w.node == node)
    {
      w.weight += weight;
      return;
    }
  weights.push_back({node, weight});
}

// The corners are taken in the order of their nodes, not of the face: both faces of an edge then add
// up the same numbers in the same order, and what is evaluated on the edge is equal to the last bit.
inline void collect_node_weights(const Cut_mesh& cut_mesh, const std::vector<Node>& nodes,
                                 const Location& location, Node_weights& weights)
{
  weights.clear();
  std::array<Node_weight, 3> corners;
  for(int k = 0; k < 3; ++k)
    corners[k] = {cut_mesh.node(location.face, k), location.coordinates[k]};
  for(const int k : {0, 1, 0})
    if(corners[k + 1].node < corners[k].node)
      std::swap(corners[k], corners[k + 1]);

  for(const Node_weight& corner : corners)
    if(corner.weight > 0.)
      add_node_weight(weights, corner.node, corner.weight);
  for(const Node_weight& corner : corners)
    if(corner.weight > 0. && !nodes[corner.node].is_singular)
      for(const int j : cut_mesh.ring(corner.node))
        add_node_weight(weights, j, corner.weight / 2.);
}

// omega = (w/(1-w))^exponent, bounded: makes a fit interpolate the node where w is 1. Exponent 1 is
// the paper's and leaves a small cone point at every node; exponent 2 removes it.
inline double interpolating_weight(const double w, const int exponent)
{
  // a ratio of 4e8, or 1e8, between a node and its ring, which closes the gap to 1e-9 of an edge and turns
  // the normal by less than 1e-8 while the normal equations stay well conditioned
  constexpr double least_complement_squared = 5e-5, least_complement = 1e-8;
  if(exponent == 1)
    return w / (std::max)(1. - w, least_complement);
  const double ratio = w / (std::max)(1. - w, least_complement_squared);
  return ratio * ratio;
}

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_MODEL_INTERPOLATION_WEIGHTS_H
