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

// Q = 2 sqrt(3) rho / L, the paper's quality: rho is the radius of the inscribed circle, L the longest
// side, Q = 1 for an equilateral triangle.
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

// What one triangle is worth, or the worst of several. The score is the quality times the squared cosine
// of the angle to the model's normal, which for a triangle inscribed in a curved surface measures the
// geometric error; negative where the triangle is turned against the model.
struct Worth
{
  double score = 1., quality = 1.;

  void add(const Worth& other)
  {
    score = (std::min)(score, other.score);
    quality = (std::min)(quality, other.quality);
  }
};

// a better score is better by this at least
constexpr double score_margin = 1e-6;
// Equal scores and qualities, which symmetric triangles have, are computed with about this difference at
// most: what may not fall may fall by so much, so that rounding does not decide.
constexpr double score_rounding = 1e-9;

inline bool is_no_worse(const Worth& after, const Worth& before)
{
  return after.score >= before.score - score_rounding && after.quality >= before.quality - score_rounding;
}

// a change that is worth making
inline bool is_better(const Worth& after, const Worth& before)
{
  return after.score > before.score + score_margin && is_no_worse(after, before);
}

// `model_normal` may have any length
inline Worth worth(const Vector& a, const Vector& b, const Vector& c, const Vector& model_normal)
{
  const Vector n = (b - a).cross(c - a);
  const double double_area = n.norm();
  Worth result{0., 0.};
  if(!(double_area > 0.))
    return result;
  result.quality = quality(a, b, c, double_area);
  const double cosine = n.dot(model_normal) / double_area;
  const double squared_length = model_normal.squaredNorm();
  if(cosine > 0.)
    result.score = result.quality * cosine * cosine / squared_length;
  else if(cosine < 0.)
    result.score = cosine / std::sqrt(squared_length);
  return result;
}

// The model's normal at a triangle: the mean of those at its vertices, which is close to the one at the
// centroid and costs no search; their sum is as good. Sites on curves have none; where less than two others are
// left, it is looked up on the reference, near the face `hint`.
inline Vector triangle_normal(const Reference& reference, const Site& a, const Site& b, const Site& c, const int hint)
{
  if(a.has_normal() + b.has_normal() + c.has_normal() < 2)
    return reference.normal_near((a.point + b.point + c.point) / 3., hint);
  return a.normal + b.normal + c.normal;
}

inline Worth worth(const Reference& reference, const Site& a, const Site& b, const Site& c, const int hint)
{
  return worth(a.point, b.point, c.point, triangle_normal(reference, a, b, c, hint));
}

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_QUALITY_H
