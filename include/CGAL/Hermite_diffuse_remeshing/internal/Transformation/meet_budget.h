// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_MEET_BUDGET_H
#define CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_MEET_BUDGET_H

#include <CGAL/Hermite_diffuse_remeshing/Remeshing_report.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Sizing/limit_number_of_faces.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Transformation/Length_band.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Transformation/Remesher.h>

#include <limits>

namespace CGAL {
namespace Hermite_diffuse_remeshing {
namespace internal {

// Features, and edges that cannot be collapsed, may make more faces than what the sizes predict. These grow then, until
// the budget is met or there is nothing left to collapse. To be called after the hunt for the worst faces: what only that
// gets rid of, as needles, does not count. `reason`: why the remeshing has ended so far; returned if nothing is to be done.
template <typename UserMesh>
Stop_reason meet_budget(Working_mesh<UserMesh>& mesh, Remesher<UserMesh>& remesher, Stop_reason reason)
{
  constexpr int maximum_number_of_rounds = 10, maximum_number_of_rounds_in_vain = 2;
  constexpr double aim = 0.97;              // of the budget: a little too far does no harm
  constexpr double longest_step = 0.7;      // the sizes are doubled
  // of the faces: after less, corners and what they keep are all that is left
  constexpr double least_decrease = 0.01;
  const double budget = double(mesh.maximum_number_of_faces());
  Scale_search search(aim * budget, longest_step);
  int rounds_in_vain = 0;
  for(int round = 0; round < maximum_number_of_rounds && reason != STOPPED_BY_VISITOR; ++round)
  {
    const double number = double(mesh.number_of_faces());
    rounds_in_vain = number < (1. - least_decrease) * search.last_number() ? 0 : rounds_in_vain + 1;
    if(number <= budget || rounds_in_vain == maximum_number_of_rounds_in_vain)
      break;
    mesh.reference().sizes.scale_by(search.next_factor(number));
    mesh.update_sizes();
    reason = remesher.adapt_again(0, (std::numeric_limits<int>::max)(), Length_band::first_tight_pass);
    reason = remesher.raise_worst(remesher.optimise(reason));
  }
  return reason;
}

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_MEET_BUDGET_H
