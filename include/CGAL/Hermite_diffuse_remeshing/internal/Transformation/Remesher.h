// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_REMESHER_H
#define CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_REMESHER_H

#include <CGAL/Hermite_diffuse_remeshing/Remeshing_report.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Transformation/Length_band.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Transformation/coarse_levels.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Transformation/collapse_short_edges.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Transformation/flip_edges.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Transformation/mesh_statistics.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Transformation/raise_worst_faces.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Transformation/relocate_vertices.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Transformation/split_long_edges.h>

#include <algorithm>

namespace CGAL {
namespace Hermite_diffuse_remeshing {
namespace internal {

// The loop of the paper's section 4: split, collapse, swap, relocate, with the factor 2 first and
// tighter bands then, until a pass has nothing left to do.
template <typename UserMesh>
class Remesher
{
  Working_mesh<UserMesh>& m_mesh;
  int m_maximum_number_of_iterations;
  int m_number_of_iterations = 0;
  // changes of the mesh when an operator last began
  std::size_t m_flipped_at = 0, m_balanced_at = 0, m_improved_at = 0, m_hinted_at = 0, m_hunted_at = 0;

  // of the faces: fewer changes than this in a pass are the last ripples of the swaps
  static constexpr double negligible_part = 5e-4;
  // of the faces: where fewer changes are made in a pass, faces are still near where they were at its beginning
  static constexpr double considerable_part = 0.02;
  // of the faces that have changed, where only a part of the mesh is adapted again
  static constexpr double negligible_part_of_changed = 0.01;
  // triangles with a better score are not worth a search
  static constexpr double satisfying_score = 0.6;
  static constexpr int maximum_number_of_optimisation_passes = 20;

public:
  Remesher(Working_mesh<UserMesh>& mesh, const int maximum_number_of_iterations)
    : m_mesh(mesh), m_maximum_number_of_iterations(maximum_number_of_iterations)
  {}

  int number_of_iterations() const { return m_number_of_iterations; }

  // sizes: every edge into its band
  Stop_reason adapt()
  {
    if(!is_adapted(m_mesh))
      return adapt_from_coarse_to_fine();
    // only edges that are far off are treated, and what changes around them
    m_flipped_at = m_balanced_at = m_improved_at = m_mesh.number_of_changes();
    return run_passes(Length_band::first_mending_pass, m_maximum_number_of_iterations, 0);
  }

  // same, where sizes or faces have changed since; the rest is left alone. `first_pass` tells the band to begin with.
  Stop_reason adapt_again(const std::size_t since, const int maximum_number_of_passes, const int first_pass)
  {
    m_flipped_at = m_balanced_at = since;
    return run_passes(first_pass, (std::min)(m_maximum_number_of_iterations, maximum_number_of_passes), since);
  }

  // Shapes: sizes come second, and the worst score that an operation touches never falls.
  Stop_reason optimise(const Stop_reason reason, const std::size_t since_change = 0)
  {
    for(int i = 0; i < maximum_number_of_optimisation_passes; ++i)
    {
      std::size_t changes =
        since_last(m_flipped_at, [&](const std::size_t since) { return flip_edges_by_score(m_mesh, since); });
      changes += since_last(m_improved_at, [&](const std::size_t since) { return improve_vertices(m_mesh, since); });
      m_mesh.report_progress(double(i + 1) / maximum_number_of_optimisation_passes);
      if(m_mesh.is_stopped() || is_negligible(changes, since_change))
        break;
    }
    return m_mesh.is_stopped() ? STOPPED_BY_VISITOR : reason;
  }

  // The worst triangles one by one. Those with a quality above `satisfying_quality` are left alone even if the
  // model is turned against them.
  Stop_reason raise_worst(const Stop_reason reason, const double satisfying_quality = 1.)
  {
    since_last(m_hunted_at, [&](const std::size_t since)
               { return Worst_face_hunt<UserMesh>(m_mesh, satisfying_score, satisfying_quality).run(since); });
    update_hints();
    return m_mesh.is_stopped() ? STOPPED_BY_VISITOR : reason;
  }

private:
  // A mesh with large sizes costs little, and the edges that halve its own make good triangles of good ones: what is
  // left to do at every finer level is to move vertices a little.
  Stop_reason adapt_from_coarse_to_fine()
  {
    int level = coarsest_level(m_mesh);
    set_level(m_mesh, level);
    Stop_reason reason = run_passes(0, m_maximum_number_of_iterations, 0);
    while(level > 0 && reason != STOPPED_BY_VISITOR)
    {
      optimise(reason);
      m_number_of_iterations = 0;
      set_level(m_mesh, --level);
      split_long_edges_once(m_mesh, Length_band::longest_before_refinement(), 0);
      // of the four parts of a triangle three meet at a middle that the last split has not joined
      since_last(m_flipped_at, [&](const std::size_t since) { return flip_edges_by_valence(m_mesh, since); });
      reason = run_passes(Length_band::first_pass_after_refinement, m_maximum_number_of_iterations, 0);
    }
    set_level(m_mesh, 0);
    return reason;
  }

  Stop_reason run_passes(const int first_iteration, const int number_of_iterations, const std::size_t since_change)
  {
    Stop_reason reason = ITERATION_BOUND;
    for(int i = first_iteration; i < first_iteration + number_of_iterations && reason == ITERATION_BOUND; ++i)
    {
      ++m_number_of_iterations;
      const double longest = Length_band::longest(i), shortest = Length_band::shortest(i);
      std::size_t changes = split_long_edges(m_mesh, longest, since_change);
      changes += collapse_short_edges(m_mesh, shortest, longest, since_change);
      changes += since_last(m_flipped_at, [&](const std::size_t since) { return flip_edges_by_valence(m_mesh, since); });
      since_last(m_balanced_at, [&](const std::size_t since) { return balance_vertices(m_mesh, since); });
      if(changes > considerable_part * m_mesh.number_of_faces())
        update_hints();
      m_mesh.report_progress(double(i + 1 - first_iteration) / number_of_iterations);
      // a mesh that is full at first may have room after the collapses
      if(i > 0 && is_negligible(changes, since_change))
        reason = CONVERGED;
      if(m_mesh.is_stopped())
        reason = STOPPED_BY_VISITOR;
    }
    update_hints();
    return reason != STOPPED_BY_VISITOR && m_mesh.is_full() ? FACE_BUDGET : reason;
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
  bool is_negligible(const std::size_t changes, const std::size_t since) const
  {
    return changes <= negligible_part * m_mesh.number_of_faces()
        || (since > 0 && changes <= negligible_part_of_changed * number_of_changed_faces(m_mesh, since));
  }

  void update_hints()
  {
    since_last(m_hinted_at, [&](const std::size_t since) { m_mesh.update_hints(since); return 0; });
  }
};

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_REMESHER_H
