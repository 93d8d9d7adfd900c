// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_MODEL_DISPLACEMENT_SUPPORT_H
#define CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_MODEL_DISPLACEMENT_SUPPORT_H

#include <CGAL/Hermite_diffuse_remeshing/internal/Classification/Cut_mesh.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Classification/Edge_table.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Model/Reference_surface.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Hermite_diffuse_remeshing {
namespace internal {

// The triangle beside a feature side in which a displacement fades: in the plane of the side's face, isosceles, with the
// side as its base.
class Displacement_support
{
  Vector m_origin, m_along, m_inwards;  // an end of the side, and unit vectors in the plane
  double m_length, m_height;
  double m_room;                        // of the side's face: the height of an isosceles triangle with as much

  // Of the length of the side. What is beside an arc of few edges has room for the first; halves of it are tried as often.
  static constexpr double largest_height = 0.5;
  static constexpr int number_of_halves = 4;

public:
  Displacement_support(const Reference_surface& surface, const Face_side& side)
    : m_origin(surface.triangles().point(side.face, side.side))
  {
    const Vector d = surface.triangles().point(side.face, next(side.side)) - m_origin;
    m_length = d.norm();
    m_along = d / m_length;
    const Vector normal = surface.evaluate(location_on_side(side, 0.5)).normal();
    m_inwards = normal.cross(m_along).normalized();
    m_height = largest_height * m_length;
    const Vector& apex = surface.triangles().point(side.face, previous(side.side));
    if(depth(apex) < 0.)
      m_inwards = -m_inwards;
    const double foot = m_along.dot(apex - m_origin) / m_length;
    m_room = depth(apex) / (2. * (std::max)(foot, 1. - foot));
  }

  double inward_part(const Vector& v) const { return m_inwards.dot(v); }

  // Displaced by as much in the middle of an arc, is the side's own face folded over its other sides? With the base from 0 to
  // 1, the top at (s, h), and what is displaced by 4 u (1 - u) g (1 - t)^2, which is (u, 0) where t is 0 and the top where it
  // is 1, the Jacobian is positive if h > 4 g max(s, 1 - s). Twice as much is room enough.
  bool is_face_folded(const double displacement) const
  {
    constexpr double sufficient_room = 4.;
    return m_room < sufficient_room * displacement;
  }

  // Chooses the largest triangle over faces of one plane, without a feature among them. Returns the faces, none if there is
  // no triangle with more room than the side's own face.
  std::vector<int> find_faces(const Reference_surface& surface, const Face_side& side)
  {
    for(int i = 0; i <= number_of_halves && m_height > m_room; ++i, m_height /= 2.)
    {
      const std::vector<int> faces = faces_below(surface.triangles(), surface.cut_mesh(), side);
      if(!faces.empty())
        return faces;
    }
    return {};
  }

  // For a point in the plane: from 1 on the side to 0 on the other two, and the part of the side at the foot
  struct Place
  {
    double share, foot;
  };

  Place place(const Vector& p) const
  {
    const double share = 1. - depth(p) / m_height;
    return {share, 0.5 + (m_along.dot(p - m_origin) / m_length - 0.5) / share};
  }

private:
  double depth(const Vector& p) const { return inward_part(p - m_origin); }

  // distances from the three sides of the triangle, positive inside and not scaled, in units of its height
  std::array<double, 3> distances(const Vector& p) const
  {
    const double x = m_along.dot(p - m_origin) / m_length, y = depth(p) / m_height;
    return {{y, 2. * x - y, 2. * (1. - x) - y}};
  }

  // does a segment have points inside?
  bool is_crossed_by(const Vector& p, const Vector& q) const
  {
    constexpr double inside = 1e-9;     // far above rounding, for edges that begin at the ends of the side
    const std::array<double, 3> at_p = distances(p), at_q = distances(q);
    double first = 0., last = 1.;
    for(int k = 0; k < 3; ++k)
    {
      if(at_p[k] <= inside && at_q[k] <= inside)
        return false;
      const double t = (inside - at_p[k]) / (at_q[k] - at_p[k]);
      if(at_p[k] <= inside)
        first = (std::max)(first, t);
      else if(at_q[k] <= inside)
        last = (std::min)(last, t);
    }
    return first < last;
  }

  // the faces that the triangle lies over; none if one of them is not in the plane, or a feature is there
  std::vector<int> faces_below(const Indexed_triangles& triangles, const Cut_mesh& cut_mesh, const Face_side& side) const
  {
    constexpr double flatness = 1e-3;   // of the length of the side: what the plane may miss the corners of faces by
    std::vector<int> faces(1, side.face);
    for(std::size_t i = 0; i < faces.size(); ++i)
      for(int k = 0; k < 3; ++k)
      {
        const Vector &p = triangles.point(faces[i], k), &q = triangles.point(faces[i], next(k));
        if(std::abs(m_along.cross(m_inwards).dot(p - m_origin)) > flatness * m_length)
          return {};
        if((faces[i] == side.face && k == side.side) || !is_crossed_by(p, q))
          continue;
        const int other = cut_mesh.neighbor(faces[i], k);
        if(other == -1)
          return {};
        if(std::find(faces.begin(), faces.end(), other) == faces.end())
          faces.push_back(other);
      }
    return faces;
  }
};

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_MODEL_DISPLACEMENT_SUPPORT_H
