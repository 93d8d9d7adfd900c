// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_QUALITY_H
#define CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_QUALITY_H

#include <CGAL/Hermite_diffuse_remeshing/internal/Transformation/Reference.h>

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace Hermite_diffuse_remeshing {
namespace internal {

// Two candidates whose scores differ by less are equal: rounding must not choose between them,
// or a rotated input would be meshed otherwise.
constexpr double score_margin = 1e-6;

// 2 sqrt(3) times the radius of the inscribed circle over the longest edge (paper, section 4.5):
// 1 for the equilateral triangle. `double_area` is twice the area.
inline double quality(const Vector& a, const Vector& b, const Vector& c, const double double_area)
{
  const double l1 = (b - a).norm(), l2 = (c - b).norm(), l3 = (a - c).norm();
  const double longest = (std::max)({l1, l2, l3});
  return longest > 0. ? 2. * std::sqrt(3.) * double_area / ((l1 + l2 + l3) * longest) : 0.;
}

inline double quality(const Vector& a, const Vector& b, const Vector& c)
{
  return quality(a, b, c, (b - a).cross(c - a).norm());
}

// Shape and geometric error in one number: the quality times the squared cosine of the angle to the
// model's normal at the middle of the triangle. Negative for a triangle that is turned over.
inline double score(const Vector& a, const Vector& b, const Vector& c, const Vector& model_normal)
{
  const Vector n = (b - a).cross(c - a);
  const double double_area = n.norm();
  if(!(double_area > 0.))
    return 0.;
  const double cosine = n.dot(model_normal) / double_area;
  return cosine > 0. ? quality(a, b, c, double_area) * cosine * cosine : cosine;
}

inline double score(const Reference& reference, const Vector& a, const Vector& b, const Vector& c, const int hint)
{
  return score(a, b, c, reference.normal_near((a + b + c) / 3., hint));
}

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_QUALITY_H
