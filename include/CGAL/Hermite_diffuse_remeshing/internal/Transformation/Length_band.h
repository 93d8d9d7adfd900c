// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_LENGTH_BAND_H
#define CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_LENGTH_BAND_H

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace Hermite_diffuse_remeshing {
namespace internal {

// Which lengths of edges, in units of their sizes, a pass of the adaptation leaves alone
class Length_band
{
  // Edges between 1/band and band times their size are left alone. The paper's factor 2 comes first,
  // because the longest and shortest edges shape the rest; then a band below sqrt(2), in which the halves
  // of a split edge may be short again: what is split and collapsed in turn for a few passes loses
  // irregular vertices. Then slowly wider ones, where that comes to rest.
  static constexpr double widest_band = 2., tightest_band = 1.25, widening = 1.08;
  static constexpr int number_of_tight_passes = 3;
  // Splits leave more short edges than collapses leave long ones: without this factor the edges would be a few
  // percent shorter than their sizes on the average, and there would be more faces than predicted.
  static constexpr double band_center = 1.035;
  // The sizes that the model gives on a mesh that was made by it differ a little from those that it was made for:
  // there only the edges that are far off are changed.
  static constexpr double mending_band = 2.8;
  // Halving makes lengths that are simple multiples of a size. A limit slightly off such numbers is not
  // decided by rounding.
  static constexpr double off_simple_ratios = 1.00137;

public:
  // for a mesh that has not to be split any more, but has irregular vertices
  static constexpr int first_tight_pass = 1;
  // for one that has been through the tight passes at a coarser level
  static constexpr int first_wide_pass = number_of_tight_passes + 1;
  // those before it tighten and widen the band
  static constexpr int first_mending_pass = 1000;

  static double longest(const int pass) { return band_center * band(pass); }
  static double shortest(const int pass) { return band_center / band(pass); }

  // By what factor an edge may be farther from its feature curve than the error law allows. The fit to a result gives
  // other curvatures at its curves than that from which they were made, and only what is far off is to be mended: the
  // distance goes with the square of the length, of which more is left alone by the ratio of the bands.
  static double slack_of_sagitta(const int pass)
  {
    return pass < first_mending_pass ? 1. : (mending_band / widest_band) * (mending_band / widest_band);
  }

  // of the edges of a coarser level, which are about twice as long as their sizes; nearly all of them are to be split
  static double longest_before_refinement() { return off_simple_ratios * 1.45; }

private:
  static double band(const int pass)
  {
    if(pass == 0)
      return off_simple_ratios * widest_band;
    if(pass >= first_mending_pass)
      return off_simple_ratios * mending_band;
    const int widenings = (std::max)(0, pass - number_of_tight_passes);
    return off_simple_ratios * (std::min)(widest_band, tightest_band * std::pow(widening, widenings));
  }
};

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_LENGTH_BAND_H
