// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_LEGALITY_H
#define CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_LEGALITY_H

#include <CGAL/Hermite_diffuse_remeshing/internal/Transformation/Working_mesh.h>

#include <algorithm>
#include <limits>

namespace CGAL {
namespace Hermite_diffuse_remeshing {
namespace internal {

// A change may lower the worst score that it touches only as far as this: below it triangles are
// too thin to be worth the right size.
constexpr double score_floor = 0.3;
// Every triangle that is made must have at least this score, unless the ones it replaces were worse.
constexpr double least_score = 0.02;

// `after` and `before`: the worst scores of the triangles that an operation makes and removes.
inline bool is_score_acceptable(const double after, const double before, const double floor)
{
  return after > least_score ? after >= (std::min)(floor, before) : after > before + score_margin;
}

// worst score of the faces around v if v were at p; faces at `skipped` vertices are left out
template <typename UserMesh>
double worst_score_around(const Working_mesh<UserMesh>& mesh,
                          const typename Working_mesh<UserMesh>::vertex_descriptor v, const Vector& p,
                          const typename Working_mesh<UserMesh>::vertex_descriptor skipped
                            = Working_mesh<UserMesh>::Graph_traits::null_vertex())
{
  typedef typename Working_mesh<UserMesh>::halfedge_descriptor halfedge_descriptor;
  double worst = (std::numeric_limits<double>::max)();
  for(const halfedge_descriptor h : CGAL::halfedges_around_target(v, mesh.tmesh()))
  {
    if(mesh.is_border_or_outside(h))
      continue;
    const auto s = source(h, mesh.tmesh());
    const auto t = target(next(h, mesh.tmesh()), mesh.tmesh());
    if(s == skipped || t == skipped)
      continue;
    worst = (std::min)(worst, score(mesh.reference(), mesh.point(s), p, mesh.point(t), mesh.hint(h)));
  }
  return worst;
}

template <typename UserMesh>
double worst_score_around(const Working_mesh<UserMesh>& mesh,
                          const typename Working_mesh<UserMesh>::vertex_descriptor v)
{
  return worst_score_around(mesh, v, mesh.point(v));
}

// score of the face of h as it is
template <typename UserMesh>
double face_score(const Working_mesh<UserMesh>& mesh,
                  const typename Working_mesh<UserMesh>::halfedge_descriptor h)
{
  return score(mesh.reference(), mesh.point(source(h, mesh.tmesh())), mesh.point(target(h, mesh.tmesh())),
               mesh.point(target(next(h, mesh.tmesh()), mesh.tmesh())), mesh.hint(h));
}

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_LEGALITY_H
