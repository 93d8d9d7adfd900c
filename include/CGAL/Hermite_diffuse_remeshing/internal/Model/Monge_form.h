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

// A surface z = z(x,y) at one point: orthonormal frame and derivatives
//   p = z_x, q = z_y, r = z_xx, s = z_xy, u = z_yy   (u, where the paper has t).
struct Monge_form
{
  Vector x_axis, y_axis, z_axis;
  double p = 0., q = 0., r = 0., s = 0., u = 0.;

  Vector normal() const { return (z_axis - p * x_axis - q * y_axis).normalized(); }

  double gaussian_curvature() const
  {
    const double g = 1. + p * p + q * q;
    return (r * u - s * s) / (g * g);
  }

  double mean_curvature() const
  {
    const double g = 1. + p * p + q * q;
    return ((1. + q * q) * r - 2. * p * q * s + (1. + p * p) * u) / (2. * g * std::sqrt(g));
  }

  // maximum and minimum of the normal curvature
  std::pair<double, double> curvatures() const
  {
    const double h = mean_curvature();
    const double root = std::sqrt((std::max)(0., h * h - gaussian_curvature()));
    return std::make_pair(h + root, h - root);
  }

  Principal_curvatures principal_curvatures() const
  {
    Principal_curvatures result;
    std::tie(result.maximum, result.minimum) = curvatures();

    // Directions: generalised eigenvectors of the second form with respect to the first. In an
    // orthonormal basis of the tangent plane this is an ordinary symmetric problem.
    const Vector n = normal();
    const Vector e1 = (x_axis + p * z_axis).normalized();
    const Vector e2 = n.cross(e1);
    const double g = std::sqrt(1. + p * p + q * q);
    const auto second_form = [&](const Vector& v, const Vector& w)
    {
      const double vx = v.dot(x_axis), vy = v.dot(y_axis), wx = w.dot(x_axis), wy = w.dot(y_axis);
      return (r * vx * wx + s * (vx * wy + vy * wx) + u * vy * wy) / g;
    };
    const double a = second_form(e1, e1), b = second_form(e1, e2), c = second_form(e2, e2);
    const double angle = 0.5 * std::atan2(2. * b, a - c);
    result.maximum_direction = std::cos(angle) * e1 + std::sin(angle) * e2;
    result.minimum_direction = n.cross(result.maximum_direction);
    return result;
  }
};

// a unit vector normal to the unit vector z, a function of z alone
inline Vector any_normal(const Vector& z)
{
  int smallest = 0;
  z.cwiseAbs().minCoeff(&smallest);
  return z.cross(Vector::Unit(smallest)).normalized();
}

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_MODEL_MONGE_FORM_H
