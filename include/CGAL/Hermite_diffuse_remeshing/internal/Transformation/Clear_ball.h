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

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>

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

// of the values at all corners of triangles; at least zero
template <typename Triangles, typename Value>
double largest_at_corners(const std::initializer_list<const Triangles*> triangles, const Value& value)
{
  double result = 0.;
  for(const Triangles* const some : triangles)
    for(const auto& t : *some)
      for(int i = 0; i < 3; ++i)
        result = (std::max)(result, value(corner_of(t, i)));
  return result;
}

// A ball in which all faces hang together and, seen along the axis, lie side by side and face the viewer. Where another
// sheet comes near it is a slice of a ball, which ends halfway to the sheet: in a slice no triangle can meet what is
// outside, however large its ball is.
struct Clear_ball
{
  Vector center, axis;
  double radius;                        // 0: the ball is clear no more
  double half_height;                   // of the slice, across the axis; infinite: the whole ball

  // \name Heights above or below the plane through the center across the axis
  double height(const Vector& p) const { return std::abs((p - center).dot(axis)); }

  // of the corners
  template <typename Triangles>
  double largest_height(const std::initializer_list<const Triangles*> triangles) const
  {
    return largest_at_corners(triangles, [this](const Vector& p) { return height(p); });
  }

  // of a triangle; zero where it meets the plane in the middle
  double least_height_of(const Numbered_triangle& t) const
  {
    const Vector heights((t.points[0] - center).dot(axis), (t.points[1] - center).dot(axis),
                         (t.points[2] - center).dot(axis));
    return (std::max)({0., heights.minCoeff(), -heights.maxCoeff()});
  }

  // \name Queries
  bool is_spoiled() const { return radius == 0.; }

  Bounding_box box() const { return Bounding_box(center, center).enlarged(radius); }

  // how far a point is from the outside, if it is inside
  double depth(const Vector& p) const { return (std::min)(radius - (p - center).norm(), half_height - height(p)); }

  // a point and triangles, whose corners are no farther from it than `distance`?
  template <typename Triangles>
  bool holds(const Vector& point, const double distance, const std::initializer_list<const Triangles*> triangles) const
  {
    const auto squared_distance = [this](const Vector& p) { return (p - center).squaredNorm(); };
    const double squared_distance_of_point = squared_distance(point);
    if(squared_distance_of_point > CGAL::square(radius))
      return false;
    // mostly told without the corners
    const bool does_hold_all = distance <= radius && squared_distance_of_point <= CGAL::square(radius - distance);
    return (does_hold_all || largest_at_corners(triangles, squared_distance) <= CGAL::square(radius))
        && (!std::isfinite(half_height) || largest_height(triangles) <= half_height);
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
