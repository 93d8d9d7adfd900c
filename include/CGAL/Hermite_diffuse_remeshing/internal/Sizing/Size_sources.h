// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_SIZING_SIZE_SOURCES_H
#define CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_SIZING_SIZE_SOURCES_H

#include <CGAL/Hermite_diffuse_remeshing/internal/Model/Reference_surface.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Sizing/size_from_curvature.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <utility>

namespace CGAL {
namespace Hermite_diffuse_remeshing {
namespace internal {

// What a size is made of. Infinity everywhere: that source is not looked at.
struct Size_options
{
  double length_over_radius = std::numeric_limits<double>::infinity();
  double sagitta = std::numeric_limits<double>::infinity();
  double maximum_deviation = std::numeric_limits<double>::infinity();
  double minimum_length = 0., maximum_length = 0.;
  double gradation = 1.3;
  // the user's size at a point and a location, infinite where there is none
  std::function<double(const Vector&, const Location&)> user_size;
  // the user's size may differ from face to face at the same point
  bool is_user_size_local = false;
};

// The sizes before gradation: of the curvature, of the user, and their bounds.
class Size_sources
{
  const Reference_surface& m_surface;
  Size_options m_options;

public:
  Size_sources(const Reference_surface& surface, const Size_options& options)
    : m_surface(surface), m_options(options)
  {}

  const Size_options& options() const { return m_options; }
  const Indexed_triangles& triangles() const { return m_surface.triangles(); }
  bool has_user_size() const { return bool(m_options.user_size); }

  // the user's field is not asked any more
  void forget_user_size() { m_options.user_size = nullptr; }

  double clamped(const double size) const
  {
    return (std::max)(m_options.minimum_length, (std::min)(m_options.maximum_length, size));
  }

  double of_curvature(const double curvature) const
  {
    if(!(curvature > 0.))
      return std::numeric_limits<double>::infinity();
    const double radius = 1. / curvature;
    const double relative = (std::min)(m_options.length_over_radius * radius,
                                       length_of_deviation(m_options.maximum_deviation, radius));
    return m_options.sagitta < std::numeric_limits<double>::infinity()
           ? (std::min)(relative, length_of_sagitta(m_options.sagitta, radius)) : relative;
  }

  double of_surface(const Location& location) const
  {
    if(!is_curvature_used())
      return std::numeric_limits<double>::infinity();
    const std::pair<double, double> k = m_surface.evaluate(location).monge_form().curvatures();
    return of_curvature((std::max)(std::abs(k.first), std::abs(k.second)));
  }

  double of_user(const Vector& p, const Location& location) const
  {
    return has_user_size() ? clamped(m_options.user_size(p, location)) : m_options.maximum_length;
  }

  // at the point of the smooth surface, which is where the new vertices will be
  double of_user(const Location& location) const
  {
    return has_user_size() ? of_user(m_surface.evaluate(location).point(), location) : m_options.maximum_length;
  }

  // The one-sided fit at the end of a fan of faces is the least certain of the model: at an open
  // node the mean curvature in its faces is taken.
  double of_node(const int node) const
  {
    const Index_range corners = m_surface.cut_mesh().corners(node);
    if(!m_surface.cut_mesh().is_open(node))
      return of_surface(location_of_corner(corners.first[0]));
    double sum = 0.;
    Location location;
    location.coordinates.fill(1. / 3.);
    for(const int c : corners)
    {
      location.face = c / 3;
      sum += 1. / of_surface(location);
    }
    return corners.size() / sum;
  }

  static Location location_of_corner(const int corner)
  {
    Location location;
    location.face = corner / 3;
    location.coordinates.fill(0.);
    location.coordinates[corner % 3] = 1.;
    return location;
  }

private:
  bool is_curvature_used() const
  {
    return (std::min)({m_options.length_over_radius, m_options.sagitta, m_options.maximum_deviation})
         < std::numeric_limits<double>::infinity();
  }
};

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_SIZING_SIZE_SOURCES_H
