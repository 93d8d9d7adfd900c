// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_FLIP_EDGES_H
#define CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_FLIP_EDGES_H

#include <CGAL/Hermite_diffuse_remeshing/internal/Transformation/Edge_queue.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Transformation/is_free.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Transformation/legality.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Transformation/propose_and_accept.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/selected_elements.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <vector>

namespace CGAL {
namespace Hermite_diffuse_remeshing {
namespace internal {

// The quality of the halves of a square, for both of its diagonals: two triangles that are both better than these
// have no better diagonal.
constexpr double quality_of_square = 0.7175;

// How many triangles the part of the surface between two curves has at the target of h, more than fit
// into the angle there; 0 is best. Six fit around a vertex inside the surface.
template <typename UserMesh>
int excess_of_faces(const Working_mesh<UserMesh>& mesh, const typename Working_mesh<UserMesh>::halfedge_descriptor h)
{
  const auto& tm = mesh.tmesh();
  constexpr int ideal_number = 6;
  const auto v = target(h, tm);
  if(mesh.data(v).type == SURFACE_VERTEX)
    return static_cast<int>(degree(v, tm)) - ideal_number;

  const auto ends_sector = [&](const auto g) { return mesh.is_on_curve(g) || mesh.is_protected(g)
                                                   || mesh.is_border_or_outside(g) != mesh.is_border_or_outside(opposite(g, tm)); };
  int number = 0;
  double angle = 0.;
  const auto add_face_of = [&](const auto g)
  {
    const Vector a = mesh.point(source(g, tm)) - mesh.point(v);
    const Vector b = mesh.point(target(next(g, tm), tm)) - mesh.point(v);
    angle += std::atan2(a.cross(b).norm(), a.dot(b));
    ++number;
  };
  // to the one side, then to the other
  auto g = h;
  do
  {
    add_face_of(g);
    g = opposite(next(g, tm), tm);
  }
  while(g != h && !ends_sector(g));
  if(g != h)
    for(g = h; !ends_sector(g); )
    {
      g = prev(opposite(g, tm), tm);
      add_face_of(g);
    }
  const double fitting = angle * ideal_number / (2. * boost::math::constants::pi<double>());
  // keeps a right angle, where one and a half would fit, away from the limit
  constexpr double offset = 0.037;
  return number - (std::max)(1, static_cast<int>(std::lround(fitting + offset)));
}

template <typename UserMesh>
bool is_flippable(const Working_mesh<UserMesh>& mesh, const typename Working_mesh<UserMesh>::halfedge_descriptor h)
{
  return !mesh.is_on_curve(h) && !mesh.is_protected(h) && !mesh.is_border_or_outside(h)
      && !mesh.is_border_or_outside(opposite(h, mesh.tmesh()));
}

template <typename UserMesh>
bool is_flip_topologically_legal(const Working_mesh<UserMesh>& mesh,
                                 const typename Working_mesh<UserMesh>::halfedge_descriptor h)
{
  const auto& tm = mesh.tmesh();
  const auto o = opposite(h, tm);
  if(!is_flippable(mesh, h))
    return false;
  const auto c = target(next(h, tm), tm), d = target(next(o, tm), tm);
  return c != d && !mesh.are_joined(c, d);
}

// Excesses of faces, which flips ask for again and again. Those of vertices inside the surface are remembered, and
// follow the flips. Several threads may ask at the same time: those that find out the same excess remember it alike.
template <typename UserMesh>
class Face_excesses
{
  typedef Working_mesh<UserMesh> Mesh;
  typedef typename Mesh::halfedge_descriptor halfedge_descriptor;

  const Mesh& m_mesh;
  std::vector<std::atomic<int> > m_excesses;          // by the number of the vertex

  // of a vertex that has not been asked for yet, and of one that has other sectors at other edges
  static constexpr int unknown = (std::numeric_limits<int>::max)(), by_sector = unknown - 1;

public:
  explicit Face_excesses(const Mesh& mesh) : m_mesh(mesh), m_excesses(mesh.number_of_vertex_slots())
  {
    for(std::atomic<int>& excess : m_excesses)
      excess.store(unknown, std::memory_order_relaxed);
  }

  // the change of the sum of squares of the excesses by the flip of an edge
  int gain_of_flip(const halfedge_descriptor h) const
  {
    const auto& tm = m_mesh.tmesh();
    const halfedge_descriptor o = opposite(h, tm);
    int gain = 0;
    for(const halfedge_descriptor g : {h, o})                     // loses a triangle
      gain += 2 * excess(g) - 1;
    for(const halfedge_descriptor g : {next(h, tm), next(o, tm)}) // gets one
      gain -= 2 * excess(g) + 1;
    return gain;
  }

  // May the flip of an edge be no loss? The vertices of the edge are remembered. Inside the surface most flips are one,
  // which is found out by less than whether they are possible.
  bool may_gain(const halfedge_descriptor h)
  {
    const auto& tm = m_mesh.tmesh();
    const halfedge_descriptor o = opposite(h, tm);
    bool are_all_remembered = true;
    for(const halfedge_descriptor g : {h, o, next(h, tm), next(o, tm)})
      are_all_remembered = remember(g) && are_all_remembered;
    if(are_all_remembered)
      return gain_of_flip(h) >= 0 && is_flippable(m_mesh, h);
    return is_flippable(m_mesh, h) && gain_of_flip(h) >= 0;
  }

  // before the flip
  void follow_flip(const halfedge_descriptor h)
  {
    const auto& tm = m_mesh.tmesh();
    const halfedge_descriptor o = opposite(h, tm);
    for(const halfedge_descriptor g : {h, o})
      change(g, -1);
    for(const halfedge_descriptor g : {next(h, tm), next(o, tm)})
      change(g, 1);
  }

private:
  int number(const halfedge_descriptor h) const { return m_mesh.index(target(h, m_mesh.tmesh())); }
  int remembered(const halfedge_descriptor h) const { return m_excesses[number(h)].load(std::memory_order_relaxed); }

  bool remember(const halfedge_descriptor h)
  {
    int excess = remembered(h);
    if(excess == unknown)
    {
      excess = m_mesh.data(target(h, m_mesh.tmesh())).type == SURFACE_VERTEX ? excess_of_faces(m_mesh, h) : by_sector;
      m_excesses[number(h)].store(excess, std::memory_order_relaxed);
    }
    return excess != by_sector;
  }

  int excess(const halfedge_descriptor h) const
  {
    const int result = remembered(h);
    return result < by_sector ? result : excess_of_faces(m_mesh, h);
  }

  void change(const halfedge_descriptor h, const int difference)
  {
    const int excess = remembered(h);
    if(excess < by_sector)
      m_excesses[number(h)].store(excess + difference, std::memory_order_relaxed);
  }
};

// the two faces of an edge, now and with the other diagonal
template <typename UserMesh>
Worth worth_of_pair(const Working_mesh<UserMesh>& mesh, const typename Working_mesh<UserMesh>::halfedge_descriptor h)
{
  Worth result = face_worth(mesh, h);
  result.add(face_worth(mesh, opposite(h, mesh.tmesh())));
  return result;
}

template <typename UserMesh>
Worth worth_after_flip(const Working_mesh<UserMesh>& mesh, const typename Working_mesh<UserMesh>::halfedge_descriptor h)
{
  const auto& tm = mesh.tmesh();
  const auto o = opposite(h, tm);
  const Site& c = mesh.site(target(next(h, tm), tm));
  const Site& d = mesh.site(target(next(o, tm), tm));
  Worth result = worth(mesh.reference(), mesh.site(source(h, tm)), d, c, mesh.hint(h));
  result.add(worth(mesh.reference(), d, mesh.site(target(h, tm)), c, mesh.hint(o)));
  return result;
}

// Flips edges one after the other where `is_legal(halfedge)`. Calls `before_flip(halfedge)`.
template <typename UserMesh, typename IsLegal, typename BeforeFlip>
std::size_t flip_in_order(Working_mesh<UserMesh>& mesh, const std::vector<Queued_edge<Working_mesh<UserMesh> > >& queue,
                          const IsLegal& is_legal, const BeforeFlip& before_flip)
{
  const auto& tm = mesh.tmesh();
  const std::size_t before = mesh.counts().flips;
  propose_and_accept(mesh, queue.begin(), queue.end(), [&](const auto& candidate) { return is_legal(candidate.halfedge); },
                     [&](const auto& candidate, const bool was_legal, const std::size_t since)
  {
    const auto h = candidate.halfedge, o = opposite(h, tm);
    // what is legal depends on the faces around the two that the edge has
    const bool has_changed = mesh.number_of_changes() != since
      && (mesh.has_changed(h, since) || mesh.has_changed(target(next(h, tm), tm), since)
          || mesh.has_changed(target(next(o, tm), tm), since));
    if(!(has_changed ? is_legal(h) : was_legal) || !is_flip_free(mesh, h))
      return;
    before_flip(h);
    mesh.flip_edge(h);
  });
  return mesh.counts().flips - before;
}

// May an edge be flipped, and is that for the better? `gain`: of the valences
template <typename UserMesh>
bool is_flip_legal(const Working_mesh<UserMesh>& mesh, const typename Working_mesh<UserMesh>::halfedge_descriptor h,
                   const int gain)
{
  const Worth before = worth_of_pair(mesh, h);
  if(gain == 0 && before.score > quality_of_square)
    return false;
  const Worth after = worth_after_flip(mesh, h);
  // triangles worse than this would hinder the relocation
  constexpr double least_score_of_flip = 0.4;
  return (gain > 0 ? is_acceptable(after, [&] { return before; }, least_score_of_flip) : is_better(after, before))
      && is_flip_topologically_legal(mesh, h);
}

// The remeshed faces with changes at their corners, each once, from the first of these.
template <typename UserMesh>
std::vector<typename Working_mesh<UserMesh>::face_descriptor>
changed_faces(const Working_mesh<UserMesh>& mesh, const std::size_t since)
{
  typedef Working_mesh<UserMesh> Mesh;
  const auto& tm = mesh.tmesh();
  std::vector<typename Mesh::face_descriptor> result;
  for(int i = 0; i < static_cast<int>(mesh.number_of_vertex_slots()) && !mesh.is_stopped_at(i); ++i)
  {
    if(!mesh.has_changed(i, since) || mesh.vertex(i) == Mesh::Graph_traits::null_vertex())
      continue;
    const auto is_earlier = [&](const auto v) { return mesh.index(v) < i && mesh.has_changed(v, since); };
    mesh.visit_copies(mesh.vertex(i), [&](const auto v)
    {
      for(const auto h : CGAL::halfedges_around_target(v, tm))
        if(!mesh.is_border_or_outside(h) && !is_earlier(source(h, tm)) && !is_earlier(target(next(h, tm), tm)))
          result.push_back(face(h, tm));
    });
  }
  return result;
}

// Flips edges that raise the worse of their two scores, the longest first.
template <typename UserMesh>
std::size_t flip_edges_by_score(Working_mesh<UserMesh>& mesh, const std::size_t since)
{
  typedef Working_mesh<UserMesh> Mesh;
  typedef typename Mesh::face_descriptor face_descriptor;
  const auto is_bad = [&](const face_descriptor f)
  { return face_worth(mesh, halfedge(f, mesh.tmesh())).score <= quality_of_square; };
  std::vector<Queued_edge<Mesh> > queue;
  for(const face_descriptor f : selected_elements(changed_faces(mesh, since), mesh.is_parallel(), is_bad, mesh.progress()))
    for(const auto h : CGAL::halfedges_around_face(halfedge(f, mesh.tmesh()), mesh.tmesh()))
      if(mesh.has_changed(h, since) && is_flippable(mesh, h))
        queue.push_back({directed_by_number(mesh, h), urgency_level(mesh.relative_length(h)), mesh.edge_key(h)});
  sort_queue(queue);
  return flip_in_order(mesh, queue,
                       [&](const auto h) { return is_flippable(mesh, h) && is_flip_legal(mesh, h, 0); }, [](const auto) {});
}

// Flips edges that lead to vertices with about the number of triangles that fits their angle, so that relocation
// can make these equilateral.
template <typename UserMesh>
std::size_t flip_edges_by_valence(Working_mesh<UserMesh>& mesh, const std::size_t since)
{
  typedef typename Working_mesh<UserMesh>::halfedge_descriptor halfedge_descriptor;
  Face_excesses<UserMesh> excesses(mesh);
  const auto queue = collect_edges(mesh, since, LONGEST_FIRST, [&](const halfedge_descriptor h)
                                   { return excesses.may_gain(h); });
  return flip_in_order(mesh, queue, [&](const halfedge_descriptor h)
  {
    const int gain = excesses.gain_of_flip(h);
    return gain >= 0 && is_flip_legal(mesh, h, gain);
  }, [&](const halfedge_descriptor h) { excesses.follow_flip(h); });
}

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_FLIP_EDGES_H
