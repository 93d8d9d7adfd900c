// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_REMESHING_MODEL_CHOICES_H
#define CGAL_HERMITE_DIFFUSE_REMESHING_MODEL_CHOICES_H

#include <CGAL/license/Hermite_diffuse_remeshing.h>

namespace CGAL {
namespace Hermite_diffuse_remeshing {

/*!
 * \ingroup PkgHermiteDiffuseRemeshingRef
 *
 * chooses how the normals at the nodes are found from the positions.
 */
enum Normal_estimation
{
  FITTED_NORMALS,   ///< quartic fit over two rings, lower degrees where it is not determined: order 3 to 4
  SMOOTH_NORMALS,   ///< three sweeps of quadratic Hermite fits: for noisy positions, as of scans and isosurfaces. Sizes
                    ///< then follow the mean curvature over as many faces as six elements cover, not that of the noise
  MAX_NORMALS,      ///< weights of Max (1999), exact on a sphere: order 1 in general
  AREA_NORMALS      ///< weighted by area as in the paper: order 1
};

/*!
 * \ingroup PkgHermiteDiffuseRemeshingRef
 *
 * chooses how the surface is evaluated between the nodes.
 */
enum Surface_model
{
  CONTINUOUS_MODEL, ///< a fit at every query, in a frame that moves with it: continuous across edges
  PAPER_MODEL       ///< the form printed by Rassineux et al.: one quadratic per face, fitted at its centroid to
                    ///< normals weighted by area with \f$ t = 1/2 \f$. It jumps across edges, and its curvature
                    ///< does not converge on irregular meshes; it is there for comparison
};

/*!
 * \ingroup PkgHermiteDiffuseRemeshingRef
 *
 * tells what kind of surface a region of a mesh is.
 */
enum Basic_surface_type
{
  FREE_FORM_SURFACE,   ///< none of the following
  PLANE_SURFACE,       ///< `point` on it, `direction` is its normal
  SPHERE_SURFACE,      ///< centre `point`, `radius`
  CYLINDER_SURFACE,    ///< axis through `point` along `direction`, `radius`
  CONE_SURFACE,        ///< apex `point`, axis along `direction` into the cone, `half_angle`
  TORUS_SURFACE        ///< centre `point`, axis along `direction`, `radius` of the circle in the middle of the tube,
                       ///< `tube_radius`
};

} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_MODEL_CHOICES_H
