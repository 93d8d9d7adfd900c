// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_REMOVE_VERTICES_H
#define CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_REMOVE_VERTICES_H

#include <CGAL/Hermite_diffuse_remeshing/internal/Transformation/Contour.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Transformation/collapse_short_edges.h>

#include <array>
#include <cstddef>

namespace CGAL {
namespace Hermite_diffuse_remeshing {
namespace internal {

// Removes a vertex inside the surface, with all its edges, and fills the contour in the best way.
template <typename UserMesh>
class Vertex_removal
{
  typedef Working_mesh<UserMesh> Mesh;
  typedef typename Mesh::vertex_descriptor vertex_descriptor;

  vertex_descriptor m_vertex;
  Contour<UserMesh> m_contour;

public:
  // what it would make of the vertex; a score of -1 where it may not
  Worth plan(const Mesh& mesh, const vertex_descriptor v)
  {
    const auto& tm = mesh.tmesh();
    m_vertex = v;
    m_contour = Contour<UserMesh>();
    if(mesh.data(v).type != SURFACE_VERTEX || mesh.is_fixed(v))
      return Worth{-1., 0.};
    const auto first = halfedge(v, tm);
    auto h = first;
    do
    {
      m_contour.add(source(h, tm));
      h = prev(opposite(h, tm), tm);
    }
    while(h != first);
    // two triangles with the same corners that close a surface
    if(m_contour.size() < 3)
      return Worth{-1., 0.};
    // the other side of a tetrahedron is no place for a second triangle with the same corners
    if(m_contour.size() == 3 && target(next(opposite(prev(first, tm), tm), tm), tm) == m_contour.corner(1))
      return Worth{-1., 0.};
    return m_contour.fill(mesh, mesh.hint(first));
  }

  bool is_free(Mesh& mesh) const { return is_filling_free(mesh, {m_vertex}, {&m_contour}); }

  void execute(Mesh& mesh) const { mesh.remove_vertex(m_vertex, m_contour.diagonals()); }
};

// Removes an edge inside the surface with both of its vertices, and fills the contour around the faces of both.
template <typename UserMesh>
class Edge_removal
{
  typedef Working_mesh<UserMesh> Mesh;
  typedef typename Mesh::vertex_descriptor vertex_descriptor;
  typedef typename Mesh::halfedge_descriptor halfedge_descriptor;

  halfedge_descriptor m_halfedge;
  Contour<UserMesh> m_contour;

public:
  Worth plan(const Mesh& mesh, const halfedge_descriptor h)
  {
    const auto& tm = mesh.tmesh();
    m_halfedge = h;
    m_contour = Contour<UserMesh>();
    for(const vertex_descriptor v : {source(h, tm), target(h, tm)})
      if(mesh.data(v).type != SURFACE_VERTEX || mesh.is_fixed(v))
        return Worth{-1., 0.};
    if(!is_collapse_topologically_legal(mesh, h))
      return Worth{-1., 0.};
    // from the one common neighbour to the other around the source, then back around the target
    const halfedge_descriptor o = opposite(h, tm);
    for(halfedge_descriptor g = prev(h, tm); g != o; g = prev(opposite(g, tm), tm))
      m_contour.add(source(g, tm));
    for(halfedge_descriptor g = prev(opposite(prev(o, tm), tm), tm); g != opposite(next(h, tm), tm);
        g = prev(opposite(g, tm), tm))
      m_contour.add(source(g, tm));
    // what is left of a surface with so few vertices may have no place for it
    return m_contour.size() > 3 ? m_contour.fill(mesh, mesh.hint(h)) : Worth{-1., 0.};
  }

  bool is_free(Mesh& mesh) const
  {
    return is_filling_free(mesh, {source(m_halfedge, mesh.tmesh()), target(m_halfedge, mesh.tmesh())}, {&m_contour});
  }

  void execute(Mesh& mesh) const
  {
    mesh.remove_vertex(mesh.collapse_edge(m_halfedge, mesh.site(target(m_halfedge, mesh.tmesh()))),
                       m_contour.diagonals());
  }
};

// Removes a vertex from its curve: its two neighbours there are joined, and the contours on both sides
// are filled anew. It is a collapse into one of the neighbours with a freer choice of triangles.
template <typename UserMesh>
class Curve_vertex_removal
{
  typedef Working_mesh<UserMesh> Mesh;
  typedef typename Mesh::vertex_descriptor vertex_descriptor;
  typedef typename Mesh::halfedge_descriptor halfedge_descriptor;

  halfedge_descriptor m_halfedge;
  std::array<Contour<UserMesh>, 2> m_contours;

public:
  // `h` goes from the vertex to one of its neighbours on the curve
  Worth plan(const Mesh& mesh, const halfedge_descriptor h)
  {
    const auto& tm = mesh.tmesh();
    m_halfedge = h;
    m_contours.fill(Contour<UserMesh>());
    const vertex_descriptor v = source(h, tm), a = target(h, tm);
    if(mesh.data(v).type != CURVE_VERTEX || !mesh.is_on_curve(h) || !is_collapse_topologically_legal(mesh, h)
       || !is_curve_collapse_faithful(mesh, h, mesh.site(a)))
      return Worth{-1., 0.};
    // two contours are no more than one sheet has: at a junction a collapse has to do
    if(mesh.has_copies(v))
      return Worth{-1., 0.};

    m_contours[0].add(a);
    m_contours[1].add(a);
    std::array<int, 2> hints = {{-1, -1}};
    int side = 0;
    for(halfedge_descriptor g = opposite(h, tm);;)
    {
      const bool has_face = !mesh.is_border_or_outside(opposite(g, tm));
      if(has_face)
        hints[side] = mesh.hint(opposite(g, tm));
      g = prev(opposite(g, tm), tm);
      if(source(g, tm) == a)
        break;
      if(side == 0)
        m_contours[0].add(source(g, tm));
      if(side == 0 && mesh.is_on_curve(g))
        side = 1;
      if(side == 1)
        m_contours[1].add(source(g, tm));
    }
    Worth result;
    for(int i = 0; i < 2; ++i)
      if(hints[i] != -1)
        result.add(m_contours[i].size() < 3 ? Worth{-1., 0.} : m_contours[i].fill(mesh, hints[i]));
    return result;
  }

  bool is_free(Mesh& mesh) const
  { return is_filling_free(mesh, {source(m_halfedge, mesh.tmesh())}, {&m_contours[0], &m_contours[1]}); }

  void execute(Mesh& mesh) const
  {
    const auto& tm = mesh.tmesh();
    const vertex_descriptor a = mesh.collapse_edge(m_halfedge, mesh.site(target(m_halfedge, tm)));
    for(const Contour<UserMesh>& contour : m_contours)
      if(contour.size() > 3)
        mesh.retriangulate_fan(halfedge(contour.corner(contour.size() - 1), a, tm).first, contour.size() - 3,
                               contour.diagonals());
  }
};

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_REMOVE_VERTICES_H
