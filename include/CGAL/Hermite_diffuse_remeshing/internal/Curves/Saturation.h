// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_CURVES_SATURATION_H
#define CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_CURVES_SATURATION_H

#include <algorithm>
#include <cmath>
#include <limits>

namespace CGAL {
namespace Hermite_diffuse_remeshing {
namespace internal {

// What is left of the distance h between the smooth and the facetted surface where it may not be larger than b:
// h / (1 + (h/b)^4)^(1/4), with its first two derivatives. It is smooth, keeps small distances to the fourth
// order, and never exceeds b.
class Saturation
{
  double m_bound;

public:
  explicit Saturation(const double bound = std::numeric_limits<double>::infinity()) : m_bound(bound) {}

  double bound() const { return m_bound; }
  bool is_bounded() const { return m_bound < std::numeric_limits<double>::infinity(); }

  struct Value
  {
    double height, slope, curvature;
  };

  Value operator()(const double h) const
  {
    // where the function is its limit up to rounding
    constexpr double saturated = 1e5;
    if(std::abs(h) >= saturated * m_bound)
      return {std::copysign((std::min)(m_bound, std::abs(h)), h), 0., 0.};
    const double r = h / m_bound, base = 1. / (1. + r * r * r * r), root = std::sqrt(std::sqrt(base));
    return {h * root, base * root, -5. * r * r * r / m_bound * base * base * root};
  }
};

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_CURVES_SATURATION_H
