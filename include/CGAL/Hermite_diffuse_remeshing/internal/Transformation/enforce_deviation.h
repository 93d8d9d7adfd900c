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
#include <CGAL/Hermite_diffuse_remeshing/internal/Transformation/Refinement_attempts.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Transformation/Remesher.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Hermite_diffuse_remeshing {
namespace internal {

// Asks the size map for smaller sizes where faces deviate too much, and knows where that is of no use.
template <typename UserMesh>
class Deviation_refiner
{
  typedef Working_mesh<UserMesh> Mesh;
  typedef Face_deviation<typename Mesh::face_descriptor> Entry;

  Mesh& m_mesh;
  Size_map& m_sizes;
  double m_maximum_deviation;
  double m_bound;                       // same, or what the number of faces allows
  double m_limit;                       // above it faces are refined
  Refinement_attempts m_attempts;

  // The adaptation leaves edges up to twice as long as their sizes. A face with a longer one has not followed
  // the size that it has been asked for already, as at a fold of the model, where every split makes slivers or
  // turns faces over. A much smaller size does not help it; it is tried again with nearly the same.
  static constexpr double longest_following_length = 2.2, reminder = 0.97;
  // The length that would do follows from d ~ L^2. Faces that do not resolve the model yet deviate less than
  // that, at most by half the radius where they span it: the length that would do is underestimated by the
  // square root of two at most.
  static constexpr double uncertainty_of_length = 1.5;

public:
  Deviation_refiner(Mesh& mesh, Size_map& sizes, const double maximum_deviation)
    : m_mesh(mesh), m_sizes(sizes), m_maximum_deviation(maximum_deviation), m_bound(maximum_deviation)
    , m_limit(maximum_deviation), m_attempts(model_diameter(mesh.reference().surface.triangles()))
  {}

  // would it take more faces than there may be to meet the bound?
  bool is_out_of_reach() const { return m_bound > m_maximum_deviation; }

  // Tells of all faces that deviate too much, by more than a part of the bound, what keeps them from being refined,
  // DEVIATION_AFTER_STOP if nothing does. Returns the number of those that are to be refined in this round.
  std::size_t begin_round(const double part, std::vector<Entry>& entries)
  {
    for(Entry& entry : entries)
      if(entry.deviation > part * m_maximum_deviation)
      {
        m_mesh.give_up_if_stopped();
        entry.obstacle = lasting_obstacle(entry);
      }
    m_bound = affordable_deviation(entries);
    m_limit = part * m_bound;
    m_attempts.begin_round();
    std::size_t number = 0;
    for(Entry& entry : entries)
      if(is_to_be_refined(entry))
      {
        m_mesh.give_up_if_stopped();
        if(is_hopeless(entry))
          entry.obstacle = DEVIATION_AT_FOLD;
        else
          ++number;
      }
    return number;
  }

  // Where nothing is in the way, asks for the length that would do: a deviation goes with the square of the
  // length. `aim`: the part of the length that just does to ask for.
  void refine(const std::vector<Entry>& entries, const double aim)
  {
    // never changes the size by more than this in one step
    constexpr double largest_step = 0.35;
    std::vector<std::pair<Location, double> > caps;
    const auto& tm = m_mesh.tmesh();
    for(const Entry& entry : entries)
    {
      if(!is_to_be_refined(entry))
        continue;
      const double longest = longest_edge(entry);
      const double factor = longest > longest_following_length * m_sizes(entry.location) ? reminder
        : (std::max)(largest_step, aim * std::sqrt(m_bound / entry.deviation));
      const auto cap_at = [&](const Location& location, const double part)
      { caps.push_back(std::make_pair(location, part * (std::min)(longest, m_sizes(location)))); };
      cap_at(entry.location, factor);
      // At the corners too, halfway: the slope of the sizes would undo a cap in the middle alone, and as much at the
      // corners would refine all faces around them with this one.
      for(const auto h : CGAL::halfedges_around_face(halfedge(entry.face, tm), tm))
        cap_at(m_mesh.data(target(h, tm)).site.location, std::sqrt(factor));
    }
    // the cells that are bisected depend on the order, which must not be that of a type of mesh
    std::sort(caps.begin(), caps.end(), [](const std::pair<Location, double>& a, const std::pair<Location, double>& b)
    {
      return std::tie(a.first.face, a.first.coordinates, a.second)
           < std::tie(b.first.face, b.first.coordinates, b.second);
    });
    for(const std::pair<Location, double>& cap : caps)
      m_sizes.add_cap(cap.first, cap.second);
    m_sizes.refine();
    m_mesh.update_sizes();
  }

private:
  bool is_to_be_refined(const Entry& entry) const
  {
    return entry.deviation > m_limit && entry.obstacle == DEVIATION_AFTER_STOP;
  }

  // The least deviation that all faces can have if there may be no more faces than the mesh may have, or the bound: a face
  // that deviates by d takes d/b of those that deviate by b. With the bound itself, too many faces would be refined for
  // nothing, and only some of them.
  double affordable_deviation(const std::vector<Entry>& entries) const
  {
    std::vector<double> deviations;
    for(const Entry& entry : entries)
      if(entry.deviation > m_maximum_deviation && entry.obstacle == DEVIATION_AFTER_STOP)
        deviations.push_back(entry.deviation);
    std::sort(deviations.begin(), deviations.end(), std::greater<double>());
    // with the k largest refined:
    const double spare = double(m_mesh.maximum_number_of_faces()) - double(m_mesh.number_of_faces());
    double sum = 0.;
    for(std::size_t k = 1; k <= deviations.size(); ++k)
    {
      sum += deviations[k - 1];
      const double number = spare + double(k), least = k < deviations.size() ? deviations[k] : m_maximum_deviation;
      if(number > 0. && sum / number >= least)
        return sum / number;
    }
    return m_maximum_deviation;
  }

  double length_that_does(const Entry& entry, const double longest) const
  {
    return longest * std::sqrt(m_maximum_deviation / entry.deviation);
  }

  double longest_edge(const Entry& entry) const
  {
    double longest = 0.;
    for(const auto h : CGAL::halfedges_around_face(halfedge(entry.face, m_mesh.tmesh()), m_mesh.tmesh()))
      longest = (std::max)(longest, m_mesh.length(h));
    return longest;
  }

  // one that no number of faces helps; DEVIATION_AFTER_STOP if there is none
  Deviation_obstacle lasting_obstacle(const Entry& entry) const
  {
    // The centroid of a face at such an edge is two thirds as far away, however small the face is; and the sizes
    // around start from the length of the edge.
    if(entry.is_on_protected_edge || m_sizes.is_cap_exceeded(entry.location))
      return DEVIATION_AT_PROTECTED_EDGE;
    const double longest = longest_edge(entry), size = m_sizes(entry.location);
    const double sufficient_length = uncertainty_of_length * length_that_does(entry, longest);
    if((std::min)({sufficient_length, reminder * longest, reminder * size}) <= m_sizes.minimum_length())
      return DEVIATION_AT_SMALLEST_SIZE;
    return DEVIATION_AFTER_STOP;
  }

  bool is_hopeless(const Entry& entry)
  {
    const auto& tm = m_mesh.tmesh();
    std::array<int, 4> reference_faces = {{entry.location.face}};
    auto h = halfedge(entry.face, tm);
    for(int k = 1; k < 4; ++k, h = next(h, tm))
      reference_faces[k] = m_mesh.data(target(h, tm)).site.location.face;
    return m_attempts.is_hopeless(reference_faces, entry.point, longest_edge(entry), entry.deviation, m_bound);
  }
};

// Lowers sizes where faces deviate too much, and adapts and measures again what that changes, until no face
// deviates too much, or until none of those that do can be helped. Where the number of faces that there may be does not
// allow that, they are used to make the largest deviation as small as they can. Throws Interrupted on request.
template <typename UserMesh>
Deviations<UserMesh> enforce_deviation(Working_mesh<UserMesh>& mesh, Size_map& sizes, Remesher<UserMesh>& remesher,
                                       const double maximum_deviation, std::size_t& number_of_rounds)
{
  constexpr std::size_t maximum_number_of_rounds = 20;
  // While faces are to be refined their shapes do not matter yet, and one pass of the adaptation does. Few rounds in
  // a row are enough for deviations that go with the square of the length; then what has changed settles.
  constexpr std::size_t maximum_number_of_coarse_rounds = 4, maximum_number_of_settlements = 8;
  // The first time with the tight bands of lengths in which irregular vertices disappear, later only with a wide one:
  // what is left is few faces, and each pass moves others above the bound.
  constexpr int number_of_passes = 5, tight_band = 1, wide_band = 6;
  // A fold cannot be helped by raising the scores of well-shaped triangles there.
  constexpr double satisfying_quality = 0.6;
  // Edges may be longer than their size by the band in which they are left alone, the square root of two.
  // At first most of the faces that deviate too much are such accidents, and the next ones will not be;
  // then the few that are left are to do even so.
  constexpr std::size_t number_of_first_rounds = 2;
  constexpr double first_aim = 0.8, last_aim = 0.8 / 1.4142135623730951;
  // Vertices move when shapes settle: faces that are that close to the bound before are refined too.
  constexpr double first_limit = 0.96, last_limit = 1.;
  Deviation_meter<UserMesh> meter(mesh, first_limit * maximum_deviation);
  Deviation_refiner<UserMesh> refiner(mesh, sizes, maximum_deviation);
  meter.measure();
  std::size_t since_finished = mesh.number_of_changes();
  std::size_t coarse_rounds = 0, settlements = 0;
  for(bool is_finished = true; ; ++number_of_rounds)
  {
    const std::size_t number = refiner.begin_round(settlements == 0 ? first_limit : last_limit, meter.deviations().faces);
    const bool is_last = number == 0 || mesh.is_full() || number_of_rounds + 1 >= maximum_number_of_rounds
                      || settlements >= maximum_number_of_settlements;
    mesh.give_up_if_stopped();
    meter.deviations().is_bound_out_of_reach = refiner.is_out_of_reach();
    if(is_last && is_finished)
      break;
    const std::size_t since = mesh.number_of_changes();
    if(!is_last)
      refiner.refine(meter.deviations().faces, number_of_rounds < number_of_first_rounds ? first_aim : last_aim);
    const bool is_settling = is_last || coarse_rounds >= maximum_number_of_coarse_rounds;
    if(is_settling && settlements == 0)
      remesher.adapt_again(since_finished, number_of_passes, tight_band);
    else
      remesher.adapt_again(since, 1, settlements == 0 ? tight_band : wide_band);
    ++coarse_rounds;
    if(is_settling)
    {
      remesher.optimise(CONVERGED, since_finished);
      if(is_last)
        remesher.raise_worst(CONVERGED, satisfying_quality);
      since_finished = mesh.number_of_changes();
      coarse_rounds = 0;
      ++settlements;
    }
    is_finished = is_last;
    meter.update(since);
  }
  return std::move(meter.deviations());
}

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_ENFORCE_DEVIATION_H
