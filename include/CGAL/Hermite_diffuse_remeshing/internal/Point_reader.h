// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_POINT_READER_H
#define CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_POINT_READER_H

#include <CGAL/Hermite_diffuse_remeshing/internal/Indexed_triangles.h>

#include <CGAL/number_utils.h>

namespace CGAL {
namespace Hermite_diffuse_remeshing {
namespace internal {

// The coordinates of points and vectors of the user, through the functors of his traits.
template <typename GeomTraits>
class Point_reader
{
  typename GeomTraits::Compute_x_3 m_x;
  typename GeomTraits::Compute_y_3 m_y;
  typename GeomTraits::Compute_z_3 m_z;

public:
  explicit Point_reader(const GeomTraits& traits)
    : m_x(traits.compute_x_3_object())
    , m_y(traits.compute_y_3_object())
    , m_z(traits.compute_z_3_object())
  {}

  template <typename Point_or_vector>
  Vector operator()(const Point_or_vector& p) const
  {
    return Vector(CGAL::to_double(m_x(p)), CGAL::to_double(m_y(p)), CGAL::to_double(m_z(p)));
  }
};

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_POINT_READER_H
