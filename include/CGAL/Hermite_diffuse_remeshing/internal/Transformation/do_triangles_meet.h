// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_DO_TRIANGLES_MEET_H
#define CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_DO_TRIANGLES_MEET_H

#include <CGAL/Hermite_diffuse_remeshing/internal/Transformation/Face_grid.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/intersections.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace CGAL {
namespace Hermite_diffuse_remeshing {
namespace internal {

// A triangle of the mesh, or one that may become one. Vertices are the same if their numbers are.
struct Numbered_triangle
{
  std::array<int, 3> vertices;
  std::array<Vector, 3> points;
};

namespace meeting {

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;

inline Kernel::Point_3 exact(const Vector& p) { return Kernel::Point_3(p[0], p[1], p[2]); }

// The predicates want triangles with an area. One without is the segment between the two of its corners that
// are farthest apart, and two without are not looked at.
inline bool is_flat(const std::array<Vector, 3>& p) { return CGAL::collinear(exact(p[0]), exact(p[1]), exact(p[2])); }

inline bool do_meet(const std::array<Vector, 3>& t, const Vector& p, const Vector& q)
{
  return p != q && !is_flat(t)
      && CGAL::do_intersect(Kernel::Triangle_3(exact(t[0]), exact(t[1]), exact(t[2])),
                            Kernel::Segment_3(exact(p), exact(q)));
}

inline bool does_meet_flat(const std::array<Vector, 3>& t, const std::array<Vector, 3>& flat)
{
  int k = 0;
  for(int i = 1; i < 3; ++i)
    if((flat[next(i)] - flat[i]).squaredNorm() > (flat[next(k)] - flat[k]).squaredNorm())
      k = i;
  return do_meet(t, flat[k], flat[next(k)]);
}

inline bool do_meet(const std::array<Vector, 3>& s, const std::array<Vector, 3>& t)
{
  if(is_flat(s))
    return does_meet_flat(t, s);
  if(is_flat(t))
    return does_meet_flat(s, t);
  return CGAL::do_intersect(Kernel::Triangle_3(exact(s[0]), exact(s[1]), exact(s[2])),
                            Kernel::Triangle_3(exact(t[0]), exact(t[1]), exact(t[2])));
}

// Whether a plane through the corner k of a triangle and at a right angle to it, along a side, has both ends
// of a segment on the other side: the segment is clearly apart then. What is not clear is left to the exact
// predicates.
inline bool is_beyond_sides(const std::array<Vector, 3>& t, const int k, const Vector& p, const Vector& q)
{
  const Vector& o = t[k];
  const Vector a = t[next(k)] - o, b = t[previous(k)] - o;
  const Vector n = a.cross(b);
  // relative to the lengths: far above rounding
  constexpr double clearly = 1e-9;
  const auto is_outside = [&](const Vector& outwards)
  {
    const double limit = clearly * outwards.norm();
    return outwards.dot(p - o) > limit * (p - o).norm() && outwards.dot(q - o) > limit * (q - o).norm();
  };
  return is_outside(a.cross(n)) || is_outside(n.cross(b));
}

// triangles with one common corner, k of the first and l of the second
inline bool do_meet_beside_corner(const std::array<Vector, 3>& s, const int k, const std::array<Vector, 3>& t, const int l)
{
  const auto hits = [](const std::array<Vector, 3>& u, const int m, const Vector& p, const Vector& q)
  {
    return !is_beyond_sides(u, m, p, q) && do_meet(u, p, q);
  };
  return hits(s, k, t[next(l)], t[previous(l)]) || hits(t, l, s[next(k)], s[previous(k)]);
}

// triangles with a common side from a to b, and their third corners: only if one is folded onto the other
inline bool do_meet_beside_side(const Vector& a, const Vector& b, const Vector& c, const Vector& d)
{
  const Vector side = b - a, n = side.cross(c - a), m = side.cross(d - a);
  // far above rounding, relative to the lengths: clearly to the two sides of the common one, or out of a plane
  constexpr double clearly = 1e-9;
  if(n.dot(m) < 0. || std::abs(n.dot(d - a)) > clearly * n.norm() * (d - a).norm())
    return false;
  return CGAL::coplanar(exact(a), exact(b), exact(c), exact(d))
      && !is_flat({{a, b, c}}) && !is_flat({{a, b, d}})
      && CGAL::coplanar_orientation(exact(a), exact(b), exact(c), exact(d)) == CGAL::POSITIVE;
}

} // namespace meeting

// Whether two triangles have more in common than the vertices they share, or the side.
inline bool do_triangles_meet(const Numbered_triangle& s, const Numbered_triangle& t)
{
  // k, l: the last common corner; the sums leave the numbers of those that are not common
  int number_of_common = 0, k = 0, l = 0, rest_of_s = 3, rest_of_t = 3;
  for(int i = 0; i < 3; ++i)
    for(int j = 0; j < 3; ++j)
      if(s.vertices[i] == t.vertices[j])
      {
        ++number_of_common;
        k = i;
        l = j;
        rest_of_s -= i;
        rest_of_t -= j;
      }
  if(number_of_common == 3)
    return true;
  if(number_of_common == 2)
    return meeting::do_meet_beside_side(s.points[next(rest_of_s)], s.points[previous(rest_of_s)], s.points[rest_of_s],
                                        t.points[rest_of_t]);
  if(number_of_common == 1)
    return meeting::do_meet_beside_corner(s.points, k, t.points, l);
  return Bounding_box(s.points).meets(Bounding_box(t.points))
      && meeting::do_meet(s.points, t.points);
}

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_DO_TRIANGLES_MEET_H
