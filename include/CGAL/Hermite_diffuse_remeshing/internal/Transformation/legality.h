// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_LEGALITY_H
#define CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_LEGALITY_H

#include <CGAL/Hermite_diffuse_remeshing/internal/Transformation/Star.h>

#include <algorithm>

namespace CGAL {
namespace Hermite_diffuse_remeshing {
namespace internal {

// While sizes are being corrected, scores may fall, but not below this.
constexpr double score_floor = 0.3;
// Where triangles were worse already, anything above this may stay as it is.
constexpr double least_score = 0.02;

// `before()` gives the score until now, which is asked for only where it decides.
template <typename Score>
bool is_score_acceptable(const double after, const Score& before, const double floor)
{
  if(after > least_score && after >= floor - score_rounding)
    return true;
  return after > least_score ? after >= before() - score_rounding : after > before() + score_margin;
}

template <typename UserMesh>
Worth face_worth(const Working_mesh<UserMesh>& mesh, const typename Working_mesh<UserMesh>::halfedge_descriptor h)
{
  const auto& tm = mesh.tmesh();
  return worth(mesh.reference(), mesh.site(source(h, tm)), mesh.site(target(h, tm)),
               mesh.site(target(next(h, tm), tm)), mesh.hint(h));
}

// the worst of the faces around a vertex, those around its copies included
template <typename UserMesh>
Worth worth_around(const Working_mesh<UserMesh>& mesh, const typename Working_mesh<UserMesh>::vertex_descriptor v)
{
  Worth result;
  mesh.visit_copies(v, [&](const auto copy)
  {
    for(const auto h : CGAL::halfedges_around_target(copy, mesh.tmesh()))
      if(!mesh.is_border_or_outside(h))
        result.add(face_worth(mesh, h));
  });
  return result;
}

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_LEGALITY_H
