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

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <cstddef>
#include <limits>

namespace CGAL {
namespace Hermite_diffuse_remeshing {
namespace internal {

// Where a chord leaves a face of the reference.
struct Chord_crossing
{
  int beside = -1;                      // the next face; -1 if the chord ends in this one, or a feature or border ends it
  double part = 0.;                     // of the chord, up to here
  double miss = (std::numeric_limits<double>::infinity)();      // beyond the end of the side, in lengths of it
  Location location;                    // on the side
};

// In the middle plane of both faces at a side, beyond the part of the chord from p to q. `came_from`: the face before.
inline Chord_crossing leave_face(const Reference_surface& surface, const int face, const int came_from, const Vector& p,
                                 const Vector& q, const double part)
{
  // of the chord: what rounding makes of places on a side
  constexpr double tolerance = 1e-9;
  // of a side: past a vertex the chord may miss all sides, since their middle planes lean
  constexpr double largest_miss = 0.1;
  const Indexed_triangles& triangles = surface.triangles();
  const Vector normal = triangles.area_vector(face).stableNormalized();
  Chord_crossing result;
  for(int k = 0; k < 3; ++k)
  {
    const int beside = surface.cut_mesh().neighbor(face, k);
    if(beside == -1 || beside == came_from)
      continue;
    const Vector end = triangles.point(face, k), side = triangles.point(face, next(k)) - end;
    const Vector outward = side.cross(normal + triangles.area_vector(beside).stableNormalized());
    const double speed = (q - p).dot(outward), at = (end - p).dot(outward) / speed;
    if(!(speed > 0. && at >= part - tolerance && at < 1.))
      continue;
    const double u = (p + at * (q - p) - end).dot(side) / side.squaredNorm();
    const double miss = (std::max)({0., -u, u - 1.});
    if(miss < (std::min)(result.miss, largest_miss))
      result = {beside, at, miss, location_on_side({face, k}, (std::min)((std::max)(u, 0.), 1.))};
  }
  return result;
}

// The model has a ridge along the sides of coarse faces, where their fits meet; over needles one of many degrees, and
// where it may not leave the facets, at all of them. Where a chord that begins over the face crosses them.
inline boost::container::small_vector<Location, 4>
crossings_of_ridges(const Reference_surface& surface, int face, const Vector& p, const Vector& q)
{
  // where a chord spans more faces, their vertices tell enough
  constexpr std::size_t largest_number = 64;
  boost::container::small_vector<Location, 4> result;
  int came_from = -1;
  for(double part = 0.; result.size() < largest_number; )
  {
    const Chord_crossing crossing = leave_face(surface, face, came_from, p, q, part);
    if(crossing.beside == -1)
      break;
    result.push_back(crossing.location);
    came_from = face;
    face = crossing.beside;
    part = crossing.part;
  }
  return result;
}

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_MODEL_CROSSING_OF_RIDGE_H
