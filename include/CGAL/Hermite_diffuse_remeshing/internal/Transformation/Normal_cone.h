// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_NORMAL_CONE_H
#define CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_NORMAL_CONE_H

#include <CGAL/Hermite_diffuse_remeshing/internal/Indexed_triangles.h>

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace Hermite_diffuse_remeshing {
namespace internal {

// A cone of directions that grows, as little as it can, to hold more of them
class Normal_cone
{
  Vector m_axis;
  double m_angle, m_cosine;             // between the axis and the mantle

public:
  Normal_cone(const Vector& axis, const double angle) : m_axis(axis), m_angle(angle), m_cosine(std::cos(angle)) {}

  const Vector& axis() const { return m_axis; }

  // with a direction of length one; false, and no change, if the angle would exceed `largest_angle`
  bool add(const Vector& n, const double largest_angle)
  {
    const double cosine = m_axis.dot(n);
    if(cosine >= m_cosine)
      return true;
    const double angle = std::acos((std::max)(-1., cosine));
    const double new_angle = (m_angle + angle) / 2.;
    const Vector aside = n - cosine * m_axis;
    const double length = aside.norm();
    if(!(new_angle <= largest_angle && length > 0.))
      return false;
    const double turn = new_angle - m_angle;
    m_axis = (std::cos(turn) * m_axis + std::sin(turn) / length * aside).normalized();
    m_angle = new_angle;
    m_cosine = std::cos(new_angle);
    return true;
  }
};

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_NORMAL_CONE_H
