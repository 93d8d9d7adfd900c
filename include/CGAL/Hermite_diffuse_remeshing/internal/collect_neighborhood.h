// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_COLLECT_NEIGHBORHOOD_H
#define CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_COLLECT_NEIGHBORHOOD_H

#include <CGAL/Hermite_diffuse_remeshing/internal/Point_reader.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/validate_input.h>

#include <CGAL/boost/graph/iterator.h>

#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

namespace CGAL {
namespace Hermite_diffuse_remeshing {
namespace internal {

// The faces of a mesh within a number of edges of a vertex, as indexed triangles, with their descriptors.
// They are found ring after ring, in the order of the halfedges. Only the sheet of `halfedge(v)` is
// found at a vertex where several touch.
template <typename TriangleMesh, typename VertexPointMap, typename GeomTraits>
Indexed_triangles
collect_neighborhood(const typename boost::graph_traits<TriangleMesh>::vertex_descriptor v, const TriangleMesh& tmesh,
                     const int number_of_rings, const VertexPointMap& points, const GeomTraits& traits,
                     std::vector<typename boost::graph_traits<TriangleMesh>::vertex_descriptor>& vertex_descriptors,
                     std::vector<typename boost::graph_traits<TriangleMesh>::face_descriptor>& face_descriptors)
{
  typedef boost::graph_traits<TriangleMesh> Graph_traits;
  typedef typename Graph_traits::vertex_descriptor vertex_descriptor;
  typedef typename Graph_traits::halfedge_descriptor halfedge_descriptor;
  typedef typename Graph_traits::face_descriptor face_descriptor;

  const Point_reader<GeomTraits> read_point(traits);
  Indexed_triangles result;
  std::unordered_map<vertex_descriptor, int> index;
  const auto index_of = [&](const vertex_descriptor w)
  {
    const auto inserted = index.insert(std::make_pair(w, result.number_of_vertices()));
    if(inserted.second)
    {
      const Vector point = read_point(get(points, w));
      if(!point.allFinite())
        refuse("a coordinate of a vertex", "not a finite number", "all coordinates must be finite");
      result.points.push_back(point);
      vertex_descriptors.push_back(w);
    }
    return inserted.first->second;
  };

  index_of(v);
  std::unordered_set<face_descriptor> known;
  std::size_t first = 0;
  for(int ring = 0; ring < number_of_rings; ++ring)
  {
    const std::size_t last = vertex_descriptors.size();
    for(; first < last; ++first)
    {
      const vertex_descriptor w = vertex_descriptors[first];
      if(halfedge(w, tmesh) == Graph_traits::null_halfedge())
        continue;
      for(const halfedge_descriptor h : CGAL::halfedges_around_target(w, tmesh))
      {
        if(is_border(h, tmesh) || !known.insert(face(h, tmesh)).second)
          continue;
        const halfedge_descriptor g = halfedge(face(h, tmesh), tmesh);
        const std::size_t degree = CGAL::halfedges_around_face(g, tmesh).size();
        if(degree != 3)
          refuse("the number of sides of a face", degree, "all faces must be triangles");
        const int a = index_of(source(g, tmesh)), b = index_of(target(g, tmesh));
        result.triangles.push_back({{a, b, index_of(target(next(g, tmesh), tmesh))}});
        face_descriptors.push_back(face(h, tmesh));
      }
    }
  }
  return result;
}

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_COLLECT_NEIGHBORHOOD_H
