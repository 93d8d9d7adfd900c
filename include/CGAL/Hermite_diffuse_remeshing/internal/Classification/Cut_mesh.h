// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_CLASSIFICATION_CUT_MESH_H
#define CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_CLASSIFICATION_CUT_MESH_H

#include <CGAL/Hermite_diffuse_remeshing/internal/Classification/classify_edges.h>

#include <boost/pending/disjoint_sets.hpp>
#include <boost/property_map/property_map.hpp>

#include <array>
#include <vector>

namespace CGAL {
namespace Hermite_diffuse_remeshing {
namespace internal {

// A range of a packed array of integers.
struct Index_range
{
  const int* first;
  const int* last;

  const int* begin() const { return first; }
  const int* end() const { return last; }
  int size() const { return static_cast<int>(last - first); }
};

// The surface cut along its features. A node is a class of corners (face, vertex) of one vertex
// that are joined by interior edges: a vertex on a crease has a node for each side, a vertex
// where two sheets touch has one for each sheet. This alone selects the elements of the paper's
// patches by adjacency (section 2.4), gives the normals per side of a crease (2.5), and is safe
// for non-manifold input. A patch is a connected component of faces joined by interior edges.
class Cut_mesh
{
  std::vector<std::array<int, 3> > m_nodes_of_face;
  std::vector<std::array<int, 3> > m_neighbors;       // across side k, or -1 at a feature
  std::vector<int> m_vertex_of_node;
  std::vector<int> m_patch_of_face;
  int m_number_of_patches = 0;
  std::vector<int> m_corners, m_first_corner;         // 3 * face + corner, grouped by node
  std::vector<int> m_ring, m_first_ring;

public:
  Cut_mesh(const Indexed_triangles& surface,
           const Edge_table& edges,
           const std::vector<Edge_class>& edge_classes)
  {
    join_corners(surface, edges, edge_classes);
    group_corners_by_node();
    collect_rings();
    collect_patches();
  }

  int number_of_nodes() const { return static_cast<int>(m_vertex_of_node.size()); }
  int number_of_patches() const { return m_number_of_patches; }
  int patch(const int face) const { return m_patch_of_face[face]; }
  int node(const int face, const int corner) const { return m_nodes_of_face[face][corner]; }
  const std::array<int, 3>& nodes(const int face) const { return m_nodes_of_face[face]; }
  int vertex(const int node) const { return m_vertex_of_node[node]; }
  // face across a side, -1 where a feature or the border is in between
  int neighbor(const int face, const int side) const { return m_neighbors[face][side]; }

  // 3 * face + corner of every corner of the node
  Index_range corners(const int node) const { return range(m_corners, m_first_corner, node); }
  // nodes that share an edge of a face with the node
  Index_range ring(const int node) const { return range(m_ring, m_first_ring, node); }
  // the fan of faces around the node does not close
  bool is_open(const int node) const { return ring(node).size() > corners(node).size(); }

private:
  static Index_range range(const std::vector<int>& values, const std::vector<int>& first, const int i)
  {
    return {values.data() + first[i], values.data() + first[i+1]};
  }

  void join_corners(const Indexed_triangles& surface,
                    const Edge_table& edges,
                    const std::vector<Edge_class>& edge_classes)
  {
    const int nf = surface.number_of_faces();
    std::vector<int> rank(3 * nf, 0), parent(3 * nf);
    // The maps are classes: get() is not found for pointers once Boost's header of compressed graphs is included.
    const auto make_map = [](std::vector<int>& values)
    { return boost::make_iterator_property_map(values.begin(), boost::identity_property_map()); };
    auto ranks = make_map(rank), parents = make_map(parent);
    boost::disjoint_sets<decltype(ranks), decltype(parents)> sets(ranks, parents);
    for(int c = 0; c < 3 * nf; ++c)
      sets.make_set(c);

    m_neighbors.assign(nf, {{-1, -1, -1}});
    for(int e = 0; e < edges.number_of_edges(); ++e)
    {
      if(is_feature(edge_classes[e]))
        continue;
      const Face_side s = edges.side(e, 0), t = edges.side(e, 1);
      sets.union_set(3 * s.face + s.side, 3 * t.face + next(t.side));
      sets.union_set(3 * s.face + next(s.side), 3 * t.face + t.side);
      m_neighbors[s.face][s.side] = t.face;
      m_neighbors[t.face][t.side] = s.face;
    }

    // nodes are numbered by their first corner, so that the numbering does not depend on the
    // representatives chosen by the union
    std::vector<int> node_of_set(3 * nf, -1);
    m_nodes_of_face.resize(nf);
    for(int c = 0; c < 3 * nf; ++c)
    {
      int& node = node_of_set[sets.find_set(c)];
      if(node == -1)
      {
        node = number_of_nodes();
        m_vertex_of_node.push_back(surface.triangles[c / 3][c % 3]);
      }
      m_nodes_of_face[c / 3][c % 3] = node;
    }
    m_vertex_of_node.shrink_to_fit();
  }

  void group_corners_by_node()
  {
    m_first_corner.assign(number_of_nodes() + 1, 0);
    for(const std::array<int, 3>& nodes : m_nodes_of_face)
      for(const int node : nodes)
        ++m_first_corner[node + 1];
    for(int i = 0; i < number_of_nodes(); ++i)
      m_first_corner[i+1] += m_first_corner[i];

    m_corners.resize(3 * m_nodes_of_face.size());
    std::vector<int> next_free(m_first_corner.begin(), m_first_corner.end() - 1);
    for(std::size_t f = 0; f < m_nodes_of_face.size(); ++f)
      for(int k = 0; k < 3; ++k)
        m_corners[next_free[m_nodes_of_face[f][k]]++] = static_cast<int>(3 * f + k);
  }

  void collect_rings()
  {
    m_first_ring.assign(1, 0);
    m_first_ring.reserve(number_of_nodes() + 1);
    // as many as corners where the fans close, one more per node where they do not
    m_ring.reserve(m_corners.size() + number_of_nodes());
    std::vector<int> last_ring(number_of_nodes(), -1);      // that a node was entered in
    for(int i = 0; i < number_of_nodes(); ++i)
    {
      last_ring[i] = i;
      for(const int c : corners(i))
        for(const int k : {next(c % 3), previous(c % 3)})
        {
          const int other = m_nodes_of_face[c / 3][k];
          if(last_ring[other] == i)
            continue;
          last_ring[other] = i;
          m_ring.push_back(other);
        }
      m_first_ring.push_back(static_cast<int>(m_ring.size()));
    }
    m_ring.shrink_to_fit();
  }

  void collect_patches()
  {
    m_patch_of_face.assign(m_nodes_of_face.size(), -1);
    std::vector<int> stack;
    for(std::size_t seed = 0; seed < m_patch_of_face.size(); ++seed)
    {
      if(m_patch_of_face[seed] != -1)
        continue;
      const int patch = m_number_of_patches++;
      m_patch_of_face[seed] = patch;
      stack.push_back(static_cast<int>(seed));
      while(!stack.empty())
      {
        const int f = stack.back();
        stack.pop_back();
        for(const int g : m_neighbors[f])
          if(g != -1 && m_patch_of_face[g] == -1)
          {
            m_patch_of_face[g] = patch;
            stack.push_back(g);
          }
      }
    }
  }
};

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_CLASSIFICATION_CUT_MESH_H
