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
    double distance;                    // to the middle of the view
  };

  struct Seen_triangle
  {
    Numbered_triangle triangle;
    double distance;                    // to the middle of the view
  };

  std::vector<Seen_triangle> m_triangles;
  // what most pairs of shadows are told apart by
  struct Extent
  {
    double left, right, low, high;
    const Shadow* shadow;
  };

  std::vector<Shadow> m_shadows;
  std::vector<Extent> m_extents;        // of the shadows, from the left

public:
  void clear() { m_triangles.clear(); }
  void add(const Numbered_triangle& t, const double distance) { m_triangles.push_back({t, distance}); }

  // the radius around the middle, up to a bound, within which no triangle lies above another, seen along an axis
  double simple_radius(const Vector& axis, double bound)
  {
    cast_shadows(axis, bound);
    for(auto s = m_extents.begin(); s != m_extents.end(); ++s)
      for(auto t = s + 1; t != m_extents.end() && t->left < s->right; ++t)
      {
        if(!(s->low < t->high && t->low < s->high))
          continue;
        const double distance = (std::max)(s->shadow->distance, t->shadow->distance);
        if(distance < bound && do_overlap(*s->shadow, *t->shadow))
          bound = distance;
      }
    return bound;
  }

private:
  // of the triangles closer than `bound`
  void cast_shadows(const Vector& axis, const double bound)
  {
    const Vector x_axis = axis.unitOrthogonal(), y_axis = axis.cross(x_axis);
    m_shadows.clear();
    m_extents.clear();
    m_shadows.reserve(m_triangles.size());
    for(const Seen_triangle& seen : m_triangles)
    {
      if(!(seen.distance < bound))
        continue;
      Shadow s;
      s.vertices = seen.triangle.vertices;
      s.distance = seen.distance;
      for(int i = 0; i < 3; ++i)
      {
        s.x[i] = x_axis.dot(seen.triangle.points[i]);
        s.y[i] = y_axis.dot(seen.triangle.points[i]);
      }
      m_shadows.push_back(s);
      m_extents.push_back({(std::min)({s.x[0], s.x[1], s.x[2]}), (std::max)({s.x[0], s.x[1], s.x[2]}),
                           (std::min)({s.y[0], s.y[1], s.y[2]}), (std::max)({s.y[0], s.y[1], s.y[2]}),
                           &m_shadows.back()});
    }
    std::sort(m_extents.begin(), m_extents.end(), [](const Extent& a, const Extent& b)
              { return a.left != b.left ? a.left < b.left : a.shadow < b.shadow; });
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
