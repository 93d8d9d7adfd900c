// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_SOUP_MESH_H
#define CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_SOUP_MESH_H

#include <CGAL/Hermite_diffuse_remeshing/internal/Classification/Cut_mesh.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Classification/orient_sheets.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Point_reader.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/validate_input.h>

#include <CGAL/Surface_mesh.h>

#include <array>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

namespace CGAL {
namespace Hermite_diffuse_remeshing {
namespace internal {

// The user's soup as indexed triangles, read before the first change. Refuses, with std::invalid_argument, an empty
// soup, polygons that are not triangles, vertices that are missing or named twice by a triangle, and points that are
// not finite.
template <typename PointRange, typename TriangleRange, typename GeomTraits>
Indexed_triangles read_soup(const PointRange& points, const TriangleRange& triangles, const GeomTraits& traits)
{
  if(triangles.begin() == triangles.end())
    throw std::invalid_argument("the soup has no triangle: there is nothing to remesh");
  const Point_reader<GeomTraits> read_point(traits);
  Indexed_triangles result;
  for(const auto& p : points)
  {
    const Vector point = read_point(p);
    if(!point.allFinite())
      refuse("a coordinate of point " + std::to_string(result.number_of_vertices()), "not a finite number",
             "all coordinates must be finite");
    result.points.push_back(point);
  }
  for(const auto& triangle : triangles)
  {
    const std::string name = "triangle " + std::to_string(result.number_of_faces());
    if(triangle.size() != 3)
      refuse("the number of vertices of " + name, triangle.size(), "all polygons must be triangles");
    std::array<int, 3> corners;
    for(int k = 0; k < 3; ++k)
    {
      const std::size_t i = std::size_t(triangle[k]);
      if(i >= result.points.size())
        refuse("a vertex of " + name, i, "the soup has " + std::to_string(result.points.size()) + " points");
      corners[k] = static_cast<int>(i);
    }
    for(int k = 0; k < 3; ++k)
      if(corners[k] == corners[next(k)])
        refuse("a vertex of " + name, corners[k],
               "a triangle must have three different vertices; repair_polygon_soup() removes the others");
    result.triangles.push_back(corners);
  }
  return result;
}

// The mesh with halfedges that holds a soup: the soup is cut along its non-manifold edges and at the vertices where
// sheets touch, by which some vertices get several copies. Face i is triangle i of `surface`, and begins with the
// same corner.
template <typename Point, typename GeomTraits>
void make_soup_mesh(const Indexed_triangles& surface, const GeomTraits& traits,
                    CGAL::Surface_mesh<Point>& mesh)
{
  typedef CGAL::Surface_mesh<Point> Mesh;
  const Edge_table edges(surface);
  // nothing but what a mesh with halfedges cannot hold
  std::vector<Edge_class> classes = classify_edges(surface, edges, std::numeric_limits<double>::infinity(),
                                                   [](int, int) { return MARKED_FREE; });
  const Cut_mesh cut_mesh(surface, edges, classes);
  const typename GeomTraits::Construct_point_3 construct_point = traits.construct_point_3_object();
  for(int i = 0; i < cut_mesh.number_of_nodes(); ++i)
  {
    const Vector& p = surface.points[cut_mesh.vertex(i)];
    mesh.add_vertex(construct_point(p[0], p[1], p[2]));
  }
  for(int f = 0; f < surface.number_of_faces(); ++f)
  {
    const std::array<int, 3>& nodes = cut_mesh.nodes(f);
    typedef typename Mesh::Vertex_index Vertex_index;
    const auto face = mesh.add_face(Vertex_index(nodes[0]), Vertex_index(nodes[1]), Vertex_index(nodes[2]));
    CGAL_assertion(face != Mesh::null_face());
    auto h = mesh.halfedge(face);
    while(mesh.source(h) != Vertex_index(nodes[0]))
      h = mesh.next(h);
    mesh.set_halfedge(face, h);
  }
}

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_SOUP_MESH_H
