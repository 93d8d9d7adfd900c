// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_SIZING_NUMBER_OF_EQUILATERAL_FACES_H
#define CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_SIZING_NUMBER_OF_EQUILATERAL_FACES_H

#include <CGAL/Hermite_diffuse_remeshing/internal/Indexed_triangles.h>

#include <array>
#include <cmath>

namespace CGAL {
namespace Hermite_diffuse_remeshing {
namespace internal {

// An equilateral triangle with sides L has the area sqrt(3)/4 L^2, so a region is covered by the
// integral of 4/(sqrt(3) L^2) of them. Over the triangle abc with sizes that are linear in it, by the
// quadrature of degree two with points inside: the integrand is smooth where sizes vary little in a cell.
inline double number_of_equilateral_faces(const Vector& a, const Vector& b, const Vector& c,
                                          const std::array<double, 3>& sizes)
{
  const double area = (b - a).cross(c - a).norm() / 2.;
  double mean = 0.;
  for(int k = 0; k < 3; ++k)
  {
    const double size = 2. / 3. * sizes[k] + (sizes[next(k)] + sizes[previous(k)]) / 6.;
    mean += 1. / (3. * size * size);
  }
  return 4. / std::sqrt(3.) * area * mean;
}

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_SIZING_NUMBER_OF_EQUILATERAL_FACES_H
