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
#include <CGAL/Hermite_diffuse_remeshing/internal/Transformation/Adaptation_passes.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Transformation/Length_band.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Transformation/coarse_levels.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Transformation/flip_edges.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Transformation/mesh_statistics.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Transformation/raise_worst_faces.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Transformation/relocate_vertices.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Transformation/split_long_edges.h>

#include <algorithm>
#include <cstddef>

namespace CGAL {
namespace Hermite_diffuse_remeshing {
namespace internal {

// The loop of the paper's section 4: split, collapse, swap, relocate, with the factor 2 first and
// tighter bands then, until a pass has nothing left to do.
template <typename UserMesh>
class Remesher : private Adaptation_passes<UserMesh>
{
  typedef Adaptation_passes<UserMesh> Base;
  using Base::m_mesh;
  using Base::m_number_of_iterations;
  using Base::m_flipped_at;
  using Base::m_balanced_at;
  using Base::m_improved_at;
  using Base::m_progress;
  using Base::m_part_of_progress;
  using Base::run_passes;
  using Base::since_last;

  int m_maximum_number_of_iterations;

  // triangles with a better score are not worth a search
  static constexpr double satisfying_score = 0.6;
  static constexpr int maximum_number_of_optimisation_passes = 20;

public:
  Remesher(Working_mesh<UserMesh>& mesh, const int maximum_number_of_iterations)
    : Base(mesh), m_maximum_number_of_iterations(maximum_number_of_iterations)
  {}

  int number_of_iterations() const { return m_number_of_iterations; }

  // sizes: every edge into its band. After a stop they may be those of a coarser level.
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
    // In a whole mesh a search where all triangles around are as good takes as long as elsewhere, and gains less than a
    // hundredth; after the coarser levels most are. While a part settles that has been refined for the deviation every
    // move counts.
    const double good_score = since_change == 0 ? 0.9 : 1.;
    for(int i = 0; i < maximum_number_of_optimisation_passes; ++i)
    {
      std::size_t changes =
        since_last(m_flipped_at, [&](const std::size_t since) { return flip_edges_by_score(m_mesh, since); });
      changes += since_last(m_improved_at, [&](const std::size_t since)
                            { return improve_vertices(m_mesh, since, good_score); });
      Base::report_progress(double(i + 1) / maximum_number_of_optimisation_passes);
      if(m_mesh.is_stopped() || Base::is_negligible(changes, Base::negligible_part, since_change))
        break;
    }
    return m_mesh.is_stopped() ? STOPPED_BY_VISITOR : reason;
  }

  // The worst triangles one by one. Those with a quality above `satisfying_quality` are left alone even if the
  // model is turned against them.
  Stop_reason raise_worst(const Stop_reason reason, const double satisfying_quality = 1.)
  {
    Worst_face_hunt<UserMesh>(m_mesh, satisfying_score, satisfying_quality).run(Base::m_hunted_at);
    // it has come back to what it has changed itself
    Base::m_hunted_at = m_mesh.number_of_changes();
    Base::update_hints();
    return m_mesh.is_stopped() ? STOPPED_BY_VISITOR : reason;
  }

private:
  // A mesh with large sizes costs little, and the edges that halve its own make good triangles of good ones: what is
  // left to do at every finer level is to move vertices a little.
  Stop_reason adapt_from_coarse_to_fine()
  {
    // of the time that is left: finer levels take four times as long
    constexpr double part_of_level = 0.2;
    int level = coarsest_level(m_mesh);
    if(level > 0)
      set_level(m_mesh, level);
    make_room_for_level(m_mesh);
    m_progress = m_part_of_progress = 0.;
    Base::begin_part(level > 0 ? part_of_level : 1.);
    Stop_reason reason = run_passes(0, m_maximum_number_of_iterations, 0);
    while(level > 0 && reason != STOPPED_BY_VISITOR)
    {
      Base::begin_part(part_of_level);
      optimise(reason);
      Base::begin_part(level > 1 ? part_of_level : 1.);
      m_number_of_iterations = 0;
      set_level(m_mesh, --level);
      if(level == 0)
        put_on_model(m_mesh);
      make_room_for_level(m_mesh);
      // nearly all are split; new vertices have to be near in memory if they are in space
      split_long_edges_once(m_mesh, Length_band::longest_before_refinement(), 0, BY_NUMBER);
      // of the four parts of a triangle three meet at a middle that the last split has not joined
      since_last(m_flipped_at, [&](const std::size_t since) { return flip_edges_by_valence(m_mesh, since); });
      const int first_pass = has_regular_sizes(m_mesh) ? Length_band::first_wide_pass : Length_band::first_tight_pass;
      reason = run_passes(first_pass, m_maximum_number_of_iterations, 0);
    }
    m_progress = 0.;
    m_part_of_progress = 1.;
    return reason;
  }
};

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_REMESHER_H
