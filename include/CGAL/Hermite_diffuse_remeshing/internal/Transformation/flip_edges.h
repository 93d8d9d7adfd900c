// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_FLIP_EDGES_H
#define CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_FLIP_EDGES_H

#include <CGAL/Hermite_diffuse_remeshing/internal/Transformation/Edge_queue.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Transformation/legality.h>

#include <algorithm>

namespace CGAL {
namespace Hermite_diffuse_remeshing {
namespace internal {

// May the edge be replaced by the other diagonal of its two triangles? Never a feature, never
// where the other diagonal is an edge already, and only if the worse of the two triangles gains in
// score, that is, in shape and agreement with the model together (paper, section 4.5).
template <typename UserMesh>
bool is_flip_legal(const Working_mesh<UserMesh>& mesh,
                   const typename Working_mesh<UserMesh>::halfedge_descriptor h)
{
  const auto& tm = mesh.tmesh();
  const auto o = opposite(h, tm);
  if(mesh.is_on_curve(h) || mesh.is_protected(h) || mesh.is_border_or_outside(h) || mesh.is_border_or_outside(o))
    return false;
  const auto c = target(next(h, tm), tm), d = target(next(o, tm), tm);
  if(c == d || halfedge(c, d, tm).second)
    return false;

  const double before = (std::min)(face_score(mesh, h), face_score(mesh, o));
  const Vector& a = mesh.point(source(h, tm));
  const Vector& b = mesh.point(target(h, tm));
  const Reference& reference = mesh.reference();
  const double first = score(reference, a, mesh.point(d), mesh.point(c), mesh.hint(h));
  if(first <= before + score_margin)
    return false;
  return score(reference, mesh.point(d), b, mesh.point(c), mesh.hint(o)) > before + score_margin;
}

// One pass over the edges with changes around them, the relatively longest first.
template <typename UserMesh>
std::size_t flip_edges(Working_mesh<UserMesh>& mesh, const std::size_t since)
{
  typedef typename Working_mesh<UserMesh>::halfedge_descriptor halfedge_descriptor;
  const std::size_t before = mesh.counts().flips;
  for(const auto& candidate : collect_edges(mesh, 1, [&](const halfedge_descriptor h, double)
                                            { return mesh.has_changed(h, since) && !mesh.is_on_curve(h)
                                                     && !mesh.is_protected(h); }))
  {
    if(mesh.is_stopped())
      break;
    if(is_flip_legal(mesh, candidate.halfedge))
      mesh.flip_edge(candidate.halfedge);
  }
  return mesh.counts().flips - before;
}

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_FLIP_EDGES_H
