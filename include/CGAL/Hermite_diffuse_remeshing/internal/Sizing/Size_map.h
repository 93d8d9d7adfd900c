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
#include <CGAL/Hermite_diffuse_remeshing/internal/Model/closest_barycentric.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Progress.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Sizing/Curve_sizes.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Sizing/Element_curvature.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Sizing/Graded_sizes.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Sizing/Size_sources.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Sizing/User_size_probes.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Sizing/coarsen_sizes.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Sizing/number_of_equilateral_faces.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace CGAL {
namespace Hermite_diffuse_remeshing {
namespace internal {

// The size of the elements as a function on the reference: the smallest of the curvature's (of the
// surface at both sides of a feature, and of the feature curve), the user's, and the bounds, then
// limited in slope. It is continuous, and piecewise linear on the reference's faces, which are bisected
// where they are larger than the size and the size varies, so that a large flat face between fine
// fillets can carry a coarse middle. Read at a location by descending the bisections of its face.
class Size_map
{
  typedef Bisection_tree::Cell Cell;

  Size_sources m_sources;
  Progress m_progress;
  Bisection_tree m_cells;
  Size_samples m_samples;                 // first the vertices of the reference
  Graded_sizes m_sizes;
  std::vector<double> m_fine_sizes;       // those that were asked for, while coarser ones are in their place
  std::vector<double> m_area_ratios;      // of the surface over the faces
  Pair_map<int> m_middles;
  Curve_sizes m_curve_sizes;
  Frozen_lengths m_frozen;
  double m_scale = 1.;                    // of the own sizes, to meet a budget
  User_size_probes m_probes;
  std::vector<int> m_unmatched;           // corners that may be in the middle of a side of another cell

  // a bisection halves a side: 48 of them in a row reach the rounding of the coordinates
  static constexpr int maximum_number_of_rounds = 48;

public:
  // `is_edge_frozen`: of the edges of the table; empty if none is
  Size_map(const Reference_surface& surface, const Edge_table& edges, const Feature_curves& curves,
           const Size_options& options, const std::vector<char>& is_edge_frozen = std::vector<char>(),
           const Progress& progress = Progress())
    : m_sources(surface, edges, options), m_progress(progress), m_cells(surface.triangles())
    , m_curve_sizes(surface, edges, curves, m_sources)
  {
    m_area_ratios = m_sources.area_ratios(progress);
    sample_vertices(surface, curves);
    m_curve_sizes.visit_strips(edges, curves, m_samples, is_parallel(), progress.part(0., 0.),
                               [&](const int sample, const double size) { lower(sample, size); });
    for(std::size_t e = 0; e < is_edge_frozen.size(); ++e)
      if(is_edge_frozen[e])
      {
        const std::array<int, 2>& ends = edges.vertices(static_cast<int>(e));
        m_frozen.add_edge(ends[0], ends[1], (m_samples.position(ends[1]) - m_samples.position(ends[0])).norm());
      }
    // What large cells pass on along their sides is lower than what holds after they are bisected.
    refine([this] { m_sizes.grade_bisected(grading()); });
    m_sizes.forget_origins();
    // From now on the mesh changes, and a field that refers to it with it: what has been read is all that is known.
    m_sources.forget_user_size();
  }

  double operator()(const Location& location) const
  {
    const std::pair<int, Barycentric> at = m_cells.leaf(location);
    const std::array<int, 3>& s = m_cells[at.first].samples;
    return at.second[0] * m_sizes[s[0]] + at.second[1] * m_sizes[s[1]] + at.second[2] * m_sizes[s[2]];
  }

  double minimum_length() const { return m_sources.options().minimum_length; }

  // Asks for a smaller size at a location: the cell there is bisected until it is small against the size, which
  // then bounds that at the corners. Call `refine()` after the last one.
  void add_cap(const Location& location, const double size)
  {
    const double bounded = (std::max)(size, minimum_length());
    int c = m_cells.leaf(location).first;
    for(; !is_full(); c = m_cells.leaf(location).first)
    {
      const int k = m_samples.longest_side(m_cells[c]);
      if(m_samples.side_length(m_cells[c], k) <= sides_per_size * bounded)
        break;
      bisect(c, k);
    }
    for(const int s : m_cells[c].samples)
    {
      m_samples.lower_cap(s, bounded);
      m_sizes.note(s);
    }
  }

  // Do edges that stay as they are keep the size at a location above what was asked for there?
  bool is_cap_exceeded(const Location& location) const
  {
    constexpr double margin = 1e-6;
    const std::array<int, 3>& s = m_cells[m_cells.leaf(location).first].samples;
    return std::any_of(s.begin(), s.end(),
                       [this](const int i) { return m_sizes[i] > (1. + margin) * m_samples.cap(i); });
  }

  // Bisects cells until each is small against the size or the size is linear in it, after sizes have been lowered.
  void refine() { refine([this] { m_sizes.grade_again(grading()); }); }

private:
  template <typename Grade>
  void refine(const Grade& grade)
  {
    for(int round = 0; round < maximum_number_of_rounds; ++round)
    {
      match_cells();
      grade();
      bool is_refined = false;
      const std::vector<char> has_changed = m_sizes.find_changes(m_samples);
      const int number_of_cells = m_cells.number_of_cells();
      for(int c = 0; c < number_of_cells; ++c, m_progress(0.))
      {
        const std::array<int, 3>& s = m_cells[c].samples;
        if(!m_cells.is_leaf(c) || is_full() || !(has_changed[s[0]] || has_changed[s[1]] || has_changed[s[2]])
           || !is_too_coarse(c))
          continue;
        bisect(c, m_samples.longest_side(m_cells[c]));
        is_refined = true;
      }
      if(!is_refined)
        break;
    }
    match_cells();
    if(!m_sizes.is_up_to_date())
      grade();
  }

public:
  // number of equilateral triangles with the size of the map on the faces that are selected
  template <typename IsSelected>
  double number_of_faces(const IsSelected& is_selected) const
  {
    double number = 0.;
    for(int c = 0; c < m_cells.number_of_cells(); ++c)
    {
      const std::array<int, 3>& s = m_cells[c].samples;
      if(m_cells.is_leaf(c) && is_selected(m_cells[c].face))
        number += m_area_ratios[m_cells[c].face] * number_of_equilateral_faces(
          m_samples.position(s[0]), m_samples.position(s[1]), m_samples.position(s[2]),
          {{m_sizes[s[0]], m_sizes[s[1]], m_sizes[s[2]]}});
    }
    return number;
  }

  // all sizes, and grades them anew
  void scale_by(const double factor)
  {
    m_scale *= factor;
    m_sizes.grade(grading());
  }

  // Makes the sizes coarser than asked for by a factor, for a mesh that is to be refined; 1: as asked for.
  void set_coarseness(const double factor)
  {
    if(m_fine_sizes.empty())
      m_fine_sizes = m_sizes.values();
    m_sizes.set(factor == 1. ? std::move(m_fine_sizes) : coarsened_sizes(
                m_fine_sizes, m_samples, m_cells.samples_of_leaves(), factor, gradation(), m_progress));
    if(factor == 1.)
      m_fine_sizes.clear();
  }

  bool is_coarse() const { return !m_fine_sizes.empty(); }

  // that an edge of a size may have over a feature curve
  double largest_sagitta(const double size) const { return m_scale * m_sources.largest_sagitta(size); }

  double certainty_of_radius() const { return m_sources.certainty_of_radius(); }
  // of the sizes that were asked for
  double scale() const { return m_scale; }

private:
  bool is_parallel() const { return m_sources.is_parallel(); }
  bool is_full() const { return m_cells.number_of_cells() >= m_sources.options().maximum_number_of_cells; }

  void sample_vertices(const Reference_surface& surface, const Feature_curves& curves)
  {
    const Indexed_triangles& triangles = surface.triangles();
    for(const Vector& p : triangles.points)
      m_samples.add(p, m_sources.options().maximum_length);
    if(m_sources.has_user_size())
    {
      std::vector<char> is_done(triangles.number_of_vertices(), false);
      for(int c = 0; c < 3 * triangles.number_of_faces(); ++c)
      {
        const int v = triangles.triangles[c / 3][c % 3];
        m_progress(0.);
        if(!is_done[v] || m_sources.options().is_user_size_local)
          lower_user_size(v, m_sources.of_user(triangles.points[v], location_of_corner(c)));
        is_done[v] = true;
      }
    }
    const std::vector<double> curvatures = largest_curvatures_of_nodes(surface, m_sources, m_progress.part(0., 0.));
    for(int i = 0; i < surface.cut_mesh().number_of_nodes(); ++i)
      if(!surface.node(i).is_singular)
        lower_by_curvature(surface.cut_mesh().vertex(i), curvatures[i]);
    for(const Feature_curve& curve : curves.curves)
      for(std::size_t i = 0; i < curve.vertices.size(); ++i)
      {
        const int point = static_cast<int>(i);
        m_samples.lower_radius(curve.vertices[i], curve.spline.curvature_at_point(point));
        lower(curve.vertices[i], size_at_point(curve.spline, point, m_sources));
      }
  }

  void lower(const int sample, const double size)
  {
    m_samples.lower(sample, m_sources.clamped(size));
    m_sizes.note(sample);
  }
  void lower_by_curvature(const int sample, const double curvature)
  {
    m_samples.lower_radius(sample, curvature);
    lower(sample, m_sources.of_curvature(curvature));
  }
  void lower_user_size(const int sample, const double size)
  {
    m_samples.lower_user_size(sample, m_sources.clamped(size));
    m_sizes.note(sample);
  }

  void bisect(const int c, const int k)
  {
    const int middle = middle_of_side(m_cells[c], k);
    m_sizes.note(middle);
    if(!m_samples.is_corner(middle))
    {
      m_samples.set_corner(middle);
      m_unmatched.push_back(middle);
    }
    m_sizes.note_bisected(m_cells[c].samples);
    m_cells.bisect(c, k, middle);
  }

  // Sizes are continuous where cells match: those beside which a cell has been bisected are, too. That it is always the
  // longest side ends, and keeps the cells in shape (M.-C. Rivara, Algorithms for refining triangular grids suitable for
  // adaptive and multigrid techniques, International Journal for Numerical Methods in Engineering 20, 1984).
  void match_cells()
  {
    std::vector<int> last_pass;           // of the samples: after which a side of theirs was bisected last
    int first_new = m_cells.number_of_cells();
    bool is_bisected = !m_unmatched.empty();
    for(int pass = 0; is_bisected; ++pass)
    {
      is_bisected = false;
      last_pass.resize(m_samples.size(), -1);
      for(const int middle : m_unmatched)
        last_pass[m_samples.ends(middle)[0]] = last_pass[m_samples.ends(middle)[1]] = pass;
      m_unmatched.clear();
      const int number_of_cells = m_cells.number_of_cells();
      for(int c = 0; c < number_of_cells && !is_full(); ++c, m_progress(0.))
        if(m_cells.is_leaf(c) && is_bisected_beside(m_cells[c], c < first_new ? pass : 0, last_pass))
        {
          bisect(c, m_samples.longest_side(m_cells[c]));
          is_bisected = true;
        }
      first_new = number_of_cells;
    }
  }

  // in one of the passes from `first_pass` on
  bool is_bisected_beside(const Cell& cell, const int first_pass, const std::vector<int>& last_pass) const
  {
    const auto is_marked = [&](const int i)
    {
      return i < static_cast<int>(last_pass.size()) && last_pass[i] >= first_pass;
    };
    for(int k = 0; k < 3; ++k)
    {
      const int a = cell.samples[k], b = cell.samples[next(k)];
      if(!is_marked(a) || !is_marked(b))
        continue;
      const auto found = m_middles.find(ordered(a, b));
      if(found != m_middles.end() && m_samples.is_corner(found->second))
        return true;
    }
    return false;
  }

  // The sample at the middle of a side, made on demand and shared by the cells at the side. Each of them
  // adds what it knows: a feature has a surface at each side, and a field of the user per face has two
  // values at an edge.
  int middle_of_side(const Cell& cell, const int k)
  {
    const int a = cell.samples[k], b = cell.samples[next(k)];
    const Sample_pair key = ordered(a, b);
    const auto found = m_middles.find(key);
    const bool is_new = found == m_middles.end();
    const int sample = is_new ? m_samples.size() : found->second;
    const bool is_on_curve = m_curve_sizes.is_on_curve(a, b);
    if(is_new)
    {
      // the interpolated size of the user stands where the field is not asked any more
      const double user_size = m_sources.has_user_size() ? m_sources.options().maximum_length
                             : (m_samples.user_size(a) + m_samples.user_size(b)) / 2.;
      m_samples.add_middle(key.first, key.second, user_size);
      m_middles[key] = sample;
      m_frozen.add_middle(a, b, sample);
      if(is_on_curve)
        lower(sample, m_curve_sizes.bisect(a, b, sample, m_samples.position(sample), user_size));
    }
    const bool is_user_asked = m_sources.has_user_size() && (is_new || m_sources.options().is_user_size_local);
    if(is_new || is_on_curve || is_user_asked)
    {
      const Location location = closest_on_face(m_sources.triangles(), cell.face, m_samples.position(sample));
      if(is_new || is_on_curve)
        lower(sample, is_on_curve ? m_sources.of_surface_beside(location) : m_sources.of_surface_around(location));
      if(is_user_asked)
        lower_user_size(sample, m_sources.of_user(location));
    }
    return sample;
  }

  bool is_too_coarse(const int c)
  {
    const Cell cell = m_cells[c];
    const int k = m_samples.longest_side(cell);
    const std::array<double, 3> s = {{m_sizes[cell.samples[0]], m_sizes[cell.samples[1]], m_sizes[cell.samples[2]]}};
    const double smallest = (std::min)({s[0], s[1], s[2]}), largest = (std::max)({s[0], s[1], s[2]});
    const double length = m_samples.side_length(cell, k);
    if(length > sides_per_size * smallest)
    {
      if(largest > (1. + size_tolerance) * smallest)
        return true;
      // The size could have a peak or a hollow between equal corners. On a feature curve the other side, where this may
      // be the longest one, would know of it alone.
      for(int i = 0; i < 3; ++i)
        if((i == k || m_curve_sizes.is_on_curve(cell.samples[i], cell.samples[next(i)]))
           && m_samples.side_length(cell, i) > sides_per_size * smallest && is_other_at_middle(cell, i))
          return true;
    }
    if(length > sides_per_size_at_jump * smallest && has_jump_of_user_size(cell, m_samples, gradation()))
      return true;
    if(!m_sources.has_user_size() || cell.is_probed)
      return false;
    if(m_probes.is_smaller_inside(cell, s, length, m_samples, m_sources, m_progress))
      return true;
    m_cells.set_probed(c);
    return false;
  }

  // Does the size in the middle of a side differ from the mean of those at its ends?
  bool is_other_at_middle(const Cell& cell, const int k)
  {
    const double interpolated = (m_sizes[cell.samples[k]] + m_sizes[cell.samples[next(k)]]) / 2.;
    const int middle = middle_of_side(cell, k);
    // the cell at the other side may have it already, graded
    const double at_middle = middle < m_sizes.number_of_samples() ? m_sizes[middle] : m_samples.own_size(middle);
    // with a gradation of 1 all sizes are the smallest
    return at_middle < interpolated / (1. + size_tolerance)
        || (gradation() > 1. && at_middle > (1. + size_tolerance) * interpolated);
  }

  double gradation() const { return m_sources.options().gradation; }
  Grading grading() const { return Grading{m_cells, m_samples, m_frozen, m_scale, gradation(), m_progress}; }
};

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_SIZING_SIZE_MAP_H
