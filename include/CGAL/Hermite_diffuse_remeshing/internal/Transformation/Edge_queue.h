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
#include <CGAL/Hermite_diffuse_remeshing/internal/for_each_index.h>

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

// The edges with changes around them, each once: by way of the vertices, unless all of them have changed. All of them, or
// in parts, which threads may visit at the same time. `visit(halfedge)`
template <typename UserMesh>
class Changed_edges
{
  typedef Working_mesh<UserMesh> Mesh;
  typedef typename Mesh::halfedge_descriptor halfedge_descriptor;
  typedef typename Mesh::edge_descriptor edge_descriptor;

  const Mesh& m_mesh;
  std::size_t m_since;
  std::vector<edge_descriptor> m_edges; // of all parts, if all have changed

  // edges or vertices: there is less to do around fewer than a thread takes to wake up
  static constexpr int size_of_part = 512;

public:
  Changed_edges(const Mesh& mesh, const std::size_t since) : m_mesh(mesh), m_since(since) {}

  template <typename Visit>
  void visit(const Visit& visit) const
  {
    std::size_t step = 0;
    if(m_since == 0)
      for(auto [e, end] = edges(m_mesh.tmesh()); e != end && !m_mesh.is_stopped_at(step++); ++e)
        visit_edge(*e, visit);
    else
      for(int i = 0; i < number_of_vertices() && !m_mesh.is_stopped_at(step++); ++i)
        visit_around(i, visit);
  }

  int make_parts()
  {
    if(m_since == 0)
      for(const edge_descriptor e : edges(m_mesh.tmesh()))
        m_edges.push_back(e);
    return (number() + size_of_part - 1) / size_of_part;
  }

  template <typename Visit>
  void visit_part(const int part, const Visit& visit) const
  {
    const int last = (std::min)(number(), (part + 1) * size_of_part);
    for(int i = part * size_of_part; i < last; ++i)
      if(m_since == 0)
        visit_edge(m_edges[i], visit);
      else
        visit_around(i, visit);
  }

private:
  int number_of_vertices() const { return static_cast<int>(m_mesh.number_of_vertex_slots()); }
  int number() const { return m_since == 0 ? static_cast<int>(m_edges.size()) : number_of_vertices(); }

  template <typename Visit>
  void visit_edge(const edge_descriptor e, const Visit& visit) const
  {
    const auto& tm = m_mesh.tmesh();
    const halfedge_descriptor h = halfedge(e, tm);
    const int s = m_mesh.index(source(h, tm)), t = m_mesh.index(target(h, tm));
    if(s != -1 || t != -1)                              // has faces
      visit(s < t ? h : opposite(h, tm));
  }

  // around the vertex with the number
  template <typename Visit>
  void visit_around(const int number, const Visit& visit) const
  {
    if(!m_mesh.has_changed(number, m_since) || m_mesh.vertex(number) == Mesh::Graph_traits::null_vertex())
      return;
    const auto& tm = m_mesh.tmesh();
    m_mesh.visit_copies(m_mesh.vertex(number), [&](const auto v)
    {
      for(const halfedge_descriptor h : CGAL::halfedges_around_target(v, tm))
      {
        const int other = m_mesh.index(source(h, tm));
        if(other > number || !m_mesh.has_changed(other, m_since))
          visit(other > number ? opposite(h, tm) : h);
      }
    });
  }
};

// The edges with changes around them that `is_candidate` takes, sorted. Several threads may ask it at the same time.
template <typename UserMesh, typename IsCandidate>
std::vector<Queued_edge<Working_mesh<UserMesh> > >
collect_edges(const Working_mesh<UserMesh>& mesh, const std::size_t since, const Edge_order order,
              const IsCandidate& is_candidate)
{
  typedef Working_mesh<UserMesh> Mesh;
  typedef std::vector<Queued_edge<Mesh> > Queue;
  const auto add_to = [&](Queue& queue)
  {
    return [&](const typename Mesh::halfedge_descriptor h)
    {
      if(is_candidate(h) && mesh.is_inside(edge(h, mesh.tmesh())))
        queue.push_back({h, order * urgency_level(mesh.relative_length(h)), mesh.edge_key(h)});
    };
  };
  Changed_edges<UserMesh> changed(mesh, since);
  Queue queue;
  if(mesh.is_parallel())
  {
    std::vector<Queue> parts(changed.make_parts());
    for_each_index(static_cast<int>(parts.size()), true, [&]
    { return [&](const int part) { changed.visit_part(part, add_to(parts[part])); }; }, mesh.progress());
    for(const Queue& part : parts)
      queue.insert(queue.end(), part.begin(), part.end());
  }
  else
    changed.visit(add_to(queue));
  if(mesh.is_stopped())
    queue.clear();
  sort_queue(queue);
  return queue;
}

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_EDGE_QUEUE_H
