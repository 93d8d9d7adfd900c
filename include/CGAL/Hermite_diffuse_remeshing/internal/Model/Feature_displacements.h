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
#include <CGAL/Hermite_diffuse_remeshing/internal/Model/Displacement_support.h>
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
// Beside a hole in a plane the faces are often needles, lower than the arcs that their sides are chords of: displaced, such
// a face would lie over those behind it. There the displacement fades in a triangle over several faces of the plane.
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
  struct Entry
  {
    std::array<int, 3> gaps_of_sides = {{none, none, none}};
    std::vector<int> supports;
  };

  struct Support
  {
    Displacement_support triangle;
    int gaps;
  };

  const Indexed_triangles& m_triangles;
  std::vector<int> m_entry_of_face;                   // most faces have no feature side
  std::vector<Entry> m_entries;
  std::vector<Support> m_supports;
  std::vector<Gaps> m_gaps;

public:
  Feature_displacements(const Reference_surface& surface, const Edge_table& edges, const Feature_curves& curves,
                        const Progress& progress)
    : m_triangles(surface.triangles()), m_entry_of_face(surface.triangles().number_of_faces(), none)
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
          add(surface, sides[first + i], block[i]);
    }
  }

  Vector operator()(const Location& location) const
  {
    Vector result = Vector::Zero();
    if(m_entry_of_face[location.face] == none)
      return result;
    const auto add = [&](const int gaps, const double share, const double foot)
    {
      if(share > 0. && foot > 0. && foot < 1.)
        result += share * share * interpolate(m_gaps[gaps], foot);
    };
    const Entry& entry = m_entries[m_entry_of_face[location.face]];
    for(int k = 0; k < 3; ++k)
      if(entry.gaps_of_sides[k] != none)
      {
        const double share = 1. - location.coordinates[previous(k)];
        add(entry.gaps_of_sides[k], share, location.coordinates[next(k)] / share);
      }
    for(const int i : entry.supports)
    {
      const Displacement_support::Place place = m_supports[i].triangle.place(m_triangles.point(location));
      add(m_supports[i].gaps, place.share, place.foot);
    }
    return result;
  }

private:
  void add(const Reference_surface& surface, const Face_side& side, const Gaps& gaps)
  {
    const int number = static_cast<int>(m_gaps.size());
    m_gaps.push_back(gaps);
    Displacement_support triangle(surface, side);
    double inwards = 0.;
    for(const Vector& gap : gaps)
      inwards = (std::max)(inwards, triangle.inward_part(gap));
    const std::vector<int> faces = triangle.is_face_folded(inwards) ? triangle.find_faces(surface, side)
                                                                    : std::vector<int>();
    if(faces.empty())
      entry(side.face).gaps_of_sides[side.side] = number;
    else
      m_supports.push_back({triangle, number});
    for(const int f : faces)
      entry(f).supports.push_back(static_cast<int>(m_supports.size()) - 1);
  }

  Entry& entry(const int face)
  {
    if(m_entry_of_face[face] == none)
    {
      m_entry_of_face[face] = static_cast<int>(m_entries.size());
      m_entries.push_back(Entry());
    }
    return m_entries[m_entry_of_face[face]];
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
