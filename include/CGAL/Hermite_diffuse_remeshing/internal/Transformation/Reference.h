// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_REFERENCE_H
#define CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_REFERENCE_H

#include <CGAL/Hermite_diffuse_remeshing/internal/Model/Reference_locator.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Sizing/Size_map.h>

#include <vector>

namespace CGAL {
namespace Hermite_diffuse_remeshing {
namespace internal {

// A place for a vertex: on the smooth surface, or on a feature curve.
struct Site
{
  Vector point = Vector::Zero();
  Location location;
  double size = 0.;
  int curve = -1;                       // -1: on the surface
  double parameter = 0.;                // on the curve
};

// All that is known of the input, frozen: what the working mesh is adapted to.
struct Reference
{
  const Edge_table& edges;
  const std::vector<Edge_class>& edge_classes;
  const std::vector<Vertex_class>& vertex_classes;
  const Feature_curves& curves;
  const Reference_surface& surface;
  const Reference_locator& locator;
  Size_map& sizes;

  // on the model, above the point of the facets that is closest to p near a face of the reference
  Site surface_site(const Vector& p, const int hint) const
  {
    Site site;
    site.location = locator.walk(p, hint);
    site.point = surface.evaluate(site.location).point();
    site.size = sizes(site.location);
    return site;
  }

  Site curve_site(const int curve, const double parameter) const
  {
    const Feature_curve& c = curves.curves[curve];
    Site site;
    site.curve = curve;
    site.parameter = parameter;
    site.point = c.spline.point(parameter);
    site.location = c.location(parameter, surface.triangles(), edges);
    site.size = sizes(site.location);
    return site;
  }

  // at a vertex of the reference, seen from one of its faces
  Site vertex_site(const int face, const int corner) const
  {
    Site site;
    site.location.face = face;
    site.location.coordinates.fill(0.);
    site.location.coordinates[corner] = 1.;
    site.point = surface.triangles().point(face, corner);
    site.size = sizes(site.location);
    return site;
  }

  // Parameter of a corner on a curve that ends there. No curve has the same corner at both ends.
  double end_parameter(const int curve, const int vertex) const
  {
    const Feature_curve& c = curves.curves[curve];
    return c.vertices.front() == vertex ? 0. : c.spline.length();
  }

  Vector normal_near(const Vector& p, const int hint) const
  {
    return surface.blended_normal(locator.walk(p, hint));
  }
};

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_REFERENCE_H
