// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_MODEL_CLOSEST_BARYCENTRIC_H
#define CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_MODEL_CLOSEST_BARYCENTRIC_H

#include <CGAL/Hermite_diffuse_remeshing/internal/Indexed_triangles.h>

#include <algorithm>
#include <limits>

namespace CGAL {
namespace Hermite_diffuse_remeshing {
namespace internal {

// Barycentric coordinates of the point of the triangle (a,b,c) closest to p; coordinates are exactly
// zero where the closest point is on a side or at a corner.
inline Barycentric closest_barycentric(const Vector& a, const Vector& b, const Vector& c, const Vector& p)
{
  const auto on_segment = [](const Vector& s, const Vector& t, const Vector& q)
  {
    const Vector d = t - s;
    const double length2 = d.squaredNorm();
    return length2 > 0. ? (std::min)(1., (std::max)(0., (q - s).dot(d) / length2)) : 0.;
  };
  const Vector n = (b - a).cross(c - a);
  const double area2 = n.squaredNorm();
  Barycentric l = {{-1., -1., -1.}};
  if(area2 > 0.)
  {
    l[0] = (b - p).cross(c - p).dot(n) / area2;
    l[1] = (c - p).cross(a - p).dot(n) / area2;
    l[2] = 1. - l[0] - l[1];
  }
  if(l[0] >= 0. && l[1] >= 0. && l[2] >= 0.)
    return l;

  // on the border: the closest of the sides that p is beyond
  const Vector* const corner[3] = {&a, &b, &c};
  double best = (std::numeric_limits<double>::max)();
  Barycentric result = {{1., 0., 0.}};
  for(int k = 0; k < 3; ++k)
  {
    if(l[previous(k)] >= 0.)
      continue;
    const Vector& s = *corner[k];
    const Vector& t = *corner[next(k)];
    const double u = on_segment(s, t, p);
    const double distance2 = (p - s - u * (t - s)).squaredNorm();
    if(distance2 < best)
    {
      best = distance2;
      result[k] = 1. - u;
      result[next(k)] = u;
      result[previous(k)] = 0.;
    }
  }
  return result;
}

inline Location closest_on_face(const Indexed_triangles& triangles, const int f, const Vector& p)
{
  Location location;
  location.face = f;
  location.coordinates = closest_barycentric(triangles.point(f, 0), triangles.point(f, 1), triangles.point(f, 2), p);
  return location;
}

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_MODEL_CLOSEST_BARYCENTRIC_H
