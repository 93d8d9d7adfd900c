// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_SIZING_LIMIT_NUMBER_OF_FACES_H
#define CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_SIZING_LIMIT_NUMBER_OF_FACES_H

#include <CGAL/Hermite_diffuse_remeshing/internal/Progress.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Sizing/Size_map.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace CGAL {
namespace Hermite_diffuse_remeshing {
namespace internal {

// Scales the sizes up until the number of faces that `is_selected(face of the reference)` takes is at most `limit`. It
// falls with the square of the scale or, where the gradation or frozen edges rule, more slowly. On all meshes seen it
// is convex over the logarithm of the scale: steps along its last secant do not lead below the limit then.
template <typename IsSelected>
void limit_number_of_faces(Size_map& sizes, const double limit, const IsSelected& is_selected, const Progress& progress)
{
  constexpr double tolerance = 0.002;   // a number of faces that is this close is met
  constexpr int maximum_number_of_steps = 100;
  // a smaller one, relative to the number, is rounding: the lengths of frozen edges rule
  constexpr double least_decrease = 1e-6;
  constexpr double longest_step = 3.;   // where the number hardly falls
  double last_step = 0., last_number = std::numeric_limits<double>::infinity();
  for(int step = 0; step < maximum_number_of_steps; ++step, progress(0.))
  {
    const double number = sizes.number_of_faces(is_selected);
    if(!(number > (1. + tolerance) * limit) || !(number < (1. - least_decrease) * last_number))
      return;
    const double along_secant = last_step * (number - limit) / (last_number - number);
    last_step = (std::max)(std::log(number / limit) / 2., (std::min)(along_secant, longest_step));
    last_number = number;
    sizes.scale_by(std::exp(last_step));
  }
}

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_SIZING_LIMIT_NUMBER_OF_FACES_H
