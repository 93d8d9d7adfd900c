// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_CURVE_FIDELITY_H
#define CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_CURVE_FIDELITY_H

#include <CGAL/Hermite_diffuse_remeshing/internal/Transformation/Working_mesh.h>

#include <algorithm>
#include <utility>

namespace CGAL {
namespace Hermite_diffuse_remeshing {
namespace internal {

// Edges may be longer than their size by the factor of a band, and the distance to the curve grows with the square.
// On the faces this averages out; on a feature curve, which everybody sees, no edge is farther from the spline than
// `Size_sources::largest_sagitta()` allows for the size there.

// `factor`: of the distance that is allowed
template <typename UserMesh>
bool is_faithful(const Working_mesh<UserMesh>& mesh, const typename Working_mesh<UserMesh>::halfedge_descriptor h,
                 const double factor = 1.)
{
  const int curve = mesh.curve(h);
  return curve == -1
      || mesh.reference().is_chord_faithful(curve, mesh.parameter(source(h, mesh.tmesh()), curve),
                                            mesh.parameter(target(h, mesh.tmesh()), curve), factor);
}

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

// May a curve vertex move along its curve to a parameter? Its edges must stay faithful where they are.
template <typename UserMesh>
bool is_curve_move_faithful(const Working_mesh<UserMesh>& mesh,
                            const typename Working_mesh<UserMesh>::vertex_descriptor v, const double parameter)
{
  const Site& site = mesh.site(v);
  const std::pair<double, double> ends = neighbor_parameters(mesh, v);
  const auto is_worse = [&](const double end)
  {
    return !mesh.reference().is_chord_faithful(site.curve, end, parameter)
        && mesh.reference().is_chord_faithful(site.curve, end, site.parameter);
  };
  return !is_worse(ends.first) && !is_worse(ends.second);
}

// May the curve vertex at the source of h disappear along the curve, if the target goes to a site?
template <typename UserMesh>
bool is_curve_collapse_faithful(const Working_mesh<UserMesh>& mesh,
                                const typename Working_mesh<UserMesh>::halfedge_descriptor h, const Site& site)
{
  const int curve = mesh.curve(h);
  const auto t = target(h, mesh.tmesh());
  std::pair<double, double> ends = neighbor_parameters(mesh, source(h, mesh.tmesh()));
  if(mesh.data(t).site.curve == curve)
  {
    const std::pair<double, double> others = neighbor_parameters(mesh, t);
    ends.first = (std::min)(ends.first, others.first);
    ends.second = (std::max)(ends.second, others.second);
  }
  const double middle = site.curve == curve ? site.parameter : mesh.parameter(t, curve);
  return mesh.reference().is_chord_faithful(curve, ends.first, middle)
      && mesh.reference().is_chord_faithful(curve, middle, ends.second);
}

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_CURVE_FIDELITY_H
