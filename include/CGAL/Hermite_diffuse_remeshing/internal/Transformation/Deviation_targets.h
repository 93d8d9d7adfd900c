// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_DEVIATION_TARGETS_H
#define CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_DEVIATION_TARGETS_H

#include <CGAL/Hermite_diffuse_remeshing/internal/Model/Side_middles.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Progress.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Transformation/Reference.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/for_each_index.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Hermite_diffuse_remeshing {
namespace internal {

// a point of the reference whose distance to the mesh is measured
struct Deviation_target
{
  Vector point;
  Location location;
  int face = -1;                        // the closest one of the mesh
};

// those of the same face that lie a step away, along its sides
inline std::vector<Location> locations_around(const Location& location, const double step)
{
  std::vector<Location> result;
  for(int k = 0; k < 3; ++k)
    for(const int to : {next(k), previous(k)})
      if(location.coordinates[k] >= step)
      {
        result.push_back(location);
        result.back().coordinates[k] -= step;
        result.back().coordinates[to] += step;
      }
  return result;
}

// The points of the model from which the deviation is measured back: the vertices of the reference, the middles
// of its feature edges, on their curves, and as many points over its faces as the model between them needs to be
// known to a part of the bound. A face of the mesh that spans several of the reference may be far from
// the model where none of its own middles is.
class Deviation_targets
{
  const Reference& m_reference;
  double m_bound;
  std::vector<Deviation_target> m_targets;
  std::vector<int> m_parts;             // in how many parts the sides of the faces are cut
  double m_model_distance = 0.;

  // What is left between the points, relative to the bound. Between them the distance to the mesh changes by
  // less where it is large, so that the largest one is off by a few percent.
  static constexpr double tolerance = 0.05;
  // Relative to the size: faces of the mesh have points of their own that are as close.
  static constexpr double least_distance = 0.25;
  // Height over the longest side of a facet, an arc of 44 degrees: a model that is steeper may be folded, and the
  // points of the mesh near another part of it.
  static constexpr double steep = 0.1;
  // four thousand points in a face; where the model is so steep, one more says nothing new
  static constexpr double largest_number_of_parts = 90.;

public:
  // `is_remeshed(face of the reference)`; the mesh will not have more than `maximum_number_of_faces`.
  template <typename IsRemeshed>
  Deviation_targets(const Reference& reference, const double bound, const std::size_t maximum_number_of_faces,
                    const IsRemeshed& is_remeshed, const Progress& progress)
    : m_reference(reference), m_bound(bound), m_parts(triangles().number_of_faces(), 0)
  {
    find_parts(is_remeshed, progress.part(0., 0.));
    limit_parts(double(maximum_number_of_faces));
    collect_vertices(progress);
    collect_curve_points(progress);
    collect_face_points(progress.part(0., 0.));
  }

  std::vector<Deviation_target>& targets() { return m_targets; }

  // of the sides of the face at a location
  int number_of_parts(const Location& location) const { return m_parts[location.face]; }

  // the largest distance between the model and the facets of the reference
  double model_distance() const { return m_model_distance; }

private:
  const Indexed_triangles& triangles() const { return m_reference.surface.triangles(); }

  static Location location(const int face, const double u, const double v)
  {
    Location result;
    result.face = face;
    result.coordinates = {{(std::max)(0., 1. - u - v), u, v}};
    return result;
  }

  double distance_to_facet(const Location& at, const Vector& p) const
  {
    return (triangles().point(m_reference.locator.location_on_face(at.face, p)) - p).norm();
  }

  bool is_parallel() const { return m_reference.surface.options().is_parallel; }

  void note_model_distances(const std::vector<double>& distances)
  {
    for(const double d : distances)
      m_model_distance = (std::max)(m_model_distance, d);
  }

  template <typename IsRemeshed>
  void find_parts(const IsRemeshed& is_remeshed, const Progress& progress)
  {
    std::vector<double> expected(m_parts.size(), 0.), heights(m_parts.size(), 0.);
    for_each_index(triangles().number_of_faces(), is_parallel(), [&]
    { return [&](const int f) { expected[f] = is_remeshed(f) ? height_of_sides(f) : 0.; }; }, progress);
    constexpr double infinity = (std::numeric_limits<double>::infinity)();
    const auto measure_between = [&](const double least, const double end)
    {
      measure_heights([&](const int f)
      {
        return is_remeshed(f) && ((least <= expected[f] && expected[f] < end)
                                  || (end == infinity && is_at_feature_or_apex(f)));
      }, progress, heights);
      note_model_distances(heights);
    };
    if(std::isfinite(m_bound) || m_reference.surface.saturation().is_bounded())
      measure_between(0., infinity);
    else
    {
      // Nothing but the largest height of a smooth model is asked for. What is expected there is nearly two thirds of it at
      // least, on all meshes that were looked at.
      constexpr double part_of_largest = 0.4;
      const double least = part_of_largest * *std::max_element(expected.begin(), expected.end());
      measure_between(least, infinity);
      if(part_of_largest * m_model_distance < least)
        measure_between(part_of_largest * m_model_distance, least);
    }
    look_between(heights, progress);
    for_each_index(triangles().number_of_faces(), is_parallel(), [&]
    {
      return [&](const int f)
      {
        if(is_remeshed(f))
          m_parts[f] = count_parts(f, (std::max)(heights[f], expected[f]));
      };
    }, progress);
  }

  // The middles and the centroid need not be the highest points. Over few facets between vertices far apart, or beside a
  // feature, they are by a third lower: the facets that have the highest ones are looked at more closely.
  void look_between(const std::vector<double>& heights, const Progress& progress)
  {
    constexpr int largest_number = 64, number_of_parts = 12;
    constexpr double least_part = 0.5;            // of the largest height: no other facet can come up to it
    std::vector<int> highest;
    for(std::size_t f = 0; f < heights.size(); ++f)
      if(heights[f] > 0. && heights[f] >= least_part * m_model_distance)
        highest.push_back(static_cast<int>(f));
    const auto end = highest.begin() + (std::min)(highest.size(), std::size_t(largest_number));
    std::partial_sort(highest.begin(), end, highest.end(), [&](const int f, const int g)
                      { return heights[f] != heights[g] ? heights[f] > heights[g] : f < g; });
    highest.erase(end, highest.end());
    std::vector<double> between(highest.size(), 0.);
    for_each_index(static_cast<int>(highest.size()), is_parallel(), [&]
    {
      return [&](const int i)
      {
        for(int a = 0; a <= number_of_parts; ++a)
          for(int b = 0; a + b <= number_of_parts; ++b)
          {
            const Location at = location(highest[i], double(a) / number_of_parts, double(b) / number_of_parts);
            between[i] = (std::max)(between[i], distance_to_facet(at, m_reference.surface_point(at)));
          }
      };
    }, progress);
    note_model_distances(between);
  }

  bool is_at_feature_or_apex(const int f) const
  {
    bool result = false;
    for(int k = 0; k < 3; ++k)
      result = result || m_reference.surface.cut_mesh().neighbor(f, k) == -1 || !m_reference.surface.node(f, k).has_normal();
    return result;
  }

  // of the model over the faces that are asked for
  template <typename IsAskedFor>
  void measure_heights(const IsAskedFor& is_asked_for, const Progress& progress, std::vector<double>& heights) const
  {
    const auto point_at = [this](const Location& location) { return m_reference.surface_point(location); };
    const Side_middles middles(m_reference.surface, m_reference.edges, is_asked_for, point_at, progress);
    for_each_index(triangles().number_of_faces(), is_parallel(), [&]
    {
      return [&](const int f)
      {
        if(is_asked_for(f))
          heights[f] = height_of_model(f, middles);
      };
    }, progress);
  }

  // Where m faces lie over one of the reference, they deviate by 1/m of the height of the model, and with n parts of
  // each side 1/n^2 of it is left between the points: n^2 = m / tolerance is enough for the m that there can be. A
  // bound that needs more is not met.
  void limit_parts(const double maximum_number_of_faces)
  {
    double sum = 0.;
    for(const int n : m_parts)
      sum += double(n) * n;
    const double factor = std::sqrt(maximum_number_of_faces / (tolerance * sum));
    if(!(factor < 1.))
      return;
    for(int& n : m_parts)
      n = static_cast<int>(std::ceil(factor * n));
  }

  // at the middles of the sides and at the centroid
  template <typename Middles>
  double height_of_model(const int f, const Middles& middles) const
  {
    const Location center = location(f, 1. / 3., 1. / 3.);
    double height = distance_to_facet(center, m_reference.surface_point(center));
    for(int k = 0; k < 3; ++k)
      height = (std::max)(height, distance_to_facet(Middles::location(f, k), middles(f, k)));
    return height;
  }

  // The height of the model over a facet falls with the square of the length.
  int count_parts(const int f, const double height) const
  {
    const double needed = std::sqrt(height / (tolerance * m_bound));
    if(needed <= 1.)
      return 1;
    double longest_side = 0.;
    for(int k = 0; k < 3; ++k)
      longest_side = (std::max)(longest_side, (triangles().point(f, next(k)) - triangles().point(f, k)).norm());
    const double useful = height > steep * longest_side ? (std::numeric_limits<double>::infinity)()
                                                        : longest_side / (least_distance * smallest_size(f));
    return (std::max)(1, static_cast<int>(std::ceil((std::min)({needed, useful, largest_number_of_parts}))));
  }

  // What the normals at the corners let expect: a side like an S has no height at its middle. An arc with the slope s
  // at both ends rises by s/4 of its length.
  double height_of_sides(const int f) const
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

  // of those at the corners, the middles and the centroid
  double smallest_size(const int f) const
  {
    double result = m_reference.sizes(location(f, 1. / 3., 1. / 3.));
    for(int i = 0; i <= 2; ++i)
      for(int j = 0; i + j <= 2; ++j)
        result = (std::min)(result, m_reference.sizes(location(f, i / 2., j / 2.)));
    return result;
  }

  void collect_vertices(const Progress& progress)
  {
    std::vector<char> is_done(triangles().number_of_vertices(), false);
    for(int f = 0; f < triangles().number_of_faces(); ++f, progress(0.))
      for(int k = 0; k < 3 && m_parts[f] > 0; ++k)
      {
        const int v = triangles().triangles[f][k];
        if(!is_done[v])
          m_targets.push_back({triangles().points[v], m_reference.vertex_site(f, k).location});
        is_done[v] = true;
      }
  }

  void collect_curve_points(const Progress& progress)
  {
    for(std::size_t c = 0; c < m_reference.curves.curves.size(); ++c)
    {
      const Feature_spline& spline = m_reference.curves.curves[c].spline;
      for(int i = 0; i < spline.number_of_segments(); ++i, progress(0.))
      {
        const Site site =
          m_reference.curve_site(static_cast<int>(c), (spline.parameter(i) + spline.parameter(i + 1)) / 2.);
        if(m_parts[site.location.face] > 0)
          m_targets.push_back({site.point, site.location});
      }
    }
  }

  void collect_face_points(const Progress& progress)
  {
    const std::size_t first = m_targets.size();
    for(int f = 0; f < triangles().number_of_faces(); ++f, progress(0.))
      collect_locations(f);
    std::vector<double> distances(m_targets.size() - first);
    for_each_index(static_cast<int>(distances.size()), is_parallel(), [&]
    {
      return [&](const int i)
      {
        Deviation_target& target = m_targets[first + i];
        target.point = m_reference.surface_point(target.location);
        distances[i] = distance_to_facet(target.location, target.point);
      };
    }, progress);
    note_model_distances(distances);
  }

  // of a regular partition, without the corners
  void collect_locations(const int f)
  {
    const int n = m_parts[f];
    for(int i = 0; i <= n; ++i)
      for(int j = 0; i + j <= n; ++j)
      {
        const int steps[3] = {n - i - j, i, j};
        if(std::max({steps[0], steps[1], steps[2]}) < n && !is_at_neighbor(f, steps))
          m_targets.push_back({Vector::Zero(), location(f, double(i) / n, double(j) / n)});
      }
  }

  // on a side of which the neighbour knows more, or as much and comes first
  bool is_at_neighbor(const int f, const int steps[3]) const
  {
    for(int k = 0; k < 3; ++k)
      if(steps[previous(k)] == 0)
      {
        const int g = m_reference.surface.cut_mesh().neighbor(f, k);
        if(g != -1 && (m_parts[g] > m_parts[f] || (m_parts[g] == m_parts[f] && g < f)))
          return true;
      }
    return false;
  }
};

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_DEVIATION_TARGETS_H
