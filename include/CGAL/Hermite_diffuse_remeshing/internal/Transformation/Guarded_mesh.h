// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_GUARDED_MESH_H
#define CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_GUARDED_MESH_H

#include <CGAL/Hermite_diffuse_remeshing/internal/Transformation/Intersection_guard.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Transformation/Mesh_elements.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Transformation/Normal_cone.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Transformation/Sheet_view.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL {
namespace Hermite_diffuse_remeshing {
namespace internal {

// Tells whether an operation would make triangles that meet others.
//
// Most operations take place where the surface is a single sheet, and are allowed without a search: in a clear
// ball all faces hang together and, seen along an axis, lie side by side and face the viewer. There an operation
// that fills a contour anew with triangles that face the viewer too cannot make them meet: seen from the axis they
// cover the inside of the contour once. A ball is found by one search and serves many operations: what is clear
// around a vertex is clear around its neighbours, in a ball that is smaller by their distance.
template <typename UserMesh>
class Guarded_mesh : public Mesh_elements<UserMesh>
{
  typedef Mesh_elements<UserMesh> Base;

public:
  typedef typename Base::TriangleMesh TriangleMesh;
  typedef typename Base::Graph_traits Graph_traits;
  typedef typename Base::vertex_descriptor vertex_descriptor;
  typedef typename Base::halfedge_descriptor halfedge_descriptor;
  typedef typename Base::face_descriptor face_descriptor;

private:
  // around a vertex
  struct Clear_ball
  {
    Vector axis = Vector::Zero();
    double radius = 0.;                                             // at least
    double bound = (std::numeric_limits<double>::infinity)();       // at most
  };
  typedef typename boost::property_map<TriangleMesh, CGAL::dynamic_face_property_t<std::size_t> >::type Search_map;

  std::unique_ptr<Intersection_guard<TriangleMesh> > m_guard;       // null: intersections are not looked for
  std::vector<Clear_ball> m_balls;                                  // by the number of the vertex
  Search_map m_search;                                              // the last search that has met the face
  std::size_t m_number_of_searches = 0;
  Sheet_view m_view;
  std::vector<face_descriptor> m_queue;
  std::vector<std::pair<double, std::size_t> > m_sheet;             // distances of faces in the queue

  // A search that succeeds looks again, as many times as far as asked for, so that its ball serves the neighbours too.
  static constexpr double reach_of_search = 2.5;
  // Sheets move a little when they are remeshed, by the sagitta of their triangles: a ball must be larger by this
  // than what takes place in it.
  static constexpr double clearance = 1.25;
  // Angles to the axis in radians: of the faces that are found in a ball, and the cosine of the angle of those that
  // may be made there. What is between them is what normals change while chords of the surface are exchanged.
  static constexpr double largest_angle_found = 1.15, least_cosine_made = 0.25;
  // cones are not made narrower: most faces need no change of the cone then
  static constexpr double least_angle = 0.25;

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
    : Base(user, reference, faces_of_reference, is_remeshed, is_edge_frozen)
  {
    if(!is_guarded)
      return;
    m_guard.reset(new Intersection_guard<TriangleMesh>(this->m_user.tmesh,
                                                       model_diameter(reference.surface.triangles())));
    m_search = get(CGAL::dynamic_face_property_t<std::size_t>(), this->m_user.tmesh);
    m_balls.resize(this->m_vertices.size());
    std::size_t step = 0;
    for(const face_descriptor f : faces(tmesh()))
    {
      // no operation will ask the guard
      if(this->is_stopped_at(step++))
        return;
      note(f);
    }
  }

  bool is_guarded() const { return m_guard != nullptr; }

  // May the one triangles take the place of the others? `center`: a vertex at which the operation takes place, if
  // nothing changes but what is inside a contour; null otherwise.
  bool is_free(const vertex_descriptor center, const Numbered_triangles& made, const Numbered_triangles& replaced)
  {
    if(!m_guard)
      return true;
    if(center != Graph_traits::null_vertex() && is_in_clear_ball(center, made, replaced))
      return true;
    if(!m_guard->allows(made, replaced, [this](const face_descriptor f) { return triangle(f); }))
      return false;
    spoil_balls(made, center == Graph_traits::null_vertex());
    return true;
  }

protected:
  // \name Changes of faces
  void note(const face_descriptor f)
  {
    if(m_guard)
      m_guard->note(f, triangle(f).points);
  }

  void note_around(const vertex_descriptor v)
  {
    if(m_guard)
      visit_copies(v, [&](const vertex_descriptor copy)
      {
        for(const halfedge_descriptor h : CGAL::halfedges_around_target(copy, tmesh()))
          if(!CGAL::is_border(h, tmesh()))
            note(face(h, tmesh()));
      });
  }

  // before faces around v are removed
  void forget_around(const vertex_descriptor v)
  {
    if(m_guard)
      visit_copies(v, [&](const vertex_descriptor copy)
      {
        for(const halfedge_descriptor h : CGAL::halfedges_around_target(copy, tmesh()))
          if(!CGAL::is_border(h, tmesh()))
            m_guard->forget(face(h, tmesh()));
      });
  }

  // \name Changes of vertices
  // the vertex with the number is new
  void forget_ball(const int number)
  {
    if(!m_guard)
      return;
    m_balls.resize(this->m_vertices.size());
    m_balls[number] = Clear_ball();
  }

  void move_ball(const int number, const double distance)
  {
    if(!m_guard)
      return;
    m_balls[number].radius -= distance;
    m_balls[number].bound += distance;
  }

private:
  bool is_in_clear_ball(const vertex_descriptor v, const Numbered_triangles& made, const Numbered_triangles& replaced)
  {
    double squared_radius = 0.;
    for(const Numbered_triangles* const triangles : {&made, &replaced})
      for(const Numbered_triangle& t : *triangles)
        for(const Vector& p : t.points)
          squared_radius = (std::max)(squared_radius, (p - point(v)).squaredNorm());
    const double radius = clearance * std::sqrt(squared_radius);
    const Clear_ball& ball = m_balls[index(v)];
    if(ball.radius < radius && !(ball.bound >= radius && has_large_ball(v, radius)))
      return false;
    return std::all_of(made.begin(), made.end(), [&](const Numbered_triangle& t)
                       { return faces_axis(t, ball.axis, least_cosine_made); });
  }

  static Vector unit_normal(const Numbered_triangle& t)
  {
    const Vector n = (t.points[1] - t.points[0]).cross(t.points[2] - t.points[0]);
    return n / n.norm();
  }

  static bool faces_axis(const Numbered_triangle& t, const Vector& axis, const double least_cosine)
  {
    const Vector n = (t.points[1] - t.points[0]).cross(t.points[2] - t.points[0]);
    return n.dot(axis) > least_cosine * n.norm();
  }

  // Looks for a ball that is large enough among those of the neighbours, then in the mesh. What is too close to
  // the neighbours for a ball will be too close to the vertex.
  bool has_large_ball(const vertex_descriptor v, const double radius)
  {
    Clear_ball& ball = m_balls[index(v)];
    for(const halfedge_descriptor h : CGAL::halfedges_around_target(v, tmesh()))
    {
      const Clear_ball& other = m_balls[index(source(h, tmesh()))];
      const double length = this->length(h);
      ball.bound = (std::min)(ball.bound, other.bound + length);
      const double inherited = other.radius - length;
      if(inherited > ball.radius)
      {
        ball.radius = inherited;
        ball.axis = other.axis;
      }
    }
    if(ball.radius < radius && ball.bound >= radius)
    {
      search(v, radius);
      if(ball.radius >= radius)
        search(v, reach_of_search * radius);
    }
    return ball.radius >= radius;
  }

  void search(const vertex_descriptor v, double radius)
  {
    Clear_ball& ball = m_balls[index(v)];
    const Vector center = point(v);
    const double first_radius = radius;
    collect_sheet(v, radius);
    const Vector reach = Vector::Constant(radius);
    m_guard->visit_near(Bounding_box(center - reach, center + reach), [&](const face_descriptor f)
    {
      if(get(m_search, f) != m_number_of_searches)
        radius = (std::min)(radius, m_guard->box(f).distance(center));
      return true;
    });
    std::sort(m_sheet.begin(), m_sheet.end());

    Normal_cone cone(unit_normal(triangle(m_queue.front())), least_angle);
    m_view.clear();
    for(const std::pair<double, std::size_t>& entry : m_sheet)
    {
      if(entry.first >= radius)
        break;
      const Numbered_triangle t = triangle(m_queue[entry.second]);
      if(cone.add(unit_normal(t), largest_angle_found))
        m_view.add(t, entry.first);
      else
        radius = entry.first;
    }
    radius = m_view.simple_radius(cone.axis(), radius);
    ball.radius = radius;
    ball.axis = cone.axis();
    ball.bound = radius < first_radius ? radius : (std::numeric_limits<double>::infinity)();
  }

  // the faces that hang together with v and begin within the radius
  void collect_sheet(const vertex_descriptor v, const double radius)
  {
    ++m_number_of_searches;
    m_sheet.clear();
    m_queue.clear();
    const auto meet = [&](const halfedge_descriptor h)
    {
      if(CGAL::is_border(h, tmesh()) || get(m_search, face(h, tmesh())) == m_number_of_searches)
        return;
      put(m_search, face(h, tmesh()), m_number_of_searches);
      m_queue.push_back(face(h, tmesh()));
    };
    for(const halfedge_descriptor h : CGAL::halfedges_around_target(v, tmesh()))
      meet(h);
    for(std::size_t i = 0; i < m_queue.size(); ++i)
    {
      const face_descriptor f = m_queue[i];
      const double distance = m_guard->box(f).distance(point(v));
      if(distance >= radius)
        continue;
      m_sheet.push_back(std::make_pair(distance, i));
      for(const halfedge_descriptor h : CGAL::halfedges_around_face(halfedge(f, tmesh()), tmesh()))
        meet(opposite(h, tmesh()));
    }
  }

  // Triangles that turn from an axis end what was known around them for good; where a border moves, it has to be
  // found again.
  void spoil_balls(const Numbered_triangles& made, const bool is_border_moved)
  {
    const auto spoil = [&](const int number)
    {
      m_balls[number] = Clear_ball();
      if(!is_border_moved)
        m_balls[number].bound = 0.;
    };
    for(const Numbered_triangle& t : made)
      for(const int number : t.vertices)
      {
        if(number < 0 || (!is_border_moved && (!(m_balls[number].radius > 0.)
                                               || faces_axis(t, m_balls[number].axis, least_cosine_made))))
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
