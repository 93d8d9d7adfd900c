// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_SIZING_CURVE_SIZES_H
#define CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_SIZING_CURVE_SIZES_H

#include <CGAL/Hermite_diffuse_remeshing/internal/Sizing/Feature_gaps.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Sizing/Sample_pair.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Sizing/Size_samples.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Sizing/Size_sources.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/for_each_index.h>

#include <algorithm>
#include <array>
#include <vector>

namespace CGAL {
namespace Hermite_diffuse_remeshing {
namespace internal {

// What a curve asks for at one of its points. Where these are at uneven distances the spline bends more beside a point
// than the circle through it and its neighbours does, and edges have to be short there in any case, to be near the
// spline: the faces at them would be narrow if their sizes did not follow.
inline double size_at_point(const Feature_spline& spline, const int point, const Size_sources& sources)
{
  // Of the distance that is allowed: edges that are to be near enough are shorter than their size by a square root of two
  // then, as edges may be anyway. With less, faces that need not be smaller are.
  constexpr double slack = 2.;
  constexpr double step = 0.9;
  // noise must not cost more than this part of the size
  constexpr double least_part = 0.3;
  double size = sources.clamped(sources.of_curvature(spline.curvature_at_point(point)));
  const double least = least_part * size;
  const double s = spline.parameter(point);
  // what bends farther away is the business of other points
  const double first = spline.parameter((std::max)(0, point - 1));
  const double last = spline.parameter((std::min)(spline.number_of_segments(), point + 1));
  const auto are_chords_near = [&]
  {
    return (std::max)(spline.distance_to_chord((std::max)(first, s - size), s),
                      spline.distance_to_chord(s, (std::min)(last, s + size))) <= slack * sources.largest_sagitta(size);
  };
  while(size > least && !are_chords_near())
    size *= step;
  return size;
}

// The sizes that feature curves ask for: by their own curvature, and by the width of the strips that they
// bound. The edges of the curves are bisected with the size map's cells.
class Curve_sizes
{
  struct Piece
  {
    double curvature_size;
    int edge;                             // of the reference
  };

  Feature_gaps m_gaps;
  Pair_map<Piece> m_pieces;               // of the feature edges, between two samples

public:
  Curve_sizes(const Reference_surface& surface, const Edge_table& edges, const Feature_curves& curves,
              const Size_sources& sources)
    : m_gaps(surface.triangles(), surface.cut_mesh(), edges, curves)
  {
    for(const Feature_curve& curve : curves.curves)
      for(std::size_t i = 0; i < curve.edges.size(); ++i)
      {
        const double curvature = (curve.spline.curvature_at_point(static_cast<int>(i))
                                + curve.spline.curvature_at_point(static_cast<int>(i) + 1)) / 2.;
        const std::array<int, 2>& ends = edges.vertices(curve.edges[i]);
        m_pieces[ordered(ends[0], ends[1])] = {sources.of_curvature(curvature), curve.edges[i]};
      }
  }

  // the size at a point of an edge of the reference, where it would be `size` if the edge bounded no strip
  double size_in_strip(const Vector& p, const int edge, const double size) const
  {
    // Two sides of a triangle go across the strip, the third is about twice as long as it is wide: Q = 0.73. Where that is
    // longer than its size by a quarter, as edges may be, Q = 0.62, and the faces need not be raised one by one.
    constexpr double lengths_per_gap = 1.9537;
    // a crack must not cost more than this factor of the size
    constexpr double largest_factor = 8.;
    const double gap = m_gaps.gap(p, edge, size / lengths_per_gap);
    return (std::max)(lengths_per_gap * gap, size / largest_factor);
  }

  // Calls `visit(vertex, size)` with the size in a strip at the ends of all edges of the curves, where it is that of the
  // samples otherwise.
  template <typename Visit>
  void visit_strips(const Edge_table& edges, const Feature_curves& curves, const Size_samples& samples,
                    const bool is_parallel, const Progress& progress, const Visit& visit) const
  {
    struct Strip { int vertex, edge; double size; };
    std::vector<Strip> strips;
    for(const Feature_curve& curve : curves.curves)
      for(const int e : curve.edges)
        for(const int v : edges.vertices(e))
          strips.push_back({v, e, samples.own_size(v)});
    for_each_index(static_cast<int>(strips.size()), is_parallel, [&]
    {
      return [&](const int i)
      { strips[i].size = size_in_strip(samples.position(strips[i].vertex), strips[i].edge, strips[i].size); };
    }, progress);
    for(const Strip& strip : strips)
      visit(strip.vertex, strip.size);
  }

  bool is_on_curve(const int a, const int b) const { return m_pieces.count(ordered(a, b)) != 0; }

  // Bisects the piece between two samples at a third one, at p. Returns what is asked for there, `size` by
  // the other sources.
  double bisect(const int a, const int b, const int middle, const Vector& p, const double size)
  {
    const Piece piece = m_pieces.at(ordered(a, b));
    m_pieces[ordered(a, middle)] = m_pieces[ordered(middle, b)] = piece;
    const double by_curvature = (std::min)(size, piece.curvature_size);
    return (std::min)(by_curvature, size_in_strip(p, piece.edge, by_curvature));
  }
};

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_SIZING_CURVE_SIZES_H
