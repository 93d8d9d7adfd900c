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
#include <CGAL/Hermite_diffuse_remeshing/internal/Transformation/Face_grid.h>

#include <algorithm>
#include <tuple>
#include <vector>

namespace CGAL {
namespace Hermite_diffuse_remeshing {
namespace internal {

// Remembers where faces that deviate too much have been refined, to tell where that does not help. Faces come
// and go; what stays is the place on the reference.
class Refinement_attempts
{
  struct Attempt
  {
    int reference_face;                 // the first of those at the place
    Vector point;
    double reach;                       // of the face there: its longest edge
    double deviation;                   // the smallest one there so far
    int number_of_failures;
    int round;
  };

  // A deviation falls with the square of the length, and a step lowers the length visibly: a gain smaller than
  // this is no more than another face in the same place.
  static constexpr double clearly_lower = 0.9;
  // Which triangles come of a refinement is partly a matter of luck, and one that has nearly done needs little of it.
  static constexpr int patience = 3, patience_near_the_bound = 8;
  static constexpr double near_the_bound = 1.25;

  std::vector<Attempt> m_attempts;
  // Of their numbers, by the box of what they reach: over a large face of the reference there may be as many as the
  // mesh has faces.
  Face_grid<int> m_grid;
  int m_round = 0;

public:
  // `extent`: of the largest face that will be
  explicit Refinement_attempts(const double extent) : m_grid(extent) {}

  // Has refining at this place failed so often? Has to be asked about every face that deviates by more than `bound`.
  // `reference_faces`: those at the place, where it was measured first.
  template <typename Integers>
  bool is_hopeless(const Integers& reference_faces, const Vector& point, const double reach, const double deviation,
                   const double bound)
  {
    Attempt current{reference_faces.front(), point, reach, deviation, 0, m_round};
    if(const Attempt* const before = nearest(reference_faces, point))
    {
      const bool is_progress = deviation < clearly_lower * before->deviation;
      current.deviation = (std::min)(deviation, before->deviation);
      current.number_of_failures = before->number_of_failures + !is_progress;
    }
    m_grid.insert(static_cast<int>(m_attempts.size()), Bounding_box(point, point).enlarged(reach));
    m_attempts.push_back(current);
    return current.number_of_failures >= (deviation <= near_the_bound * bound ? patience_near_the_bound : patience);
  }

  void begin_round() { ++m_round; }

private:
  // the latest of the earlier attempts that are nearest to a point; null if there is none
  template <typename Integers>
  const Attempt* nearest(const Integers& reference_faces, const Vector& point) const
  {
    const Attempt* result = nullptr;
    const auto rank = [&](const Attempt& attempt)
    { return std::make_tuple((attempt.point - point).norm(), -attempt.round, attempt.deviation,
                             attempt.number_of_failures); };
    m_grid.visit_near(Bounding_box(point, point), [&](const int number, const Bounding_box&)
    {
      const Attempt& attempt = m_attempts[number];
      if(attempt.round < m_round && (attempt.point - point).norm() <= attempt.reach
         && std::find(reference_faces.begin(), reference_faces.end(), attempt.reference_face) != reference_faces.end()
         && (result == nullptr || rank(attempt) < rank(*result)))
        result = &attempt;
      return true;
    });
    return result;
  }
};

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_REFINEMENT_ATTEMPTS_H
