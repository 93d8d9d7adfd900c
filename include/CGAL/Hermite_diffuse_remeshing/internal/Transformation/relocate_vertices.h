// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_RELOCATE_VERTICES_H
#define CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_RELOCATE_VERTICES_H

#include <CGAL/Hermite_diffuse_remeshing/internal/Transformation/legality.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Transformation/select_vertices.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace CGAL {
namespace Hermite_diffuse_remeshing {
namespace internal {

// The two neighbours of a curve vertex along its curve, by their parameters.
template <typename UserMesh>
std::pair<double, double> neighbor_parameters(const Working_mesh<UserMesh>& mesh,
                                              const typename Working_mesh<UserMesh>::vertex_descriptor v)
{
  const int curve = mesh.data(v).site.curve;
  std::pair<double, double> result(mesh.data(v).site.parameter, mesh.data(v).site.parameter);
  for(const auto h : CGAL::halfedges_around_target(v, mesh.tmesh()))
    if(mesh.curve(h) == curve)
    {
      const double s = mesh.parameter(source(h, mesh.tmesh()), curve);
      result.first = (std::min)(result.first, s);
      result.second = (std::max)(result.second, s);
    }
  return result;
}

// Where the sizes want the vertex: on a curve, between its neighbours in proportion to the sizes;
// on the surface, the centroid of the faces around, each weighted by its area in units of the size.
template <typename UserMesh>
Site balanced_site(const Working_mesh<UserMesh>& mesh,
                   const typename Working_mesh<UserMesh>::vertex_descriptor v)
{
  const auto& tm = mesh.tmesh();
  const Site& site = mesh.data(v).site;
  if(mesh.data(v).type == CURVE_VERTEX)
  {
    const std::pair<double, double> ends = neighbor_parameters(mesh, v);
    const Reference& reference = mesh.reference();
    const double size_before = reference.curve_site(site.curve, ends.first).size;
    const double size_after = reference.curve_site(site.curve, ends.second).size;
    const double before = size_before + site.size, after = size_after + site.size;
    return reference.curve_site(site.curve, ends.first + (ends.second - ends.first) * before / (before + after));
  }
  Vector sum = Vector::Zero();
  double sum_of_weights = 0.;
  int hint = -1;
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
    hint = site.location.face;
  }
  return sum_of_weights > 0. ? mesh.reference().surface_site(site.point + sum / sum_of_weights, hint) : site;
}

// One sweep: each vertex goes to its balanced place, or half or a quarter of the way, if the worst
// score around it does not fall below the floor or below what it was.
template <typename UserMesh>
std::size_t balance_vertices(Working_mesh<UserMesh>& mesh, const std::size_t since)
{
  const std::size_t before = mesh.counts().relocations;
  for(const auto v : movable_vertices(mesh, since))
  {
    if(mesh.is_stopped())
      break;
    const Site& old_site = mesh.data(v).site;
    const Site site = balanced_site(mesh, v);
    // moves that cannot be seen are not made: the sweeps come to rest
    constexpr double least_move = 0.02;
    if((site.point - old_site.point).norm() < least_move * old_site.size)
      continue;
    const double score_before = worst_score_around(mesh, v);
    // the centroid makes good triangles on the whole; a mild loss of the worst is allowed above this
    constexpr double good_score = 0.6;
    if(is_score_acceptable(worst_score_around(mesh, v, site.point), score_before, good_score))
      mesh.relocate(v, site);
  }
  return mesh.counts().relocations - before;
}

// Candidate places around a vertex at a distance `step`: on a curve to both sides, on the surface in
// eight directions of the tangent plane, the first towards a neighbour so that the pattern turns
// with the mesh.
template <typename UserMesh, typename Visit>
void visit_pattern(const Working_mesh<UserMesh>& mesh,
                   const typename Working_mesh<UserMesh>::vertex_descriptor v,
                   const double step, const Visit& visit)
{
  const Site& site = mesh.data(v).site;
  const Reference& reference = mesh.reference();
  if(mesh.data(v).type == CURVE_VERTEX)
  {
    const std::pair<double, double> ends = neighbor_parameters(mesh, v);
    for(const double s : {site.parameter - step, site.parameter + step})
      if(s > ends.first && s < ends.second)
        visit(reference.curve_site(site.curve, s));
    return;
  }
  const Vector n = reference.surface.blended_normal(site.location);
  const Node_frame frame(site.point, n, mesh.point(first_neighbor(mesh, v)), 1.);
  constexpr int number_of_directions = 8;
  for(int i = 0; i < number_of_directions; ++i)
  {
    const double angle = 2. * boost::math::constants::pi<double>() * i / number_of_directions;
    visit(reference.surface_site(site.point + step * (std::cos(angle) * frame.x_axis
                                                      + std::sin(angle) * frame.y_axis),
                                 site.location.face));
  }
}

// Pattern search for the place with the best worst score (paper, section 4.5). Only vertices with a
// face below `target_score` are looked at; the worst score around a vertex never falls.
template <typename UserMesh>
std::size_t improve_vertices(Working_mesh<UserMesh>& mesh, const double target_score, const std::size_t since)
{
  const std::size_t before = mesh.counts().relocations;
  for(const auto v : movable_vertices(mesh, since))
  {
    if(mesh.is_stopped())
      break;
    double best_score = worst_score_around(mesh, v);
    if(best_score >= target_score)
      continue;
    // steps relative to the size; the last is small enough to settle near the optimum
    constexpr double first_step = 0.25, last_step = 0.02;
    for(double step = first_step; step >= last_step; )
    {
      Site best;
      bool is_found = false;
      const auto visit = [&](const Site& site)
      {
        const double candidate_score = worst_score_around(mesh, v, site.point);
        if(candidate_score > best_score + score_margin)
        {
          best_score = candidate_score;
          best = site;
          is_found = true;
        }
      };
      visit_pattern(mesh, v, step * mesh.size(v), visit);
      if(is_found)
        mesh.relocate(v, best);
      else
        step /= 2.;
    }
  }
  return mesh.counts().relocations - before;
}

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_RELOCATE_VERTICES_H
