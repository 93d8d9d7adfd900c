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
#include <CGAL/Hermite_diffuse_remeshing/internal/Transformation/legality.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Transformation/split_long_edges.h>

#include <boost/container/static_vector.hpp>

#include <algorithm>

namespace CGAL {
namespace Hermite_diffuse_remeshing {
namespace internal {

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
  // an ear between two edges of one curve would fold the curve over
  for(const auto side : {prev(h, tm), next(opposite(h, tm), tm)})
    if(mesh.is_on_curve(side) && mesh.data(s).type == CURVE_VERTEX && !CGAL::is_border(side, tm))
      return false;
  return CGAL::Euler::does_satisfy_link_condition(edge(h, tm), tm);
}

// Worst score and longest relative length around the vertex that a collapse leaves.
template <typename UserMesh>
bool is_collapse_geometrically_legal(const Working_mesh<UserMesh>& mesh,
                                     const typename Working_mesh<UserMesh>::halfedge_descriptor h,
                                     const Site& site, const double longest_length, const double score_before)
{
  const auto& tm = mesh.tmesh();
  const auto s = source(h, tm), t = target(h, tm);
  for(const auto v : {s, t})
    for(const auto g : CGAL::halfedges_around_target(v, tm))
    {
      const auto w = source(g, tm);
      if(w == s || w == t)
        continue;
      if((mesh.point(w) - site.point).norm() > longest_length * (mesh.size(w) + site.size) / 2.)
        return false;
    }
  const double after = (std::min)(worst_score_around(mesh, s, site.point, t),
                                  worst_score_around(mesh, t, site.point, s));
  return is_score_acceptable(after, score_before, score_floor);
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

// Collapses the edges that are shorter than `bound` times their size, shortest first, where no edge
// becomes longer than `longest_length` times its size: what a collapse makes is not split again.
template <typename UserMesh>
std::size_t collapse_short_edges(Working_mesh<UserMesh>& mesh, const double bound, const double longest_length)
{
  typedef Working_mesh<UserMesh> Mesh;
  typedef typename Mesh::halfedge_descriptor halfedge_descriptor;
  typedef typename Mesh::vertex_descriptor vertex_descriptor;
  const std::size_t before = mesh.counts().collapses;

  // ends as descriptors and numbers: a collapse of a neighbour may have removed the edge
  struct Candidate { vertex_descriptor source, target; std::pair<int, int> key; };
  std::vector<Candidate> queue;
  for(const auto& e : collect_edges(mesh, -1, [&](const halfedge_descriptor h, const double length)
                                    { return length < bound && !mesh.is_protected(h); }))
    queue.push_back({source(e.halfedge, mesh.tmesh()), target(e.halfedge, mesh.tmesh()), e.key});

  std::vector<char> is_touched(mesh.number_of_vertex_slots(), false);
  for(const Candidate& candidate : queue)
  {
    if(mesh.is_stopped())
      break;
    // vertices that an earlier collapse of this pass has removed or moved wait for the next one
    if(is_touched[candidate.key.first] || is_touched[candidate.key.second])
      continue;
    const std::pair<halfedge_descriptor, bool> found = halfedge(candidate.source, candidate.target, mesh.tmesh());
    if(!found.second || mesh.relative_length(found.first) >= bound)
      continue;
    halfedge_descriptor h = found.first;
    // the vertex with the smaller number stays where both may: the same for every mesh type
    if(mesh.index(source(h, mesh.tmesh())) < mesh.index(target(h, mesh.tmesh())))
      h = opposite(h, mesh.tmesh());
    const double score_before = (std::min)(worst_score_around(mesh, candidate.source),
                                           worst_score_around(mesh, candidate.target));
    bool is_done = false;
    for(const halfedge_descriptor d : {h, opposite(h, mesh.tmesh())})
    {
      if(is_done || !is_collapse_topologically_legal(mesh, d))
        continue;
      for(const Site& site : collapse_sites(mesh, d))
        if(is_collapse_geometrically_legal(mesh, d, site, longest_length, score_before))
        {
          const int removed = mesh.index(source(d, mesh.tmesh()));
          mesh.collapse_edge(d, site);
          is_touched[removed] = true;
          is_done = true;
          break;
        }
      if(is_done)
        break;
    }
  }
  return mesh.counts().collapses - before;
}

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_COLLAPSE_SHORT_EDGES_H
