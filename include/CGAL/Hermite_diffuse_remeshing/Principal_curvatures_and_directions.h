// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_REMESHING_PRINCIPAL_CURVATURES_AND_DIRECTIONS_H
#define CGAL_HERMITE_DIFFUSE_REMESHING_PRINCIPAL_CURVATURES_AND_DIRECTIONS_H

namespace CGAL {
namespace Hermite_diffuse_remeshing {

/*!
 * \ingroup PkgHermiteDiffuseRemeshingRef
 *
 * The class `Principal_curvatures_and_directions` holds the principal curvatures of a surface at a point, in
 * one over the unit of length, and their directions, orthogonal unit vectors of the tangent plane. A
 * curvature is negative where the surface bends away from its normal: both are on a sphere with
 * outward normals.
 *
 * \tparam GeomTraits a type with the types `FT` and `Vector_3`
 */
template <typename GeomTraits>
struct Principal_curvatures_and_directions
{
  /// number type
  typedef typename GeomTraits::FT FT;
  /// type of a direction
  typedef typename GeomTraits::Vector_3 Vector_3;

  FT maximum_curvature = FT(0);       ///< the larger one, with its sign
  FT minimum_curvature = FT(0);       ///< the smaller one, with its sign
  Vector_3 maximum_direction;         ///< of the larger one
  Vector_3 minimum_direction;         ///< of the smaller one

  /// half the sum of the curvatures.
  FT mean_curvature() const { return (maximum_curvature + minimum_curvature) / FT(2); }
  /// the product of the curvatures.
  FT gaussian_curvature() const { return maximum_curvature * minimum_curvature; }
};

} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_PRINCIPAL_CURVATURES_AND_DIRECTIONS_H
