// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_MEASURE_EDGE_H
#define CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_MEASURE_EDGE_H

#include <CGAL/Hermite_diffuse_remeshing/internal/Transformation/Working_mesh.h>

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace Hermite_diffuse_remeshing {
namespace internal {

// relative to the local size; a deviation needs two digits
constexpr double tolerance_of_deviation = 1e-3;

// The place of the model closest to a point over the face of h.
//
// Newton's method starts where the point is located. Where the surface is steep over its
// facets it may end at another part of the surface: before a point counts as farther away than `bound`, the
// locations of the vertices around it are tried.
template <typename UserMesh>
Reference::Nearest nearest_on_model(const Working_mesh<UserMesh>& mesh, const Vector& p,
                                    const typename Working_mesh<UserMesh>::halfedge_descriptor h, const double bound)
{
  const Reference& reference = mesh.reference();
  const auto& tm = mesh.tmesh();
  Reference::Nearest nearest = reference.nearest(p, reference.locate(p, mesh.hint(h)), tolerance_of_deviation);
  if(nearest.distance > bound)
    for(const auto v : {source(h, tm), target(h, tm), target(next(h, tm), tm)})
    {
      const Reference::Nearest other = reference.nearest(p, mesh.data(v).site.location, tolerance_of_deviation);
      if(other.distance < nearest.distance)
        nearest = other;
    }
  return nearest;
}

template <typename UserMesh>
Vector middle_of_chord(const Working_mesh<UserMesh>& mesh, const typename Working_mesh<UserMesh>::halfedge_descriptor h)
{
  return (mesh.point(source(h, mesh.tmesh())) + mesh.point(target(h, mesh.tmesh()))) / 2.;
}

// By how much a ridge of the model across an edge may rise above what the middle of the edge, with the place of the model
// nearest to it, tells.
//
// The height of the model over the middle of an edge of the length l is k l^2 / 8, k the curvature along the edge, if
// it is smooth. A ridge across the edge adds a triangle to this, the peak of which is twice as high as its
// contribution at the middle at most.
template <typename UserMesh>
double height_of_ridge(const Working_mesh<UserMesh>& mesh,
                       const typename Working_mesh<UserMesh>::halfedge_descriptor h, const Reference::Nearest& nearest)
{
  const Site& from = mesh.site(source(h, mesh.tmesh()));
  const Site& to = mesh.site(target(h, mesh.tmesh()));
  if(from.location.face == to.location.face)
    return 0.;                          // no side of a face of the reference is crossed
  const Local_quadric& quadric = nearest.quadric;
  const Vector edge = to.point - from.point;
  const double x = edge.dot(quadric.x_axis), y = edge.dot(quadric.y_axis);
  const double smooth = (quadric.a[3] * x * x + quadric.a[4] * x * y + quadric.a[5] * y * y) / (4. * quadric.size);
  return 2. * std::abs(nearest.gap.dot(quadric.z_axis) - smooth);
}

struct Edge_measurement
{
  Reference::Nearest nearest;
  double deviation;                     // on curves, of the whole arc
  double ridge = 0.;                    // see `height_of_ridge()`
};

// at the middle of an edge
template <typename UserMesh>
Edge_measurement measure_edge(const Working_mesh<UserMesh>& mesh,
                              const typename Working_mesh<UserMesh>::halfedge_descriptor h, const double bound)
{
  const Vector p = middle_of_chord(mesh, h);
  const int curve = mesh.curve(h);
  Edge_measurement result;
  if(curve == -1)
  {
    result.nearest = nearest_on_model(mesh, p, h, bound);
    result.deviation = result.nearest.distance;
    result.ridge = height_of_ridge(mesh, h, result.nearest);
    return result;
  }
  const Reference& reference = mesh.reference();
  const double u = mesh.parameter(source(h, mesh.tmesh()), curve), v = mesh.parameter(target(h, mesh.tmesh()), curve);
  const Site site = reference.curve_site(curve, (u + v) / 2.);
  result.nearest.location = site.location;
  result.nearest.gap = p - site.point;
  result.nearest.distance = result.nearest.gap.norm();
  // the arc may be farther away than its middle
  result.deviation = (std::max)(result.nearest.distance, reference.curves.curves[curve].spline
                                  .distance_to_chord((std::min)(u, v), (std::max)(u, v)));
  return result;
}

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_MEASURE_EDGE_H
