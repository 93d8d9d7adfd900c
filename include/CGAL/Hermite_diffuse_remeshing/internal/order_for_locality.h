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

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Hermite_diffuse_remeshing {
namespace internal {

// Numbers the faces that were read patch by patch, and the vertices in the order in which these faces use them, isolated
// ones last: what a query reads is then near in memory, however the mesh is stored. A patch is grown by a breadth-first
// search, and the next one begins beside the last. Unlike a space-filling curve the order does not depend on how the
// mesh lies in space, and it is the same for every type of mesh. `rank`, a map of faces to integers, has the
// ranks in the new order afterwards.
template <typename FaceRankMap, typename TriangleMesh, typename GeomTraits>
void order_for_locality(const FaceRankMap& rank, Input_mesh<TriangleMesh, GeomTraits>& input)
{
  // faces: what is known of so many, some hundred bytes of each, stays in the cache next to the processor
  constexpr std::size_t size_of_patch = 256;
  const TriangleMesh& tmesh = input.tmesh;
  const std::size_t n = input.face_descriptors.size();
  for(std::size_t i = 0; i < n; ++i)
    put(rank, input.face_descriptors[i], static_cast<int>(i));
  // the corner from which the others are counted: that of the vertex that was read first
  const auto first_corner = [&](const std::size_t f)
  {
    const std::array<int, 3>& t = input.triangles.triangles[f];
    return static_cast<int>(std::min_element(t.begin(), t.end()) - t.begin());
  };

  std::vector<std::size_t> order, seeds;
  order.reserve(n);
  std::vector<bool> is_ordered(n, false);
  const auto append = [&](const std::size_t f)
  {
    if(!is_ordered[f])
      order.push_back(f);
    is_ordered[f] = true;
  };
  for(std::size_t first = 0; first < n; ++first)
    for(seeds.push_back(first); !seeds.empty(); )
    {
      const std::size_t begin_of_patch = order.size();
      append(seeds.back());
      seeds.pop_back();
      for(std::size_t at = begin_of_patch; at < order.size(); ++at)
      {
        auto h = halfedge(input.face_descriptors[order[at]], tmesh);
        for(int k = first_corner(order[at]); k > 0; --k)
          h = next(h, tmesh);
        for(int k = 0; k < 3; ++k, h = next(h, tmesh))
        {
          if(is_border(opposite(h, tmesh), tmesh))
            continue;
          const std::size_t beside = get(rank, face(opposite(h, tmesh), tmesh));
          if(order.size() - begin_of_patch < size_of_patch)
            append(beside);
          else if(!is_ordered[beside])
            seeds.push_back(beside);
        }
      }
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
    for(int i = 0, k = first_corner(f); i < 3; ++i, k = next(k))
      number(t[k]);
    ordered.triangles.triangles.push_back({{number(t[0]), number(t[1]), number(t[2])}});
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
  for(std::size_t i = 0; i < n; ++i)
    put(rank, input.face_descriptors[i], static_cast<int>(i));
}

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_ORDER_FOR_LOCALITY_H
