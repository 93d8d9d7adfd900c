// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_SIZING_COARSEN_SIZES_H
#define CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_SIZING_COARSEN_SIZES_H

#include <CGAL/Hermite_diffuse_remeshing/internal/Sizing/Size_samples.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Sizing/limit_gradation.h>

#include <algorithm>
#include <array>
#include <vector>

namespace CGAL {
namespace Hermite_diffuse_remeshing {
namespace internal {

// Sizes for a coarse mesh that will be refined: `factor` times as large where that is not too coarse for the shape.
// `leaves`: three samples each.
inline std::vector<double> coarsened_sizes(const std::vector<double>& sizes, const Size_samples& samples,
                                           const std::vector<std::array<int, 3> >& leaves, const double factor,
                                           const double gradation, const Progress& progress)
{
  // The longest edges make a square around a cylinder. Over longer ones the normal turns by more than 90 degrees, and
  // operators that compare the normals of triangles with the model's do not know any more where they are.
  constexpr double longest_edge_per_radius = 1.4142135623730951;
  // Refined step by step, a coarse mesh may be less graded than what it is to become.
  constexpr double least_gradation = 1.5;
  std::vector<double> result(sizes.size());
  for(std::size_t i = 0; i < sizes.size(); ++i)
  {
    const double longest = longest_edge_per_radius * samples.radius(static_cast<int>(i));
    result[i] = (std::max)(sizes[i], (std::min)(factor * sizes[i], longest));
  }
  limit_gradation(leaves, [&](const int i) -> const Vector& { return samples.position(i); },
                  slope_of_gradation((std::max)(gradation, least_gradation)), result, progress);
  return result;
}

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_SIZING_COARSEN_SIZES_H
