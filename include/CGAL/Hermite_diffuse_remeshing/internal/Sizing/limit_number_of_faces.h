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

// By what to scale sizes up until a number of faces falls to a limit. It falls with the square of the scale or, where the
// gradation, features or frozen edges rule, more slowly. Over the logarithm of the scale the number that sizes predict is
// convex on all meshes seen: steps along its last secant do not lead below the limit then.
class Scale_search
{
  double m_limit, m_longest_step;       // of the logarithm, where the number hardly falls
  double m_last_step = 0., m_last_number = (std::numeric_limits<double>::infinity)();

public:
  Scale_search(const double limit, const double longest_step) : m_limit(limit), m_longest_step(longest_step) {}

  // that it has been asked about; infinite at first
  double last_number() const { return m_last_number; }

  // `number`: with the sizes scaled by the factors before
  double next_factor(const double number)
  {
    const double along_secant = m_last_step * (number - m_limit) / (m_last_number - number);
    m_last_step = (std::max)(std::log(number / m_limit) / 2.,
                             number < m_last_number ? (std::min)(along_secant, m_longest_step) : m_longest_step);
    m_last_number = number;
    return std::exp(m_last_step);
  }
};

// Scales the sizes up until the number of faces that `is_selected(face of the reference)` takes is at most `limit`.
template <typename IsSelected>
void limit_number_of_faces(Size_map& sizes, const double limit, const IsSelected& is_selected, const Progress& progress)
{
  constexpr double tolerance = 0.002;   // a number of faces that is this close is met
  constexpr int maximum_number_of_steps = 100;
  // a smaller one, relative to the number, is rounding: the lengths of frozen edges rule
  constexpr double least_decrease = 1e-6;
  constexpr double longest_step = 3.;
  Scale_search search(limit, longest_step);
  for(int step = 0; step < maximum_number_of_steps; ++step, progress(0.))
  {
    const double number = sizes.number_of_faces(is_selected);
    if(!(number > (1. + tolerance) * limit) || !(number < (1. - least_decrease) * search.last_number()))
      return;
    sizes.scale_by(search.next_factor(number));
  }
}

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_SIZING_LIMIT_NUMBER_OF_FACES_H
