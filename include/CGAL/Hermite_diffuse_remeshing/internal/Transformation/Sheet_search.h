// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_SHEET_SEARCH_H
#define CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_SHEET_SEARCH_H

#include <CGAL/Hermite_diffuse_remeshing/internal/Transformation/Clear_ball.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Transformation/Intersection_guard.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Transformation/Mesh_elements.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Transformation/Normal_cone.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Transformation/Sheet_outline.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Transformation/Sheet_view.h>

#include <boost/math/constants/constants.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Hermite_diffuse_remeshing {
namespace internal {

// The faces around a vertex as far as they hang together, and how far they lie side by side, seen along an axis.
template <typename UserMesh>
class Sheet_search
{
  typedef Mesh_elements<UserMesh> Mesh;
  typedef typename Mesh::TriangleMesh TriangleMesh;
  typedef typename Mesh::vertex_descriptor vertex_descriptor;
  typedef typename Mesh::halfedge_descriptor halfedge_descriptor;
  typedef typename Mesh::face_descriptor face_descriptor;
  typedef typename boost::property_map<TriangleMesh, CGAL::dynamic_face_property_t<std::size_t> >::type Search_map;

public:
  // its corners follow the halfedge
  struct Met_face { halfedge_descriptor halfedge; Numbered_triangle triangle; double distance; };

private:
  const Mesh& m_mesh;
  Search_map m_last_search;                         // that has met the face: twice its number, and 1 more beyond
  std::size_t m_number_of_searches = 0;
  Vector m_center = Vector::Zero();
  std::vector<Met_face> m_met, m_beyond;            // as far as it looks, and beyond
  std::size_t m_number_of_expanded = 0, m_number_in_cone = 0;       // of those that were met
  double m_limit = 0.;                              // of their distances
  bool m_do_all_face = true;                        // do they turn from no other?
  Normal_cone m_cone;
  Sheet_outline m_outline;
  Sheet_view m_view;

  // In a fine mesh that is being coarsened, for one, a search looks as far as it is expected to meet so many faces,
  static constexpr double satisfying_number_of_faces = 1024.;
  // and no farther than it meets as many times as many, where they are smaller than around its center.
  static constexpr double largest_excess_of_faces = 4.;
  // Angle to the axis of the faces that are found in a ball, in radians. What is between this and the angle of those
  // that may be made there is what normals change while chords of the surface are exchanged.
  static constexpr double largest_angle_found = 1.35;
  // cones are not made narrower: most faces need no change of the cone then
  static constexpr double least_angle = 0.25;

public:
  Sheet_search(const Mesh& mesh, TriangleMesh& tmesh)
    : m_mesh(mesh), m_last_search(get(CGAL::dynamic_face_property_t<std::size_t>(), tmesh))
    , m_cone(Vector::UnitZ(), least_angle)
  {}

  bool has_met(const face_descriptor f) const { return get(m_last_search, f) / 2 == m_number_of_searches; }

  const std::vector<Met_face>& met() const { return m_met; }
  const Vector& axis() const { return m_cone.axis(); }

  // with the faces around v
  void begin_at(const vertex_descriptor v)
  {
    m_center = m_mesh.point(v);
    meet_around(v);
    m_number_in_cone = 0;
    m_do_all_face = true;
    m_cone = Normal_cone(area_vector(m_met.front().triangle).normalized(), least_angle);
  }

  // the radius of as many faces of a flat mesh as the search is content with, if they are as large as those met first
  double satisfying_reach() const
  {
    double area = 0.;
    for(const Met_face& met : m_met)
      area += area_vector(met.triangle).norm() / 2.;
    return std::sqrt(satisfying_number_of_faces * area / (double(m_met.size()) * boost::math::constants::pi<double>()));
  }

  // Meets the faces up to a distance; where they are too many, some are left out, and count as another sheet.
  void meet_up_to(const double limit)
  {
    m_limit = limit;
    const auto is_reached = [&](const Met_face& met)
    {
      const bool is_near = met.distance < limit;
      if(is_near)
        add_near(met);
      return is_near;
    };
    m_beyond.erase(std::remove_if(m_beyond.begin(), m_beyond.end(), is_reached), m_beyond.end());
    const double largest_number = largest_excess_of_faces * satisfying_number_of_faces;
    for(; m_number_of_expanded < m_met.size() && double(m_met.size()) < largest_number; ++m_number_of_expanded)
    {
      const Met_face met = m_met[m_number_of_expanded];
      halfedge_descriptor h = met.halfedge;
      for(int k = 0; k < 3; ++k, h = next(h, m_mesh.tmesh()))
        meet(opposite(h, m_mesh.tmesh()), met.triangle, k);
    }
  }

  // Up to the bound: the distance of the nearest of the faces met since that turns from the others
  double facing_radius(double bound)
  {
    for(; m_number_in_cone < m_met.size(); ++m_number_in_cone)
    {
      const Met_face& met = m_met[m_number_in_cone];
      if(met.distance < bound && m_cone.add(area_vector(met.triangle).normalized(), largest_angle_found))
        continue;
      m_do_all_face = false;
      bound = (std::min)(bound, met.distance);
    }
    return bound;
  }

  // Meets no faces but those up to a distance at which all face the viewer: what hangs together with v by others alone
  // counts as another sheet from now on.
  void narrow_to(const vertex_descriptor v, const double limit)
  {
    if(m_do_all_face)
      return;
    meet_around(v);
    meet_up_to(limit);
    m_number_in_cone = m_met.size();
    m_do_all_face = true;
  }

  // Up to the bound: the radius within which none of the faces, which all face the viewer, lies above another
  double simple_radius(const double bound)
  {
    if(is_outline_simple())
      return bound;
    m_view.clear();
    for(const Met_face& met : m_met)
      m_view.add(met.triangle, met.distance);
    return m_view.simple_radius(m_cone.axis(), bound);
  }

  // Up to a radius, the part of a ball without the faces that the search has not met, of which the guard knows: it ends
  // before the nearest that leaves a slice of less than the height, and halfway to those farther above or below.
  Clear_ball without_other_sheets(const Intersection_guard<TriangleMesh>& guard, Clear_ball ball, double radius,
                                  const double least_height) const
  {
    struct Other { double distance, half_height; };
    std::vector<Other> others;
    guard.visit_near(Bounding_box(ball.center, ball.center).enlarged(radius),
                     [&](const face_descriptor f, const Bounding_box& box)
    {
      if(box.distance(ball.center) >= radius || has_met(f))
        return true;
      // without the slack of the guard's box, as faces that were met are measured
      const Numbered_triangle t = m_mesh.triangle(f);
      const Other other = {Bounding_box(t.points).distance(ball.center), ball.least_height_of(t) / 2.};
      if(other.distance >= radius)
        return true;
      if(other.half_height < least_height)
        radius = other.distance;
      else
        others.push_back(other);
      return true;
    });
    ball.radius = radius;
    for(const Other& other : others)
      if(other.distance < radius)
        ball.half_height = (std::min)(ball.half_height, other.half_height);
    return ball;
  }

private:
  void meet_around(const vertex_descriptor v)
  {
    ++m_number_of_searches;
    m_met.clear();
    m_beyond.clear();
    m_number_of_expanded = 0;
    m_limit = (std::numeric_limits<double>::infinity)();
    for(const halfedge_descriptor h : CGAL::halfedges_around_target(v, m_mesh.tmesh()))
    {
      const vertex_descriptor s = source(h, m_mesh.tmesh());
      meet(h, {{{m_mesh.index(v), m_mesh.index(s)}}, {{m_center, m_mesh.point(s)}}}, 0);
    }
  }

  bool is_outline_simple()
  {
    const TriangleMesh& tm = m_mesh.tmesh();
    m_outline.look_along(m_cone.axis());
    for(const Met_face& met : m_met)
    {
      halfedge_descriptor h = met.halfedge;
      for(int k = 0; k < 3; ++k, h = next(h, tm))
      {
        const halfedge_descriptor o = opposite(h, tm);
        if(CGAL::is_border(o, tm) || get(m_last_search, face(o, tm)) != 2 * m_number_of_searches)
          m_outline.add(met.triangle, k);
      }
    }
    return m_outline.is_simple();
  }

  void add_near(const Met_face& met)
  {
    put(m_last_search, face(met.halfedge, m_mesh.tmesh()), 2 * m_number_of_searches);
    m_met.push_back(met);
  }

  void add_beyond(const Met_face& met)
  {
    put(m_last_search, face(met.halfedge, m_mesh.tmesh()), 2 * m_number_of_searches + 1);
    m_beyond.push_back(met);
  }

  // the face of h, beside the corners k and k + 1 of another
  void meet(const halfedge_descriptor h, const Numbered_triangle& beside, const int k)
  {
    const TriangleMesh& tm = m_mesh.tmesh();
    if(CGAL::is_border(h, tm) || has_met(face(h, tm)))
      return;
    const int l = (k + 1) % 3;
    const vertex_descriptor apex = target(next(h, tm), tm);
    const Numbered_triangle t = {{{beside.vertices[l], beside.vertices[k], m_mesh.index(apex)}},
                                 {{beside.points[l], beside.points[k], m_mesh.point(apex)}}};
    const double distance = Bounding_box(t.points).distance(m_center);
    if(distance < m_limit)
      add_near({h, t, distance});
    else
      add_beyond({h, t, distance});
  }
};

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_SHEET_SEARCH_H
