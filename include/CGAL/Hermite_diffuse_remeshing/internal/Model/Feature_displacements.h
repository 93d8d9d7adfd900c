// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_MODEL_FEATURE_DISPLACEMENTS_H
#define CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_MODEL_FEATURE_DISPLACEMENTS_H

#include <CGAL/Hermite_diffuse_remeshing/internal/Curves/chain_feature_edges.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Model/Reference_surface.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Progress.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/for_each_index.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Hermite_diffuse_remeshing {
namespace internal {

// The fits at the two sides of a feature and its spline meet at the feature's vertices, but only
// nearly in between. A displacement closes the gap: along a feature side of a face it moves the
// fit onto the spline, and it fades with the distance from the side. It is zero on the other
// sides, where the foot on the feature is one of its vertices, so the surface stays continuous.
//
// A gap is smooth along its side. It is sampled once, and interpolated by a cubic spline: asked at every query, it
// would cost another fit.
class Feature_displacements
{
  // Between the samples less than a thousandth of the gaps is left: where the bound of the deviation is a
  // twentieth of the gaps, nothing that counts.
  static constexpr int number_of_intervals = 32;
  typedef std::array<Vector, number_of_intervals + 1> Gaps;     // from the first end of the side to the other

  static constexpr int none = -1;
  static constexpr std::size_t number_in_block = 4096;          // of sides that are sampled before most are left out
  std::vector<int> m_entry_of_face;                   // most faces have no feature side
  std::vector<std::array<int, 3> > m_gaps_of_sides;   // by the entry
  std::vector<Gaps> m_gaps;

public:
  Feature_displacements(const Reference_surface& surface, const Edge_table& edges, const Feature_curves& curves,
                        const Progress& progress)
    : m_entry_of_face(surface.triangles().number_of_faces(), none)
  {
    std::vector<Face_side> sides;
    for(const Feature_curve& curve : curves.curves)
      for(const int e : curve.edges)
        for(int i = 0; i < edges.number_of_sides(e); ++i)
          sides.push_back(edges.side(e, i));
    // Only those that are not zero are kept: straight curves between planes have none.
    std::vector<Gaps> block((std::min)(number_in_block, sides.size()));
    for(std::size_t first = 0; first < sides.size(); first += number_in_block)
    {
      const std::size_t number = (std::min)(number_in_block, sides.size() - first);
      for_each_index(static_cast<int>(number), surface.options().is_parallel, [&]
      {
        return [&](const int i) { block[i] = sample(surface, edges, curves, sides[first + i]); };
      }, progress.part(double(first) / double(sides.size()), double(first + number) / double(sides.size())));
      for(std::size_t i = 0; i < number; ++i)
        if(!std::all_of(block[i].begin(), block[i].end(), [](const Vector& gap) { return gap == Vector::Zero(); }))
          add(sides[first + i], block[i]);
    }
  }

  Vector operator()(const Location& location) const
  {
    Vector result = Vector::Zero();
    const int entry = m_entry_of_face[location.face];
    if(entry == none)
      return result;
    for(int k = 0; k < 3; ++k)
    {
      const double share = 1. - location.coordinates[previous(k)];
      if(m_gaps_of_sides[entry][k] == none || share <= 0.)
        continue;
      const double u = location.coordinates[next(k)] / share;
      if(u > 0. && u < 1.)
        result += share * share * interpolate(m_gaps[m_gaps_of_sides[entry][k]], u);
    }
    return result;
  }

private:
  void add(const Face_side& side, const Gaps& gaps)
  {
    int& entry = m_entry_of_face[side.face];
    if(entry == none)
    {
      entry = static_cast<int>(m_gaps_of_sides.size());
      m_gaps_of_sides.push_back({{none, none, none}});
    }
    m_gaps_of_sides[entry][side.side] = static_cast<int>(m_gaps.size());
    m_gaps.push_back(gaps);
  }

  static Gaps sample(const Reference_surface& surface, const Edge_table& edges, const Feature_curves& curves,
                     const Face_side& side)
  {
    const int edge = edges.edge(side.face, side.side), segment = curves.segment_of_edge[edge];
    const Feature_curve& curve = curves.curves[curves.curve_of_edge[edge]];
    const Vector first = surface.triangles().point(side.face, side.side);
    const double length = (surface.triangles().point(side.face, next(side.side)) - first).norm();
    // of the points: not more than that is none
    constexpr double rounding = 1e-13;
    const double least_gap = rounding * (length + first.norm());

    Gaps gaps;
    gaps.fill(Vector::Zero());
    for(int i = 1; i < number_of_intervals; ++i)
    {
      const double u = double(i) / number_of_intervals, s = curve.parameter(segment, side, u, surface.triangles());
      const Vector gap = curve.spline.point(s) - surface.evaluate(location_on_side(side, u)).point();
      if(gap.norm() > least_gap)
        gaps[i] = gap;
    }
    return gaps;
  }

  // Hermite's cubics between the samples, with the slopes of the parabolas through three of them
  static Vector interpolate(const Gaps& gaps, const double u)
  {
    constexpr int n = number_of_intervals;
    const int i = (std::min)(n - 1, static_cast<int>(u * n));
    const double x = u * n - i, y = 1. - x;
    const Vector rise = gaps[i + 1] - gaps[i];
    // twice the slopes
    const Vector before = i > 0 ? Vector(gaps[i + 1] - gaps[i - 1]) : Vector(4. * rise - (gaps[2] - gaps[0]));
    const Vector after = i + 1 < n ? Vector(gaps[i + 2] - gaps[i]) : Vector(4. * rise - (gaps[n] - gaps[n - 2]));
    return y * gaps[i] + x * gaps[i + 1] + x * y * (y * (before / 2. - rise) - x * (after / 2. - rise));
  }
};

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_MODEL_FEATURE_DISPLACEMENTS_H
