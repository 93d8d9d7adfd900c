// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_IS_FREE_H
#define CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_IS_FREE_H

#include <CGAL/Hermite_diffuse_remeshing/internal/Transformation/Contour.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Transformation/Working_mesh.h>

#include <algorithm>
#include <initializer_list>

namespace CGAL {
namespace Hermite_diffuse_remeshing {
namespace internal {

// Would an operation make triangles that meet others? The triangles that it makes come from those that it
// replaces by exchanging corners.

// a number that no vertex has
constexpr int number_of_new_vertex = -2;

// faces around vertices and all their copies, each once
template <typename UserMesh>
Numbered_triangles
triangles_around(const Working_mesh<UserMesh>& mesh,
                 const std::initializer_list<typename Working_mesh<UserMesh>::vertex_descriptor> vertices)
{
  Numbered_triangles result;
  for(const auto v : vertices)
    mesh.visit_copies(v, [&](const auto copy)
    {
      for(const auto h : CGAL::halfedges_around_target(copy, mesh.tmesh()))
      {
        if(CGAL::is_border(h, mesh.tmesh()))
          continue;
        const Numbered_triangle t = mesh.triangle(face(h, mesh.tmesh()));
        if(std::none_of(result.begin(), result.end(), [&](const auto& other) { return other.vertices == t.vertices; }))
          result.push_back(t);
      }
    });
  return result;
}

// a triangle with another vertex in the place of the one with the number `old_number`
inline Numbered_triangle with_corner(Numbered_triangle t, const int old_number, const int number, const Vector& point)
{
  for(int i = 0; i < 3; ++i)
    if(t.vertices[i] == old_number)
    {
      t.vertices[i] = number;
      t.points[i] = point;
    }
  return t;
}

// the triangles with a vertex at another site
template <typename UserMesh>
Numbered_triangles
with_moved(const Working_mesh<UserMesh>& mesh, Numbered_triangles triangles,
           const typename Working_mesh<UserMesh>::vertex_descriptor v, const Site& site)
{
  for(Numbered_triangle& t : triangles)
    t = with_corner(t, mesh.index(v), mesh.index(v), site.point);
  return triangles;
}

// The vertex, if the faces around it are a disc whose border is not touched; null otherwise
template <typename UserMesh>
typename Working_mesh<UserMesh>::vertex_descriptor
center_of_disc(const Working_mesh<UserMesh>& mesh, const typename Working_mesh<UserMesh>::vertex_descriptor v)
{
  return mesh.has_copies(v) || CGAL::is_border(v, mesh.tmesh())
       ? Working_mesh<UserMesh>::Graph_traits::null_vertex() : v;
}

template <typename UserMesh>
bool is_relocation_free(Working_mesh<UserMesh>& mesh,
                        const typename Working_mesh<UserMesh>::vertex_descriptor v, const Site& site)
{
  typedef Working_mesh<UserMesh> Mesh;
  if(!mesh.is_guarded())
    return true;
  const auto& tm = mesh.tmesh();
  boost::container::small_vector<Corner_points, 12> moved;
  bool is_disc = !mesh.has_copies(v);
  for(const auto h : CGAL::halfedges_around_target(v, tm))
  {
    is_disc = is_disc && !CGAL::is_border(h, tm);
    moved.push_back({{&mesh.point(source(h, tm)), &site.point, &mesh.point(target(next(h, tm), tm))}});
  }
  const auto center = is_disc ? v : Mesh::Graph_traits::null_vertex();
  // the corners of the others are among theirs, and the center
  const decltype(moved) none;
  if(is_disc && mesh.is_clear(center, moved, none))
    return true;
  const Numbered_triangles replaced = triangles_around(mesh, {v});
  return mesh.is_allowed(center, with_moved(mesh, replaced, v, site), replaced);
}

template <typename UserMesh>
bool is_collapse_free(Working_mesh<UserMesh>& mesh,
                      const typename Working_mesh<UserMesh>::halfedge_descriptor h, const Site& site)
{
  if(!mesh.is_guarded())
    return true;
  const auto& tm = mesh.tmesh();
  const auto s = source(h, tm), t = target(h, tm);
  const auto center = center_of_disc(mesh, s);
  const bool is_looked_for = center != Working_mesh<UserMesh>::Graph_traits::null_vertex() && !mesh.has_copies(t);
  if(is_looked_for)
  {
    boost::container::small_vector<Corner_points, 12> moved, removed;
    for(const auto v : {s, t})
      for(const auto g : CGAL::halfedges_around_target(v, tm))
      {
        const auto from = source(g, tm), to = target(next(g, tm), tm);
        if(CGAL::is_border(g, tm) || (v == t && (from == s || to == s)))
          continue;                     // around s already
        removed.push_back({{&mesh.point(from), &mesh.point(v), &mesh.point(to)}});
        if(v == t || (from != t && to != t))
          moved.push_back({{&mesh.point(from), &site.point, &mesh.point(to)}});
      }
    if(mesh.is_clear(center, moved, removed))
      return true;
  }
  const Numbered_triangles replaced = triangles_around(mesh, {s, t});
  Numbered_triangles made;
  for(const Numbered_triangle& triangle : replaced)
  {
    const Numbered_triangle moved = with_corner(with_corner(triangle, mesh.index(t), mesh.index(t), site.point),
                                                mesh.index(s), mesh.index(t), site.point);
    if(std::count(moved.vertices.begin(), moved.vertices.end(), mesh.index(t)) == 1)
      made.push_back(moved);
  }
  return is_looked_for ? mesh.is_allowed(center, made, replaced) : mesh.is_free(center, made, replaced);
}

template <typename UserMesh>
bool is_split_free(Working_mesh<UserMesh>& mesh,
                   const typename Working_mesh<UserMesh>::halfedge_descriptor h, const Site& site)
{
  typedef Working_mesh<UserMesh> Mesh;
  if(!mesh.is_guarded())
    return true;
  const auto& tm = mesh.tmesh();
  Numbered_triangles made, replaced;
  for(const auto sibling : mesh.siblings(h))
    for(const auto side : {sibling, opposite(sibling, tm)})
    {
      if(CGAL::is_border(side, tm))
        continue;
      replaced.push_back(mesh.triangle(face(side, tm)));
      made.push_back(with_corner(replaced.back(), mesh.index(source(side, tm)), number_of_new_vertex, site.point));
      made.push_back(with_corner(replaced.back(), mesh.index(target(side, tm)), number_of_new_vertex, site.point));
    }
  return mesh.is_free(CGAL::is_border(edge(h, tm), tm) ? Mesh::Graph_traits::null_vertex()
                                                      : center_of_disc(mesh, source(h, tm)), made, replaced);
}

// the two faces of an edge, and those that a flip makes of them
template <typename UserMesh>
void add_flip(const Working_mesh<UserMesh>& mesh, const typename Working_mesh<UserMesh>::halfedge_descriptor h,
              Numbered_triangles& made, Numbered_triangles& replaced)
{
  const auto& tm = mesh.tmesh();
  const auto o = opposite(h, tm);
  const auto c = target(next(h, tm), tm), d = target(next(o, tm), tm);
  replaced.push_back(mesh.triangle(face(h, tm)));
  made.push_back(with_corner(replaced.back(), mesh.index(target(h, tm)), mesh.index(d), mesh.point(d)));
  replaced.push_back(mesh.triangle(face(o, tm)));
  made.push_back(with_corner(replaced.back(), mesh.index(source(h, tm)), mesh.index(c), mesh.point(c)));
}

template <typename UserMesh>
bool is_flip_free(Working_mesh<UserMesh>& mesh, const typename Working_mesh<UserMesh>::halfedge_descriptor h)
{
  if(!mesh.is_guarded())
    return true;
  const auto c = target(next(h, mesh.tmesh()), mesh.tmesh());
  Numbered_triangles made, replaced;
  add_flip(mesh, h, made, replaced);
  return mesh.is_free(mesh.has_copies(c) ? Working_mesh<UserMesh>::Graph_traits::null_vertex() : c, made, replaced);
}

// the edge of h is flipped, and v, a vertex of its faces, moves
template <typename UserMesh>
bool is_flip_and_relocation_free(Working_mesh<UserMesh>& mesh,
                                 const typename Working_mesh<UserMesh>::halfedge_descriptor h,
                                 const typename Working_mesh<UserMesh>::vertex_descriptor v, const Site& site)
{
  if(!mesh.is_guarded())
    return true;
  Numbered_triangles made, replaced;
  add_flip(mesh, h, made, replaced);
  for(const Numbered_triangle& t : triangles_around(mesh, {v}))
    if(std::none_of(replaced.begin(), replaced.end(), [&](const auto& other) { return other.vertices == t.vertices; }))
    {
      replaced.push_back(t);
      made.push_back(t);
    }
  return mesh.is_free(center_of_disc(mesh, v), with_moved(mesh, made, v, site), replaced);
}

// may contours take the place of the faces around vertices?
template <typename UserMesh>
bool is_filling_free(Working_mesh<UserMesh>& mesh,
                     const std::initializer_list<typename Working_mesh<UserMesh>::vertex_descriptor> vertices,
                     const std::initializer_list<const Contour<UserMesh>*> contours)
{
  if(!mesh.is_guarded())
    return true;
  Numbered_triangles made;
  for(const Contour<UserMesh>* const contour : contours)
    for(const auto& corners : contour->triangles())
    {
      Numbered_triangle t;
      for(int i = 0; i < 3; ++i)
      {
        t.vertices[i] = mesh.index(corners[i]);
        t.points[i] = mesh.point(corners[i]);
      }
      made.push_back(t);
    }
  return mesh.is_free(center_of_disc(mesh, *vertices.begin()), made, triangles_around(mesh, vertices));
}

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_IS_FREE_H
