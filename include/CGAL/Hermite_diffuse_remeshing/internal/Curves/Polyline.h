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

#include <boost/math/constants/constants.hpp>

#include <algorithm>
#include <limits>
#include <vector>

namespace CGAL {
namespace Hermite_diffuse_remeshing {
namespace internal {

// More than a segment of a regular polygon of 11 sides turns, less than one of 10: between two points of an arc
// that turns by more its shape is a guess, if nothing but the arc tells of it.
constexpr double largest_credible_turn = 34. * boost::math::constants::pi<double>() / 180.;

// The points of a chain of feature edges, and how it turns at them. Segment i goes from point i to the next one;
// of a closed chain the last segment returns to the first point, which is not repeated.
class Polyline
{
  const std::vector<Vector>& m_points;
  bool m_is_closed;
  std::vector<Vector> m_turns;
  std::vector<double> m_credible_turns;

public:
  // `bends`: by which angle a smooth surface beside the chain turns at each point; empty: by none
  Polyline(const std::vector<Vector>& points, const bool is_closed, const std::vector<double>& bends)
    : m_points(points), m_is_closed(is_closed), m_turns(points.size(), Vector::Zero()),
      m_credible_turns(points.size(), largest_credible_turn)
  {
    // The surface explains a turn if it makes most of it, which on a cone it does not make whole.
    constexpr double least_part = 0.5;
    // segments that are longer than those beside them turn by more than their ends
    constexpr double slack = 1.1;
    for(int i = 0; i < number_of_points(); ++i)
      if(has_turn(i))
      {
        const Vector u = chord(segment(i, -1)), v = chord(i);
        const Vector axis = u.cross(v);
        const double sine = axis.norm(), lengths = u.norm() + v.norm(), angle = angle_between(u, v);
        if(sine > 0. && lengths > 0.)
          m_turns[i] = axis / sine * (2. * angle / lengths);
        if(!bends.empty() && bends[i] > least_part * angle)
          m_credible_turns[i] = (std::max)(largest_credible_turn, slack * angle);
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

  // By how much a segment may turn between its ends: the surface beside them is smooth there and turns as well, or
  // the arc is the only witness.
  double credible_turn(const int segment) const
  {
    double result = std::numeric_limits<double>::infinity();
    for(const int point : {segment, end_point(segment)})
      if(has_turn(point))
        result = (std::min)(result, m_credible_turns[point]);
    return result;
  }

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
