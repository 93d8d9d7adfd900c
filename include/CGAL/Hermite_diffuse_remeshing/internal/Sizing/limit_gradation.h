// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_SIZING_LIMIT_GRADATION_H
#define CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_SIZING_LIMIT_GRADATION_H

#include <CGAL/Hermite_diffuse_remeshing/internal/Indexed_triangles.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Progress.h>

#include <boost/range/irange.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL {
namespace Hermite_diffuse_remeshing {
namespace internal {

// Slope of the size with distance that makes the sizes of two adjacent faces differ by the ratio
// `gradation`. In a row of equilateral triangles of size L the centroids are L/sqrt(3) apart, so
// sizes that grow by the ratio g at every step have dL/ds = sqrt(3) ln g. The slope, unlike a
// ratio between the faces of the reference, does not depend on how the reference is meshed.
inline double slope_of_gradation(const double gradation)
{
  return std::sqrt(3.) * std::log(gradation);
}

// The smallest size that the slope allows at p for the sizes s at a and t at b, linear in between:
// the minimum over the points x of the segment of size(x) + slope |p - x|.
inline double bound_from_segment(const Vector& a, const Vector& b, const double s, const double t,
                                 const Vector& p, const double slope)
{
  const double at_ends = (std::min)(s + slope * (p - a).norm(), t + slope * (p - b).norm());
  const double length = (b - a).norm();
  if(!(length > 0.))
    return at_ends;
  const double sine = (t - s) / (slope * length);          // of the angle at which the front arrives
  if(!(std::abs(sine) < 1.))
    return at_ends;
  const Vector direction = (b - a) / length;
  const double foot = (p - a).dot(direction);
  const double height = (p - a - foot * direction).norm();
  const double x = foot - height * sine / std::sqrt(1. - sine * sine);
  if(x <= 0. || x >= length)
    return at_ends;
  // A size may only depend on smaller ones. In an obtuse triangle the front can seem to arrive before it has passed one
  // of the ends, and two vertices would lower each other for ever; there the larger end is the bound, which keeps it
  // monotone in both sizes: what follows is the same in whatever order sizes are lowered. In symmetric triangles the two
  // are equal, which rounding must not decide.
  constexpr double margin = 1e-6;
  const double bound = s + (t - s) * x / length + slope * std::sqrt((foot - x) * (foot - x) + height * height);
  return (std::min)(at_ends, (std::max)(bound, (1. + margin) * (std::max)(s, t)));
}

// The indices, of some, that are in a triangle in which the slope may be too large. Nowhere in a triangle a size is lowered
// to less than the smallest one and what the slope makes of the smallest height.
template <typename PointOfIndex, typename IndexRange>
std::vector<int> find_steep(const std::vector<std::array<int, 3> >& triangles, const PointOfIndex& point,
                            const double slope, const IndexRange& indices, const std::vector<double>& sizes)
{
  // far above the rounding of the heights
  constexpr double margin = 1e-6;
  std::vector<char> is_asked(sizes.size(), false), is_steep(sizes.size(), false);
  for(const int i : indices)
    is_asked[i] = true;
  for(const std::array<int, 3>& triangle : triangles)
  {
    if(!is_asked[triangle[0]] && !is_asked[triangle[1]] && !is_asked[triangle[2]])
      continue;
    const std::array<double, 3> s = {{sizes[triangle[0]], sizes[triangle[1]], sizes[triangle[2]]}};
    const double difference = *std::max_element(s.begin(), s.end()) - *std::min_element(s.begin(), s.end());
    if(!(difference > 0.))
      continue;
    const Vector& a = point(triangle[0]);
    const Vector& b = point(triangle[1]);
    const Vector& c = point(triangle[2]);
    const double longest2 = (std::max)({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
    const double double_area = (b - a).cross(c - a).norm();
    if(difference * std::sqrt(longest2) > (1. - margin) * slope * double_area)
      for(const int i : triangle)
        is_steep[i] = true;
  }
  std::vector<int> result;
  for(const int i : indices)
    if(is_steep[i])
      result.push_back(i);
  return result;
}

// Lowers the sizes until they rise by no more than `slope` per length along the triangles. Fast
// marching from the smallest size up: a size is final when it leaves the queue, and is passed on
// along the sides and across the triangles.
// `triangles`: three indices each, into `sizes` and `point(index)`; `seeds`: the indices from which sizes may have to be
// passed on: all, or, where the slopes have been limited before, those of what has changed since; `note(index, i, j)` is
// called when a size is lowered, from the side between two others.
template <typename PointOfIndex, typename IndexRange, typename Note>
void limit_gradation(const std::vector<std::array<int, 3> >& triangles, const PointOfIndex& point,
                     const double slope, const IndexRange& seeds, std::vector<double>& sizes,
                     const Progress& progress, const Note& note)
{
  // in slivers rounding would lower a size again and again by its last digit
  constexpr double least_gain = 1e-9;
  progress(0.);
  const std::vector<int> steep_seeds = find_steep(triangles, point, slope, seeds, sizes);
  if(steep_seeds.empty())
    return;
  progress(0.);
  std::vector<int> first(sizes.size() + 1, 0);
  for(const std::array<int, 3>& triangle : triangles)
    for(const int i : triangle)
      ++first[i + 1];
  for(std::size_t i = 0; i < sizes.size(); ++i)
    first[i+1] += first[i];
  std::vector<int> incident(first.back()), next_free(first.begin(), first.end() - 1);
  for(std::size_t f = 0; f < triangles.size(); ++f)
    for(const int i : triangles[f])
      incident[next_free[i]++] = static_cast<int>(f);

  progress(0.);
  typedef std::pair<double, int> Entry;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry> > queue;
  for(const int i : steep_seeds)
    queue.push(Entry(sizes[i], i));
  while(!queue.empty())
  {
    progress(0.);
    const Entry top = queue.top();
    queue.pop();
    const int i = top.second;
    if(top.first > sizes[i])
      continue;
    for(int n = first[i]; n < first[i+1]; ++n)
    {
      const std::array<int, 3>& triangle = triangles[incident[n]];
      for(int k = 0; k < 3; ++k)
      {
        const int target = triangle[k];
        // a smaller one is lowered from smaller ones only, which have been here before
        if(!(sizes[target] > sizes[i]))
          continue;
        const int other = triangle[next(k)] == i ? triangle[previous(k)] : triangle[next(k)];
        const double bound = bound_from_segment(point(i), point(other), sizes[i], sizes[other],
                                                point(target), slope);
        if(bound < (1. - least_gain) * sizes[target])
        {
          sizes[target] = bound;
          note(target, i, other);
          queue.push(Entry(bound, target));
        }
      }
    }
  }
}

template <typename PointOfIndex>
void limit_gradation(const std::vector<std::array<int, 3> >& triangles, const PointOfIndex& point,
                     const double slope, std::vector<double>& sizes, const Progress& progress = Progress())
{
  limit_gradation(triangles, point, slope, boost::irange(0, static_cast<int>(sizes.size())), sizes, progress,
                  [](int, int, int) {});
}

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_SIZING_LIMIT_GRADATION_H
