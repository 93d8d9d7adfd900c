// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_MESH_STATISTICS_H
#define CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_MESH_STATISTICS_H

#include <CGAL/Hermite_diffuse_remeshing/internal/Transformation/Working_mesh.h>

#include <boost/range/irange.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace CGAL {
namespace Hermite_diffuse_remeshing {
namespace internal {

struct Quality_statistics
{
  double smallest = 1., mean = 0.;
};

// `quality_of(face)` of the faces that are selected
template <typename FaceRange, typename IsSelected, typename QualityOf>
Quality_statistics summarize_quality(const FaceRange& faces, const IsSelected& is_selected, const QualityOf& quality_of)
{
  Quality_statistics result;
  std::size_t number = 0;
  for(const auto f : faces)
  {
    if(!is_selected(f))
      continue;
    const double q = quality_of(f);
    result.smallest = (std::min)(result.smallest, q);
    result.mean += q;
    ++number;
  }
  result.mean /= (std::max)(std::size_t(1), number);
  return result;
}

template <typename IsSelected>
Quality_statistics measure_quality(const Indexed_triangles& triangles, const IsSelected& is_selected)
{
  return summarize_quality(boost::irange(0, triangles.number_of_faces()), is_selected, [&](const int f)
                           { return quality(triangles.point(f, 0), triangles.point(f, 1), triangles.point(f, 2)); });
}

// `is_counted(face)` selects faces
template <typename UserMesh, typename IsCounted>
Quality_statistics measure_quality(const Working_mesh<UserMesh>& mesh, const IsCounted& is_counted)
{
  return summarize_quality(faces(mesh.tmesh()), [&](const auto f) { return mesh.is_remeshed(f) && is_counted(f); },
                           [&](const auto f)
  {
    const std::array<Vector, 3> points = mesh.triangle(f).points;
    return quality(points[0], points[1], points[2]);
  });
}

template <typename UserMesh>
std::size_t number_of_changed_faces(const Working_mesh<UserMesh>& mesh, const std::size_t since)
{
  return std::count_if(faces(mesh.tmesh()).begin(), faces(mesh.tmesh()).end(), [&](const auto f)
                       { return mesh.is_remeshed(f) && mesh.has_changed(f, since); });
}

// lengths of the edges in units of their sizes
struct Size_statistics
{
  double within_2 = 0., within_sqrt_2 = 0.;       // shares of the edges between 1/x and x
  double mean_log2 = 0.;                          // of the logarithm to base 2
};

// `is_counted(halfedge)` selects edges; `uncertainty` of the sizes, as a logarithm, widens the bands
template <typename UserMesh, typename IsCounted>
Size_statistics measure_sizes(const Working_mesh<UserMesh>& mesh, const IsCounted& is_counted,
                              const double uncertainty = 0.)
{
  Size_statistics result;
  std::size_t number = 0;
  for(const auto e : edges(mesh.tmesh()))
  {
    const auto h = halfedge(e, mesh.tmesh());
    if(!mesh.is_inside(e) || !is_counted(h))
      continue;
    const double log2 = std::log2(mesh.relative_length(h));
    ++number;
    result.within_2 += std::abs(log2) <= 1. + uncertainty;
    result.within_sqrt_2 += std::abs(log2) <= 0.5 + uncertainty;
    result.mean_log2 += std::isfinite(log2) ? log2 : 0.;
  }
  const double divisor = double((std::max)(std::size_t(1), number));
  result.within_2 /= divisor;
  result.within_sqrt_2 /= divisor;
  result.mean_log2 /= divisor;
  return result;
}

// that the loop reaches at least, where features do not rule
constexpr double mean_quality_of_result = 0.85;

// Has the mesh the sizes already, and good triangles, as after a run with the same sizes? A second run leaves
// such a mesh nearly as it is. What lies at curves does not count: close curves, and whole numbers of edges on short
// ones, force other lengths than the sizes, and with them other shapes.
template <typename UserMesh>
bool is_adapted(const Working_mesh<UserMesh>& mesh)
{
  // what the loop reaches, by a little more than what sizes change when the model is fitted to its result
  constexpr double least_share_within_2 = 0.95, least_share_within_sqrt_2 = 0.8, largest_mean = 0.15;
  const auto& tm = mesh.tmesh();
  const auto is_inside = [&](const auto v) { return mesh.data(v).type == SURFACE_VERTEX; };
  const auto has_ends_inside = [&](const auto h) { return is_inside(source(h, tm)) && is_inside(target(h, tm)); };
  // Where hardly anything is known of the radius, sizes may still be bounds or those of the user: a factor of 1.23.
  constexpr double largest_uncertainty = 0.3;
  const double uncertainty =
    (std::min)(largest_uncertainty, -std::log2(mesh.reference().sizes.certainty_of_radius()));
  const Size_statistics sizes = measure_sizes(mesh, has_ends_inside, uncertainty);
  return sizes.within_2 >= least_share_within_2 && sizes.within_sqrt_2 >= least_share_within_sqrt_2
      && std::abs(sizes.mean_log2) <= largest_mean + uncertainty
      && measure_quality(mesh, [&](const auto f)
         {
           const auto h = halfedge(f, tm);
           return has_ends_inside(h) || has_ends_inside(next(h, tm)) || has_ends_inside(prev(h, tm));
         }).mean >= mean_quality_of_result;
}

// Are nearly all lengths within a narrow band around their sizes?
template <typename UserMesh>
bool has_regular_sizes(const Working_mesh<UserMesh>& mesh)
{
  constexpr double least_share_within_sqrt_2 = 0.9;
  return measure_sizes(mesh, [](const auto) { return true; }).within_sqrt_2 >= least_share_within_sqrt_2;
}

// Are the sizes near those of the map, and the triangles good, so that the mesh needs only be mended here and there?
template <typename UserMesh>
bool is_nearly_adapted(const Working_mesh<UserMesh>& mesh)
{
  constexpr double least_share_within_2 = 0.8, largest_mean = 0.3;
  const Size_statistics sizes = measure_sizes(mesh, [](const auto) { return true; });
  return sizes.within_2 >= least_share_within_2 && std::abs(sizes.mean_log2) <= largest_mean
      && measure_quality(mesh, [](const auto) { return true; }).mean >= mean_quality_of_result;
}

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_MESH_STATISTICS_H
