// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_FOLLOWED_MESH_H
#define CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_FOLLOWED_MESH_H

#include <CGAL/Hermite_diffuse_remeshing/internal/Transformation/Clear_ball.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Transformation/Intersection_guard.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Transformation/Mesh_elements.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Transformation/Moved_vertices.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <vector>

namespace CGAL {
namespace Hermite_diffuse_remeshing {
namespace internal {

// Lets the guard know where the faces are: not at each change, but when it is asked near by.
template <typename UserMesh>
class Followed_mesh : public Mesh_elements<UserMesh>
{
  typedef Mesh_elements<UserMesh> Base;

public:
  typedef typename Base::TriangleMesh TriangleMesh;
  typedef typename Base::Graph_traits Graph_traits;
  typedef typename Base::vertex_descriptor vertex_descriptor;
  typedef typename Base::halfedge_descriptor halfedge_descriptor;
  typedef typename Base::face_descriptor face_descriptor;

protected:
  // what is known around a vertex
  struct Surroundings
  {
    int ball = -1;                      // the clear ball that it lies deepest in
    int ball_of_move = -1;              // where the faces around it are if it has moved; -1: anywhere
    double bound = (std::numeric_limits<double>::infinity)();       // no ball around it has a larger radius
    // how far it may be from where the guard has last been told that it is, and how far it is
    double slack = 0., drift = 0.;
    bool is_moved = false;              // the guard has still to be told of the faces around it
    bool is_told_of = false;            // just now
  };

  std::unique_ptr<Intersection_guard<TriangleMesh> > m_guard;       // null: intersections are not looked for
  std::vector<Clear_ball> m_balls;
  std::vector<Surroundings> m_surroundings;                         // by the number of the vertex

private:
  std::unique_ptr<Moved_vertices> m_moved;
  std::vector<int> m_told;                                          // numbers of vertices
  bool m_is_begun = false;                                           // not if a stop came before

  // Of the shortest edge around a vertex: it may move so far before the guard is told, which takes its faces for larger
  // until then. Relocations are smaller as a rule.
  static constexpr double part_of_slack = 0.1;

public:
  using Base::tmesh;
  using Base::index;
  using Base::point;
  using Base::triangle;
  using Base::visit_copies;

  template <typename IsFrozen>
  Followed_mesh(const UserMesh& user, const Reference& reference,
                const std::vector<face_descriptor>& faces_of_reference,
                const std::vector<char>& is_remeshed,
                const IsFrozen& is_edge_frozen, const bool is_guarded)
    : Base(user, reference, faces_of_reference, is_remeshed, is_edge_frozen)
  {
    if(!is_guarded)
      return;
    const double extent = model_diameter(reference.surface.triangles());
    m_guard.reset(new Intersection_guard<TriangleMesh>(this->m_user.tmesh, extent));
    m_moved.reset(new Moved_vertices(extent));
    m_surroundings.resize(this->m_vertices.size());
    // The reference has an order of its own, in which what comes next is near. After a stop no operation will ask.
    std::size_t step = 0;
    for(const face_descriptor f : faces_of_reference)
      if(this->is_stopped_at(step++))
        return;
      else
        for(const int number : triangle(f).vertices)
          if(m_surroundings[number].slack == 0.)
            m_surroundings[number].slack = slack_of(this->vertex(number));
    for(const face_descriptor f : faces_of_reference)
      if(this->is_stopped_at(step++))
        return;
      else
        note(f);
    m_is_begun = true;
  }

  bool is_guarded() const { return m_guard != nullptr; }

  // for assertions: does the guard know of all faces, or will be told of them when it is asked near by?
  bool is_followed() const
  {
    const auto all = faces(tmesh());
    return !m_is_begun || std::all_of(all.begin(), all.end(), [this](const face_descriptor f)
    {
      const Numbered_triangle t = triangle(f);
      return m_guard->knows(f, Bounding_box(t.points))
          || std::any_of(t.vertices.begin(), t.vertices.end(), [&](const int number) { return will_be_told(number, t); });
    });
  }

protected:
  // \name Changes of faces
  // the face is new
  void note(const face_descriptor f)
  {
    if(m_guard)
      tell(f, triangle(f));
  }

  // The faces around v are new, or v has moved.
  void note_around(const vertex_descriptor v)
  {
    if(!m_guard)
      return;
    Surroundings& around = m_surroundings[index(v)];
    if(around.is_moved && around.ball_of_move == -1)
      return;
    const int ball = ball_around(v);
    if(around.is_moved && around.ball_of_move == ball)
      return;
    around.is_moved = true;
    around.ball_of_move = ball;
    if(ball == -1)
      m_moved->add_anywhere(index(v));
    else
      m_moved->add(index(v), ball, m_balls[ball].box());
  }

  // before the face is removed
  void forget(const face_descriptor f)
  {
    if(m_guard)
      m_guard->forget(f);
  }

  // same, for the faces around v
  void forget_around(const vertex_descriptor v)
  {
    if(m_guard)
      visit_faces_around(v, [&](const face_descriptor f) { m_guard->forget(f); });
  }

  // \name Changes of vertices
  void make_room_for_vertices(const std::size_t number)
  {
    if(m_guard)
      m_surroundings.reserve(number);
  }

  // the vertex with the number is new
  void forget_ball(const int number)
  {
    if(!m_guard)
      return;
    m_surroundings.resize(this->m_vertices.size());
    m_surroundings[number] = Surroundings();
  }

  void move_ball(const int number, const double distance)
  {
    if(!m_guard)
      return;
    m_surroundings[number].bound += distance;
    m_surroundings[number].drift += distance;
  }

  // nothing around v is new
  void note_relocated(const vertex_descriptor v)
  {
    if(!m_guard)
      return;
    const Surroundings& around = m_surroundings[index(v)];
    if(around.is_moved || !(around.drift <= around.slack))
      note_around(v);
  }

  // Tells the guard of what has moved and may be in a box. After a stop, for which many that have moved do not let wait,
  // it returns false: nothing is allowed any more.
  bool note_moved(const Bounding_box& box)
  {
    std::size_t step = 0;
    m_told.clear();
    m_moved->take(box, [&](const int number)
    {
      Surroundings& around = m_surroundings[number];
      // told of already, at another place where it has moved, or the vertex is gone, and another has its number
      if(!around.is_moved)
        return true;
      around.is_moved = false;
      if(this->vertex(number) == Graph_traits::null_vertex())
        return true;
      around.slack = slack_of(this->vertex(number));
      around.drift = 0.;
      around.is_told_of = true;
      m_told.push_back(number);
      return !this->is_stopped_at(step++);
    });
    // what its corners may move is known for all of them
    for(const int number : m_told)
      visit_faces_around(this->vertex(number), [&](const face_descriptor f)
      {
        const Numbered_triangle t = triangle(f);
        // each once, from the first of its corners that the guard is told of
        const bool is_first = std::none_of(t.vertices.begin(), t.vertices.end(), [&](const int other)
                                           { return other < number && m_surroundings[other].is_told_of; });
        if(is_first)
          tell(f, t);
      });
    for(const int number : m_told)
      m_surroundings[number].is_told_of = false;
    // also one that came earlier, in a larger box of the same operation, which has left vertices untold of
    return !this->m_user.visitor.is_stopped();
  }

private:
  void tell(const face_descriptor f, const Numbered_triangle& t)
  {
    double slack = 0.;
    for(const int number : t.vertices)
      slack = (std::max)(slack, m_surroundings[number].slack);
    m_guard->note(f, Bounding_box(t.points).enlarged(slack));
  }

  template <typename Visit>
  void visit_faces_around(const vertex_descriptor v, const Visit& visit) const
  {
    visit_copies(v, [&](const vertex_descriptor copy)
    {
      for(const halfedge_descriptor h : CGAL::halfedges_around_target(copy, tmesh()))
        if(!CGAL::is_border(h, tmesh()))
          visit(face(h, tmesh()));
    });
  }

  // of a triangle at the vertex
  bool will_be_told(const int number, const Numbered_triangle& t) const
  {
    const Surroundings& around = m_surroundings[number];
    if(!around.is_moved || around.ball_of_move == -1)
      return around.is_moved;
    const Clear_ball& ball = m_balls[around.ball_of_move];
    return ball.is_spoiled() || ball.box().holds(Bounding_box(t.points));
  }

  // A ball that holds the faces around v, also after moves of which the guard is not told; -1 if none is known.
  int ball_around(const vertex_descriptor v) const
  {
    if(this->has_copies(v))
      return -1;
    const auto does_hold = [&](const int ball)
    {
      const auto is_inside = [&](const vertex_descriptor w)
      {
        const double radius = m_balls[ball].radius - m_surroundings[index(w)].slack;
        return radius > 0. && (point(w) - m_balls[ball].center).squaredNorm() < CGAL::square(radius);
      };
      const auto around = CGAL::halfedges_around_target(v, tmesh());
      return ball != -1 && is_inside(v)
          && std::all_of(around.begin(), around.end(), [&](const halfedge_descriptor h)
                         { return is_inside(source(h, tmesh())); });
    };
    const int own = m_surroundings[index(v)].ball;
    if(does_hold(own))
      return own;
    for(const halfedge_descriptor h : CGAL::halfedges_around_target(v, tmesh()))
    {
      const int other = m_surroundings[index(source(h, tmesh()))].ball;
      if(other != own && does_hold(other))
        return other;
    }
    return -1;
  }

  double slack_of(const vertex_descriptor v) const
  {
    double shortest = (std::numeric_limits<double>::infinity)();
    visit_copies(v, [&](const vertex_descriptor copy)
    {
      for(const halfedge_descriptor h : CGAL::halfedges_around_target(copy, tmesh()))
        shortest = (std::min)(shortest, this->length(h));
    });
    return std::isfinite(shortest) ? part_of_slack * shortest : 0.;
  }
};

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_FOLLOWED_MESH_H
