// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_SIZING_USER_SIZE_PROBES_H
#define CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_SIZING_USER_SIZE_PROBES_H

#include <CGAL/Hermite_diffuse_remeshing/internal/Indexed_triangles.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Model/closest_barycentric.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Progress.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Sizing/Bisection_tree.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Sizing/Size_samples.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Sizing/Size_sources.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Sizing/limit_gradation.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace CGAL {
namespace Hermite_diffuse_remeshing {
namespace internal {

// a cell is fine enough when its longest side is this many sizes long; off the simple ratios, so that
// rounding does not decide on regular meshes
constexpr double sides_per_size = 2.0037;
// where the size that was asked for jumps, this many: the place of the jump moves by as much
constexpr double sides_per_size_at_jump = 0.2513;
// or when the size in it differs by less than this from its linear interpolation
constexpr double size_tolerance = 0.25;

// Do the user's sizes differ more between two corners than the gradation allows? The curvature's are
// not asked: they jump at every smooth junction of a flat and a round part, and what a fit says
// between two vertices there is no better known than at the vertices.
inline bool has_jump_of_user_size(const Bisection_tree::Cell& cell, const Size_samples& samples, const double gradation)
{
  for(int k = 0; k < 3; ++k)
  {
    const double a = samples.user_size(cell.samples[k]), b = samples.user_size(cell.samples[next(k)]);
    const double allowed = slope_of_gradation(gradation) * samples.side_length(cell, k);
    if(std::abs(a - b) > (1. + size_tolerance) * allowed + size_tolerance * (std::min)(a, b))
      return true;
  }
  return false;
}

// Looks for what the user's field has inside of cells, until the number of questions that is allowed has been asked.
class User_size_probes
{
  double m_number = 0.;

  // The user's field is probed at points this many sizes apart: a part of the field with smaller sizes
  // is seen when it is as large as the elements around it. Off the simple ratios that regular meshes
  // have, so that rounding does not choose the number of points.
  static constexpr double distance = 0.4973;

public:
  // Is there a point in a cell where the user's size is smaller than the interpolation of the corners', `sizes`, and
  // small against the cell, the longest side of which has the given length?
  bool is_smaller_inside(const Bisection_tree::Cell& cell, const std::array<double, 3>& sizes, const double length,
                         const Size_samples& samples, const Size_sources& sources, const Progress& progress)
  {
    const double step = distance * *std::min_element(sizes.begin(), sizes.end());
    const int n = static_cast<int>((std::min)(length / step, double((std::numeric_limits<int>::max)() / 2)));
    const double last = sources.options().maximum_number_of_probes;
    for(int i = 0; i <= n && m_number < last; ++i, progress(0.))
      for(int j = 0; i + j <= n && m_number < last; ++j, ++m_number)
      {
        // the centroids of the upright triangles of a regular partition of the cell
        const Barycentric l = {{(i + 1. / 3.) / (n + 1.), (j + 1. / 3.) / (n + 1.), 1. - (i + j + 2. / 3.) / (n + 1.)}};
        Vector p = Vector::Zero();
        double interpolated = 0.;
        for(int m = 0; m < 3; ++m)
        {
          p += l[m] * samples.position(cell.samples[m]);
          interpolated += l[m] * sizes[m];
        }
        const double size = sources.of_user(p, closest_on_face(sources.triangles(), cell.face, p));
        if(size * (1. + size_tolerance) < interpolated && length > sides_per_size * size)
          return true;
      }
    return false;
  }
};

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_SIZING_USER_SIZE_PROBES_H
