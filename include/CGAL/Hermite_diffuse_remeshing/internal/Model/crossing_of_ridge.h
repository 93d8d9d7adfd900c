// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_MODEL_CROSSING_OF_RIDGE_H
#define CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_MODEL_CROSSING_OF_RIDGE_H

#include <CGAL/Hermite_diffuse_remeshing/internal/Model/Reference_surface.h>

namespace CGAL {
namespace Hermite_diffuse_remeshing {
namespace internal {

// The model has a ridge along the sides of coarse faces, where their fits meet; over needles one of many degrees. Where
// a chord between two places of faces with a common side crosses it, in the middle plane of both faces: the place on
// the side. Without a face if there is none.
inline Location crossing_of_ridge(const Reference_surface& surface, const Location& from, const Vector& p,
                                  const Location& to, const Vector& q)
{
  const Indexed_triangles& triangles = surface.triangles();
  for(int k = 0; k < 3; ++k)
  {
    if(surface.cut_mesh().neighbor(from.face, k) != to.face)
      continue;
    const Vector end = triangles.point(from.face, k), side = triangles.point(from.face, next(k)) - end;
    const Vector across = side.cross(triangles.area_vector(from.face).stableNormalized()
                                     + triangles.area_vector(to.face).stableNormalized());
    const double before = (p - end).dot(across), behind = (q - end).dot(across);
    if(!(before * behind < 0.))
      continue;
    const Vector crossing = p + before / (before - behind) * (q - p);
    const double u = (crossing - end).dot(side) / side.squaredNorm();
    if(u > 0. && u < 1.)
      return location_on_side({from.face, k}, u);
  }
  return Location();
}

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_MODEL_CROSSING_OF_RIDGE_H
