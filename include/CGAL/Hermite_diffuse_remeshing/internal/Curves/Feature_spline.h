// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_CURVES_FEATURE_SPLINE_H
#define CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_CURVES_FEATURE_SPLINE_H

#include <CGAL/Hermite_diffuse_remeshing/internal/Indexed_triangles.h>

#include <boost/math/constants/constants.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

namespace CGAL {
namespace Hermite_diffuse_remeshing {
namespace internal {

// A C1 cubic spline through the points of a chain, parametrised by (nearly) its arc length.
// The tangent at a point is that of the circle through it and its two neighbours, so points on a
// circle give the circle to the sixth order of the angle; at an end the circle's tangent there.
// Tessellations have about the same sagitta everywhere. A segment whose neighbours would make it
// bulge many times more than they do themselves is therefore taken as straight (a long edge
// between two rounded corners), and its neighbours become tangent to it. Where the turns
// alternate strongly the chain is kept as a polyline.
class Feature_spline
{
  struct Segment
  {
    Vector start, end;
    Vector start_derivative, end_derivative;   // with respect to the segment's own parameter in [0,1]
    bool is_straight;
  };

  std::vector<Segment> m_segments;
  std::vector<double> m_parameters;            // at the points; one more than segments
  std::vector<double> m_curvatures;            // at the points

public:
  // `is_closed`: the last point is joined to the first, which is not repeated
  Feature_spline(const std::vector<Vector>& points, const bool is_closed)
  {
    const int n = static_cast<int>(points.size());
    const int ns = is_closed ? n : n - 1;
    const auto chord = [&](const int i) -> Vector { return points[(i + 1) % n] - points[i]; };
    const auto before = [&](const int i) { return is_closed ? (i + ns - 1) % ns : i - 1; };
    const auto has_turn = [&](const int i) { return is_closed || (i > 0 && i < n - 1); };

    // vector along the axis of the turn at a point, of length curvature
    std::vector<Vector> turn(n, Vector::Zero());
    m_curvatures.assign(n, 0.);
    for(int i = 0; i < n; ++i)
      if(has_turn(i))
      {
        const Vector u = chord(before(i)), v = chord(i);
        const Vector axis = u.cross(v);
        const double sine = axis.norm(), lengths = u.norm() + v.norm();
        if(sine > 0. && lengths > 0.)
          turn[i] = axis / sine * (2. * angle_between(u, v) / lengths);
        m_curvatures[i] = turn[i].norm();
      }

    const std::vector<bool> straight = find_straight_segments(turn, ns, n, is_closed, chord);

    std::vector<Vector> start_tangent(ns), end_tangent(ns);
    for(int i = 0; i < ns; ++i)
      start_tangent[i] = end_tangent[i] = chord(i).stableNormalized();
    for(int i = 0; i < n; ++i)
      if(has_turn(i))
      {
        const int p = before(i), q = i;
        const Vector u = chord(p), v = chord(q);
        if(straight[p] && straight[q])
          continue;
        const Vector tangent = straight[p] ? u.stableNormalized()
                             : straight[q] ? v.stableNormalized()
                             : circle_tangent(u, v);
        end_tangent[p] = start_tangent[q] = tangent;
      }
    if(!is_closed && ns > 1)
    {
      start_tangent[0] = mirrored(end_tangent[0], chord(0));
      end_tangent[ns-1] = mirrored(start_tangent[ns-1], chord(ns-1));
      m_curvatures[0] = m_curvatures[1];
      m_curvatures[n-1] = m_curvatures[n-2];
    }

    m_parameters.assign(1, 0.);
    for(int i = 0; i < ns; ++i)
    {
      m_segments.push_back(make_segment(points[i], points[(i + 1) % n], start_tangent[i], end_tangent[i],
                                        straight[i]));
      m_parameters.push_back(m_parameters.back() + length(m_segments.back()));
    }
    if(is_closed)
      m_curvatures.push_back(m_curvatures.front());
  }

  // the part of a spline from one of its points to another
  Feature_spline(const Feature_spline& other, const int first, const int last)
    : m_segments(other.m_segments.begin() + first, other.m_segments.begin() + last)
    , m_parameters(other.m_parameters.begin() + first, other.m_parameters.begin() + last + 1)
    , m_curvatures(other.m_curvatures.begin() + first, other.m_curvatures.begin() + last + 1)
  {
    const double offset = m_parameters.front();
    for(double& s : m_parameters)
      s -= offset;
  }

  int number_of_segments() const { return static_cast<int>(m_segments.size()); }
  double length() const { return m_parameters.back(); }
  double parameter(const int point) const { return m_parameters[point]; }
  double curvature_at_point(const int point) const { return m_curvatures[point]; }

  // segment and local parameter in [0,1]
  std::pair<int, double> segment(const double s) const
  {
    const int i = static_cast<int>(std::upper_bound(m_parameters.begin() + 1, m_parameters.end() - 1, s)
                                   - m_parameters.begin()) - 1;
    const double length = m_parameters[i+1] - m_parameters[i];
    const double u = length > 0. ? (s - m_parameters[i]) / length : 0.;
    return std::make_pair(i, (std::min)(1., (std::max)(0., u)));
  }

  Vector point(const double s) const
  {
    const std::pair<int, double> at = segment(s);
    return point(m_segments[at.first], at.second);
  }

  double curvature(const double s) const
  {
    const std::pair<int, double> at = segment(s);
    return (1. - at.second) * m_curvatures[at.first] + at.second * m_curvatures[at.first + 1];
  }

private:
  // tangent at the middle point of the circle through three points, from its two chords
  static Vector circle_tangent(const Vector& u, const Vector& v)
  {
    const double u2 = u.squaredNorm(), v2 = v.squaredNorm();
    // of coincident points the first and the second are the same
    if(!(u2 > 0.) || !(v2 > 0.))
      return (u + v).stableNormalized();
    return (u / u2 + v / v2).stableNormalized();
  }

  // tangent of an arc at its other end
  static Vector mirrored(const Vector& tangent, const Vector& chord)
  {
    const Vector d = chord.stableNormalized();
    return 2. * tangent.dot(d) * d - tangent;
  }

  template <typename Chord>
  static std::vector<bool> find_straight_segments(const std::vector<Vector>& turn, const int ns, const int n,
                                                  const bool is_closed, const Chord& chord)
  {
    constexpr double credible_ratio = 4.;                // of sagittas of neighbouring segments
    constexpr double zigzag = 15. * boost::math::constants::pi<double>() / 180.;
    std::vector<double> sagitta(ns);
    for(int i = 0; i < ns; ++i)
      sagitta[i] = (turn[i].norm() + turn[(i + 1) % n].norm()) / 16. * chord(i).squaredNorm();

    std::vector<bool> straight(ns, false), alternates(ns, false);
    for(int i = 0; i < ns; ++i)
    {
      const Vector& t0 = turn[i];
      const Vector& t1 = turn[(i + 1) % n];
      alternates[i] = t0.dot(t1) < 0. && chord(i).norm() * (std::min)(t0.norm(), t1.norm()) > zigzag;
    }
    for(int i = 0; i < ns; ++i)
    {
      double neighbours = 0.;
      bool has_neighbour = false;
      for(const int step : {-1, 1})
      {
        const int j = is_closed ? (i + step + ns) % ns : i + step;
        if(j < 0 || j >= ns)
          continue;
        has_neighbour = true;
        neighbours = (std::max)(neighbours, sagitta[j]);
      }
      // at an end there is no second turn to compare: the zigzag of the neighbour goes on
      const bool is_zigzag_end = !is_closed && ns > 1
                              && ((i == 0 && alternates[1]) || (i == ns - 1 && alternates[ns-2]));
      straight[i] = !has_neighbour || alternates[i] || is_zigzag_end || sagitta[i] > credible_ratio * neighbours;
    }
    return straight;
  }

  static Segment make_segment(const Vector& start, const Vector& end,
                              const Vector& start_tangent, const Vector& end_tangent, const bool is_straight)
  {
    const Vector chord = end - start;
    const double length = chord.norm();
    // below the rounding of a tangent the segment is exactly straight
    constexpr double rounding = 1e-12;
    const auto is_along = [&](const Vector& t) { return t.cross(chord).norm() <= rounding * length; };
    if(is_straight || length == 0. || (is_along(start_tangent) && is_along(end_tangent)))
      return {start, end, chord, chord, true};
    // derivative that makes a symmetric pair of tangents a circular arc
    const auto speed = [&](const Vector& t)
    { return 2. * length / (1. + (std::max)(0., t.dot(chord) / length)); };
    return {start, end, speed(start_tangent) * start_tangent, speed(end_tangent) * end_tangent, false};
  }

  static Vector point(const Segment& c, const double u)
  {
    if(u == 0.)
      return c.start;
    if(u == 1.)
      return c.end;
    if(c.is_straight)
      return (1. - u) * c.start + u * c.end;
    const double v = 1. - u;
    return v * v * (1. + 2. * u) * c.start + u * u * (3. - 2. * u) * c.end
         + u * v * (v * c.start_derivative - u * c.end_derivative);
  }

  static double length(const Segment& c)
  {
    if(c.is_straight)
      return (c.end - c.start).norm();
    // Simpson's rule on the speed
    const Vector middle = 1.5 * (c.end - c.start) - 0.25 * (c.start_derivative + c.end_derivative);
    return (c.start_derivative.norm() + 4. * middle.norm() + c.end_derivative.norm()) / 6.;
  }
};

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_CURVES_FEATURE_SPLINE_H
