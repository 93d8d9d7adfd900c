// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_ORDER_FOR_LOCALITY_H
#define CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_ORDER_FOR_LOCALITY_H

#include <CGAL/Hermite_diffuse_remeshing/internal/Indexed_triangles.h>

#include <CGAL/boost/graph/iterator.h>

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Hermite_diffuse_remeshing {
namespace internal {

// Numbers the faces that were read in the order of a breadth-first search over the mesh, and the vertices
// in the order in which these faces use them, isolated ones last: what a query reads is then near in memory,
// however the mesh is stored. Unlike a space-filling curve the order does not depend on how the mesh lies
// in space. `rank` is a temporary map of faces to integers.
template <typename TriangleMesh, typename FaceRankMap, typename Faces, typename Vertices>
void order_for_locality(const TriangleMesh& tmesh, const FaceRankMap& rank, Indexed_triangles& triangles,
                        Faces& faces, Vertices& vertices)
{
  const std::size_t n = faces.size();
  for(std::size_t i = 0; i < n; ++i)
    put(rank, faces[i], static_cast<int>(i));

  std::vector<int> order;                        // also the queue
  order.reserve(n);
  std::vector<bool> is_reached(n, false);
  for(std::size_t seed = 0; seed < n; ++seed)
  {
    const auto reach = [&](const std::size_t i)
    {
      if(!is_reached[i])
        order.push_back(static_cast<int>(i));
      is_reached[i] = true;
    };
    std::size_t next_in_queue = order.size();
    reach(seed);
    for(; next_in_queue < order.size(); ++next_in_queue)
      for(const auto h : CGAL::halfedges_around_face(halfedge(faces[order[next_in_queue]], tmesh), tmesh))
        if(!is_border(opposite(h, tmesh), tmesh))
          reach(get(rank, face(opposite(h, tmesh), tmesh)));
  }

  std::vector<int> new_vertex(vertices.size(), -1);
  Vertices ordered_vertices;
  Faces ordered_faces;
  Indexed_triangles ordered;
  ordered_vertices.reserve(vertices.size());
  ordered_faces.reserve(n);
  ordered.points.reserve(vertices.size());
  ordered.triangles.reserve(n);
  const auto number = [&](const int v)
  {
    if(new_vertex[v] == -1)
    {
      new_vertex[v] = ordered.number_of_vertices();
      ordered.points.push_back(triangles.points[v]);
      ordered_vertices.push_back(vertices[v]);
    }
    return new_vertex[v];
  };
  for(const int f : order)
  {
    const std::array<int, 3>& t = triangles.triangles[f];
    const int a = number(t[0]), b = number(t[1]), c = number(t[2]);
    ordered.triangles.push_back({{a, b, c}});
    ordered_faces.push_back(faces[f]);
  }
  for(std::size_t v = 0; v < vertices.size(); ++v)
    number(static_cast<int>(v));
  faces.swap(ordered_faces);
  vertices.swap(ordered_vertices);
  triangles = std::move(ordered);
}

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_ORDER_FOR_LOCALITY_H
