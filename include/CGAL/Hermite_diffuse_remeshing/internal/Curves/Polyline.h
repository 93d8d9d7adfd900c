// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_CURVES_POLYLINE_H
#define CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_CURVES_POLYLINE_H

#include <CGAL/Hermite_diffuse_remeshing/internal/Indexed_triangles.h>

#include <vector>

namespace CGAL {
namespace Hermite_diffuse_remeshing {
namespace internal {

// The points of a chain of feature edges, and how it turns at them. Segment i goes from point i to the next one;
// of a closed chain the last segment returns to the first point, which is not repeated.
class Polyline
{
  const std::vector<Vector>& m_points;
  bool m_is_closed;
  std::vector<Vector> m_turns;

public:
  Polyline(const std::vector<Vector>& points, const bool is_closed)
    : m_points(points), m_is_closed(is_closed), m_turns(points.size(), Vector::Zero())
  {
    for(int i = 0; i < number_of_points(); ++i)
      if(has_turn(i))
      {
        const Vector u = chord(segment(i, -1)), v = chord(i);
        const Vector axis = u.cross(v);
        const double sine = axis.norm(), lengths = u.norm() + v.norm();
        if(sine > 0. && lengths > 0.)
          m_turns[i] = axis / sine * (2. * angle_between(u, v) / lengths);
      }
  }

  bool is_closed() const { return m_is_closed; }
  int number_of_points() const { return static_cast<int>(m_points.size()); }
  int number_of_segments() const { return m_is_closed ? number_of_points() : number_of_points() - 1; }

  const Vector& start(const int segment) const { return m_points[segment]; }
  int end_point(const int segment) const { return (segment + 1) % number_of_points(); }
  const Vector& end(const int segment) const { return m_points[end_point(segment)]; }
  Vector chord(const int segment) const { return end(segment) - start(segment); }

  // the segment `step` behind another one; -1 where an open chain has none
  int segment(const int i, const int step) const
  {
    const int ns = number_of_segments(), j = i + step;
    if(m_is_closed)
      return (j % ns + ns) % ns;
    return j < 0 || j >= ns ? -1 : j;
  }

  // all points but the ends of an open chain
  bool has_turn(const int point) const
  {
    return m_is_closed || (point > 0 && point < number_of_points() - 1);
  }
  // at a point, a vector along the axis of the turn, as long as the curvature; zero where there is no turn
  const Vector& turn(const int point) const { return m_turns[point]; }
  double curvature(const int point) const { return m_turns[point].norm(); }

  // of a segment, the mean at those of its ends that have one
  double segment_curvature(const int i) const
  {
    const int number = int(has_turn(i)) + int(has_turn(end_point(i)));
    return number == 0 ? 0. : (curvature(i) + curvature(end_point(i))) / number;
  }
};

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_CURVES_POLYLINE_H
