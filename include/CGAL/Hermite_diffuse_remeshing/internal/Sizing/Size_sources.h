// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_SIZING_SIZE_SOURCES_H
#define CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_SIZING_SIZE_SOURCES_H

#include <CGAL/Hermite_diffuse_remeshing/internal/Classification/Edge_table.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Model/Reference_surface.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Model/Side_middles.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Model/closest_barycentric.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Progress.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Sizing/size_from_curvature.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/for_each_index.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Hermite_diffuse_remeshing {
namespace internal {

// What a size is made of. Infinity everywhere: that source is not looked at.
struct Size_options
{
  // Of the bisected faces of the size map, about 100 bytes each: an absurd size in a large face must not
  // eat the memory. Where it is reached the sizes stay linear in the cells.
  int maximum_number_of_cells = 2000000;
  // Of the user's field, for sizes between those at the corners of a cell: it must not eat the time either.
  double maximum_number_of_probes = 2e7;
  double length_over_radius = std::numeric_limits<double>::infinity();
  double sagitta = std::numeric_limits<double>::infinity();
  double maximum_deviation = std::numeric_limits<double>::infinity();
  double minimum_length = 0., maximum_length = 0.;
  double gradation = 1.3;
  // Feature curves with a larger radius are treated as if they had this one: on a long flat arc an error that is
  // small against the radius would be large against the model.
  double largest_curve_radius = std::numeric_limits<double>::infinity();
  // the user's size at a point and a location, infinite where there is none
  std::function<double(const Vector&, const Location&)> user_size;
  // the user's size may differ from face to face at the same point
  bool is_user_size_local = false;
};

// The sizes before gradation: of the curvature, of the user, and their bounds.
class Size_sources
{
  const Reference_surface& m_surface;
  const Edge_table& m_edges;
  Size_options m_options;

public:
  Size_sources(const Reference_surface& surface, const Edge_table& edges, const Size_options& options)
    : m_surface(surface), m_edges(edges), m_options(options)
  {}

  const Size_options& options() const { return m_options; }
  const Indexed_triangles& triangles() const { return m_surface.triangles(); }
  bool is_parallel() const { return m_surface.options().is_parallel; }
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

  // The distance between an arc and its chord if the chord has a size that the relative error asks for, or the largest
  // deviation; the other laws, and a size of the user, ask for no more. Nor does an error that asks for less than about
  // sixteen edges on a circle: whole numbers of edges that are close enough would be much shorter than their sizes then.
  double largest_sagitta(const double size) const
  {
    constexpr double largest_length_over_radius = 0.4;
    if(!(m_options.length_over_radius < largest_length_over_radius))
      return m_options.maximum_deviation;
    const double radius = (std::min)(size / m_options.length_over_radius, m_options.largest_curve_radius);
    return (std::min)(radius * (1. - std::cos(half_angle_of_edge())), m_options.maximum_deviation);
  }

  // Of the regular polygon whose edges are as long on a circle as the relative error asks for, the radius of the circle
  // inside over that of the circle around: a mesh with these sizes does not tell which one it approximates, and no
  // fit to it knows the radius of curvature, nor the sizes, any better.
  double certainty_of_radius() const { return is_error_used() ? std::cos(half_angle_of_edge()) : 1.; }

  double of_surface(const Location& location) const
  {
    if(!is_curvature_used())
      return std::numeric_limits<double>::infinity();
    return of_curvature(largest_curvature(location));
  }

  // At a location on a side of a face that is part of a feature, between two open nodes: there the fits are one-sided,
  // too, and the place in the face stands for it that is as far from the side as the centroid.
  double of_surface_beside(const Location& location) const
  {
    const Barycentric& b = location.coordinates;
    const int opposite = static_cast<int>(std::min_element(b.begin(), b.end()) - b.begin());
    Location inside = location;
    for(int k = 0; k < 3; ++k)
      inside.coordinates[k] = k == opposite ? 1. / 3. : 2. / 3. * b[k] / (1. - b[opposite]);
    return of_surface(inside);
  }

  // Where sizes are sampled inside a facet or on a side of it. Between tangent nodes the surface bends on one side of the
  // line only, and the fit on it knows neither: the faces at both sides tell.
  double of_surface_around(const Location& location) const
  {
    constexpr double on_side = 1e-9;
    const Barycentric& b = location.coordinates;
    const int side = next(static_cast<int>(std::min_element(b.begin(), b.end()) - b.begin()));
    const auto is_tangent = [&](const int corner)
    { return m_surface.node(m_surface.cut_mesh().node(location.face, corner)).is_tangent; };
    if(b[previous(side)] > on_side || !is_tangent(side) || !is_tangent(next(side)))
      return of_surface(location);
    const Vector p = triangles().point(location);
    const int e = m_edges.edge(location.face, side);
    double result = std::numeric_limits<double>::infinity();
    for(int i = 0; i < m_edges.number_of_sides(e); ++i)
      result = (std::min)(result, of_surface_beside(closest_on_face(triangles(), m_edges.side(e, i).face, p)));
    return result;
  }

  // of the surface
  double largest_curvature(const Location& location) const
  {
    const std::pair<double, double> k = m_surface.evaluate_unbounded(location).monge_form().curvatures();
    return (std::max)(std::abs(k.first), std::abs(k.second));
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
  // node the mean in its faces is taken. On a tangent line the curvature jumps, and the fit does not know it: the mean is
  // that of the half of the faces where it is larger.
  double largest_curvature(const int node) const
  {
    const Index_range corners = m_surface.cut_mesh().corners(node);
    const bool is_tangent = m_surface.node(node).is_tangent;
    if(!is_tangent && !m_surface.cut_mesh().is_open(node))
      return largest_curvature(location_of_corner(corners.first[0]));
    std::vector<double> curvatures;
    Location location;
    location.coordinates.fill(1. / 3.);
    for(const int c : corners)
    {
      location.face = c / 3;
      curvatures.push_back(largest_curvature(location));
    }
    if(is_tangent)
    {
      std::sort(curvatures.begin(), curvatures.end());
      curvatures.erase(curvatures.begin(), curvatures.begin() + curvatures.size() / 2);
    }
    return std::accumulate(curvatures.begin(), curvatures.end(), 0.) / curvatures.size();
  }

  // areas of the smooth surface over the faces divided by those of the faces
  std::vector<double> area_ratios(const Progress& progress) const
  {
    const auto point_at = [this](const Location& location) { return m_surface.evaluate(location).point(); };
    const auto is_bent = [this](const int f) { return this->is_bent(f); };
    const Side_middles middles(m_surface, m_edges, is_bent, point_at, progress);
    std::vector<double> result(triangles().number_of_faces(), 1.);
    for_each_index(triangles().number_of_faces(), is_parallel(), [&]
    {
      return [&](const int f)
      {
        if(is_bent(f))
          result[f] = area_ratio(f, {{middles(f, 0), middles(f, 1), middles(f, 2)}});
      };
    }, progress);
    return result;
  }

private:
  bool is_bent(const int face) const
  {
    // Between normals that differ by less than this angle, in radians, the areas differ by less than its
    // square over eight, half a percent.
    constexpr double nearly_flat = 0.2037;
    double bend2 = 0.;
    for(int k = 0; k < 3; ++k)
      bend2 = (std::max)(bend2, (m_surface.node(face, k).normal - m_surface.node(face, next(k)).normal).squaredNorm());
    return bend2 >= nearly_flat * nearly_flat && triangles().area_vector(face).norm() > 0.;
  }

  // The four triangles to the middles of the sides, and L. F. Richardson's extrapolation from one triangle and four.
  double area_ratio(const int face, const std::array<Vector, 3>& middle) const
  {
    const Indexed_triangles& t = triangles();
    const double flat = t.area_vector(face).norm();
    double area = (middle[1] - middle[0]).cross(middle[2] - middle[0]).norm();
    for(int k = 0; k < 3; ++k)
      area += (middle[k] - t.point(face, k)).cross(middle[previous(k)] - t.point(face, k)).norm();
    // beyond this the fit of a bad triangle is not believed
    constexpr double largest_ratio = 1.5;
    return (std::max)(1., (std::min)(largest_ratio, (4. * area / flat - 1.) / 3.));
  }

  bool is_error_used() const { return m_options.length_over_radius < std::numeric_limits<double>::infinity(); }

  // seen from the center of curvature, of an edge as long as the relative error asks for
  double half_angle_of_edge() const { return std::asin((std::min)(1., m_options.length_over_radius / 2.)); }

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
