// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_EDGE_QUEUE_H
#define CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_EDGE_QUEUE_H

#include <CGAL/Hermite_diffuse_remeshing/internal/Transformation/Working_mesh.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Hermite_diffuse_remeshing {
namespace internal {

// An edge to be looked at, by the vertices that it joined when it was queued: after other
// operations these may be joined no more, or be other vertices under the same descriptors, so the
// edge is looked up and measured again when its turn comes.
template <typename Mesh>
struct Queued_edge
{
  typename Mesh::halfedge_descriptor halfedge;
  int level;                            // most urgent: the largest
  std::pair<int, int> key;

  bool operator<(const Queued_edge& other) const
  {
    return level != other.level ? level > other.level : key < other.key;
  }
};

// Edges that are equal up to rounding get the same level and are taken in the order of their keys.
inline int urgency_level(const double relative_length)
{
  constexpr double levels_per_octave = 16.;
  // keeps the levels of the usual ratios 1, 2, sqrt(2) away from the limits between levels
  constexpr double offset = 0.37;
  return relative_length > 0. ? static_cast<int>(std::floor(levels_per_octave * std::log2(relative_length) + offset))
                              : (std::numeric_limits<int>::min)() / 2;
}

template <typename Mesh>
void sort_queue(std::vector<Queued_edge<Mesh> >& queue)
{
  std::sort(queue.begin(), queue.end());
  // the copies of an edge of a junction are changed together
  queue.erase(std::unique(queue.begin(), queue.end(), [](const Queued_edge<Mesh>& a, const Queued_edge<Mesh>& b)
                          { return a.key == b.key; }), queue.end());
}

// By number, edges that follow each other are near each other, in space and in memory.
enum Edge_order { SHORTEST_FIRST = -1, BY_NUMBER = 0, LONGEST_FIRST = 1 };

// the edges that `is_candidate` takes, sorted
template <typename UserMesh, typename IsCandidate>
std::vector<Queued_edge<Working_mesh<UserMesh> > >
collect_edges(const Working_mesh<UserMesh>& mesh, const Edge_order order, const IsCandidate& is_candidate)
{
  typedef Working_mesh<UserMesh> Mesh;
  std::vector<Queued_edge<Mesh> > queue;
  std::size_t step = 0;
  for(const typename Mesh::edge_descriptor e : edges(mesh.tmesh()))
  {
    if(mesh.is_stopped_at(step++))
      return std::vector<Queued_edge<Mesh> >();
    const typename Mesh::halfedge_descriptor h = halfedge(e, mesh.tmesh());
    if(is_candidate(h) && mesh.is_inside(e))
      queue.push_back({h, order * urgency_level(mesh.relative_length(h)), mesh.edge_key(h)});
  }
  sort_queue(queue);
  return queue;
}

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_EDGE_QUEUE_H
