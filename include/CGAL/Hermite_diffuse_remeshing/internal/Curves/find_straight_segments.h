// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_CURVES_FIND_STRAIGHT_SEGMENTS_H
#define CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_CURVES_FIND_STRAIGHT_SEGMENTS_H

#include <CGAL/Hermite_diffuse_remeshing/internal/Curves/Polyline.h>

#include <boost/math/constants/constants.hpp>

#include <algorithm>
#include <vector>

namespace CGAL {
namespace Hermite_diffuse_remeshing {
namespace internal {

// Does a segment leave its neighbour, `step` behind it, as a line leaves an arc that it is tangent to? The turn at
// their point is then the half of the arc's between two of its points.
inline bool is_tangent_line(const Polyline& line, const int segment, const int step)
{
  // of the turn that it would have if the arc went on
  constexpr double largest_part = 0.25;
  const int neighbor = line.segment(segment, step);
  const int at = step > 0 ? line.end_point(segment) : segment;
  const int beyond = step > 0 ? line.end_point(at) : line.segment(at, -1);
  if(neighbor == -1 || !line.has_turn(at) || beyond == -1 || !line.has_turn(beyond))
    return false;
  const double own = line.chord(segment).norm(), other = line.chord(neighbor).norm();
  const double angle = line.curvature(at) * (own + other) / 2.;
  return angle - line.curvature(beyond) * other / 2. < largest_part * line.curvature(at) * own / 2.;
}

inline bool is_turn_credible(const Polyline& line, const int segment)
{
  return line.segment_curvature(segment) * line.chord(segment).norm() <= line.credible_turn(segment);
}

// The larger one of what is usual at the two sides of a segment: at each the (lower) median of the next three, as
// far as they are there and credible themselves.
inline double usual_sagitta(const Polyline& line, const int segment, const std::vector<double>& sagitta)
{
  double result = 0.;
  for(const int direction : {-1, 1})
  {
    std::vector<double> side;
    for(int i = 1; i <= 3; ++i)
    {
      const int j = line.segment(segment, direction * i);
      if(j != -1 && j != segment && is_turn_credible(line, j))
        side.push_back(sagitta[j]);
    }
    std::sort(side.begin(), side.end());
    if(!side.empty())
      result = (std::max)(result, side[(side.size() - 1) / 2]);
  }
  return result;
}

// The segments between which no arc is credible: where the turns alternate, where the arc would turn by too much,
// and where it would bulge more than is usual around: tessellations have about the same sagitta everywhere.
inline std::vector<bool> find_straight_segments(const Polyline& line)
{
  // what lengths of neighbouring segments explain that differ by a factor of two
  constexpr double largest_ratio = 5.;
  // above this ratio a line that is tangent to an arc is told from the arc
  constexpr double suspect_ratio = 2.;
  constexpr double zigzag = 15. * boost::math::constants::pi<double>() / 180.;

  const int ns = line.number_of_segments();
  std::vector<double> sagitta(ns);
  std::vector<bool> straight(ns, false), alternates(ns, false);
  for(int i = 0; i < ns; ++i)
  {
    sagitta[i] = line.segment_curvature(i) * line.chord(i).squaredNorm() / 8.;
    const Vector& t0 = line.turn(i);
    const Vector& t1 = line.turn(line.end_point(i));
    alternates[i] = t0.dot(t1) < 0. && line.chord(i).norm() * (std::min)(t0.norm(), t1.norm()) > zigzag;
  }
  for(int i = 0; i < ns; ++i)
  {
    const double usual = usual_sagitta(line, i, sagitta);
    // at an end there is no second turn to compare: the zigzag of the neighbour goes on
    const bool is_zigzag_end = !line.is_closed() && ns > 1
                            && ((i == 0 && alternates[1]) || (i == ns - 1 && alternates[ns-2]));
    straight[i] = ns == 1 || alternates[i] || is_zigzag_end
               || sagitta[i] > largest_ratio * usual
               || !is_turn_credible(line, i)
               || (sagitta[i] > suspect_ratio * usual
                   && (is_tangent_line(line, i, -1) || is_tangent_line(line, i, 1)));
  }
  return straight;
}

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_CURVES_FIND_STRAIGHT_SEGMENTS_H
