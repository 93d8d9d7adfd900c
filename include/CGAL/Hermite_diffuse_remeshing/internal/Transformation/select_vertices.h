// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_SELECT_VERTICES_H
#define CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_SELECT_VERTICES_H

#include <CGAL/Hermite_diffuse_remeshing/internal/Transformation/Working_mesh.h>

#include <vector>

namespace CGAL {
namespace Hermite_diffuse_remeshing {
namespace internal {

// A halfedge to the vertex that has a remeshed face; null if there is none.
template <typename UserMesh>
typename Working_mesh<UserMesh>::halfedge_descriptor
first_remeshed_halfedge(const Working_mesh<UserMesh>& mesh,
                        const typename Working_mesh<UserMesh>::vertex_descriptor v)
{
  for(const auto h : CGAL::halfedges_around_target(v, mesh.tmesh()))
    if(!mesh.is_border_or_outside(h))
      return h;
  return Working_mesh<UserMesh>::Graph_traits::null_halfedge();
}

// The neighbour with the smallest number.
template <typename UserMesh>
typename Working_mesh<UserMesh>::vertex_descriptor
first_neighbor(const Working_mesh<UserMesh>& mesh, const typename Working_mesh<UserMesh>::vertex_descriptor v)
{
  const auto& tm = mesh.tmesh();
  auto first = source(halfedge(v, tm), tm);
  for(const auto h : CGAL::halfedges_around_target(v, tm))
    if(mesh.index(source(h, tm)) < mesh.index(first))
      first = source(h, tm);
  return first;
}

// The vertices that may change their place and have changed neighbours, in the order of their numbers; one of the copies
// stands for all.
template <typename UserMesh>
std::vector<typename Working_mesh<UserMesh>::vertex_descriptor>
movable_vertices(const Working_mesh<UserMesh>& mesh, const std::size_t since)
{
  typedef Working_mesh<UserMesh> Mesh;
  typedef typename Mesh::vertex_descriptor vertex_descriptor;
  std::vector<vertex_descriptor> result;
  for(int i = 0; i < static_cast<int>(mesh.number_of_vertex_slots()); ++i)
  {
    if(mesh.is_stopped_at(i))
      return std::vector<vertex_descriptor>();
    if(!mesh.has_changed(i, since))
      continue;
    const vertex_descriptor v = mesh.vertex(i);
    if(v == Mesh::Graph_traits::null_vertex() || mesh.is_fixed(v))
      continue;
    bool is_found = false;
    mesh.visit_copies(v, [&](const vertex_descriptor copy)
    {
      if(!is_found && first_remeshed_halfedge(mesh, copy) != Mesh::Graph_traits::null_halfedge())
      {
        result.push_back(copy);
        is_found = true;
      }
    });
  }
  return result;
}

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_SELECT_VERTICES_H
