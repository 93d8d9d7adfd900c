// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_POLYGON_TRIANGULATIONS_H
#define CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_POLYGON_TRIANGULATIONS_H

#include <CGAL/Hermite_diffuse_remeshing/internal/Transformation/quality.h>

#include <CGAL/assertions.h>

#include <array>
#include <vector>

namespace CGAL {
namespace Hermite_diffuse_remeshing {
namespace internal {

typedef std::array<int, 3> Corner_triple;
typedef std::vector<Corner_triple> Polygon_triangulation;

constexpr int largest_tabulated_polygon = 8;

// All triangulations without new vertices of a polygon with up to 8 corners: 1, 2, 5, 14, 42 and 132 of
// them (the Catalan numbers). The triangle at the side from the last corner to the first splits a polygon
// into two smaller ones.
class Triangulation_table
{
  std::array<std::vector<Polygon_triangulation>, largest_tabulated_polygon + 1> m_of_size;

  // of the corners first, first + 1, ..., last
  static std::vector<Polygon_triangulation> all_between(const int first, const int last)
  {
    if(last - first < 2)
      return std::vector<Polygon_triangulation>(1);
    std::vector<Polygon_triangulation> result;
    for(int apex = first + 1; apex < last; ++apex)
      for(const Polygon_triangulation& left : all_between(first, apex))
        for(const Polygon_triangulation& right : all_between(apex, last))
        {
          Polygon_triangulation t(1, Corner_triple{{first, apex, last}});
          t.insert(t.end(), left.begin(), left.end());
          t.insert(t.end(), right.begin(), right.end());
          result.push_back(t);
        }
    return result;
  }

  Triangulation_table()
  {
    for(int n = 3; n <= largest_tabulated_polygon; ++n)
      m_of_size[n] = all_between(0, n - 1);
  }

public:
  static const std::vector<Polygon_triangulation>& of_size(const int n)
  {
    static const Triangulation_table table;
    CGAL_precondition(n >= 3 && n <= largest_tabulated_polygon);
    return table.m_of_size[n];
  }
};

struct Scored_triangulation
{
  Worth worth{-1., 0.};
  Polygon_triangulation triangles;
};

// The triangulation of a polygon with n corners whose worst triangle is best; `triangle_worth(i, j, k)`
// with i < j < k tells what one is worth. Polygons larger than the table are split where the worse of the
// two parts and of the triangle between them is best, from the small parts to the large ones: the same
// optimum in O(n^3).
template <typename TriangleWorth>
Scored_triangulation best_triangulation(const int n, const TriangleWorth& triangle_worth)
{
  std::vector<Worth> worths(n * n * n);
  const auto worth_of = [&](const int i, const int j, const int k) -> Worth& { return worths[(i * n + j) * n + k]; };
  for(int i = 0; i < n; ++i)
    for(int j = i + 1; j < n; ++j)
      for(int k = j + 1; k < n; ++k)
        worth_of(i, j, k) = triangle_worth(i, j, k);

  Scored_triangulation best;
  if(n <= largest_tabulated_polygon)
  {
    const Polygon_triangulation* chosen = nullptr;
    for(const Polygon_triangulation& candidate : Triangulation_table::of_size(n))
    {
      Worth worst;
      for(const Corner_triple& t : candidate)
        worst.add(worth_of(t[0], t[1], t[2]));
      if(chosen == nullptr || worst.score > best.worth.score + score_margin)
      {
        best.worth = worst;
        chosen = &candidate;
      }
    }
    best.triangles = *chosen;
    return best;
  }

  std::vector<Worth> worst(n * n);
  std::vector<int> apex(n * n, -1);
  for(int length = 2; length < n; ++length)
    for(int i = 0; i + length < n; ++i)
    {
      const int k = i + length;
      for(int j = i + 1; j < k; ++j)
      {
        Worth candidate = worth_of(i, j, k);
        candidate.add(worst[i * n + j]);
        candidate.add(worst[j * n + k]);
        if(apex[i * n + k] == -1 || candidate.score > worst[i * n + k].score + score_margin)
        {
          worst[i * n + k] = candidate;
          apex[i * n + k] = j;
        }
      }
    }
  best.worth = worst[n - 1];
  std::vector<std::array<int, 2> > open(1, std::array<int, 2>{{0, n - 1}});
  while(!open.empty())
  {
    const std::array<int, 2> side = open.back();
    open.pop_back();
    if(side[1] - side[0] < 2)
      continue;
    const int j = apex[side[0] * n + side[1]];
    best.triangles.push_back(Corner_triple{{side[0], j, side[1]}});
    open.push_back({{side[0], j}});
    open.push_back({{j, side[1]}});
  }
  return best;
}

// the sides of the triangles that are no sides of the polygon
inline std::vector<std::array<int, 2> > diagonals(const int n, const Polygon_triangulation& triangles)
{
  std::vector<std::array<int, 2> > result;
  for(const Corner_triple& t : triangles)
  {
    // every diagonal is the long side of one triangle
    if(t[2] - t[0] != n - 1)
      result.push_back({{t[0], t[2]}});
  }
  return result;
}

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_POLYGON_TRIANGULATIONS_H
