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

namespace CGAL {
namespace Hermite_diffuse_remeshing {
namespace internal {

// While sizes are being corrected, scores may fall, but not below this.
constexpr double score_floor = 0.3;
// Where triangles were worse already, anything above this may stay as it is. Nor is the quality of a triangle below it
// worth anything: the score of one that is flat is zero with the sign of the rounding, which is better than that of all
// that are turned over.
constexpr double least_score = 0.02;

// `before()` gives the worth until now, which is asked for only where it decides. What is turned over may not make room
// for what is flat: of flat triangles no operation would find back.
template <typename Before>
bool is_acceptable(const Worth& after, const Before& before, const double floor)
{
  if(after.score > least_score)
    return after.score >= floor - score_rounding || after.score >= before().score - score_rounding;
  const Worth worth_before = before();
  return after.score > worth_before.score + score_margin
      && (after.quality > least_score || after.quality >= worth_before.quality - score_rounding);
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
