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
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Hermite_diffuse_remeshing {
namespace internal {

// Triangles of a part of a surface, seen along an axis: tells which of them lie above others, as on a spiral
// staircase.
class Sheet_view
{
  struct Shadow
  {
    std::array<int, 3> vertices;
    std::array<double, 3> x, y;
    double left, right, low, high;
    double distance;                    // of the triangle to the middle of the view
  };

  Vector m_x_axis, m_y_axis;
  std::vector<Shadow> m_shadows;

public:
  void start(const Vector& axis)
  {
    m_x_axis = axis.unitOrthogonal();
    m_y_axis = axis.cross(m_x_axis);
    m_shadows.clear();
  }

  void add(const Numbered_triangle& t, const double distance)
  {
    Shadow s;
    s.vertices = t.vertices;
    for(int i = 0; i < 3; ++i)
    {
      s.x[i] = m_x_axis.dot(t.points[i]);
      s.y[i] = m_y_axis.dot(t.points[i]);
    }
    s.left = (std::min)({s.x[0], s.x[1], s.x[2]});
    s.right = (std::max)({s.x[0], s.x[1], s.x[2]});
    s.low = (std::min)({s.y[0], s.y[1], s.y[2]});
    s.high = (std::max)({s.y[0], s.y[1], s.y[2]});
    s.distance = distance;
    m_shadows.push_back(s);
  }

  // the radius around the middle, up to a bound, within which no triangle lies above another
  double simple_radius(double bound)
  {
    std::sort(m_shadows.begin(), m_shadows.end(), [](const Shadow& s, const Shadow& t) { return s.left < t.left; });
    for(std::size_t i = 0; i < m_shadows.size(); ++i)
      for(std::size_t j = i + 1; j < m_shadows.size() && m_shadows[j].left < m_shadows[i].right; ++j)
      {
        const Shadow& s = m_shadows[i];
        const Shadow& t = m_shadows[j];
        if(s.low < t.high && t.low < s.high && (std::max)(s.distance, t.distance) < bound && do_overlap(s, t))
          bound = (std::max)(s.distance, t.distance);
      }
    return bound;
  }

private:
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
