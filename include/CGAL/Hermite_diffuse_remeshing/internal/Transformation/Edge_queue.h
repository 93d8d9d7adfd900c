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

// The halfedge from the smaller number to the larger, which is the same for every mesh type.
template <typename UserMesh>
typename Working_mesh<UserMesh>::halfedge_descriptor
directed_by_number(const Working_mesh<UserMesh>& mesh, const typename Working_mesh<UserMesh>::halfedge_descriptor h)
{
  const auto& tm = mesh.tmesh();
  return mesh.index(source(h, tm)) < mesh.index(target(h, tm)) ? h : opposite(h, tm);
}

// Visits the edges with changes around them, each once: by way of the vertices, unless all of them have changed.
// `visit(halfedge)`
template <typename UserMesh, typename Visit>
void visit_changed_edges(const Working_mesh<UserMesh>& mesh, const std::size_t since, const Visit& visit)
{
  const auto& tm = mesh.tmesh();
  if(since == 0)
  {
    std::size_t step = 0;
    for(auto [e, end] = edges(tm); e != end && !mesh.is_stopped_at(step++); ++e)
    {
      const auto h = halfedge(*e, tm);
      const int s = mesh.index(source(h, tm)), t = mesh.index(target(h, tm));
      if(s != -1 || t != -1)                            // has faces
        visit(s < t ? h : opposite(h, tm));
    }
    return;
  }
  for(int i = 0; i < static_cast<int>(mesh.number_of_vertex_slots()) && !mesh.is_stopped_at(i); ++i)
    if(mesh.has_changed(i, since) && mesh.vertex(i) != Working_mesh<UserMesh>::Graph_traits::null_vertex())
      mesh.visit_copies(mesh.vertex(i), [&](const auto v)
      {
        for(const auto h : CGAL::halfedges_around_target(v, tm))
        {
          const int j = mesh.index(source(h, tm));
          if(j > i || !mesh.has_changed(j, since))
            visit(directed_by_number(mesh, h));
        }
      });
}

// The edges with changes around them that `is_candidate` takes, sorted.
template <typename UserMesh, typename IsCandidate>
std::vector<Queued_edge<Working_mesh<UserMesh> > >
collect_edges(const Working_mesh<UserMesh>& mesh, const std::size_t since, const Edge_order order,
              const IsCandidate& is_candidate)
{
  typedef Working_mesh<UserMesh> Mesh;
  std::vector<Queued_edge<Mesh> > queue;
  visit_changed_edges(mesh, since, [&](const typename Mesh::halfedge_descriptor h)
  {
    if(is_candidate(h) && mesh.is_inside(edge(h, mesh.tmesh())))
      queue.push_back({h, order * urgency_level(mesh.relative_length(h)), mesh.edge_key(h)});
  });
  if(mesh.is_stopped())
    queue.clear();
  sort_queue(queue);
  return queue;
}

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_EDGE_QUEUE_H
