// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_ADAPTATION_PASSES_H
#define CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_ADAPTATION_PASSES_H

#include <CGAL/Hermite_diffuse_remeshing/Remeshing_report.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Transformation/Length_band.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Transformation/collapse_short_edges.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Transformation/flip_edges.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Transformation/mesh_statistics.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Transformation/relocate_vertices.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Transformation/split_long_edges.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Transformation/split_slivers.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>

namespace CGAL {
namespace Hermite_diffuse_remeshing {
namespace internal {

// One pass of the paper's loop after the other: split, collapse, swap, relocate. Operators look only at what has
// changed since they ran last.
template <typename UserMesh>
class Adaptation_passes
{
protected:
  // of the faces: fewer changes than this in a pass are the last ripples of the swaps
  static constexpr double negligible_part = 5e-4;
  // and in a small mesh this number: a few edges may be split and collapsed in turn
  static constexpr double negligible_number = 4.;
  // and in a mesh that has been refined from a coarser one, which is regular
  static constexpr double negligible_part_of_refined = 2e-3;
  // In such a mesh vertices need not go to the middle of their neighbours again and again, which on a rough surface
  // does not come to rest: the optimisation has better places.
  static constexpr int number_of_balancing_passes_of_refined = 2;
  // of the faces: where fewer changes are made in a pass, faces are still near where they were at its beginning
  static constexpr double considerable_part = 0.1;
  // of the faces that have changed, where only a part of the mesh is adapted again
  static constexpr double negligible_part_of_changed = 0.01;

  Working_mesh<UserMesh>& m_mesh;
  int m_number_of_iterations = 0;
  // changes of the mesh when an operator last began
  std::size_t m_flipped_at = 0, m_balanced_at = 0, m_improved_at = 0, m_hinted_at = 0, m_hunted_at = 0;

  // of the stage: what is done, and the part that is being done
  double m_progress = 0., m_part_of_progress = 1.;

  explicit Adaptation_passes(Working_mesh<UserMesh>& mesh) : m_mesh(mesh) {}

  // `since_change`: all changes that count
  Stop_reason run_passes(const int first_iteration, const int number_of_iterations, const std::size_t since_change)
  {
    const bool is_refined = first_iteration == Length_band::first_wide_pass && since_change == 0;
    Stop_reason reason = ITERATION_BOUND;
    for(int i = first_iteration; i - first_iteration < number_of_iterations && reason == ITERATION_BOUND; ++i)
    {
      ++m_number_of_iterations;
      const double longest = Length_band::longest(i), shortest = Length_band::shortest(i);
      const double slack = Length_band::slack_of_sagitta(i);
      std::size_t changes = i == 0 ? split_slivers(m_mesh, longest, slack) : 0;
      changes += split_long_edges(m_mesh, longest, since_change, slack);
      changes += collapse_short_edges(m_mesh, shortest, longest, since_change);
      changes += since_last(m_flipped_at, [&](const std::size_t since) { return flip_edges_by_valence(m_mesh, since); });
      if(!is_refined || i - first_iteration < number_of_balancing_passes_of_refined)
        since_last(m_balanced_at, [&](const std::size_t since)
                   { return balance_vertices(m_mesh, since, since_change > 0 ? least_move_again : least_move); });
      if(changes > considerable_part * m_mesh.number_of_faces())
        update_hints();
      report_progress(double(i + 1 - first_iteration) / number_of_iterations);
      // a mesh that is full at first may have room after the collapses
      if(i > 0 && is_negligible(changes, is_refined ? negligible_part_of_refined : negligible_part, since_change))
        reason = CONVERGED;
      if(m_mesh.is_stopped())
        reason = STOPPED_BY_VISITOR;
    }
    update_hints();
    return reason != STOPPED_BY_VISITOR && m_mesh.is_full() ? FACE_BUDGET : reason;
  }

  void report_progress(const double fraction) { m_mesh.report_progress(m_progress + m_part_of_progress * fraction); }

  // the next part of the stage, of what is left to do
  void begin_part(const double part)
  {
    m_progress += m_part_of_progress;
    m_part_of_progress = part * (1. - m_progress);
  }

  // runs an operator on what has changed since it ran last
  template <typename Operator>
  std::size_t since_last(std::size_t& last, const Operator& run)
  {
    const std::size_t since = last;
    last = m_mesh.number_of_changes();
    return run(since);
  }

  // since > 0: where only what has changed since then is adapted
  bool is_negligible(const std::size_t changes, const double part, const std::size_t since) const
  {
    return changes <= (std::max)(negligible_number, part * double(m_mesh.number_of_faces()))
        || (since > 0 && changes <= negligible_part_of_changed * number_of_changed_faces(m_mesh, since));
  }

  void update_hints()
  {
    CGAL_assertion(m_mesh.is_followed());
    since_last(m_hinted_at, [&](const std::size_t since) { m_mesh.update_hints(since); return 0; });
  }
};

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_ADAPTATION_PASSES_H
