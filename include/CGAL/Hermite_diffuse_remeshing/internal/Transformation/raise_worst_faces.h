// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_RAISE_WORST_FACES_H
#define CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_RAISE_WORST_FACES_H

#include <CGAL/Hermite_diffuse_remeshing/internal/Transformation/Face_queue.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Transformation/collapse_short_edges.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Transformation/flip_and_relocate.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Transformation/flip_edges.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Transformation/relocate_vertices.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Transformation/remove_vertices.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Transformation/slide_from_corner.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Transformation/split_and_flip.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Transformation/split_long_edges.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <set>
#include <variant>
#include <vector>

namespace CGAL {
namespace Hermite_diffuse_remeshing {
namespace internal {

// Hunts the worst faces of the whole mesh one by one, from a queue, with every operator and their short
// combinations. An operation is done if the worst face that it makes is better than the worst of those
// that it replaces, so the smallest quality of the mesh never falls, nor does the smallest score, but for needles that
// give way to better triangles. Every step raises a score by the margin or doubles a quality at least, and a face for
// which none is found waits until something changes beside it; as many small steps would take too long, the
// number of tries is bounded too: the hunt ends.
template <typename UserMesh>
class Worst_face_hunt
{
  typedef Working_mesh<UserMesh> Mesh;
  typedef typename Mesh::vertex_descriptor vertex_descriptor;
  typedef typename Mesh::halfedge_descriptor halfedge_descriptor;
  typedef typename Mesh::face_descriptor face_descriptor;

  enum Kind { NOTHING, FLIP, RELOCATION, COLLAPSE, SPLIT, OPERATION };

  // The best operation is free of intersections as a rule; not all are asked for them before there is a need.
  enum Search { BEST_SCORE, BEST_FREE_SCORE, BEST_FREE_QUALITY };

  // the best operation found so far for a face
  struct Plan
  {
    Search search = BEST_SCORE;
    Kind kind = NOTHING;
    Worth after{-1., 0.};
    halfedge_descriptor halfedge = halfedge_descriptor();
    vertex_descriptor vertex = vertex_descriptor();
    Site site = Site();
    std::variant<Vertex_removal<UserMesh>, Edge_removal<UserMesh>, Curve_vertex_removal<UserMesh>,
                 Flip_and_relocation<UserMesh>, Split_and_flip<UserMesh>, Slide_from_corner<UserMesh> > operation = {};
  };

  Mesh& m_mesh;
  double m_satisfying_score, m_satisfying_quality;
  Face_queue<UserMesh> m_queue;
  std::set<Face_corners> m_given_way;   // needles that were raised at the expense of a score

  // shape comes before size here, but not without limit: lengths relative to the size
  static constexpr double longest_length = 2., shortest_length_to_split = 1.;
  // per face that is bad at first; one that can be helped is after a few tries
  static constexpr std::size_t maximum_number_of_tries = 20;
  // per face of the mesh: where nearly all are bad most tries are in vain
  static constexpr std::size_t maximum_number_of_tries_of_mesh = 3;
  // a vertex of a long protected edge may have hundreds of bad faces: pairs of its edges are not tried
  static constexpr std::size_t largest_degree = 24;
  // of a triangle with an angle of five degrees, the normal of which turns by forty when a vertex moves by a
  // fourteenth of its length
  static constexpr double needle_quality = 0.1;
  // Between corners that are close to each other a needle is the better the shorter it is.
  static constexpr double shortest_length_to_split_of_needle = 0.25;

public:
  // Faces with a better score, or with a better quality, are not worth a search.
  Worst_face_hunt(Mesh& mesh, const double satisfying_score, const double satisfying_quality)
    : m_mesh(mesh), m_satisfying_score(satisfying_score), m_satisfying_quality(satisfying_quality), m_queue(mesh)
  {}

  // returns the number of operations
  std::size_t run(const std::size_t since)
  {
    std::size_t step = 0;
    for(const face_descriptor f : faces(m_mesh.tmesh()))
    {
      if(m_mesh.is_stopped_at(step++))
        return 0;
      // what keeps a needle may be another sheet, which has gone since
      if(m_mesh.is_remeshed(f) && (m_mesh.has_changed(f, since) || is_needle(halfedge(f, m_mesh.tmesh()))))
        push(halfedge(f, m_mesh.tmesh()));
    }
    std::size_t number = 0;
    const std::size_t last_try = (std::min)(maximum_number_of_tries * m_queue.size(),
                                            maximum_number_of_tries_of_mesh * m_mesh.number_of_faces());
    for(std::size_t i = 0; i < last_try && !m_queue.is_empty() && !m_mesh.is_stopped(); ++i)
    {
      const halfedge_descriptor h = m_queue.pop();
      if(h == Mesh::Graph_traits::null_halfedge())
        continue;                       // has been replaced
      m_mesh.start_log();
      if(raise(h))
      {
        ++number;
        push_changed();
      }
      else
        m_queue.note_failure(h);
      m_mesh.stop_log();
    }
    return number;
  }

  enum Prospect { NO_OPERATION, NOT_FREE, FREE };

  // Is there an operation that raises a face, and is it free of intersections?
  Prospect prospect(const halfedge_descriptor h) const
  {
    const Plan plan = best_plan(h, BEST_SCORE);
    return plan.kind == NOTHING ? NO_OPERATION
         : is_free(plan) || best_plan(h, BEST_FREE_SCORE).kind != NOTHING ? FREE : NOT_FREE;
  }

private:
  bool raise(const halfedge_descriptor h)
  {
    const Plan plan = best_plan(h, BEST_SCORE);
    return execute(plan) || (plan.kind != NOTHING && execute(best_plan(h, BEST_FREE_SCORE)))
        || (is_needle(h) && give_way(h));
  }

  // What gives way to a better shape may have a better score, and come back for that: each face does so once.
  bool give_way(const halfedge_descriptor h)
  {
    const Face_corners corners = m_queue.corners(h);
    if(m_given_way.count(corners) != 0 || !execute(best_plan(h, BEST_FREE_QUALITY)))
      return false;
    m_given_way.insert(corners);
    return true;
  }

  bool is_needle(const halfedge_descriptor h) const { return face_worth(m_mesh, h).quality < needle_quality; }

  void push(const halfedge_descriptor h)
  {
    const Worth worth = face_worth(m_mesh, h);
    if(worth.score < m_satisfying_score && worth.quality < m_satisfying_quality)
      m_queue.push(h);
  }

  void push_changed()
  {
    std::vector<int> changed = m_mesh.log();
    std::sort(changed.begin(), changed.end());
    changed.erase(std::unique(changed.begin(), changed.end()), changed.end());
    for(const int i : changed)
      if(m_mesh.vertex(i) != Mesh::Graph_traits::null_vertex())
        m_mesh.visit_copies(m_mesh.vertex(i), [&](const vertex_descriptor v)
        {
          for(const halfedge_descriptor h : CGAL::halfedges_around_target(v, m_mesh.tmesh()))
            if(!m_mesh.is_border_or_outside(h))
              push(h);
        });
  }

  // tries everything at a face
  Plan best_plan(const halfedge_descriptor h, const Search search) const
  {
    const auto& tm = m_mesh.tmesh();
    const std::array<halfedge_descriptor, 3> sides = {{h, next(h, tm), prev(h, tm)}};
    Plan plan;
    plan.search = search;
    for(const halfedge_descriptor side : sides)
    {
      plan_flip(side, plan);
      plan_relocation(target(side, tm), plan);
    }
    if(plan.after.score >= m_satisfying_score)
      return plan;
    const double shortest_to_split = is_needle(h) ? shortest_length_to_split_of_needle : shortest_length_to_split;
    for(const halfedge_descriptor side : sides)
    {
      plan_collapse(side, plan);
      plan_collapse(opposite(side, tm), plan);
      if(m_mesh.relative_length(side) >= shortest_to_split)
        plan_split(side, plan);
      if(degree(target(side, tm), tm) <= largest_degree)
        plan_removals(side, plan);
    }
    // these take as long as all others together
    if(plan.kind == NOTHING)
      for(const halfedge_descriptor side : sides)
        if(degree(target(side, tm), tm) <= largest_degree)
          plan_flips_and_relocation(target(side, tm), plan);
    if(plan.kind == NOTHING)
      for(const halfedge_descriptor side : sides)
        plan_slide(side, plan);
    if(plan.kind == NOTHING)
      for(const halfedge_descriptor side : sides)
        if(m_mesh.relative_length(side) >= shortest_to_split)
          plan_splits_and_flips(side, plan);
    return plan;
  }

  // The normal of a needle says little. Where no score can be raised a triangle of twice its quality may take its place,
  // however far from the model's normal, as long as it is not turned over, or flat beside one that is.
  static bool improves(const Worth& after, const Worth& before, const Plan& plan)
  {
    if(plan.search != BEST_FREE_QUALITY)
      return is_better(after, before) && after.score > plan.after.score + score_margin;
    const bool is_flat_at_fold = before.score < 0. && before.quality < least_score;
    return before.quality < needle_quality && (is_flat_at_fold || after.score > (std::min)(0., before.score))
        && after.quality > (std::max)(2. * before.quality, plan.after.quality) + score_margin;
  }

  void offer(const Plan& candidate, Plan& plan) const
  {
    if(plan.search == BEST_SCORE || is_free(candidate))
      plan = candidate;
  }

  void plan_flip(const halfedge_descriptor h, Plan& plan) const
  {
    if(!is_flip_topologically_legal(m_mesh, h))
      return;
    const Worth after = worth_after_flip(m_mesh, h);
    if(improves(after, worth_of_pair(m_mesh, h), plan))
      offer({plan.search, FLIP, after, h}, plan);
  }

  void plan_relocation(const vertex_descriptor v, Plan& plan) const
  {
    if(m_mesh.is_fixed(v))
      return;
    Star star(m_mesh.reference(), Star::WORST);
    star.add(m_mesh, v);
    const Site site = better_site(m_mesh, v, star);
    const Worth after = star.worth(site);
    if(improves(after, star.worth(m_mesh.site(v)), plan))
      offer({plan.search, RELOCATION, after, halfedge(v, m_mesh.tmesh()), v, site}, plan);
  }

  void plan_collapse(const halfedge_descriptor h, Plan& plan) const
  {
    if(!is_collapse_topologically_legal(m_mesh, h))
      return;
    const vertex_descriptor s = source(h, m_mesh.tmesh()), t = target(h, m_mesh.tmesh());
    Worth before = worth_around(m_mesh, s);
    before.add(worth_around(m_mesh, t));
    const Star star = star_after_collapse(m_mesh, h, Star::WORST);
    auto sites = collapse_sites(m_mesh, h);
    if(m_mesh.data(s).type == SURFACE_VERTEX && !m_mesh.is_fixed(t) && m_mesh.data(t).type == SURFACE_VERTEX)
      sites[0] = star.better_site(sites[0]);
    for(const Site& site : sites)
    {
      const Worth after = star.worth(site);
      if(improves(after, before, plan) && are_edges_acceptable_after_collapse(m_mesh, h, site, longest_length))
        offer({plan.search, COLLAPSE, after, h, t, site}, plan);
    }
  }

  void plan_split(const halfedge_descriptor h, Plan& plan) const
  {
    const auto& tm = m_mesh.tmesh();
    if(!is_split_topologically_legal(m_mesh, h))
      return;
    Star star(m_mesh.reference(), Star::WORST);
    Worth before;
    for(const halfedge_descriptor side : sides_of_split(m_mesh, h))
    {
      before.add(face_worth(m_mesh, side));
      star.add_side(m_mesh, next(side, tm));
      star.add_side(m_mesh, prev(side, tm));
    }
    const Site site = better_site_of_split(m_mesh, h, star);
    const Worth after = star.worth(site);
    if(improves(after, before, plan))
      offer({plan.search, SPLIT, after, h, target(h, tm), site}, plan);
  }

  // an operation that has a class of its own, at an element or several
  template <typename Operation, typename... Elements>
  void plan_operation(Plan& plan, const Worth& before, const Elements&... elements) const
  {
    Operation operation;
    const Worth after = operation.plan(m_mesh, elements...);
    if(improves(after, before, plan))
      offer({plan.search, OPERATION, after, halfedge_descriptor(), vertex_descriptor(), Site(), operation}, plan);
  }

  void plan_removals(const halfedge_descriptor h, Plan& plan) const
  {
    const auto& tm = m_mesh.tmesh();
    const vertex_descriptor v = target(h, tm);
    Worth before = worth_around(m_mesh, v);
    plan_operation<Vertex_removal<UserMesh> >(plan, before, v);
    if(m_mesh.data(v).type == CURVE_VERTEX)
      for(const halfedge_descriptor g : CGAL::halfedges_around_target(v, tm))
        plan_operation<Curve_vertex_removal<UserMesh> >(plan, before, opposite(g, tm));
    before.add(worth_around(m_mesh, source(h, tm)));
    plan_operation<Edge_removal<UserMesh> >(plan, before, h);
  }

  // the edge of h is split, and one of the other sides of its faces flipped
  void plan_splits_and_flips(const halfedge_descriptor h, Plan& plan) const
  {
    const auto& tm = m_mesh.tmesh();
    for(const halfedge_descriptor side : {h, opposite(h, tm)})
      if(!m_mesh.is_border_or_outside(side))
        for(const halfedge_descriptor flipped : {next(side, tm), prev(side, tm)})
          plan_split_and_flip(side, flipped, plan);
  }

  void plan_split_and_flip(const halfedge_descriptor h, const halfedge_descriptor flipped, Plan& plan) const
  {
    if(!is_flippable(m_mesh, flipped))
      return;
    Worth before = worth_of_pair(m_mesh, flipped);
    for(const halfedge_descriptor side : sides_of_split(m_mesh, h))
      before.add(face_worth(m_mesh, side));
    plan_operation<Split_and_flip<UserMesh> >(plan, before, h, flipped);
  }

  void plan_slide(const halfedge_descriptor h, Plan& plan) const
  {
    const auto& tm = m_mesh.tmesh();
    if(!m_mesh.is_on_curve(next(h, tm)) || !m_mesh.is_on_curve(prev(h, tm)))
      return;
    Worth before = worth_around(m_mesh, source(h, tm));
    before.add(worth_around(m_mesh, target(h, tm)));
    plan_operation<Slide_from_corner<UserMesh> >(plan, before, h, before, longest_length);
  }

  // an edge at v or opposite to v is flipped, and v moves
  void plan_flips_and_relocation(const vertex_descriptor v, Plan& plan) const
  {
    const auto& tm = m_mesh.tmesh();
    if(m_mesh.data(v).type != SURFACE_VERTEX || m_mesh.is_fixed(v))
      return;
    const Worth around = worth_around(m_mesh, v);
    for(const halfedge_descriptor h : CGAL::halfedges_around_target(v, tm))
      for(const halfedge_descriptor flipped : {h, opposite(prev(h, tm), tm)})
      {
        if(!is_flip_topologically_legal(m_mesh, flipped))
          continue;
        Worth before = around;
        if(flipped != h)
          before.add(face_worth(m_mesh, flipped));
        const double least = plan.search == BEST_FREE_QUALITY ? -1. : (std::max)(before.score, plan.after.score);
        plan_operation<Flip_and_relocation<UserMesh> >(plan, before, h, flipped, least);
      }
  }

  bool is_free(const Plan& plan) const
  {
    switch(plan.kind)
    {
      case NOTHING:              return false;
      case FLIP:                 return is_flip_free(m_mesh, plan.halfedge);
      case RELOCATION:           return is_relocation_free(m_mesh, plan.vertex, plan.site);
      case COLLAPSE:             return is_collapse_free(m_mesh, plan.halfedge, plan.site);
      case SPLIT:                return is_split_free(m_mesh, plan.halfedge, plan.site);
      case OPERATION:            return std::visit([&](const auto& o) { return o.is_free(m_mesh); }, plan.operation);
    }
    return false;
  }

  bool execute(const Plan& plan)
  {
    if(!is_free(plan))
      return false;
    switch(plan.kind)
    {
      case NOTHING:              return false;
      case FLIP:                 m_mesh.flip_edge(plan.halfedge); break;
      case RELOCATION:           m_mesh.relocate(plan.vertex, plan.site); break;
      case COLLAPSE:             m_mesh.collapse_edge(plan.halfedge, plan.site); break;
      case SPLIT:                m_mesh.split_edge(plan.halfedge, plan.site); break;
      case OPERATION:            std::visit([&](const auto& o) { o.execute(m_mesh); }, plan.operation); break;
    }
    return true;
  }
};

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_RAISE_WORST_FACES_H
