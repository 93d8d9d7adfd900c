// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_MODEL_LOCAL_QUADRIC_H
#define CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_MODEL_LOCAL_QUADRIC_H

#include <CGAL/Hermite_diffuse_remeshing/internal/Curves/Saturation.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Model/Monge_form.h>

#include <array>

namespace CGAL {
namespace Hermite_diffuse_remeshing {
namespace internal {

// The local surface z = a0 + a1 x + a2 y + a3 x^2 + a4 xy + a5 y^2 in units of `size`, in a frame
// that moves with the query: what a fit knows around its origin.
struct Local_quadric
{
  Vector origin, x_axis, y_axis, z_axis;
  double size = 1.;
  std::array<double, 6> a = {{0., 0., 0., 0., 0., 0.}};

  Vector point() const { return origin + size * a[0] * z_axis; }
  Vector normal() const { return (z_axis - a[1] * x_axis - a[2] * y_axis).normalized(); }

  // the same quadric, expanded at the foot of p in the plane of the frame
  Local_quadric expanded_at(const Vector& p) const
  {
    Local_quadric result = *this;
    const double x = (p - origin).dot(x_axis) / size, y = (p - origin).dot(y_axis) / size;
    result.origin = origin + size * (x * x_axis + y * y_axis);
    result.a[0] = a[0] + x * (a[1] + a[3] * x + a[4] * y) + y * (a[2] + a[5] * y);
    result.a[1] = a[1] + 2. * a[3] * x + a[4] * y;
    result.a[2] = a[2] + a[4] * x + 2. * a[5] * y;
    return result;
  }

  // The same quadric with its height over a facet bounded: the facet goes through p, the foot of which is the origin.
  Local_quadric saturated(const Vector& p, const Vector& facet_normal, const Saturation& saturation) const
  {
    const double height = (p - origin).dot(z_axis) / size, nz = facet_normal.dot(z_axis);
    // of a facet that the frame does not see from above the slope says nothing
    constexpr double least_cosine = 0.2;
    const bool is_seen = nz > least_cosine * facet_normal.norm();
    const double p_x = is_seen ? -facet_normal.dot(x_axis) / nz : 0.;
    const double p_y = is_seen ? -facet_normal.dot(y_axis) / nz : 0.;
    const Saturation::Value bounded = saturation(size * (a[0] - height));
    const double over_x = a[1] - p_x, over_y = a[2] - p_y, c = size * bounded.curvature / 2.;
    Local_quadric result = *this;
    result.a = {{height + bounded.height / size, p_x + bounded.slope * over_x, p_y + bounded.slope * over_y,
                 bounded.slope * a[3] + c * over_x * over_x, bounded.slope * a[4] + 2. * c * over_x * over_y,
                 bounded.slope * a[5] + c * over_y * over_y}};
    return result;
  }

  Monge_form monge_form() const
  {
    return {x_axis, y_axis, z_axis, a[1], a[2], 2. * a[3] / size, a[4] / size, 2. * a[5] / size};
  }
};

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_MODEL_LOCAL_QUADRIC_H
