// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_SIZING_LIMIT_GRADATION_H
#define CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_SIZING_LIMIT_GRADATION_H

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

struct Weighted_link
{
  int first, second;
  double length;
};

// Lowers the sizes until size_j <= size_i + slope * length for all links, by Dijkstra's algorithm
// from the smallest size up: sizes are final when they leave the queue.
inline void limit_gradation(const std::vector<Weighted_link>& links, const double slope,
                            std::vector<double>& sizes)
{
  std::vector<int> first_link(sizes.size() + 1, 0);
  for(const Weighted_link& link : links)
  {
    ++first_link[link.first + 1];
    ++first_link[link.second + 1];
  }
  for(std::size_t i = 0; i < sizes.size(); ++i)
    first_link[i+1] += first_link[i];
  std::vector<std::pair<int, double> > neighbors(first_link.back());
  std::vector<int> next_free(first_link.begin(), first_link.end() - 1);
  for(const Weighted_link& link : links)
  {
    neighbors[next_free[link.first]++] = std::make_pair(link.second, link.length);
    neighbors[next_free[link.second]++] = std::make_pair(link.first, link.length);
  }

  typedef std::pair<double, int> Entry;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry> > queue;
  const auto relax_neighbors = [&](const int i)
  {
    for(int k = first_link[i]; k < first_link[i+1]; ++k)
    {
      const int j = neighbors[k].first;
      const double bound = sizes[i] + slope * neighbors[k].second;
      if(bound < sizes[j])
      {
        sizes[j] = bound;
        queue.push(Entry(bound, j));
      }
    }
  };
  for(std::size_t i = 0; i < sizes.size(); ++i)
    queue.push(Entry(sizes[i], static_cast<int>(i)));
  while(!queue.empty())
  {
    const Entry top = queue.top();
    queue.pop();
    if(top.first <= sizes[top.second])
      relax_neighbors(top.second);
  }
}

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_SIZING_LIMIT_GRADATION_H
