// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_MODEL_SKETCH_SURFACE_H
#define CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_MODEL_SKETCH_SURFACE_H

#include <CGAL/Hermite_diffuse_remeshing/internal/Model/Reference_surface.h>

namespace CGAL {
namespace Hermite_diffuse_remeshing {
namespace internal {

// A surface near the one that is evaluated, at a fiftieth of the price, for meshes that will be refined: through the
// nodes, with the same z axes, and between the nodes halfway from the facet to the tangent planes of its corners, which
// is right for a paraboloid. Sets the height over the facet. Returns false where it is not near.
inline bool sketch_surface(const Reference_surface& surface, const Location& location, Local_quadric& result)
{
  // a tangent plane that is steeper over the facet says little of the height
  constexpr double least_cosine = 0.5;
  if(surface.saturation().is_bounded() || surface.options().is_solved_at_centroids)
    return false;
  result.origin = surface.triangles().point(location);
  result.z_axis = surface.blended_normal(location);
  result.size = 1.;
  result.a[0] = 0.;
  for(int k = 0; k < 3; ++k)
  {
    const Node& corner = surface.node(location.face, k);
    const double cosine = corner.normal.dot(result.z_axis);
    if(corner.is_near_apex || corner.is_tangent || !(cosine > least_cosine))
      return false;
    result.a[0] += location.coordinates[k] * (corner.position - result.origin).dot(corner.normal) / (2. * cosine);
  }
  return true;
}

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_MODEL_SKETCH_SURFACE_H
