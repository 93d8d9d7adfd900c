// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_SIZING_SIZE_FROM_CURVATURE_H
#define CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_SIZING_SIZE_FROM_CURVATURE_H

#include <cmath>

namespace CGAL {
namespace Hermite_diffuse_remeshing {
namespace internal {

// The error law of the paper's section 3 with the factor 1/8 that its expansion needs: for a chord of
// length L on a circle of radius R, the norm of the two strains between chord and arc is
//   eps = (xi^2/8) sqrt(1 + 1/(1 - xi^2/4)^2),  xi = L/R < 2.
inline double error_of_length(const double length_over_radius)
{
  const double u = length_over_radius * length_over_radius;
  const double c = 1. - u / 4.;
  return u / 8. * std::sqrt(1. + 1. / (c * c));
}

// The inverse: L/R of an error. The second-order expansion sqrt(2 eps)(1.68179 - 0.594604 eps) is
// within 0.1 % up to eps = 0.077; Newton on u = xi^2 then makes it exact, also for large errors.
inline double length_of_error(const double error)
{
  const double first = 2. * std::pow(2., -0.25), second = first / (2. * std::sqrt(2.));
  const double guess = std::sqrt(2. * error) * (first - second * error);
  constexpr double largest_u = 3.9;                       // the law ends at u = 4
  double u = error < 1. ? guess * guess : largest_u / 2.;
  constexpr int maximum_number_of_steps = 50;
  for(int i = 0; i < maximum_number_of_steps; ++i)
  {
    const double c = 1. - u / 4., root = std::sqrt(1. + 1. / (c * c));
    const double value = u / 8. * root - error;
    const double derivative = root / 8. + u / (32. * c * c * c * root);
    double u_next = u - value / derivative;
    if(u_next >= 4.)
      u_next = (u + 4.) / 2.;
    if(u_next <= 0.)
      u_next = u / 2.;
    const bool is_done = std::abs(u_next - u) <= 1e-15 * u;
    u = u_next;
    if(is_done)
      break;
  }
  return std::sqrt(u);
}

// The chord with this sagitta on a circle, s = R - sqrt(R^2 - L^2/4); no chord is longer than the diameter.
inline double length_of_sagitta(const double sagitta, const double radius)
{
  return sagitta < radius ? 2. * std::sqrt(sagitta * (2. * radius - sagitta)) : 2. * radius;
}

// Edge length of an equilateral triangle inscribed in a sphere whose middle is `deviation` below the
// sphere: the circumscribed circle has the radius L/sqrt(3) and the sagitta L^2/(6 R).
inline double length_of_deviation(const double deviation, const double radius)
{
  return std::sqrt(6. * deviation * radius);
}

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_SIZING_SIZE_FROM_CURVATURE_H
