// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_SIZING_SIZE_MAP_H
#define CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_SIZING_SIZE_MAP_H

#include <CGAL/Hermite_diffuse_remeshing/internal/Curves/chain_feature_edges.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Model/Reference_surface.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Sizing/limit_gradation.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Sizing/size_from_curvature.h>

#include <boost/container_hash/hash.hpp>

#include <algorithm>
#include <array>
#include <functional>
#include <limits>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Hermite_diffuse_remeshing {
namespace internal {

struct Size_options
{
  double approximation_error = 0.01;      // 0: the curvature is not looked at
  double minimum_length = 0., maximum_length = 0.;
  double gradation = 1.3;
  double maximum_deviation = std::numeric_limits<double>::infinity();
  // the user's size at a point, infinite where there is none
  std::function<double(const Vector&)> user_size;
};

// The size of the elements as a function on the reference: the smallest of the curvature's (of the
// surface at both sides of a feature, and of the feature curve), the user's, and the bounds, then
// limited in slope. It is piecewise linear on the reference's faces, which are bisected where they
// are larger than the size and the size varies, so that a large flat face between fine fillets can
// carry a coarse middle. Read at a location by descending the bisections of its face.
class Size_map
{
  struct Cell
  {
    std::array<int, 3> samples;
    int face;
    int split_side = -1;                  // -1: leaf
    int first_child = -1;                 // the children keep the start and the end of the split side
  };

  struct Sample
  {
    Vector position;
    double own_size;                      // before gradation
  };

  typedef std::pair<int, int> Sample_pair;

  const Reference_surface& m_surface;
  Size_options m_options;
  double m_length_over_radius;
  std::vector<Cell> m_cells;              // first one root per face
  std::vector<Sample> m_samples;          // first the vertices of the reference
  std::vector<double> m_sizes;            // after gradation
  std::unordered_map<Sample_pair, int, boost::hash<Sample_pair> > m_middles;
  // curvature's size along the pieces of the feature edges
  std::unordered_map<Sample_pair, double, boost::hash<Sample_pair> > m_curve_sizes;

  // a cell is fine enough when its longest side is this many sizes long
  static constexpr double sides_per_size = 2.;
  // or when the size in it differs by less than this from its linear interpolation
  static constexpr double size_tolerance = 0.25;
  // a bisection halves a side: 48 of them in a row reach the rounding of the coordinates
  static constexpr int maximum_number_of_rounds = 48;

public:
  Size_map(const Reference_surface& surface, const Edge_table& edges, const Feature_curves& curves,
           const Size_options& options)
    : m_surface(surface), m_options(options)
    , m_length_over_radius(options.approximation_error > 0.
                           ? length_of_error(options.approximation_error)
                           : std::numeric_limits<double>::infinity())
  {
    sample_vertices(curves);
    sample_curves(edges, curves);
    const Indexed_triangles& triangles = surface.triangles();
    for(int f = 0; f < triangles.number_of_faces(); ++f)
    {
      Cell root;
      root.samples = triangles.triangles[f];
      root.face = f;
      m_cells.push_back(root);
    }
    refine();
  }

  double operator()(const Location& location) const
  {
    const std::pair<int, Barycentric> at = leaf(location);
    const std::array<int, 3>& s = m_cells[at.first].samples;
    return at.second[0] * m_sizes[s[0]] + at.second[1] * m_sizes[s[1]] + at.second[2] * m_sizes[s[2]];
  }

  double minimum_length() const { return m_options.minimum_length; }

  // Asks for smaller sizes: each cap bounds the size at the corners of the cell around a location.
  // Call `refine()` after the last one.
  void add_cap(const Location& location, const double size)
  {
    const double bounded = (std::max)(size, m_options.minimum_length);
    for(const int s : m_cells[leaf(location).first].samples)
      m_samples[s].own_size = (std::min)(m_samples[s].own_size, bounded);
  }

  // bisects cells until each is small against the size or the size is linear in it
  void refine()
  {
    for(int round = 0; round < maximum_number_of_rounds; ++round)
    {
      grade();
      bool is_refined = false;
      const int number_of_cells = static_cast<int>(m_cells.size());
      for(int c = 0; c < number_of_cells; ++c)
        if(m_cells[c].split_side == -1 && is_too_coarse(c))
        {
          bisect(c);
          is_refined = true;
        }
      if(!is_refined)
        return;
    }
    grade();
  }

private:
  // the cell without children at a location, and the coordinates in it
  std::pair<int, Barycentric> leaf(const Location& location) const
  {
    // Points between two children are usual on regular meshes, and the sizes may differ there where
    // only one of the children is bisected further: rounding must not choose.
    constexpr double margin = 1e-9;
    int c = location.face;
    Barycentric l = location.coordinates;
    while(m_cells[c].split_side != -1)
    {
      const int k = m_cells[c].split_side, j = next(k);
      const int child = l[k] + margin >= l[j] ? 0 : 1;
      const int kept = child == 0 ? k : j, replaced = child == 0 ? j : k;
      l[kept] -= l[replaced];
      l[replaced] *= 2.;
      c = m_cells[c].first_child + child;
    }
    return std::make_pair(c, l);
  }

  double clamped(const double size) const
  {
    return (std::max)(m_options.minimum_length, (std::min)(m_options.maximum_length, size));
  }

  double size_of_curvature(const double curvature) const
  {
    if(!(curvature > 0.))
      return std::numeric_limits<double>::infinity();
    return (std::min)(m_length_over_radius / curvature,
                      length_of_deviation(m_options.maximum_deviation, 1. / curvature));
  }

  double user_size(const Vector& p) const
  {
    return m_options.user_size ? m_options.user_size(p) : std::numeric_limits<double>::infinity();
  }

  double surface_size(const Location& location) const
  {
    if(m_options.approximation_error <= 0. && m_options.maximum_deviation == std::numeric_limits<double>::infinity())
      return std::numeric_limits<double>::infinity();
    const std::pair<double, double> k = m_surface.evaluate(location).monge_form().curvatures();
    return size_of_curvature((std::max)(std::abs(k.first), std::abs(k.second)));
  }

  // The one-sided fit at the end of a fan of faces is the least certain of the model: at an open
  // node the mean curvature in its faces is taken.
  double node_size(const int node) const
  {
    const Index_range corners = m_surface.cut_mesh().corners(node);
    Location location;
    if(!m_surface.cut_mesh().is_open(node))
    {
      location.face = corners.first[0] / 3;
      location.coordinates.fill(0.);
      location.coordinates[corners.first[0] % 3] = 1.;
      return surface_size(location);
    }
    double sum = 0.;
    location.coordinates.fill(1. / 3.);
    for(const int c : corners)
    {
      location.face = c / 3;
      sum += 1. / surface_size(location);
    }
    return corners.size() / sum;
  }

  void sample_vertices(const Feature_curves& curves)
  {
    const Indexed_triangles& triangles = m_surface.triangles();
    for(const Vector& p : triangles.points)
      m_samples.push_back({p, clamped(user_size(p))});
    for(int i = 0; i < m_surface.cut_mesh().number_of_nodes(); ++i)
      if(!m_surface.node(i).is_singular)
        lower(m_surface.cut_mesh().vertex(i), node_size(i));
    for(const Feature_curve& curve : curves.curves)
      for(std::size_t i = 0; i < curve.vertices.size(); ++i)
        lower(curve.vertices[i], size_of_curvature(curve.spline.curvature_at_point(static_cast<int>(i))));
  }

  void sample_curves(const Edge_table& edges, const Feature_curves& curves)
  {
    for(const Feature_curve& curve : curves.curves)
      for(std::size_t i = 0; i < curve.edges.size(); ++i)
      {
        const double curvature = (curve.spline.curvature_at_point(static_cast<int>(i))
                                + curve.spline.curvature_at_point(static_cast<int>(i) + 1)) / 2.;
        const std::array<int, 2>& ends = edges.vertices(curve.edges[i]);
        m_curve_sizes[Sample_pair(ends[0], ends[1])] = clamped(size_of_curvature(curvature));
      }
  }

  void lower(const int sample, const double size)
  {
    m_samples[sample].own_size = (std::min)(m_samples[sample].own_size, clamped(size));
  }

  static Sample_pair ordered(const int a, const int b)
  {
    return a < b ? Sample_pair(a, b) : Sample_pair(b, a);
  }

  double side_length(const Cell& cell, const int k) const
  {
    return (m_samples[cell.samples[next(k)]].position - m_samples[cell.samples[k]].position).norm();
  }

  int longest_side(const Cell& cell) const
  {
    int longest = 0;
    for(int k = 1; k < 3; ++k)
      // a tie must not be decided by rounding
      if(side_length(cell, k) > (1. + 1e-9) * side_length(cell, longest))
        longest = k;
    return longest;
  }

  Location location_of(const Cell& cell, const Vector& p) const
  {
    const Indexed_triangles& triangles = m_surface.triangles();
    const Vector n = triangles.area_vector(cell.face);
    const double area2 = n.squaredNorm();
    Location location;
    location.face = cell.face;
    if(area2 > 0.)
      for(int k = 0; k < 3; ++k)
        location.coordinates[k] = (std::max)(0., (triangles.point(cell.face, next(k)) - p)
                                   .cross(triangles.point(cell.face, previous(k)) - p).dot(n) / area2);
    return location;
  }

  // the sample at the middle of a side, made on demand and shared by the cells at the side
  int middle_of_side(const Cell& cell, const int k)
  {
    const int a = cell.samples[k], b = cell.samples[next(k)];
    const Sample_pair key = ordered(a, b);
    const auto found = m_middles.find(key);
    const Vector middle = (m_samples[key.first].position + m_samples[key.second].position) / 2.;
    const auto on_curve = m_curve_sizes.find(key);
    if(found != m_middles.end())
    {
      // a feature has a surface at each side
      if(on_curve != m_curve_sizes.end())
        lower(found->second, surface_size(location_of(cell, middle)));
      return found->second;
    }

    const int sample = static_cast<int>(m_samples.size());
    m_samples.push_back({middle, clamped(user_size(middle))});
    lower(sample, surface_size(location_of(cell, middle)));
    if(on_curve != m_curve_sizes.end())
    {
      const double size = on_curve->second;
      lower(sample, size);
      m_curve_sizes[ordered(a, sample)] = m_curve_sizes[ordered(sample, b)] = size;
    }
    m_middles[key] = sample;
    return sample;
  }

  bool is_too_coarse(const int c)
  {
    const Cell cell = m_cells[c];
    const int k = longest_side(cell);
    const double s[3] = {m_sizes[cell.samples[0]], m_sizes[cell.samples[1]], m_sizes[cell.samples[2]]};
    const double smallest = (std::min)({s[0], s[1], s[2]}), largest = (std::max)({s[0], s[1], s[2]});
    if(side_length(cell, k) <= sides_per_size * smallest)
      return false;
    if(largest > (1. + size_tolerance) * smallest)
      return true;
    // the size could have a peak or a hollow between equal corners
    const double interpolated = (s[k] + s[next(k)]) / 2.;
    const int middle = middle_of_side(cell, k);
    // the cell at the other side may have it already, graded
    const double at_middle = middle < static_cast<int>(m_sizes.size()) ? m_sizes[middle]
                                                                       : m_samples[middle].own_size;
    return at_middle < interpolated / (1. + size_tolerance) || at_middle > (1. + size_tolerance) * interpolated;
  }

  void bisect(const int c)
  {
    const int k = longest_side(m_cells[c]);
    const int middle = middle_of_side(m_cells[c], k);
    Cell first = m_cells[c], second = m_cells[c];
    first.samples[next(k)] = middle;
    second.samples[k] = middle;
    m_cells[c].split_side = k;
    m_cells[c].first_child = static_cast<int>(m_cells.size());
    m_cells.push_back(first);
    m_cells.push_back(second);
  }

  void grade()
  {
    m_sizes.resize(m_samples.size());
    for(std::size_t i = 0; i < m_samples.size(); ++i)
      m_sizes[i] = m_samples[i].own_size;
    if(m_options.gradation == 1.)
    {
      // one size for all
      std::fill(m_sizes.begin(), m_sizes.end(), *std::min_element(m_sizes.begin(), m_sizes.end()));
      return;
    }
    std::vector<std::array<int, 3> > leaves;
    for(const Cell& cell : m_cells)
      if(cell.split_side == -1)
        leaves.push_back(cell.samples);
    limit_gradation(leaves, [this](const int i) -> const Vector& { return m_samples[i].position; },
                    slope_of_gradation(m_options.gradation), m_sizes);
  }
};

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_SIZING_SIZE_MAP_H
