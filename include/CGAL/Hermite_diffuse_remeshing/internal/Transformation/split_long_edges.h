// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_SPLIT_LONG_EDGES_H
#define CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_SPLIT_LONG_EDGES_H

#include <CGAL/Hermite_diffuse_remeshing/internal/Transformation/Edge_queue.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Transformation/curve_fidelity.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Transformation/is_free.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Transformation/legality.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Transformation/propose_and_accept.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/edge_topology.h>

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Hermite_diffuse_remeshing {
namespace internal {

// the middle of an edge, in the parameter of its curve or on the model above its middle
template <typename UserMesh>
Site middle_site(const Working_mesh<UserMesh>& mesh,
                 const typename Working_mesh<UserMesh>::halfedge_descriptor h)
{
  const auto s = source(h, mesh.tmesh()), t = target(h, mesh.tmesh());
  const int curve = mesh.curve(h);
  if(curve != -1)
    return mesh.reference().curve_site(curve, (mesh.parameter(s, curve) + mesh.parameter(t, curve)) / 2.);
  const auto side = mesh.is_border_or_outside(h) ? opposite(h, mesh.tmesh()) : h;
  return mesh.reference().surface_site((mesh.point(s) + mesh.point(t)) / 2., mesh.hint(side));
}

// The halfedges in front of which a split of h halves a remeshed face, all copies included.
template <typename UserMesh>
boost::container::small_vector<typename Working_mesh<UserMesh>::halfedge_descriptor, 2>
sides_of_split(const Working_mesh<UserMesh>& mesh, const typename Working_mesh<UserMesh>::halfedge_descriptor h)
{
  boost::container::small_vector<typename Working_mesh<UserMesh>::halfedge_descriptor, 2> result;
  for(const auto sibling : mesh.siblings(h))
    for(const auto side : {sibling, opposite(sibling, mesh.tmesh())})
      if(!mesh.is_border_or_outside(side))
        result.push_back(side);
  return result;
}

template <typename UserMesh>
bool is_split_topologically_legal(const Working_mesh<UserMesh>& mesh,
                                  const typename Working_mesh<UserMesh>::halfedge_descriptor h)
{
  const auto& tm = mesh.tmesh();
  if(mesh.is_protected(h) || mesh.is_full())
    return false;
  // the two halves of the faces would meet along two edges between the same vertices
  if(!mesh.has_copies(source(h, tm)) && !mesh.has_copies(target(h, tm)))
    return !is_between_coincident_faces(h, tm);
  // two sheets must not be joined by a second junction
  std::vector<int> opposite_vertices;
  for(const auto side : sides_of_split(mesh, h))
    opposite_vertices.push_back(mesh.index(target(next(side, tm), tm)));
  if(!mesh.has_room_for(opposite_vertices.size()))
    return false;
  std::sort(opposite_vertices.begin(), opposite_vertices.end());
  return std::adjacent_find(opposite_vertices.begin(), opposite_vertices.end()) == opposite_vertices.end();
}

// Which triangles may a split leave?
enum Split_rule { GOOD_HALVES, ANY_HALVES };

// May the edge be split at the site? By the rule of good halves, none of the triangles it makes may be turned over, and none
// may be thinner than halving a triangle explains. Long strips between features consist of needles before they are
// split: where their normals are still right, their shape does not matter. Along a curve edges that are far too long
// are split in any case.
template <typename UserMesh>
bool is_split_legal(const Working_mesh<UserMesh>& mesh,
                    const typename Working_mesh<UserMesh>::halfedge_descriptor h, const Site& site,
                    const Split_rule rule = GOOD_HALVES)
{
  if(!is_split_topologically_legal(mesh, h))
    return false;
  // The two halves of a good triangle have two thirds of its quality or more. The arc of a curve may rise far into the
  // triangle, and has to be taken while there is room: what comes into the triangle later turns all its halves over.
  constexpr double share_of_half_inside = 0.4, share_of_half_at_arc = 0.1;
  const double share_of_half = mesh.is_on_curve(h) ? share_of_half_at_arc : share_of_half_inside;
  constexpr double least_score_of_half = 1e-4;
  const auto& tm = mesh.tmesh();
  const Reference& reference = mesh.reference();
  Worth after;
  const auto sides = sides_of_split(mesh, h);
  for(const auto side : sides)
  {
    const Site& opposite_site = mesh.site(target(next(side, tm), tm));
    after.add(worth(reference, mesh.site(source(side, tm)), site, opposite_site, mesh.hint(side)));
    after.add(worth(reference, site, mesh.site(target(side, tm)), opposite_site, mesh.hint(side)));
  }
  if(after.score >= score_floor)
    return true;
  Worth before;
  for(const auto side : sides)
    before.add(face_worth(mesh, side));
  // of flat triangles no operation would find back
  if(after.quality <= least_score_of_half && before.quality > least_score_of_half)
    return false;
  if(rule == ANY_HALVES)
    return true;
  // Nothing else follows a feature where the triangles at it are turned over, as at a fold of the model: there its
  // edges would keep the length of the input.
  constexpr double longest_length_on_curve = 4.;
  if(mesh.is_on_curve(h) && mesh.relative_length(h) > longest_length_on_curve)
    return true;
  return after.score > least_score_of_half ? after.score >= share_of_half * before.score
                                           : after.score > before.score + score_margin;
}

// Splits the edges that are longer than `bound` times their size, or farther from their feature curve than `slack`
// times what is allowed, each once, and only if `is_ready(halfedge)` when its turn comes. Only edges with changes around
// them are looked at.
template <typename UserMesh, typename IsReady>
std::size_t split_long_edges_once(Working_mesh<UserMesh>& mesh, const double bound, const std::size_t since,
                                  const Edge_order order, const double slack, const IsReady& is_ready,
                                  const Split_rule rule = GOOD_HALVES)
{
  typedef typename Working_mesh<UserMesh>::halfedge_descriptor halfedge_descriptor;
  const std::size_t before = mesh.counts().splits;
  const auto queue = collect_edges(mesh, since, order, [&](const halfedge_descriptor h)
                                   { return !mesh.is_protected(h)
                                            && (mesh.relative_length(h) > bound || !is_faithful(mesh, h, slack)); });
  // splits move no vertex, and the faces that they make have the hints of their origin: middles stay
  propose_and_accept(mesh, queue.begin(), queue.end(), [&](const auto& candidate)
                     { return mesh.is_full() ? Site() : middle_site(mesh, candidate.halfedge); },
                     [&](const auto& candidate, const Site& site, std::size_t)
  {
    if(is_ready(candidate.halfedge) && is_split_legal(mesh, candidate.halfedge, site, rule)
       && is_split_free(mesh, candidate.halfedge, site))
      mesh.split_edge(candidate.halfedge, site);
  });
  return mesh.counts().splits - before;
}

template <typename UserMesh>
std::size_t split_long_edges_once(Working_mesh<UserMesh>& mesh, const double bound, const std::size_t since,
                                  const Edge_order order = LONGEST_FIRST, const double slack = 1.)
{
  return split_long_edges_once(mesh, bound, since, order, slack, [](auto) { return true; });
}

// Rounds of splits, `split_once(since)`, until one of them changes nothing. What could not be split, and has not changed
// in the round before, is not tried again. Lengths halve, so the rounds end.
template <typename UserMesh, typename SplitOnce>
std::size_t split_in_rounds(Working_mesh<UserMesh>& mesh, std::size_t since, const SplitOnce& split_once)
{
  // halve the longest edge from the model's diameter to its rounding
  constexpr int maximum_number_of_rounds = 48;
  const std::size_t before = mesh.counts().splits;
  for(int round = 0; round < maximum_number_of_rounds && !mesh.is_stopped() && !mesh.is_full(); ++round)
  {
    const std::size_t number_of_changes = mesh.number_of_changes();
    if(split_once(since) == 0)
      break;
    since = number_of_changes;
  }
  return mesh.counts().splits - before;
}

// Edges that are still too long after one round are met again in the next. Where nearly all of them have to stay, because
// the model rises over needles by more than these are wide and turns their halves over, they are split nevertheless: what
// is turned while its neighbours wait for the same is mended by flips.
template <typename UserMesh>
std::size_t split_long_edges(Working_mesh<UserMesh>& mesh, const double bound, const std::size_t since,
                             const double slack = 1.)
{
  std::size_t number_of_tries = 0;
  const auto note_try = [&](auto) { ++number_of_tries; return true; };
  const auto split_by = [&](const Split_rule rule)
  {
    return split_in_rounds(mesh, since, [&](const std::size_t since_round)
    { return split_long_edges_once(mesh, bound, since_round, LONGEST_FIRST, slack, note_try, rule); });
  };
  // of the edges that stay, and these of the faces: less than that is nothing
  constexpr double negligible_part = 0.1, considerable_part_of_faces = 0.1;
  const std::size_t number = split_by(GOOD_HALVES);
  const double least_considerable = considerable_part_of_faces * double(mesh.number_of_faces());
  double number_left = 0.;
  // those that stay have been tried
  if(double(number) < negligible_part * double(mesh.number_of_faces())
     && double(number_of_tries - number) > least_considerable)
    Changed_edges<UserMesh>(mesh, since).visit([&](const auto h)
    {
      if(mesh.relative_length(h) > bound && !mesh.is_protected(h) && mesh.is_inside(edge(h, mesh.tmesh())))
        ++number_left;
    });
  if(double(number) < negligible_part * number_left && number_left > least_considerable)
    return number + split_by(ANY_HALVES);
  return number;
}

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_SPLIT_LONG_EDGES_H
