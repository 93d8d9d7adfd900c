// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_REMESHING_BASIC_SURFACE_H
#define CGAL_HERMITE_DIFFUSE_REMESHING_BASIC_SURFACE_H

#include <CGAL/license/Hermite_diffuse_remeshing.h>

#include <CGAL/Hermite_diffuse_remeshing/Model_choices.h>

#include <cstddef>

namespace CGAL {
namespace Hermite_diffuse_remeshing {

/*!
 * \ingroup PkgHermiteDiffuseRemeshingRef
 *
 * The class `Basic_surface` describes a region of a mesh that lies on a plane, a sphere, a cylinder, a cone or
 * a torus. The meaning of the members depends on `type`, see `Basic_surface_type`. Lengths are in the
 * unit of the coordinates, angles in radians.
 *
 * \tparam GeomTraits a type with the types `FT`, `Point_3` and `Vector_3`
 */
template <typename GeomTraits>
struct Basic_surface
{
  Basic_surface_type type = FREE_FORM_SURFACE;         ///< the kind of surface
  typename GeomTraits::Point_3 point;                  ///< centre, apex, or point of the plane or axis
  typename GeomTraits::Vector_3 direction;             ///< unit vector along the axis, or a normal of the plane
  typename GeomTraits::FT radius = 0;                  ///< of sphere, cylinder, or the torus' central circle
  typename GeomTraits::FT tube_radius = 0;             ///< of the torus' tube
  typename GeomTraits::FT half_angle = 0;              ///< between the axis and the sides of the cone, in radians
  std::size_t number_of_faces = 0;                     ///< in the region
};

} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_BASIC_SURFACE_H
