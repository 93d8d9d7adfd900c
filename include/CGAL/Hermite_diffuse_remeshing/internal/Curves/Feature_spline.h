// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_CURVES_FEATURE_SPLINE_H
#define CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_CURVES_FEATURE_SPLINE_H

#include <CGAL/Hermite_diffuse_remeshing/internal/Curves/Saturation.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Curves/find_straight_segments.h>

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace CGAL {
namespace Hermite_diffuse_remeshing {
namespace internal {

// A C1 cubic spline through the points of a chain, parametrised by (nearly) its arc length.
// The tangent at a point is that of the circle through it and its two neighbours, so points on a
// circle give the circle to the sixth order of the angle; at an end the circle's tangent there.
// Where no arc is credible the segment is straight, and its neighbours become tangent to it. Where that would make one of
// them turn too much it keeps the circle of its other end, and the spline has a kink; if there is no such circle it is
// straight, too: the chain is a polyline there.
// The distance of the points to those of the chords may be bounded; the curvatures stay those of the chain.
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
  Saturation m_saturation;                     // of the distance to the chords

public:
  // `is_closed`: the last point is joined to the first, which is not repeated. `turns_of_ends`: the first and the last
  // segment of an open spline turn by no more than that. `bends`: those of the surface, as a polyline gets them.
  Feature_spline(const std::vector<Vector>& points, const bool is_closed,
                 const std::array<double, 2>& turns_of_ends = {{largest_credible_turn, largest_credible_turn}},
                 const Saturation& saturation = Saturation(),
                 const std::vector<double>& bends = std::vector<double>())
    : m_saturation(saturation)
  {
    const Polyline line(points, is_closed, bends);
    const int ns = line.number_of_segments();
    std::vector<bool> straight = find_straight_segments(line);
    std::vector<bool> kinks(line.number_of_points(), false);
    std::vector<Vector> start_tangents, end_tangents;
    do
      find_tangents(line, straight, kinks, start_tangents, end_tangents);
    while(reduce_turns(line, start_tangents, end_tangents, turns_of_ends, straight, kinks));

    for(int i = 0; i < line.number_of_points(); ++i)
      m_curvatures.push_back(line.curvature(i));
    if(!is_closed && ns > 1)
    {
      m_curvatures.front() = m_curvatures[1];
      m_curvatures.back() = m_curvatures[ns-1];
    }

    m_parameters.assign(1, 0.);
    for(int i = 0; i < ns; ++i)
    {
      m_segments.push_back(make_segment(line.start(i), line.end(i), start_tangents[i], end_tangents[i], straight[i]));
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
    , m_saturation(other.m_saturation)
  {
    const double offset = m_parameters.front();
    for(double& s : m_parameters)
      s -= offset;
  }

  // of the first or the last segment at the spline's end; the tangents are unit vectors towards the last point
  Vector end_tangent(const bool is_last) const
  {
    return (is_last ? m_segments.back().end_derivative : m_segments.front().start_derivative).normalized();
  }
  bool is_straight_at_end(const bool is_last) const
  {
    return (is_last ? m_segments.back() : m_segments.front()).is_straight;
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
    const Segment& segment = m_segments[at.first];
    const Vector p = point(segment, at.second);
    if(!m_saturation.is_bounded() || segment.is_straight)
      return p;
    const Vector on_chord = (1. - at.second) * segment.start + at.second * segment.end, displacement = p - on_chord;
    const double distance = displacement.norm();
    return distance > 0. ? Vector(on_chord + m_saturation(distance).height / distance * displacement) : p;
  }

  double curvature(const double s) const
  {
    const std::pair<int, double> at = segment(s);
    return (1. - at.second) * m_curvatures[at.first] + at.second * m_curvatures[at.first + 1];
  }

  // The largest distance between the spline from one parameter to another and its chord, over the points
  // and some places in between.
  double distance_to_chord(const double first, const double last) const
  {
    // an arc of a cubic is at most this far from its chord by 1 + 1/15 times what is seen at these places
    constexpr int places_per_segment = 4;
    const Vector a = point(first), chord = point(last) - a;
    const double length2 = chord.squaredNorm();
    double largest = 0.;
    const auto visit = [&](const double s)
    {
      const Vector d = point(s) - a;
      const double u = length2 > 0. ? (std::max)(0., (std::min)(1., d.dot(chord) / length2)) : 0.;
      largest = (std::max)(largest, (d - u * chord).norm());
    };
    for(int i = segment(first).first; i < number_of_segments() && m_parameters[i] < last; ++i)
    {
      const double from = (std::max)(first, m_parameters[i]), to = (std::min)(last, m_parameters[i+1]);
      if(m_segments[i].is_straight)
        visit(to);
      else
        for(int k = 1; k <= places_per_segment; ++k)
          visit(from + (to - from) * k / places_per_segment);
    }
    return largest;
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

  // `kinks`: the points where an arc does not become tangent to a straight segment
  static void find_tangents(const Polyline& line, const std::vector<bool>& straight, const std::vector<bool>& kinks,
                            std::vector<Vector>& start_tangents, std::vector<Vector>& end_tangents)
  {
    const int ns = line.number_of_segments();
    start_tangents.resize(ns);
    for(int i = 0; i < ns; ++i)
      start_tangents[i] = line.chord(i).stableNormalized();
    end_tangents = start_tangents;
    for(int i = 0; i < ns; ++i)
    {
      const int before = line.segment(i, -1);
      if(!line.has_turn(i) || (straight[before] && straight[i]) || kinks[i])
        continue;
      const Vector u = line.chord(before), v = line.chord(i);
      end_tangents[before] = start_tangents[i] = straight[before] ? u.stableNormalized()
                                               : straight[i] ? v.stableNormalized() : circle_tangent(u, v);
    }
    for(int i = 0; i < ns; ++i)
      if(!straight[i] && line.has_turn(i) && kinks[i])
        start_tangents[i] = mirrored(end_tangents[i], line.chord(i));
      else if(!straight[i] && line.has_turn(line.end_point(i)) && kinks[line.end_point(i)])
        end_tangents[i] = mirrored(start_tangents[i], line.chord(i));
    if(!line.is_closed() && ns > 1)
    {
      if(!straight[0])
        start_tangents[0] = mirrored(end_tangents[0], line.chord(0));
      if(!straight[ns-1])
        end_tangents[ns-1] = mirrored(start_tangents[ns-1], line.chord(ns-1));
    }
  }

  // Gives the segments that turn by too much a kink, or makes them straight; was there one? A kink is at a straight
  // neighbor, if the other neighbor is an arc.
  static bool reduce_turns(const Polyline& line, const std::vector<Vector>& start_tangents,
                           const std::vector<Vector>& end_tangents, const std::array<double, 2>& turns_of_ends,
                           std::vector<bool>& straight, std::vector<bool>& kinks)
  {
    bool is_changed = false;
    const std::vector<bool> were_straight = straight;
    const auto is_straight = [&](const int segment) { return segment == -1 || were_straight[segment]; };
    for(int i = 0; i < line.number_of_segments(); ++i)
    {
      double largest = line.credible_turn(i);
      if(i == 0)
        largest = (std::min)(largest, turns_of_ends[0]);
      if(i + 1 == line.number_of_segments())
        largest = (std::min)(largest, turns_of_ends[1]);
      if(straight[i] || angle_between(start_tangents[i], end_tangents[i]) <= largest)
        continue;
      is_changed = true;
      const int before = line.segment(i, -1), after = line.segment(i, 1);
      const int at = is_straight(before) ? i : line.end_point(i);
      if(is_straight(before) == is_straight(after) || (at == i ? before : after) == -1 || kinks[at])
        straight[i] = true;
      else
        kinks[at] = true;
    }
    return is_changed;
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
