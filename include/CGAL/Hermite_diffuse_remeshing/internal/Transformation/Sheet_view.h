// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_SHEET_VIEW_H
#define CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_SHEET_VIEW_H

#include <CGAL/Hermite_diffuse_remeshing/internal/Transformation/do_triangles_meet.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Hermite_diffuse_remeshing {
namespace internal {

// Triangles of a part of a surface, seen along an axis: tells whether some of them lie above others, as on a
// spiral staircase.
class Sheet_view
{
  struct Shadow
  {
    std::array<int, 3> vertices;
    std::array<double, 3> x, y;
    double right, low, high, distance;
  };

  struct Seen_triangle
  {
    Numbered_triangle triangle;
    double distance;                    // to the middle of the view
  };

  std::vector<Seen_triangle> m_triangles;
  std::vector<Shadow> m_shadows;
  std::vector<std::pair<double, std::size_t> > m_order;           // of the shadows, from the left

public:
  void clear() { m_triangles.clear(); }
  void add(const Numbered_triangle& t, const double distance) { m_triangles.push_back({t, distance}); }

  // the radius around the middle, up to a bound, within which no triangle lies above another, seen along an axis
  double simple_radius(const Vector& axis, double bound)
  {
    cast_shadows(axis);
    for(std::size_t i = 0; i < m_order.size(); ++i)
    {
      const Shadow& s = m_shadows[m_order[i].second];
      for(std::size_t j = i + 1; j < m_order.size() && m_order[j].first < s.right; ++j)
      {
        const Shadow& t = m_shadows[m_order[j].second];
        if(s.low < t.high && t.low < s.high && (std::max)(s.distance, t.distance) < bound && do_overlap(s, t))
          bound = (std::max)(s.distance, t.distance);
      }
    }
    return bound;
  }

private:
  void cast_shadows(const Vector& axis)
  {
    const Vector x_axis = axis.unitOrthogonal(), y_axis = axis.cross(x_axis);
    m_shadows.clear();
    m_order.clear();
    for(const Seen_triangle& seen : m_triangles)
    {
      Shadow s;
      s.vertices = seen.triangle.vertices;
      for(int i = 0; i < 3; ++i)
      {
        s.x[i] = x_axis.dot(seen.triangle.points[i]);
        s.y[i] = y_axis.dot(seen.triangle.points[i]);
      }
      s.right = (std::max)({s.x[0], s.x[1], s.x[2]});
      s.low = (std::min)({s.y[0], s.y[1], s.y[2]});
      s.high = (std::max)({s.y[0], s.y[1], s.y[2]});
      s.distance = seen.distance;
      m_order.push_back(std::make_pair((std::min)({s.x[0], s.x[1], s.x[2]}), m_shadows.size()));
      m_shadows.push_back(s);
    }
    std::sort(m_order.begin(), m_order.end());
  }

  // Neighbours, which have a common vertex, lie side by side as both face the viewer.
  static bool do_overlap(const Shadow& s, const Shadow& t)
  {
    for(const int v : s.vertices)
      if(v == t.vertices[0] || v == t.vertices[1] || v == t.vertices[2])
        return false;
    return !is_separated_by_sides(s, t) && !is_separated_by_sides(t, s);
  }

  // Does a side of s have t on its other side? Both turn left.
  static bool is_separated_by_sides(const Shadow& s, const Shadow& t)
  {
    for(int k = 0; k < 3; ++k)
    {
      const int l = next(k);
      const auto is_outside = [&](const int i)
      { return (s.x[l] - s.x[k]) * (t.y[i] - s.y[k]) <= (s.y[l] - s.y[k]) * (t.x[i] - s.x[k]); };
      if(is_outside(0) && is_outside(1) && is_outside(2))
        return true;
    }
    return false;
  }
};

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_SHEET_VIEW_H
