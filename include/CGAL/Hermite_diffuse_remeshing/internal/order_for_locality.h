// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_ORDER_FOR_LOCALITY_H
#define CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_ORDER_FOR_LOCALITY_H

#include <CGAL/Hermite_diffuse_remeshing/internal/read_input.h>

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
// in space. `rank` is a map of faces to integers, and is overwritten.
template <typename FaceRankMap, typename TriangleMesh, typename GeomTraits>
void order_for_locality(const FaceRankMap& rank, Input_mesh<TriangleMesh, GeomTraits>& input)
{
  const TriangleMesh& tmesh = input.tmesh;
  const std::size_t n = input.face_descriptors.size();
  for(std::size_t i = 0; i < n; ++i)
    put(rank, input.face_descriptors[i], static_cast<int>(i));

  std::vector<std::size_t> order;                // also the queue
  order.reserve(n);
  std::vector<bool> is_reached(n, false);
  const auto reach = [&](const std::size_t i)
  {
    if(!is_reached[i])
      order.push_back(i);
    is_reached[i] = true;
  };
  for(std::size_t seed = 0; seed < n; ++seed)
  {
    std::size_t at = order.size();
    reach(seed);
    for(; at < order.size(); ++at)
      for(const auto h : CGAL::halfedges_around_face(halfedge(input.face_descriptors[order[at]], tmesh), tmesh))
        if(!is_border(opposite(h, tmesh), tmesh))
          reach(get(rank, face(opposite(h, tmesh), tmesh)));
  }

  Input_mesh<TriangleMesh, GeomTraits> ordered = {tmesh, input.traits, {}, {}, {}, {}, {}};
  std::vector<int> new_vertex(input.vertex_descriptors.size(), -1);
  const auto number = [&](const std::size_t v)
  {
    if(new_vertex[v] == -1)
    {
      new_vertex[v] = ordered.triangles.number_of_vertices();
      ordered.triangles.points.push_back(input.triangles.points[v]);
      ordered.vertex_descriptors.push_back(input.vertex_descriptors[v]);
    }
    return new_vertex[v];
  };
  for(const std::size_t f : order)
  {
    const std::array<int, 3>& t = input.triangles.triangles[f];
    const int a = number(t[0]), b = number(t[1]), c = number(t[2]);
    ordered.triangles.triangles.push_back({{a, b, c}});
    ordered.face_descriptors.push_back(input.face_descriptors[f]);
    ordered.side_marks.push_back(input.side_marks[f]);
    ordered.face_ranks.push_back(input.face_ranks[f]);
  }
  for(std::size_t v = 0; v < new_vertex.size(); ++v)
    number(v);
  ordered.face_descriptors.shrink_to_fit();
  input.vertex_descriptors.swap(ordered.vertex_descriptors);
  input.face_descriptors.swap(ordered.face_descriptors);
  input.side_marks.swap(ordered.side_marks);
  input.face_ranks.swap(ordered.face_ranks);
  std::swap(input.triangles, ordered.triangles);
}

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_ORDER_FOR_LOCALITY_H
