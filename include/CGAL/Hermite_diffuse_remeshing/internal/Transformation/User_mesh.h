// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_USER_MESH_H
#define CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_USER_MESH_H

#include <cstddef>

namespace CGAL {
namespace Hermite_diffuse_remeshing {
namespace internal {

// What the user handed in.
template <typename TriangleMesh_, typename VertexPointMap, typename EdgeIsConstrainedMap,
          typename FacePatchMap_, typename GeomTraits_, typename Visitor_>
struct User_mesh
{
  typedef TriangleMesh_ TriangleMesh;
  typedef GeomTraits_ GeomTraits;
  typedef Visitor_ Visitor;
  typedef FacePatchMap_ FacePatchMap;

  TriangleMesh& tmesh;
  VertexPointMap points;
  EdgeIsConstrainedMap edge_is_constrained;
  FacePatchMap face_patch;
  GeomTraits traits;
  Visitor& visitor;
};

struct Operation_counts
{
  std::size_t splits = 0, collapses = 0, flips = 0, vertex_removals = 0, relocations = 0;
};

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_USER_MESH_H
