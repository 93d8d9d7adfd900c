// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_MODEL_HEIGHTS_H
#define CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_MODEL_HEIGHTS_H

#include <CGAL/Hermite_diffuse_remeshing/internal/Model/Side_middles.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Progress.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Transformation/Reference.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/for_each_index.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace CGAL {
namespace Hermite_diffuse_remeshing {
namespace internal {

inline Location location_in_face(const int face, const double u, const double v)
{
  Location result;
  result.face = face;
  result.coordinates = {{(std::max)(0., 1. - u - v), u, v}};
  return result;
}

// How high the model is over the facets of the reference.
class Model_heights
{
  const Reference& m_reference;

public:
  explicit Model_heights(const Reference& reference) : m_reference(reference) {}

  double distance_to_facet(const Location& at, const Vector& p) const
  {
    return (triangles().point(m_reference.locator.location_on_face(at.face, p)) - p).norm();
  }

  // What the normals at the corners let expect: a side like an S has no height at its middle. An arc with the slope s
  // at both ends rises by s/4 of its length.
  double expected(const int f) const
  {
    constexpr double least_cosine = 0.2;
    const Vector normal = triangles().area_vector(f).stableNormalized();
    double height = 0.;
    for(int k = 0; k < 3; ++k)
    {
      const Vector side = triangles().point(f, next(k)) - triangles().point(f, k);
      double rise = 0.;
      for(const int corner : {k, next(k)})
      {
        const Vector& n = m_reference.surface.node(f, corner).normal;
        rise += std::abs(n.dot(side)) / (std::max)(n.dot(normal), least_cosine);
      }
      height = (std::max)(height, rise / 8.);
    }
    return height;
  }

  // at the middles of the sides and at the centroid, of the faces that are asked for
  template <typename IsAskedFor>
  void measure(const IsAskedFor& is_asked_for, const Progress& progress, std::vector<double>& heights) const
  {
    const auto point_at = [this](const Location& location) { return m_reference.surface_point(location); };
    const Side_middles middles(m_reference.surface, m_reference.edges, is_asked_for, point_at, progress);
    for_each_index(triangles().number_of_faces(), is_parallel(), [&]
    {
      return [&](const int f)
      {
        if(is_asked_for(f))
          heights[f] = of_model(f, middles);
      };
    }, progress);
  }

  // at the points of a regular partition
  double between(const int f, const int number_of_parts) const
  {
    double result = 0.;
    for(int a = 0; a <= number_of_parts; ++a)
      for(int b = 0; a + b <= number_of_parts; ++b)
      {
        const Location at = location_in_face(f, double(a) / number_of_parts, double(b) / number_of_parts);
        result = (std::max)(result, distance_to_facet(at, m_reference.surface_point(at)));
      }
    return result;
  }

  bool is_at_feature_or_apex(const int f) const
  {
    bool result = false;
    for(int k = 0; k < 3; ++k)
      result = result || m_reference.surface.cut_mesh().neighbor(f, k) == -1 || !m_reference.surface.node(f, k).has_normal();
    return result;
  }

  // The corners of a thin facet tell little of what is between them: if there is a bound more points are looked at there.
  bool is_thin(const int f) const
  {
    constexpr double largest_height = 0.25;     // over the longest side
    return triangles().area_vector(f).norm() < largest_height * CGAL::square(longest_side(f));
  }

  double longest_side(const int f) const
  {
    double result = 0.;
    for(int k = 0; k < 3; ++k)
      result = (std::max)(result, (triangles().point(f, next(k)) - triangles().point(f, k)).norm());
    return result;
  }

private:
  const Indexed_triangles& triangles() const { return m_reference.surface.triangles(); }
  bool is_parallel() const { return m_reference.surface.options().is_parallel; }

  // at the middles of the sides and at the centroid
  template <typename Middles>
  double of_model(const int f, const Middles& middles) const
  {
    const Location center = location_in_face(f, 1. / 3., 1. / 3.);
    double height = distance_to_facet(center, m_reference.surface_point(center));
    for(int k = 0; k < 3; ++k)
      height = (std::max)(height, distance_to_facet(Middles::location(f, k), middles(f, k)));
    return height;
  }
};

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_MODEL_HEIGHTS_H
