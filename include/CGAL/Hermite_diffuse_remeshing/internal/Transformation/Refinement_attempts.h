// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_REFINEMENT_ATTEMPTS_H
#define CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_REFINEMENT_ATTEMPTS_H

#include <CGAL/Hermite_diffuse_remeshing/internal/Indexed_triangles.h>

#include <algorithm>
#include <map>
#include <utility>

namespace CGAL {
namespace Hermite_diffuse_remeshing {
namespace internal {

// Remembers where faces that deviate too much have been refined, to tell where that does not help. Faces come
// and go; what stays is the place on the reference.
class Refinement_attempts
{
  struct Attempt
  {
    Vector point;
    double reach;                       // of the face there: its longest edge
    double deviation;
    int number_of_failures;
  };

  // A deviation falls with the square of the length, and a step lowers the length visibly: a gain smaller than
  // this is no more than another face in the same place.
  static constexpr double clearly_lower = 0.9;
  static constexpr int patience = 3;

  std::multimap<int, Attempt> m_last, m_current;      // by the face of the reference

public:
  // Has refining at this place failed `patience` times in a row? Has to be asked about every face that
  // deviates too much. `reference_faces`: those at the place, where it was measured first.
  template <typename Integers>
  bool is_hopeless(const Integers& reference_faces, const Vector& point, const double reach, const double deviation)
  {
    double before = 0.;
    int number_of_failures = 0;
    for(const int f : reference_faces)
    {
      const auto range = m_last.equal_range(f);
      for(auto it = range.first; it != range.second; ++it)
        if((it->second.point - point).norm() <= it->second.reach)
        {
          before = (std::max)(before, it->second.deviation);
          number_of_failures = (std::max)(number_of_failures, it->second.number_of_failures + 1);
        }
    }
    const bool is_progress = deviation < clearly_lower * before || number_of_failures == 0;
    m_current.insert(std::make_pair(reference_faces.front(),
                                    is_progress ? Attempt{point, reach, deviation, 0}
                                                : Attempt{point, reach, before, number_of_failures}));
    return !is_progress && number_of_failures >= patience;
  }

  void begin_round()
  {
    m_last.swap(m_current);
    m_current.clear();
  }
};

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_REFINEMENT_ATTEMPTS_H
