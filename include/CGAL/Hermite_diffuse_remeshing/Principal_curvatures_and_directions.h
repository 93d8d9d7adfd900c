// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_REMESHING_PRINCIPAL_CURVATURES_AND_DIRECTIONS_H
#define CGAL_HERMITE_DIFFUSE_REMESHING_PRINCIPAL_CURVATURES_AND_DIRECTIONS_H

#include <CGAL/license/Hermite_diffuse_remeshing.h>

#include <CGAL/Hermite_diffuse_remeshing/internal/Model/Monge_form.h>

namespace CGAL {
namespace Hermite_diffuse_remeshing {

/*!
 * \ingroup PkgHermiteDiffuseRemeshingRef
 *
 * The class `Principal_curvatures_and_directions` holds the principal curvatures of a surface at a point, in
 * one over the unit of length, and their directions, orthogonal unit vectors of the tangent plane. A
 * curvature is positive where the surface bends away from its normal: both are on a sphere with
 * outward normals. This is the sign of `CGAL::Polygon_mesh_processing::interpolated_corrected_curvatures()`, the class
 * for the results of which has the same members; `CGAL::Monge_via_jet_fitting` has the opposite one.
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

  FT min_curvature = FT(0);       ///< the smaller one, with its sign
  FT max_curvature = FT(0);       ///< the larger one, with its sign
  Vector_3 min_direction;         ///< of the smaller one
  Vector_3 max_direction;         ///< of the larger one

  /// half the sum of the curvatures.
  FT mean_curvature() const { return (max_curvature + min_curvature) / FT(2); }
  /// the product of the curvatures.
  FT Gaussian_curvature() const { return max_curvature * min_curvature; }
};

namespace internal {

// Fits look at a surface along its normal, from where a body is concave: to the user the signs are the other ones.
template <typename GeomTraits>
Principal_curvatures_and_directions<GeomTraits> to_public(const Principal_curvatures& k, const GeomTraits& traits)
{
  typedef typename GeomTraits::FT FT;
  const typename GeomTraits::Construct_vector_3 vector = traits.construct_vector_3_object();
  const auto to_vector = [&](const Vector& v) { return vector(FT(v[0]), FT(v[1]), FT(v[2])); };
  // no negative zeros
  return {FT(0. - k.maximum), FT(0. - k.minimum), to_vector(k.maximum_direction), to_vector(k.minimum_direction)};
}

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_PRINCIPAL_CURVATURES_AND_DIRECTIONS_H
