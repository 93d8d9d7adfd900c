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

#include <boost/container/static_vector.hpp>

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

// The same where the faces have no common side but one between them, as at the thin end of a needle: the places on both
// sides of it. Farther apart the vertices of the faces tell enough.
inline boost::container::static_vector<Location, 2>
crossings_of_ridges(const Reference_surface& surface, const Location& from, const Vector& p, const Location& to,
                    const Vector& q)
{
  boost::container::static_vector<Location, 2> result;
  if(from.face == to.face)
    return result;
  const Location crossing = crossing_of_ridge(surface, from, p, to, q);
  if(crossing.face != -1)
    result.push_back(crossing);
  else
    for(int k = 0; k < 3 && result.empty(); ++k)
    {
      Location between;
      between.face = surface.cut_mesh().neighbor(from.face, k);
      if(between.face == -1 || between.face == to.face)
        continue;
      const Location second = crossing_of_ridge(surface, between, p, to, q);
      if(second.face == -1)
        continue;
      const Location first = crossing_of_ridge(surface, from, p, between, q);
      if(first.face != -1)
        result = {first, second};
    }
  return result;
}

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_MODEL_CROSSING_OF_RIDGE_H
