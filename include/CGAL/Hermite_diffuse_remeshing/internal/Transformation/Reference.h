// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_REFERENCE_H
#define CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_REFERENCE_H

#include <CGAL/Hermite_diffuse_remeshing/internal/Model/Feature_displacements.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Model/Reference_locator.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Model/sketch_surface.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Sizing/Size_map.h>

#include <algorithm>
#include <limits>
#include <vector>

namespace CGAL {
namespace Hermite_diffuse_remeshing {
namespace internal {

// A place for a vertex: on the smooth surface, or on a feature curve.
struct Site
{
  Vector point = Vector::Zero();
  Vector normal = Vector::Zero();       // of the model; zero on curves and at corners, which have several
  double size = 0.;
  double parameter = 0.;                // on the curve
  Location location;
  int curve = -1;                       // -1: on the surface
  bool is_sketched = false;             // near the model only, see `sketch_surface()`

  bool has_normal() const { return normal != Vector::Zero(); }
};

// The part of the last image that Anderson's iteration x = G(x) with one step of memory takes in place of this one's, from
// the steps G(x) - x of now and of before.
inline double memory_of_step(const Vector& step, const Vector& last_step)
{
  const Vector change = step - last_step;
  const double norm = change.squaredNorm();
  return norm > 0. ? step.dot(change) / norm : 0.;
}

// All that is known of the input, frozen: what the working mesh is adapted to.
struct Reference
{
  const Edge_table& edges;
  const std::vector<Edge_class>& edge_classes;
  const std::vector<Vertex_class>& vertex_classes;
  const Feature_curves& curves;
  const Reference_surface& surface;
  const Reference_locator& locator;
  const Feature_displacements& displacement;
  Size_map& sizes;

  Vector surface_point(const Location& location) const
  {
    const Local_quadric quadric = surface.evaluate(location);
    return quadric.point() + displacement_of(location, quadric);
  }

  // What leads the fit at a location to the feature curves beside it, as far as the bound of all displacements allows.
  Vector displacement_of(const Location& location, const Local_quadric& quadric) const
  {
    const Vector result = displacement(location);
    const double bound = surface.saturation().bound();
    if(!surface.saturation().is_bounded() || result == Vector::Zero())
      return result;
    const Vector sum = quadric.point() + result - surface.triangles().point(location);
    const double norm = sum.norm();
    return norm > bound ? Vector(result - (1. - bound / norm) * sum) : result;
  }

  struct Nearest
  {
    Location location;
    double distance;
    Vector gap = Vector::Zero();        // from the surface to the point
    Local_quadric quadric = Local_quadric();            // the fit at the location
  };

  // Distance of p to the surface near a location. The locator knows the fit without the displacement, so
  // it is asked for the foot of p minus the displacement at the last foot. Each foot gives a distance,
  // of which the smallest counts: this converges fast where the displacement is small against the face. Where it
  // changes faster than the place, as from a few edges to their arc over a narrow face beside them, each foot would be
  // farther off than the last: where the change does not halve, a step is Anderson's, as in `locate()`.
  Nearest nearest(const Vector& p, const Location& start, const double tolerance) const
  {
    constexpr int maximum_number_of_steps = 10;
    constexpr double part_of_distance = 0.01;   // no more is promised of a distance that is an upper bound
    constexpr double slow_contraction = 0.5;
    Nearest best{start, std::numeric_limits<double>::infinity()};
    Reference_locator::Projection projection = locator.start_at(start);
    Vector displaced = displacement_of(start, projection.quadric), last_image = displaced;
    Vector last_change = Vector::Zero();
    for(int step = 0; step < maximum_number_of_steps; ++step)
    {
      projection = locator.project_from(p - displaced, projection, tolerance, part_of_distance);
      const Vector normal = projection.quadric.normal();
      Vector gap = p - displaced - projection.quadric.point();
      // what is left along the surface when Newton's method has converged is no distance
      if(projection.is_foot)
        gap = gap.dot(normal) * normal;
      const Vector image = displacement_of(projection.location, projection.quadric), change = image - displaced;
      const double distance = (gap - change).norm();
      if(distance < best.distance)
        best = {projection.location, distance, gap - change, projection.quadric};
      if(change.norm() <= tolerance * distance)
        break;
      const bool is_slow = step > 0 && change.norm() > slow_contraction * last_change.norm();
      const double memory = is_slow ? memory_of_step(change, last_change) : 0.;
      displaced = image - memory * (image - last_image);
      last_image = image;
      last_change = change;
    }
    return best;
  }

  // The location of the model at p, near a face of the reference: the point x of the facets that is led below p by its
  // displacement, x = G(x), where G(x) is the foot of p - d(x). Beside an arc of few edges what is beyond these is
  // reached from within. G may stretch: the iteration is Anderson's with one step of memory.
  Location locate(const Vector& p, const int hint) const
  {
    constexpr int maximum_number_of_steps = 8;
    constexpr double tolerance = 0.02;          // of the displacement; what comes of it is on the model in any case
    const Indexed_triangles& triangles = surface.triangles();
    Location location = locator.walk(p, hint);
    Vector at = triangles.point(location), last_image = Vector::Zero(), last_step = Vector::Zero();
    for(int i = 0; i < maximum_number_of_steps; ++i)
    {
      const Vector moved = displacement(location);
      if(moved == Vector::Zero())
        break;
      const Location image_location = locator.walk(p - moved, location.face);
      const Vector image = triangles.point(image_location), step = image - at;
      if(step.norm() <= tolerance * moved.norm())
        break;
      const double memory = i > 0 ? memory_of_step(step, last_step) : 0.;
      location = memory == 0. ? image_location
                              : locator.walk(image - memory * (image - last_image), image_location.face);
      at = triangles.point(location);
      last_image = image;
      last_step = step;
    }
    return location;
  }

  // on the model at p, near a face of the reference
  Site surface_site(const Vector& p, const int hint) const
  {
    // The model is above the facets along normals that turn, and over coarse ones aside from their feet. A part of the
    // size; what is less is below the steps of relocations.
    constexpr double tolerance = 0.02;
    constexpr int maximum_number_of_corrections = 2;
    Site site = surface_site(locate(p, hint));
    for(int i = 0; i < maximum_number_of_corrections; ++i)
    {
      const Vector gap = p - site.point, aside = gap - gap.dot(site.normal) * site.normal;
      if(aside.norm() <= tolerance * site.size)
        break;
      site = surface_site(locator.walk(surface.triangles().point(site.location) + aside, site.location.face));
    }
    return site;
  }

  // above a location. What a coarse mesh is made for is to be refined: there a sketch of the model does.
  Site surface_site(const Location& location) const
  {
    Site site;
    site.location = location;
    Local_quadric quadric;
    site.is_sketched = sizes.is_coarse() && sketch_surface(surface, location, quadric);
    if(!site.is_sketched)
      quadric = surface.evaluate(location);
    site.point = quadric.point() + displacement_of(location, quadric);
    site.size = sizes(location);
    // blended from the nodes: where a fit is badly conditioned it still points outwards
    site.normal = quadric.z_axis;
    return site;
  }

  double curve_size(const int curve, const double parameter) const
  {
    return sizes(curves.curves[curve].location(parameter, surface.triangles(), edges));
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

  // Is a chord of a feature curve as close to it as the error law allows for an edge of the size there, or closer than
  // `factor` times that?
  bool is_chord_faithful(const int curve, const double first, const double last, const double factor = 1.) const
  {
    const Feature_curve& c = curves.curves[curve];
    const double size = (curve_size(curve, first) + curve_size(curve, last)) / 2.;
    return c.spline.distance_to_chord((std::min)(first, last), (std::max)(first, last))
        <= factor * sizes.largest_sagitta(size);
  }

  // at a vertex of the reference, seen from one of its faces; without normal
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
