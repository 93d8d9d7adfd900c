// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_GUARDED_MESH_H
#define CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_GUARDED_MESH_H

#include <CGAL/Hermite_diffuse_remeshing/internal/Transformation/Clear_ball.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Transformation/Followed_mesh.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Transformation/Intersection_guard.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Transformation/Sheet_search.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <vector>

namespace CGAL {
namespace Hermite_diffuse_remeshing {
namespace internal {

// Tells whether an operation would make triangles that meet others.
//
// Most operations take place where the surface is a single sheet, and are allowed without a search: in a clear
// ball all faces hang together and, seen along an axis, lie side by side and face the viewer. There an operation
// that fills a contour anew with triangles that face the viewer too cannot make them meet: seen from the axis they
// cover the inside of the contour once. A ball is found by one search and serves all operations inside it from then
// on, whatever vertices come and go there: each vertex remembers the ball that it lies deepest in, and asks its
// neighbours for theirs.
template <typename UserMesh>
class Guarded_mesh : public Followed_mesh<UserMesh>
{
  typedef Followed_mesh<UserMesh> Base;

public:
  typedef typename Base::TriangleMesh TriangleMesh;
  typedef typename Base::Graph_traits Graph_traits;
  typedef typename Base::vertex_descriptor vertex_descriptor;
  typedef typename Base::halfedge_descriptor halfedge_descriptor;
  typedef typename Base::face_descriptor face_descriptor;

private:
  typedef typename Base::Surroundings Surroundings;

  using Base::m_guard;
  using Base::m_balls;
  using Base::m_surroundings;

  std::unique_ptr<Sheet_search<UserMesh> > m_search;

  // A search looks farther than asked for, as many times as far, so that its ball serves the neighbours too.
  static constexpr double reach_of_search = 5.;
  // It gets there in steps, for in most places a face that turns from the others ends it before.
  static constexpr double growth_of_reach = 1.2;
  // Where no ball can be as many times as large as asked for, it takes less time to test the faces near by than to find it.
  static constexpr double least_useful_ball = 2.;
  // Sheets move a little when they are remeshed, by the sagitta of their triangles: a ball is as many times smaller
  // than what is clear.
  static constexpr double clearance = 1.25;
  // Of the height of what is to be done, and of its radius: a slice that is no higher would not serve the neighbours.
  static constexpr double headroom = 1.5, least_part_of_height = 0.05;

public:
  using Base::tmesh;
  using Base::index;
  using Base::point;
  using Base::triangle;
  using Base::visit_copies;

  template <typename IsFrozen>
  Guarded_mesh(const UserMesh& user, const Reference& reference,
               const std::vector<face_descriptor>& faces_of_reference,
               const std::vector<char>& is_remeshed,
               const IsFrozen& is_edge_frozen, const bool is_guarded)
    : Base(user, reference, faces_of_reference, is_remeshed, is_edge_frozen, is_guarded)
  {
    if(is_guarded)
      m_search.reset(new Sheet_search<UserMesh>(*this, this->m_user.tmesh));
  }

  // Does an operation take place in a clear ball? `center`: a vertex at which it takes place, if nothing changes but
  // what is inside a contour; null otherwise.
  template <typename Triangles>
  bool is_clear(const vertex_descriptor center, const Triangles& made, const Triangles& replaced)
  {
    if(center == Graph_traits::null_vertex())
      return false;
    const double squared_radius =
      largest_at_corners<Triangles>({&made, &replaced}, [&](const Vector& p) { return (p - point(center)).squaredNorm(); });
    const int ball = find_ball(center, std::sqrt(squared_radius), {&made, &replaced});
    return ball != -1
        && std::all_of(made.begin(), made.end(), [&](const auto& t) { return m_balls[ball].is_faced_by(t); });
  }

  // May the one triangles take the place of the others?
  bool is_free(const vertex_descriptor center, const Numbered_triangles& made, const Numbered_triangles& replaced)
  {
    return !m_guard || is_clear(center, made, replaced) || is_allowed(center, made, replaced);
  }

  // same, for who has looked for a clear ball already, with a guard
  bool is_allowed(const vertex_descriptor center, const Numbered_triangles& made, const Numbered_triangles& replaced)
  {
    Bounding_box box = Bounding_box::nothing();
    for(const Numbered_triangles* const triangles : {&made, &replaced})
      for(const Numbered_triangle& t : *triangles)
        box.add(Bounding_box(t.points));
    if(!Base::note_moved(box) || !m_guard->allows(made, replaced, [this](const face_descriptor f) { return triangle(f); }))
      return false;
    spoil_balls(made, center == Graph_traits::null_vertex());
    return true;
  }

private:
  // A clear ball that holds v and the triangles, whose corners are no farther from v than the radius: the ball of v, one of
  // its neighbours, or a new one; -1 if there is none, or none worth a search. What is too close to the neighbours for a
  // ball will be too close to v.
  template <typename Triangles>
  int find_ball(const vertex_descriptor v, const double radius,
                const std::initializer_list<const Triangles*> triangles)
  {
    Surroundings& around = m_surroundings[index(v)];
    const auto does_hold = [&](const int ball) { return ball != -1 && m_balls[ball].holds(point(v), radius, triangles); };
    if(does_hold(around.ball))
      return around.ball;
    for(const halfedge_descriptor h : CGAL::halfedges_around_target(v, tmesh()))
    {
      const Surroundings& other = m_surroundings[index(source(h, tmesh()))];
      if(other.ball != around.ball && does_hold(other.ball))
        return around.ball = other.ball;
      around.bound = (std::min)(around.bound, other.bound + this->length(h));
    }
    return around.bound >= least_useful_ball * radius && search(v, radius, triangles) ? around.ball : -1;
  }

  // Looks for a ball around v, with the radius at least, which holds the corners. Faces are met as far as they hang
  // together; the ball ends at the nearest that turns from the others or lies above them, or at another sheet. Where no
  // ball was found beside, that of a thin sheet as a rule, the other one is looked for before faces farther away.
  template <typename Triangles>
  bool search(const vertex_descriptor v, const double radius, const std::initializer_list<const Triangles*> triangles)
  {
    const double needed = clearance * radius;
    m_search->begin_at(v);
    Clear_ball ball = {point(v), m_search->axis(), 0., (std::numeric_limits<double>::infinity)()};
    ball.radius = (std::max)(needed, (std::min)(reach_of_search * needed, m_search->satisfying_reach()));
    const auto look_up_to = [&](const double reach)
    {
      m_search->meet_up_to(reach);
      ball.radius = m_search->facing_radius(ball.radius);
      ball.axis = m_search->axis();
    };
    const auto least_height = [&] { return (std::max)(headroom * ball.largest_height(triangles), least_part_of_height * radius); };
    // No faces farther away than the search has come need to be told of; false after a stop.
    const auto tell_up_to = [&](const double reach)
    { return Base::note_moved(Bounding_box(ball.center, ball.center).enlarged(reach)); };
    Surroundings& around = m_surroundings[index(v)];
    look_up_to(needed);
    if(ball.radius >= needed && std::isfinite(around.bound))
    {
      if(!tell_up_to(needed))
        return false;
      const double reach = m_search->without_other_sheets(*m_guard, ball, needed, least_height()).radius;
      if(reach < needed)
        ball.radius = reach;
    }
    for(double reach = needed; ball.radius > reach; look_up_to(reach))
      reach = (std::min)(growth_of_reach * reach, ball.radius);
    if(ball.radius >= needed)
    {
      m_search->narrow_to(v, ball.radius);
      ball.radius = m_search->simple_radius(ball.radius);
    }
    if(ball.radius >= needed)
    {
      if(!tell_up_to(ball.radius))
        return false;
      ball = m_search->without_other_sheets(*m_guard, ball, ball.radius, least_height());
    }
    if(ball.radius < needed)
    {
      around.bound = ball.radius / clearance;
      return false;
    }
    around.ball = static_cast<int>(m_balls.size());
    ball.radius /= clearance;
    m_balls.push_back(ball);
    tell_vertices_inside();
    return true;
  }

  // of the last ball, which they may lie deeper in than in theirs
  void tell_vertices_inside()
  {
    const Clear_ball& found = m_balls.back();
    for(const auto& met : m_search->met())
      for(int k = 0; k < 3; ++k)
      {
        int& ball = m_surroundings[met.triangle.vertices[k]].ball;
        const Vector& p = met.triangle.points[k];
        if(found.depth(p) > (ball == -1 ? 0. : m_balls[ball].depth(p)))
          ball = static_cast<int>(m_balls.size()) - 1;
      }
  }

  // Triangles that turn from the axis end a ball for good; where a border moves, it has to be found again.
  void spoil_balls(const Numbered_triangles& made, const bool is_border_moved)
  {
    const auto spoil = [&](const int number)
    {
      Surroundings& around = m_surroundings[number];
      if(around.ball != -1)
        m_balls[around.ball].radius = 0.;
      around.ball = -1;
      around.bound = is_border_moved ? (std::numeric_limits<double>::infinity)() : 0.;
    };
    for(const Numbered_triangle& t : made)
      for(const int number : t.vertices)
      {
        if(number < 0)
          continue;
        const int ball = m_surroundings[number].ball;
        if(!is_border_moved && (ball == -1 || m_balls[ball].is_spoiled() || m_balls[ball].is_faced_by(t)))
          continue;
        spoil(number);
        visit_copies(this->vertex(number), [&](const vertex_descriptor copy)
        {
          for(const halfedge_descriptor h : CGAL::halfedges_around_target(copy, tmesh()))
            spoil(index(source(h, tmesh())));
        });
      }
  }
};

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_GUARDED_MESH_H
