// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_SPLIT_SLIVERS_H
#define CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_SPLIT_SLIVERS_H

#include <CGAL/Hermite_diffuse_remeshing/internal/Transformation/flip_edges.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Transformation/measure_edge.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Transformation/split_long_edges.h>

#include <cstddef>

namespace CGAL {
namespace Hermite_diffuse_remeshing {
namespace internal {

// Is a face beside an edge low? Halves of its sides are as low for their lengths, and lie close together in the end.
template <typename UserMesh>
bool is_beside_sliver(const Working_mesh<UserMesh>& mesh, const typename Working_mesh<UserMesh>::halfedge_descriptor h)
{
  // of the edge's length; of an equilateral triangle it is 0.87
  constexpr double least_height = 1. / 3.;
  const auto& tm = mesh.tmesh();
  const Vector& p = mesh.point(source(h, tm));
  const Vector edge = mesh.point(target(h, tm)) - p;
  for(const auto side : {h, opposite(h, tm)})
    if(!mesh.is_border_or_outside(side)
       && (mesh.point(target(next(side, tm), tm)) - p).cross(edge).norm() < least_height * edge.squaredNorm())
      return true;
  return false;
}

// Are nearly all edges that are too long beside slivers, as in the tessellations of CAD models? In scans some are, of
// which little can be saved.
template <typename UserMesh>
bool is_of_slivers(const Working_mesh<UserMesh>& mesh, const double bound)
{
  constexpr double considerable_part = 0.75;
  std::size_t number = 0, number_beside_slivers = 0;
  Changed_edges<UserMesh>(mesh, 0).visit([&](const auto h)
  {
    if(mesh.relative_length(h) > bound && !mesh.is_protected(h) && mesh.is_inside(edge(h, mesh.tmesh())))
    {
      ++number;
      number_beside_slivers += is_beside_sliver(mesh, h);
    }
  });
  return double(number_beside_slivers) > considerable_part * double(number);
}

// Would the middle of an edge be close to a vertex opposite to it? On a curve it is wanted in any case.
template <typename UserMesh>
bool is_middle_crowded(const Working_mesh<UserMesh>& mesh, const typename Working_mesh<UserMesh>::halfedge_descriptor h)
{
  // of the size: shorter edges are collapsed when the band of lengths becomes tight
  constexpr double least_distance = 0.7;
  if(mesh.is_on_curve(h))
    return false;
  const auto& tm = mesh.tmesh();
  const Vector middle = middle_of_chord(mesh, h);
  const double size = (mesh.size(source(h, tm)) + mesh.size(target(h, tm))) / 2.;
  for(const auto side : {h, opposite(h, tm)})
    if(!mesh.is_border_or_outside(side))
    {
      const auto v = target(next(side, tm), tm);
      if((mesh.point(v) - middle).norm() < least_distance * (mesh.size(v) + size) / 2.)
        return true;
    }
  return false;
}

// The first splits of a mesh of slivers. If all long edges were split, nearly all of the new vertices would have to be
// collapsed again, and there would be many times as many as are wanted. Here an edge waits while its middle would be
// crowded, until the splits of others let a flip replace it. What still waits in the end is left to
// `split_long_edges()`.
template <typename UserMesh>
std::size_t split_slivers(Working_mesh<UserMesh>& mesh, const double bound, const double slack)
{
  if(!is_of_slivers(mesh, bound))
    return 0;
  return split_in_rounds(mesh, 0, [&](const std::size_t since_round)
  {
    const std::size_t number_of_changes = mesh.number_of_changes();
    const std::size_t splits = split_long_edges_once(mesh, bound, since_round, LONGEST_FIRST, slack, [&](const auto h)
                                                     { return !is_middle_crowded(mesh, h); });
    return splits + flip_edges_by_score(mesh, number_of_changes);
  });
}

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_SPLIT_SLIVERS_H
