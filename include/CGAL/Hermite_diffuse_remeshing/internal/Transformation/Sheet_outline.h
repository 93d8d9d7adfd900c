// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_SHEET_OUTLINE_H
#define CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_SHEET_OUTLINE_H

#include <CGAL/Hermite_diffuse_remeshing/internal/Transformation/do_triangles_meet.h>

#include <algorithm>
#include <array>
#include <vector>

namespace CGAL {
namespace Hermite_diffuse_remeshing {
namespace internal {

// The outline of triangles that hang together and face the viewer, seen along an axis. If no two of its sides cross,
// none of the triangles lies above another: a point is below as many of them as the outline winds around it. An
// outline that does not cross itself consists of loops, n of which turn to the left and m to the right, and n - m is
// the Euler characteristic 2 - 2g - (n + m): then n = 1 - g, which leaves one loop around all the others, and winds
// once around what is inside.
class Sheet_outline
{
  struct Side
  {
    std::array<int, 2> vertices;
    std::array<double, 2> x, y;

    double left() const { return (std::min)(x[0], x[1]); }
    double right() const { return (std::max)(x[0], x[1]); }
    double low() const { return (std::min)(y[0], y[1]); }
    double high() const { return (std::max)(y[0], y[1]); }
  };

  Vector m_x_axis = Vector::UnitX(), m_y_axis = Vector::UnitY();
  std::vector<Side> m_sides;

public:
  // forgets all sides
  void look_along(const Vector& axis)
  {
    m_x_axis = axis.unitOrthogonal();
    m_y_axis = axis.cross(m_x_axis);
    m_sides.clear();
  }

  // the side from corner k of the triangle to the next one
  void add(const Numbered_triangle& t, const int k)
  {
    const int l = next(k);
    m_sides.push_back({{{t.vertices[k], t.vertices[l]}},
                       {{m_x_axis.dot(t.points[k]), m_x_axis.dot(t.points[l])}},
                       {{m_y_axis.dot(t.points[k]), m_y_axis.dot(t.points[l])}}});
  }

  // does no side cross or touch another that it has no end in common with?
  bool is_simple()
  {
    std::sort(m_sides.begin(), m_sides.end(), [](const Side& s, const Side& t)
              { return s.left() != t.left() ? s.left() < t.left() : s.vertices < t.vertices; });
    for(auto s = m_sides.begin(); s != m_sides.end(); ++s)
      for(auto t = s + 1; t != m_sides.end() && t->left() <= s->right(); ++t)
        if(s->low() <= t->high() && t->low() <= s->high() && do_cross(*s, *t))
          return false;
    return true;
  }

private:
  static bool do_cross(const Side& s, const Side& t)
  {
    for(const int v : s.vertices)
      if(v == t.vertices[0] || v == t.vertices[1])
        return false;
    return !is_on_one_side(s, t) && !is_on_one_side(t, s);
  }

  // of the line through s
  static bool is_on_one_side(const Side& s, const Side& t)
  {
    const auto area = [&](const int i)
    { return (s.x[1] - s.x[0]) * (t.y[i] - s.y[0]) - (s.y[1] - s.y[0]) * (t.x[i] - s.x[0]); };
    const double a = area(0), b = area(1);
    return (a > 0. && b > 0.) || (a < 0. && b < 0.);
  }
};

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_SHEET_OUTLINE_H
