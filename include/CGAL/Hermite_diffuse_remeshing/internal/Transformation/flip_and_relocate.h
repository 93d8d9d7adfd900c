// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_FLIP_AND_RELOCATE_H
#define CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_FLIP_AND_RELOCATE_H

#include <CGAL/Hermite_diffuse_remeshing/internal/Transformation/flip_edges.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Transformation/is_free.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Transformation/Star.h>

namespace CGAL {
namespace Hermite_diffuse_remeshing {
namespace internal {

// Flips an edge at a vertex inside the surface, or opposite to it, and moves the vertex.
template <typename UserMesh>
class Flip_and_relocation
{
  typedef Working_mesh<UserMesh> Mesh;
  typedef typename Mesh::halfedge_descriptor halfedge_descriptor;

  halfedge_descriptor m_flipped;
  typename Mesh::vertex_descriptor m_vertex;
  Site m_site;

public:
  // `h`: has the vertex as its target, and is flipped, or a side of the face that is; no better score than `least` is
  // wanted
  Worth plan(const Mesh& mesh, const halfedge_descriptor h, const halfedge_descriptor flipped, const double least)
  {
    const auto& tm = mesh.tmesh();
    m_flipped = flipped;
    m_vertex = target(h, tm);
    const bool is_at_vertex = flipped == h;
    const halfedge_descriptor o = opposite(h, tm);
    Worth result;                       // of the face that is made away from the vertex
    Star star(mesh.reference(), Star::WORST);
    for(const halfedge_descriptor g : CGAL::halfedges_around_target(m_vertex, tm))
      if(g != h && !(is_at_vertex && g == prev(o, tm)))
        star.add_side(mesh, prev(g, tm));
    if(is_at_vertex)
    {
      const Site& s = mesh.site(source(h, tm));
      const Site& t = mesh.site(target(next(h, tm), tm));
      const Site& u = mesh.site(target(next(o, tm), tm));
      star.add_side(t, u, mesh.hint(h));
      result = worth(mesh.reference(), s, u, t, mesh.hint(o));
      if(result.score <= least)
        return Worth{-1., 0.};
    }
    else
    {
      star.add_side(mesh, next(flipped, tm));
      star.add_side(mesh, prev(flipped, tm));
    }
    m_site = star.better_site(mesh.site(m_vertex));
    result.add(star.worth(m_site));
    return result;
  }

  bool is_free(Mesh& mesh) const { return is_flip_and_relocation_free(mesh, m_flipped, m_vertex, m_site); }

  void execute(Mesh& mesh) const
  {
    mesh.flip_edge(m_flipped);
    mesh.relocate(m_vertex, m_site);
  }
};

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_FLIP_AND_RELOCATE_H
