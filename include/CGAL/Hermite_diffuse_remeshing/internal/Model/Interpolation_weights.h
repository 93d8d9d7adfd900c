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
#include <CGAL/Hermite_diffuse_remeshing/internal/Progress.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/for_each_index.h>

#include <Eigen/Core>

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Hermite_diffuse_remeshing {
namespace internal {

// w_i of the paper's figure 5: the shape functions of the face applied to 1 at a corner and 1/2 at the nodes that share an
// edge with it. w_i is in [0,1], and 1 at node i only. Which nodes have a weight on a face, and from which of its corners,
// is found once for all queries, or again for each. Of a tangent node's neighbours only those on the line have one.
class Interpolation_weights
{
  // A node of a face of valences 6 is one of 12. Around a vertex with very many faces every one of them would have all the
  // others' nodes: those of a face with more are found again for each query. So are those of flat faces: nobody asks.
  static constexpr std::size_t largest_number = 64;
  // a node that is no corner
  static constexpr unsigned char no_corner = 3;

  struct Influence
  {
    int node;
    // the corner that is the node, and a bit, from 4 on, for each of those that share an edge with it
    unsigned char corners;
  };

  // packed: of each face, by the number of the node
  std::vector<int> m_nodes;
  std::vector<unsigned char> m_corners;
  std::vector<std::size_t> m_first;
  Neighbors_on_lines m_on_lines;

public:
  Interpolation_weights() = default;
  Interpolation_weights(const Cut_mesh& cut_mesh, const std::vector<Node>& nodes, const std::vector<char>& is_flat,
                        const int number_of_faces, Neighbors_on_lines on_lines, const bool is_parallel,
                        const Progress& progress)
    : m_first(1, 0), m_on_lines(std::move(on_lines))
  {
    const auto is_remembered = [&](const int face)
    {
      const auto& corners = cut_mesh.nodes(face);
      return std::all_of(corners.begin(), corners.end(),
                         [&](const int node) { return std::size_t(cut_mesh.ring(node).size()) < largest_number; })
          && !std::all_of(corners.begin(), corners.end(), [&](const int node) { return is_flat[node]; });
    };
    const std::size_t most = largest_total(cut_mesh, number_of_faces, is_remembered);
    m_nodes.reserve(most);
    m_corners.reserve(most);
    m_first.reserve(number_of_faces + 1);
    // faces of which the influences are found before they are entered, at one time
    constexpr int block_size = 2048;
    std::vector<std::vector<Influence> > of_faces((std::min)(block_size, number_of_faces));
    for(int first = 0; first < number_of_faces; first += block_size)
    {
      const int number = (std::min)(block_size, number_of_faces - first);
      for_each_index(number, is_parallel, [&]
      {
        return [&](const int i)
        {
          of_faces[i].clear();
          if(is_remembered(first + i))
            collect(cut_mesh, nodes, first + i, of_faces[i]);
        };
      }, progress.part(0., 0.));
      for(int i = 0; i < number; ++i)
        enter(of_faces[i]);
    }
  }

  // takes no memory any more, for longer queries
  void forget()
  {
    m_nodes = std::vector<int>();
    m_corners = std::vector<unsigned char>();
    m_first = std::vector<std::size_t>();
  }

  // Calls `visit(node, weight)` for the nodes with a weight, in the order of their numbers, not of the face: both faces of
  // an edge then add up the same numbers in the same order, and what is evaluated on the edge is equal to the last bit.
  template <typename Visit>
  void for_each(const Cut_mesh& cut_mesh, const std::vector<Node>& nodes, const Location& location,
                const Visit& visit) const
  {
    const std::array<double, 3>& l = location.coordinates;
    const double of_corner[] = {l[0], l[1], l[2], 0.};
    double of_neighbors[8];
    for(int bits = 0; bits < 8; ++bits)
      of_neighbors[bits] = ((bits & 1 ? l[0] : 0.) + (bits & 2 ? l[1] : 0.) + (bits & 4 ? l[2] : 0.)) / 2.;
    const auto visit_one = [&](const int node, const unsigned char corners)
    {
      const double weight = of_corner[corners & 3] + of_neighbors[corners >> 2];
      if(weight > 0.)
        visit(node, weight);
    };
    if(!m_first.empty() && m_first[location.face + 1] > m_first[location.face])
    {
      for(std::size_t i = m_first[location.face]; i < m_first[location.face + 1]; ++i)
        visit_one(m_nodes[i], m_corners[i]);
      return;
    }
    boost::container::small_vector<Influence, largest_number> influences;
    collect(cut_mesh, nodes, location.face, influences);
    for(const Influence& influence : influences)
      visit_one(influence.node, influence.corners);
  }

private:
  // of the next face
  void enter(const std::vector<Influence>& influences)
  {
    if(influences.size() <= largest_number)
      for(const Influence& influence : influences)
      {
        m_nodes.push_back(influence.node);
        m_corners.push_back(influence.corners);
      }
    m_first.push_back(m_nodes.size());
  }

  // each side of a face joins two of its corners
  template <typename IsRemembered>
  static std::size_t largest_total(const Cut_mesh& cut_mesh, const int number_of_faces, const IsRemembered& is_remembered)
  {
    std::size_t result = 0;
    for(int f = 0; f < number_of_faces; ++f)
    {
      if(!is_remembered(f))
        continue;
      std::size_t number = 0;
      for(const int node : cut_mesh.nodes(f))
        number += cut_mesh.ring(node).size() - 1;
      result += (std::min)(number, largest_number);
    }
    return result;
  }

  // of a neighbour, where the node is a corner
  bool has_influence(const std::vector<Node>& nodes, const int node, const int neighbor) const
  {
    return !nodes[node].is_tangent
        || std::binary_search(m_on_lines.begin(), m_on_lines.end(), std::make_pair(node, neighbor));
  }

  // A node that several corners know is met several times at first: looking for it would take the square of the degree.
  template <typename Influences>
  void collect(const Cut_mesh& cut_mesh, const std::vector<Node>& nodes, const int face, Influences& result) const
  {
    result.clear();
    for(int k = 0; k < 3; ++k)
    {
      const int node = cut_mesh.node(face, k);
      result.push_back({node, static_cast<unsigned char>(k)});
      if(!nodes[node].is_singular)
        for(const int j : cut_mesh.ring(node))
          if(has_influence(nodes, node, j))
            result.push_back({j, static_cast<unsigned char>(no_corner | 4 << k)});
    }
    std::sort(result.begin(), result.end(), [](const Influence& a, const Influence& b) { return a.node < b.node; });
    auto last = result.begin();
    for(auto it = last + 1; it != result.end(); ++it)
      if(it->node == last->node)
        last->corners = static_cast<unsigned char>((std::min)(last->corners & 3, it->corners & 3)
                                                   | ((last->corners | it->corners) & ~3));
      else
        *++last = *it;
    result.erase(last + 1, result.end());
  }
};

// omega = (w/(1-w))^exponent, bounded: makes a fit interpolate the node where w is 1. Exponent 1 is
// the paper's and leaves a small cone point at every node; exponent 2 removes it. For two nodes at once.
inline Eigen::Array2d interpolating_weights(const Eigen::Array2d& w, const int exponent)
{
  // a ratio of 4e8, or 1e8, between a node and its ring, which closes the gap to 1e-9 of an edge and turns
  // the normal by less than 1e-8 while the normal equations stay well conditioned
  constexpr double least_complement_of_square = 5e-5, least_complement = 1e-8;
  if(exponent == 1)
    return w / (1. - w).max(least_complement);
  const Eigen::Array2d ratio = w / (1. - w).max(least_complement_of_square);
  return ratio * ratio;
}

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_MODEL_INTERPOLATION_WEIGHTS_H
