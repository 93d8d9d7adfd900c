// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_DEVIATION_TARGETS_H
#define CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_DEVIATION_TARGETS_H

#include <CGAL/Hermite_diffuse_remeshing/internal/Progress.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Transformation/Model_heights.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/for_each_index.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
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
  Model_heights m_model;
  double m_bound;
  std::vector<Deviation_target> m_targets;
  std::vector<double> m_heights;        // of the model over the faces, by the corners, the middles and the centroids
  std::vector<int> m_parts;             // in how many parts the sides of the faces are cut
  double m_part_factor = 1.;            // of these numbers
  double m_model_distance = 0.;

  // What is left between the points, relative to the bound. Between them the distance to the mesh changes by
  // less where it is large, so that the largest one is off by a few percent.
  static constexpr double tolerance = 0.05;
  // Relative to the size: faces of the mesh have points of their own that are as close.
  static constexpr double least_distance = 0.25;
  // Height over the longest side of a facet, an arc of 44 degrees: a model that is steeper may be folded, and the
  // points of the mesh near another part of it.
  static constexpr double steep = 0.1;
  static constexpr int parts_of_thin_face = 6;
  // four thousand points in a face; where the model is so steep, one more says nothing new
  static constexpr double largest_number_of_parts = 90.;

public:
  // `is_remeshed(face of the reference)`; the mesh will not have more than `maximum_number_of_faces`.
  template <typename IsRemeshed>
  Deviation_targets(const Reference& reference, const double bound, const std::size_t maximum_number_of_faces,
                    const IsRemeshed& is_remeshed, const Progress& progress)
    : m_reference(reference), m_model(reference), m_bound(bound), m_parts(triangles().number_of_faces(), 0)
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

  bool is_parallel() const { return m_reference.surface.options().is_parallel; }

  void note_model_distances(const std::vector<double>& distances)
  {
    for(const double d : distances)
      m_model_distance = (std::max)(m_model_distance, d);
  }

  template <typename IsRemeshed>
  void find_parts(const IsRemeshed& is_remeshed, const Progress& progress)
  {
    std::vector<double> heights(m_parts.size(), 0.);
    std::vector<double>& expected = m_heights;
    expected.assign(m_parts.size(), 0.);
    for_each_index(triangles().number_of_faces(), is_parallel(), [&]
    { return [&](const int f) { expected[f] = is_remeshed(f) ? m_model.expected(f) : 0.; }; }, progress);
    constexpr double infinity = (std::numeric_limits<double>::infinity)();
    const auto measure_between = [&](const double least, const double end)
    {
      m_model.measure([&](const int f)
      {
        return is_remeshed(f) && ((least <= expected[f] && expected[f] < end)
                                  || (end == infinity && m_model.is_at_feature_or_apex(f)));
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
        if(!is_remeshed(f))
          return;
        m_heights[f] = (std::max)(heights[f], m_heights[f]);
        m_parts[f] = count_parts(f, std::isfinite(m_bound) && m_model.is_thin(f) ? m_model.between(f, parts_of_thin_face) : 0.);
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
      return [&](const int i) { between[i] = m_model.between(highest[i], number_of_parts); };
    }, progress);
    note_model_distances(between);
  }

  // Where m faces lie over one of the reference, they deviate by 1/m of the height of the model, and with n parts of
  // each side 1/n^2 of it is left between the points: n^2 = m / tolerance is enough for the m that there can be. A
  // bound that needs more is not met.
  void limit_parts(const double maximum_number_of_faces)
  {
    double sum = 0.;
    for(const int n : m_parts)
      sum += double(n) * n;
    m_part_factor = (std::min)(1., std::sqrt(maximum_number_of_faces / (tolerance * sum)));
    for(int& n : m_parts)
      n = limited(n);
  }

  int limited(const int number_of_parts) const { return static_cast<int>(std::ceil(m_part_factor * number_of_parts)); }

  // The height of the model over a facet falls with the square of the length. Where it was found to be higher at a point
  // than `m_heights` says, the peak is narrower than the facet by as much.
  int count_parts(const int f, const double height_found) const
  {
    constexpr double narrowest = 4.;
    double height = m_heights[f];
    if(height_found > height)
      height = height_found * CGAL::square((std::min)(narrowest, height_found / height));
    const double needed = std::sqrt(height / (tolerance * m_bound));
    if(needed <= 1.)
      return 1;
    const double longest_side = m_model.longest_side(f);
    const double useful = height > steep * longest_side ? (std::numeric_limits<double>::infinity)()
                                                        : longest_side / (least_distance * smallest_size(f));
    return (std::max)(1, static_cast<int>(std::ceil((std::min)({needed, useful, largest_number_of_parts}))));
  }

  // of those at the corners, the middles and the centroid
  double smallest_size(const int f) const
  {
    double result = m_reference.sizes(location_in_face(f, 1. / 3., 1. / 3.));
    for(int i = 0; i <= 2; ++i)
      for(int j = 0; i + j <= 2; ++j)
        result = (std::min)(result, m_reference.sizes(location_in_face(f, i / 2., j / 2.)));
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

  // Where a point is higher over its face than what the face was cut for, it is cut again.
  void collect_face_points(const Progress& progress)
  {
    std::vector<int> faces(m_parts.size());
    std::iota(faces.begin(), faces.end(), 0);
    while(!faces.empty())
    {
      const std::size_t first = m_targets.size();
      for(const int f : faces)
      {
        progress(0.);
        collect_locations(f);
      }
      const std::vector<double> distances = find_points(first, progress);
      note_model_distances(distances);
      faces.clear();
      for(std::size_t i = 0, next; i < distances.size(); i = next)
      {
        const int f = m_targets[first + i].location.face;
        double height = 0.;
        for(next = i; next < distances.size() && m_targets[first + next].location.face == f; ++next)
          height = (std::max)(height, distances[next]);
        if(height <= m_heights[f])
          continue;
        const int n = limited(count_parts(f, height));
        if(n <= m_parts[f])
          continue;
        m_parts[f] = n;
        faces.push_back(f);
      }
    }
  }

  // of the targets from the first one on; returns how far they are from their facets
  std::vector<double> find_points(const std::size_t first, const Progress& progress)
  {
    std::vector<double> distances(m_targets.size() - first);
    for_each_index(static_cast<int>(distances.size()), is_parallel(), [&]
    {
      return [&](const int i)
      {
        Deviation_target& target = m_targets[first + i];
        target.point = m_reference.surface_point(target.location);
        distances[i] = m_model.distance_to_facet(target.location, target.point);
      };
    }, progress);
    return distances;
  }

  // of a regular partition, without the corners
  void collect_locations(const int f)
  {
    const int n = m_parts[f];
    for(int i = 0; i <= n; ++i)
      for(int j = 0; i + j <= n; ++j)
      {
        const int steps[3] = {n - i - j, i, j};
        if((std::max)({steps[0], steps[1], steps[2]}) < n && !is_at_neighbor(f, steps))
          m_targets.push_back({Vector::Zero(), location_in_face(f, double(i) / n, double(j) / n)});
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
