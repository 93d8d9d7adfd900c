// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_RELOCATE_VERTICES_H
#define CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_RELOCATE_VERTICES_H

#include <CGAL/Hermite_diffuse_remeshing/internal/Transformation/curve_fidelity.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Transformation/is_free.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Transformation/legality.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Transformation/propose_and_accept.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Transformation/select_vertices.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

namespace CGAL {
namespace Hermite_diffuse_remeshing {
namespace internal {

// of the size: moves that cannot be seen are not made, so that the sweeps come to rest
constexpr double least_move = 0.02;
// and where a part of an optimised mesh is adapted again, so that its surroundings, which are not at the middles of their
// neighbours any more, stay where they are
constexpr double least_move_again = 0.06;

// Where the sizes want a vertex of a curve: between its neighbours, in proportion to the sizes
template <typename UserMesh>
Site balanced_site_on_curve(const Working_mesh<UserMesh>& mesh,
                            const typename Working_mesh<UserMesh>::vertex_descriptor v)
{
  const Site& site = mesh.site(v);
  const std::pair<double, double> ends = neighbor_parameters(mesh, v);
  const Reference& reference = mesh.reference();
  const double before = reference.curve_size(site.curve, ends.first) + site.size;
  const double after = reference.curve_size(site.curve, ends.second) + site.size;
  return reference.curve_site(site.curve, ends.first + (ends.second - ends.first) * before / (before + after));
}

// and one of the surface: the centroid of the faces around, each weighted by its area in units of the size
template <typename UserMesh>
Site balanced_site_on_surface(const Working_mesh<UserMesh>& mesh,
                              const typename Working_mesh<UserMesh>::vertex_descriptor v, const double shortest_move)
{
  const auto& tm = mesh.tmesh();
  const Site& site = mesh.site(v);
  Vector sum = Vector::Zero();
  double sum_of_weights = 0.;
  for(const auto h : CGAL::halfedges_around_target(v, tm))
  {
    if(mesh.is_border_or_outside(h))
      continue;
    const auto s = source(h, tm), t = target(next(h, tm), tm);
    const Vector p = mesh.point(s) - site.point, q = mesh.point(t) - site.point;
    const double size = (site.size + mesh.size(s) + mesh.size(t)) / 3.;
    const double weight = p.cross(q).norm() / (size * size);
    sum += weight * (p + q) / 3.;
    sum_of_weights += weight;
  }
  if(!(sum_of_weights > 0.))
    return site;
  const Vector move = sum / sum_of_weights;
  if((move - move.dot(site.normal) * site.normal).norm() < shortest_move * site.size)
    return site;                        // the model needs not be asked
  return mesh.reference().surface_site(site.point + move, site.location.face);
}

template <typename UserMesh>
Site balanced_site(const Working_mesh<UserMesh>& mesh,
                   const typename Working_mesh<UserMesh>::vertex_descriptor v, const double shortest_move)
{
  return mesh.data(v).type == CURVE_VERTEX ? balanced_site_on_curve(mesh, v)
                                           : balanced_site_on_surface(mesh, v, shortest_move);
}

// Moves the vertices near which something has changed to the sites that `propose(vertex)` finds, if it does.
template <typename UserMesh, typename Propose>
std::size_t relocate_vertices(Working_mesh<UserMesh>& mesh, const std::size_t since, const Propose& propose)
{
  typedef typename Working_mesh<UserMesh>::vertex_descriptor vertex_descriptor;
  const std::size_t before = mesh.counts().relocations;
  propose_and_accept_in_waves(mesh, movable_vertices(mesh, since), propose,
                              [&](const vertex_descriptor v, const std::optional<Site>& site)
  {
    if(site && is_relocation_free(mesh, v, *site))
      mesh.relocate(v, *site);
  });
  return mesh.counts().relocations - before;
}

// Moves shorter than `shortest_move`, in units of the size, are not made.
template <typename UserMesh>
std::size_t balance_vertices(Working_mesh<UserMesh>& mesh, const std::size_t since, const double shortest_move)
{
  typedef typename Working_mesh<UserMesh>::vertex_descriptor vertex_descriptor;
  return relocate_vertices(mesh, since, [&](const vertex_descriptor v) -> std::optional<Site>
  {
    const Site& old_site = mesh.data(v).site;
    const Site site = balanced_site(mesh, v, shortest_move);
    if((site.point - old_site.point).norm() < shortest_move * old_site.size)
      return std::nullopt;
    if(mesh.data(v).type == CURVE_VERTEX && !is_curve_move_faithful(mesh, v, site.parameter))
      return std::nullopt;
    Star star(mesh.reference(), Star::MEAN);
    star.add(mesh, v);
    // the centroid makes good triangles on the whole; a mild loss of the worst is allowed above this
    constexpr double good_score = 0.6;
    if(!is_acceptable(star.worth(site), [&] { return star.worth(old_site); }, good_score))
      return std::nullopt;
    return site;
  });
}

// Moves the vertices that lie on a sketch of the model to where it is evaluated, unless that spoils triangles.
template <typename UserMesh>
std::size_t put_on_model(Working_mesh<UserMesh>& mesh)
{
  typedef typename Working_mesh<UserMesh>::vertex_descriptor vertex_descriptor;
  return relocate_vertices(mesh, 0, [&](const vertex_descriptor v) -> std::optional<Site>
  {
    const Site& old_site = mesh.site(v);
    if(!old_site.is_sketched)
      return std::nullopt;
    const Site site = mesh.reference().surface_site(old_site.location);
    Star star(mesh.reference(), Star::MEAN);
    star.add(mesh, v);
    if(!is_acceptable(star.worth(site), [&] { return star.worth(old_site); }, score_floor))
      return std::nullopt;
    return site;
  });
}

// A search along a line: the values a step away from the best so far are offered to `take(value)`, which tells whether they
// are better. Where neither is, the step is halved, until `is_short(step, best)`.
template <typename IsShort, typename Take>
void search_by_halving(double best, double step, const IsShort& is_short, const Take& take)
{
  while(!is_short(step, best))
  {
    const double center = best;
    for(const double value : {center - step, center + step})
      if(take(value))
        best = value;
    if(best == center)
      step /= 2.;
  }
}

// A site with less badness and no worse triangle on a curve, between two parameters, found from `start` on by steps that
// are halved; `is_allowed(parameter)`.
template <typename IsAllowed>
Site better_site_on_curve(const Reference& reference, const Site& start, const std::pair<double, double>& ends,
                          const Star& star, const IsAllowed& is_allowed)
{
  // Of the mean distance to the ends, and of that to the closer one: a vertex may be as near to one of them as
  // rounding lets it, and would not get away in such steps. Once it has got away they need not be so small any more.
  // In a sharp corner, two sides that differ by the last step cost half of it in quality: a thousandth where the worst
  // triangle is all that counts.
  constexpr double first_step = 0.2;
  const double last_step = star.objective() == Star::WORST ? 0.002 : 0.005;
  const double mean_length = (ends.second - ends.first) / 2.;
  Site best = start;
  Star::Badness least = star.badness(best);
  search_by_halving(start.parameter, first_step * mean_length, [&](const double step, const double s)
  { return !(step > 0. && step >= last_step * (std::min)(s - ends.first, ends.second - s)); },
  [&](const double s)
  {
    if(s <= ends.first || s >= ends.second)
      return false;
    const Site candidate = reference.curve_site(best.curve, s);
    const Star::Badness b = star.badness(candidate);
    if(!(b.sum < (1. - score_margin) * least.sum && b.worst.score >= least.worst.score - score_rounding && is_allowed(s)))
      return false;
    least = b;
    best = candidate;
    return true;
  });
  return best;
}

// what relocation tries for a vertex; still to be compared
template <typename UserMesh>
Site better_site(const Working_mesh<UserMesh>& mesh, const typename Working_mesh<UserMesh>::vertex_descriptor v,
                 const Star& star)
{
  if(mesh.data(v).type != CURVE_VERTEX)
    return star.better_site(mesh.site(v));
  return better_site_on_curve(mesh.reference(), mesh.site(v), neighbor_parameters(mesh, v), star,
                              [&](const double s) { return is_curve_move_faithful(mesh, v, s); });
}

// Moves every vertex near which something has changed to where its triangles are best on the whole and
// the worst is no worse than before, unless all of them have a better score than `good_score`.
template <typename UserMesh>
std::size_t improve_vertices(Working_mesh<UserMesh>& mesh, const std::size_t since, const double good_score)
{
  typedef typename Working_mesh<UserMesh>::vertex_descriptor vertex_descriptor;
  // of the badness: a smaller gain is not worth a move, and the sweeps come to rest
  constexpr double least_gain = 0.02;
  return relocate_vertices(mesh, since, [&](const vertex_descriptor v) -> std::optional<Site>
  {
    Star star(mesh.reference(), Star::MEAN);
    star.add(mesh, v);
    const Site& old_site = mesh.site(v);
    const Star::Badness before_move = star.badness(old_site);
    if(before_move.worst.score > good_score)
      return std::nullopt;
    const Site site = better_site(mesh, v, star);
    if(site.point == old_site.point)
      return std::nullopt;
    const Star::Badness after_move = star.badness(site);
    if(!is_no_worse(after_move.worst, before_move.worst) || after_move.sum >= (1. - least_gain) * before_move.sum)
      return std::nullopt;
    return site;
  });
}

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_RELOCATE_VERTICES_H
