// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_MODEL_SCATTER_OF_NORMALS_H
#define CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_MODEL_SCATTER_OF_NORMALS_H

#include <CGAL/Hermite_diffuse_remeshing/internal/Model/Monge_form.h>

#include <cmath>

namespace CGAL {
namespace Hermite_diffuse_remeshing {
namespace internal {

// How normals scatter around one of them, in its plane.
class Scatter_of_normals
{
  Vector m_x, m_y;
  double m_xx = 0., m_xy = 0., m_yy = 0.;

public:
  explicit Scatter_of_normals(const Vector& normal) : m_x(any_normal(normal)), m_y(normal.cross(m_x)) {}

  void add(const Vector& n)
  {
    m_xx += n.dot(m_x) * n.dot(m_x);
    m_xy += n.dot(m_x) * n.dot(m_y);
    m_yy += n.dot(m_y) * n.dot(m_y);
  }

  // between the two principal ones
  double difference() const { return std::hypot(m_xx - m_yy, 2. * m_xy); }

  Vector widest() const
  {
    const double angle = angle_of_larger_axis(m_xx, m_xy, m_yy);
    return std::cos(angle) * m_x + std::sin(angle) * m_y;
  }
};

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_MODEL_SCATTER_OF_NORMALS_H
