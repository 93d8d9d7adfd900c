// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_CLEAR_BALL_H
#define CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_CLEAR_BALL_H

#include <CGAL/Hermite_diffuse_remeshing/internal/Transformation/do_triangles_meet.h>

#include <CGAL/number_utils.h>

#include <array>

namespace CGAL {
namespace Hermite_diffuse_remeshing {
namespace internal {

typedef std::array<const Vector*, 3> Corner_points;

inline const Vector& corner_of(const Numbered_triangle& t, const int i) { return t.points[i]; }
inline const Vector& corner_of(const Corner_points& t, const int i) { return *t[i]; }

template <typename Triangle>
Vector area_vector(const Triangle& t)
{
  return (corner_of(t, 1) - corner_of(t, 0)).cross(corner_of(t, 2) - corner_of(t, 0));
}

// A ball in which all faces hang together and, seen along the axis, lie side by side and face the viewer.
struct Clear_ball
{
  Vector center, axis;
  double radius;                        // 0: the ball is clear no more

  // how far a point is from the outside, if it is in the ball
  double depth(const Vector& p) const { return radius - (p - center).norm(); }

  // the one with the center and the radius
  bool holds(const Vector& other_center, const double other_radius) const
  {
    return radius >= other_radius && (other_center - center).squaredNorm() <= CGAL::square(radius - other_radius);
  }

  // May the triangle be made in the ball?
  template <typename Triangle>
  bool is_faced_by(const Triangle& t) const
  {
    // of the angle to the axis: it turns neither away from the viewer nor edge-on
    constexpr double least_cosine = 0.1;
    const Vector n = area_vector(t);
    return n.dot(axis) > least_cosine * n.norm();
  }
};

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_CLEAR_BALL_H
