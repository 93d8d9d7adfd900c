// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_COLLAPSE_SHORT_EDGES_H
#define CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_COLLAPSE_SHORT_EDGES_H

#include <CGAL/Hermite_diffuse_remeshing/internal/Transformation/Edge_queue.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Transformation/curve_fidelity.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Transformation/is_free.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Transformation/legality.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Transformation/propose_and_accept.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Transformation/split_long_edges.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/edge_topology.h>

#include <boost/container/static_vector.hpp>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Hermite_diffuse_remeshing {
namespace internal {

// Would the collapse of h join two vertices that are joined already in another sheet?
template <typename UserMesh>
bool does_collapse_make_junction(const Working_mesh<UserMesh>& mesh,
                                 const typename Working_mesh<UserMesh>::halfedge_descriptor h)
{
  const auto& tm = mesh.tmesh();
  const auto s = source(h, tm), t = target(h, tm);
  for(const auto g : CGAL::halfedges_around_target(s, tm))
  {
    const auto w = source(g, tm);
    if(w != t && (mesh.has_copies(w) || mesh.has_copies(t)) && !halfedge(w, t, tm).second && mesh.are_joined(w, t))
      return true;
  }
  return false;
}

// May the source of h disappear into its target, as far as features and topology go? A corner and a
// frozen vertex stay; a vertex of a curve moves only along its curve; two features are not
// brought together across the surface.
template <typename UserMesh>
bool is_collapse_topologically_legal(const Working_mesh<UserMesh>& mesh,
                                     const typename Working_mesh<UserMesh>::halfedge_descriptor h)
{
  const auto& tm = mesh.tmesh();
  const auto s = source(h, tm);
  if(mesh.is_fixed(s) || mesh.is_protected(h))
    return false;
  if(mesh.data(s).type == CURVE_VERTEX && !mesh.is_on_curve(h))
    return false;
  const auto siblings = mesh.siblings(h);
  // a copy that does not go along would be left behind
  if(mesh.has_copies(s) && siblings.size() != mesh.copies(s).size())
    return false;
  for(const auto sibling : siblings)
  {
    // an ear between two edges of one curve would fold the curve over
    for(const auto side : {prev(sibling, tm), next(opposite(sibling, tm), tm)})
      if(mesh.is_on_curve(side) && mesh.data(s).type == CURVE_VERTEX && !CGAL::is_border(side, tm))
        return false;
    if(!is_collapse_manifold(sibling, tm) || does_collapse_make_junction(mesh, sibling))
      return false;
  }
  return true;
}

// If both ends of h came to a point with a size, would no edge be longer than `longest_length` times its size?
template <typename UserMesh>
bool are_edges_short_after_collapse(const Working_mesh<UserMesh>& mesh,
                                    const typename Working_mesh<UserMesh>::halfedge_descriptor h,
                                    const Vector& point, const double size, const double longest_length)
{
  const auto& tm = mesh.tmesh();
  for(const auto sibling : mesh.siblings(h))
  {
    const auto s = source(sibling, tm), t = target(sibling, tm);
    for(const auto v : {s, t})
      for(const auto g : CGAL::halfedges_around_target(v, tm))
      {
        const auto w = source(g, tm);
        if(w == s || w == t)
          continue;
        if((mesh.point(w) - point).squaredNorm() > CGAL::square(longest_length * (mesh.size(w) + size) / 2.))
          return false;
      }
  }
  return true;
}

// The edges that the collapse makes may not be longer than `longest_length` times their size, nor leave a feature
// curve.
template <typename UserMesh>
bool are_edges_acceptable_after_collapse(const Working_mesh<UserMesh>& mesh,
                                         const typename Working_mesh<UserMesh>::halfedge_descriptor h,
                                         const Site& site, const double longest_length)
{
  return (!mesh.is_on_curve(h) || is_curve_collapse_faithful(mesh, h, site))
      && are_edges_short_after_collapse(mesh, h, site.point, site.size, longest_length);
}

// the triangles that the collapse leaves around the vertex that stays
template <typename UserMesh>
Star star_after_collapse(const Working_mesh<UserMesh>& mesh,
                         const typename Working_mesh<UserMesh>::halfedge_descriptor h, const Star::Objective objective)
{
  Star star(mesh.reference(), objective);
  for(const auto sibling : mesh.siblings(h))
  {
    const auto s = source(sibling, mesh.tmesh()), t = target(sibling, mesh.tmesh());
    star.add(mesh, s, t);
    star.add(mesh, t, s);
  }
  return star;
}

// Places for the vertex that stays, best first.
template <typename UserMesh>
boost::container::static_vector<Site, 2>
collapse_sites(const Working_mesh<UserMesh>& mesh, const typename Working_mesh<UserMesh>::halfedge_descriptor h)
{
  const auto s = source(h, mesh.tmesh()), t = target(h, mesh.tmesh());
  boost::container::static_vector<Site, 2> sites;
  if(!mesh.is_fixed(t) && mesh.data(s).type == mesh.data(t).type)
    sites.push_back(middle_site(mesh, h));
  sites.push_back(mesh.data(t).site);
  return sites;
}

// A collapse of an edge that is legal and makes no bad triangle; whether these meet others is still to be asked.
template <typename UserMesh>
struct Collapse
{
  static constexpr int number_of_choices = 4;

  int choice = number_of_choices;       // two places in one direction, then two in the other; the last: none is legal
  typename Working_mesh<UserMesh>::halfedge_descriptor halfedge;
  Site site;

  bool is_legal() const { return choice < number_of_choices; }
};

// Of equal needles side by side each collapse makes some that are a little worse, before it makes good triangles in the
// end: the first one of an even row makes one that is half as wide again.
constexpr double least_part_of_needle = 0.65;
// relative to the size
constexpr double length_of_needle = 0.25;

// The first legal choice from `first_choice` on for the edge of h, at the best place that is legal, if possible of the
// source of h. The worst score may fall to `least_part` of itself.
template <typename UserMesh>
Collapse<UserMesh> find_collapse(const Working_mesh<UserMesh>& mesh,
                                 const typename Working_mesh<UserMesh>::halfedge_descriptor h, const int first_choice,
                                 const double longest_length, const double least_part)
{
  typedef Collapse<UserMesh> Result;
  Result result;
  if(first_choice >= Result::number_of_choices)
    return result;
  const auto worth_before = [&]
  {
    Worth result = worth_around(mesh, source(h, mesh.tmesh()));
    result.add(worth_around(mesh, target(h, mesh.tmesh())));
    result.score *= result.score > 0. ? least_part : 1.;
    return result;
  };
  // Nearly all edges that may not collapse are refused for the lengths around, which need not wait for the model's
  // middle: it is not so far from the chord's, nor its size from the mean.
  constexpr double clearly_too_long = 1.1;
  const Site& s = mesh.site(source(h, mesh.tmesh()));
  const Site& t = mesh.site(target(h, mesh.tmesh()));
  const bool may_middle_do = are_edges_short_after_collapse(mesh, h, (s.point + t.point) / 2., (s.size + t.size) / 2.,
                                                            clearly_too_long * longest_length);
  for(int direction = 2 * first_choice / Result::number_of_choices; direction < 2; ++direction)
  {
    result.halfedge = direction == 0 ? h : opposite(h, mesh.tmesh());
    const Site& end = mesh.site(target(result.halfedge, mesh.tmesh()));
    if(!may_middle_do && !are_edges_short_after_collapse(mesh, h, end.point, end.size, longest_length))
      continue;
    if(!is_collapse_topologically_legal(mesh, result.halfedge))
      continue;
    const Star star = star_after_collapse(mesh, result.halfedge, Star::MEAN);
    int choice = direction * Result::number_of_choices / 2;
    for(const Site& site : collapse_sites(mesh, result.halfedge))
    {
      if(choice >= first_choice && are_edges_acceptable_after_collapse(mesh, result.halfedge, site, longest_length)
         && is_acceptable(star.worth(site), worth_before, score_floor))
      {
        result.choice = choice;
        result.site = site;
        return result;
      }
      ++choice;
    }
  }
  return result;
}

// Collapses the edges that are shorter than `bound` times their size where no edge becomes longer than
// `longest_length` times its size, what a collapse makes is not split again: the shortest first. Only edges with changes
// around them are looked at. `least_part`: see `find_collapse()`. Returns how many edges are
// about as short as needles, relative to the size.
template <typename UserMesh>
std::size_t collapse_short_edges(Working_mesh<UserMesh>& mesh, const double bound, const double longest_length,
                          const std::size_t since, const double least_part)
{
  typedef Working_mesh<UserMesh> Mesh;
  typedef typename Mesh::halfedge_descriptor halfedge_descriptor;
  typedef typename Mesh::vertex_descriptor vertex_descriptor;
  // both before the pass and when its turn comes
  const auto is_candidate = [&](const halfedge_descriptor h)
  { return mesh.relative_length(h) < bound && !mesh.is_protected(h); };

  // ends as descriptors and numbers: a collapse of a neighbour may have removed the edge
  struct Candidate { vertex_descriptor source, target; std::pair<int, int> key; };
  std::vector<Candidate> queue;
  std::size_t number_of_needles = 0;
  for(const auto& e : collect_edges(mesh, since, SHORTEST_FIRST, is_candidate))
  {
    queue.push_back({source(e.halfedge, mesh.tmesh()), target(e.halfedge, mesh.tmesh()), e.key});
    number_of_needles += e.level >= SHORTEST_FIRST * urgency_level(length_of_needle);
  }

  std::vector<char> is_removed(mesh.number_of_vertex_slots(), false);
  // null if the edge is no candidate any more
  const auto find_edge = [&](const Candidate& candidate)
  {
    const halfedge_descriptor none = Mesh::Graph_traits::null_halfedge();
    if(is_removed[candidate.key.first] || is_removed[candidate.key.second])
      return none;
    const std::pair<halfedge_descriptor, bool> found = halfedge(candidate.source, candidate.target, mesh.tmesh());
    if(!found.second || !is_candidate(found.first))
      return none;
    // the vertex with the smaller number stays where both may: the same for every mesh type
    return mesh.index(source(found.first, mesh.tmesh())) < mesh.index(target(found.first, mesh.tmesh()))
         ? opposite(found.first, mesh.tmesh()) : found.first;
  };
  const auto propose_from = [&](const Candidate& candidate, const int first_choice)
  {
    const halfedge_descriptor h = find_edge(candidate);
    return h == Mesh::Graph_traits::null_halfedge() ? Collapse<UserMesh>()
         : find_collapse(mesh, h, first_choice, longest_length, least_part);
  };
  propose_and_accept(mesh, queue.begin(), queue.end(), [&](const Candidate& candidate) { return propose_from(candidate, 0); },
                     [&](const Candidate& candidate, Collapse<UserMesh> collapse, const std::size_t since_proposal)
  {
    if(is_removed[candidate.key.first] || is_removed[candidate.key.second])
      return;
    // what is proposed depends on the faces around the ends
    if(mesh.has_changed(candidate.source, since_proposal) || mesh.has_changed(candidate.target, since_proposal))
      collapse = propose_from(candidate, 0);
    for(; collapse.is_legal(); collapse = propose_from(candidate, collapse.choice + 1))
      if(is_collapse_free(mesh, collapse.halfedge, collapse.site))
      {
        is_removed[mesh.index(source(collapse.halfedge, mesh.tmesh()))] = true;
        mesh.collapse_edge(collapse.halfedge, collapse.site);
        return;
      }
  });
  return number_of_needles;
}

// Same, and where nearly all of the shortest edges have to stay for the needles around them, these are given up.
template <typename UserMesh>
std::size_t collapse_short_edges(Working_mesh<UserMesh>& mesh, const double bound, const double longest_length,
                                 const std::size_t since)
{
  // of the edges of needles, and these of the faces: less than that is nothing
  constexpr double negligible_part = 0.1, negligible_part_of_faces = 0.02;
  const std::size_t before = mesh.counts().collapses;
  const double number_of_needles = double(collapse_short_edges(mesh, bound, longest_length, since, 1.));
  // where nearly all have stayed, there are as many now
  if(double(mesh.counts().collapses - before) < negligible_part * number_of_needles
     && number_of_needles > negligible_part_of_faces * double(mesh.number_of_faces()))
    collapse_short_edges(mesh, length_of_needle, longest_length, since, least_part_of_needle);
  return mesh.counts().collapses - before;
}

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_COLLAPSE_SHORT_EDGES_H
