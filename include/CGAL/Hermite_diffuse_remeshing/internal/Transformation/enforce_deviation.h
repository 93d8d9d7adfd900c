// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_ENFORCE_DEVIATION_H
#define CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_ENFORCE_DEVIATION_H

#include <CGAL/Hermite_diffuse_remeshing/internal/Transformation/Deviation_meter.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Transformation/Remesher.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Hermite_diffuse_remeshing {
namespace internal {

// Where a face deviates too much, asks the size map for the length that would do: a deviation goes
// with the square of the length. `aim`: the part of the length that just does to ask for. Returns whether a
// smaller size could be asked for anywhere.
template <typename UserMesh>
bool refine_sizes(Working_mesh<UserMesh>& mesh, Size_map& sizes, const Deviations<UserMesh>& deviations,
                  const double maximum_deviation, const double aim)
{
  // never changes the size by more than this in one step
  constexpr double largest_step = 0.35;
  // The adaptation leaves edges up to twice as long as their sizes. A face with a longer one has not followed
  // the size that it has been asked for already: a protected edge, or a fold of the model, where
  // every split makes slivers or turns faces over. A smaller size does not help it.
  constexpr double longest_following_length = 2.2;
  // a cap must lower the size by a visible amount to be worth another pass
  constexpr double least_gain = 0.98;
  std::vector<std::pair<Location, double> > caps;
  const auto& tm = mesh.tmesh();
  for(const auto& entry : deviations.faces)
  {
    if(entry.deviation <= maximum_deviation)
      continue;
    mesh.give_up_if_stopped();
    double longest = 0.;
    for(const auto h : CGAL::halfedges_around_face(halfedge(entry.face, tm), tm))
      longest = (std::max)(longest, mesh.length(h));
    if(longest > longest_following_length * sizes(entry.location))
      continue;
    const double factor = (std::max)(largest_step, aim * std::sqrt(maximum_deviation / entry.deviation));
    // at the corners too: the slope of the sizes would undo a cap in the middle alone
    const auto cap_at = [&](const Location& location)
    {
      const double before = sizes(location);
      const double cap = (std::max)(factor * (std::min)(longest, before), sizes.minimum_length());
      if(cap >= least_gain * before)
        return;
      caps.push_back(std::make_pair(location, cap));
    };
    cap_at(entry.location);
    for(const auto h : CGAL::halfedges_around_face(halfedge(entry.face, tm), tm))
      cap_at(mesh.data(target(h, tm)).site.location);
  }
  for(const std::pair<Location, double>& cap : caps)
    sizes.add_cap(cap.first, cap.second);
  if(!caps.empty())
  {
    sizes.refine();
    mesh.update_sizes();
  }
  return !caps.empty();
}

// Lowers sizes where faces deviate too much, and adapts and measures again what that changes, until no face
// deviates too much, or until it does not help: the number of the faces that do must fall to a clearly lower
// one at least every third time. Where it does not, the bound cannot be met (protected edges, the
// smallest size), and finer faces would only be more faces.
template <typename UserMesh>
Deviations<UserMesh> enforce_deviation(Working_mesh<UserMesh>& mesh, Size_map& sizes, Remesher<UserMesh>& remesher,
                                       const double maximum_deviation, Stop_reason& stop_reason,
                                       std::size_t& number_of_rounds)
{
  constexpr int maximum_number_of_rounds = 20, patience = 3;
  constexpr double clearly_lower = 0.9;
  // Edges may be longer than their size by the band in which they are left alone, the square root of two.
  // At first most of the faces that deviate too much are such accidents, and the next ones will not be;
  // then the few that are left are to do even so.
  constexpr int number_of_first_rounds = 2;
  constexpr double first_aim = 0.8, last_aim = 0.8 / 1.4142135623730951;
  Deviation_meter<UserMesh> meter(mesh, maximum_deviation);
  meter.measure();
  std::size_t fewest = (std::numeric_limits<std::size_t>::max)();
  int rounds_without_gain = 0;
  for(int round = 0; round < maximum_number_of_rounds; ++round)
  {
    const Deviations<UserMesh>& deviations = meter.deviations();
    const std::size_t number = std::count_if(deviations.faces.begin(), deviations.faces.end(),
                                             [&](const auto& entry) { return entry.deviation > maximum_deviation; });
    const bool is_gain = double(number) < clearly_lower * double(fewest);
    rounds_without_gain = is_gain ? 0 : rounds_without_gain + 1;
    if(is_gain)
      fewest = number;
    const std::size_t since = mesh.number_of_changes();
    if(number == 0 || rounds_without_gain == patience || mesh.is_stopped() || mesh.is_full()
       || !refine_sizes(mesh, sizes, deviations, maximum_deviation,
                        round < number_of_first_rounds ? first_aim : last_aim))
      break;
    stop_reason = remesher.optimise(remesher.adapt_again(since), since);
    meter.update(since);
    ++number_of_rounds;
  }
  if(number_of_rounds > 0)
    meter.measure();
  return meter.deviations();
}

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_ENFORCE_DEVIATION_H
