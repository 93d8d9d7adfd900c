// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_MODEL_MONGE_FORM_H
#define CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_MODEL_MONGE_FORM_H

#include <CGAL/Hermite_diffuse_remeshing/internal/Indexed_triangles.h>

#include <boost/config.hpp>

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

namespace CGAL {
namespace Hermite_diffuse_remeshing {
namespace internal {

// Principal curvatures, larger first, and their unit directions. A curvature is negative where
// the surface bends away from its normal, as on a convex body with outward normals.
struct Principal_curvatures
{
  double maximum = 0., minimum = 0.;
  Vector maximum_direction = Vector::Zero(), minimum_direction = Vector::Zero();

  double largest_absolute() const { return (std::max)(std::abs(maximum), std::abs(minimum)); }
};

// from the x axis to the principal axis of the symmetric matrix (xx xy; xy yy) with the larger value
inline double angle_of_larger_axis(const double xx, const double xy, const double yy)
{
  return 0.5 * std::atan2(2. * xy, xx - yy);
}

// The second fundamental form in an orthonormal basis of the tangent plane, where the principal curvatures are the
// eigenvalues of a symmetric matrix. They follow from it without the cancellation of H^2 - K, which costs half of the
// digits where they are equal.
struct Second_form
{
  double xx = 0., xy = 0., yy = 0.;

  // maximum and minimum of the normal curvature
  std::pair<double, double> curvatures() const
  {
    const double mean = (xx + yy) / 2., difference = std::hypot((xx - yy) / 2., xy);
    return std::make_pair(mean + difference, mean - difference);
  }

  double largest_absolute_curvature() const
  {
    const std::pair<double, double> k = curvatures();
    return (std::max)(std::abs(k.first), std::abs(k.second));
  }
};

// A surface z = z(x,y) at one point: orthonormal frame and derivatives
//   p = z_x, q = z_y, r = z_xx, s = z_xy, u = z_yy   (u, where the paper has t).
struct Monge_form
{
  Vector x_axis, y_axis, z_axis;
  double p = 0., q = 0., r = 0., s = 0., u = 0.;

  Vector normal() const { return (z_axis - p * x_axis - q * y_axis).normalized(); }

  // maximum and minimum of the normal curvature
  std::pair<double, double> curvatures() const { return second_form().curvatures(); }

  Principal_curvatures principal_curvatures() const
  {
    Principal_curvatures result;
    const Second_form form = second_form();
    std::tie(result.maximum, result.minimum) = form.curvatures();
    const Vector n = normal();
    const Vector e1 = (x_axis + p * z_axis).normalized();
    const Vector e2 = n.cross(e1);
    const double angle = angle_of_larger_axis(form.xx, form.xy, form.yy);
    result.maximum_direction = std::cos(angle) * e1 + std::sin(angle) * e2;
    result.minimum_direction = n.cross(result.maximum_direction);
    return result;
  }

private:
  // in the basis of which the first vector is the tangent over the x axis
  Second_form second_form() const
  {
    const double w = 1. + p * p, g2 = w + q * q, g = std::sqrt(g2), m = p * q;
    return {r / (w * g), (s * w - r * m) / (w * g2), (r * m * m - 2. * s * m * w + u * w * w) / (w * g2 * g)};
  }
};

// a unit vector normal to the unit vector z, a function of z alone
BOOST_FORCEINLINE Vector any_normal(const Vector& z)
{
  int smallest = 0;
  z.cwiseAbs().minCoeff(&smallest);
  return z.cross(Vector::Unit(smallest)).normalized();
}

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_MODEL_MONGE_FORM_H
