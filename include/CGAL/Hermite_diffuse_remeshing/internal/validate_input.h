// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_VALIDATE_INPUT_H
#define CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_VALIDATE_INPUT_H

#include <CGAL/Hermite_diffuse_remeshing/internal/Indexed_triangles.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Point_reader.h>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>

#include <boost/graph/graph_traits.hpp>

#include <array>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace CGAL {
namespace Hermite_diffuse_remeshing {
namespace internal {

// One sentence for the user: what was given, and what is accepted.
template <typename Value>
[[noreturn]] void refuse(const std::string& what, const Value& value, const std::string& accepted)
{
  std::ostringstream message;
  message << what << " is " << value << ": " << accepted;
  throw std::invalid_argument(message.str());
}

// A parameter in [smallest, largest]; NaN is never accepted.
inline void check_parameter(const char* name, const double value, const double smallest, const double largest)
{
  if(value >= smallest && value <= largest)
    return;
  std::ostringstream accepted;
  accepted << "it must be at least " << smallest;
  if(largest != std::numeric_limits<double>::infinity())
    accepted << " and at most " << largest;
  refuse(name, value, accepted.str());
}

inline void check_positive_parameter(const char* name, const double value)
{
  if(!(value > 0.))
    refuse(name, value, "it must be larger than zero");
}

// larger than zero, and not infinite
inline void check_finite_parameter(const char* name, const double value)
{
  check_positive_parameter(name, value);
  check_parameter(name, value, 0., (std::numeric_limits<double>::max)());
}

// The diameter of the mesh, which the defaults are relative to. Areas are multiplied, and the squares of lengths fitted.
inline double checked_diameter(const Indexed_triangles& triangles)
{
  // the fourth power of a length must neither overflow nor vanish
  constexpr double smallest = 1e-50, largest = 1e50;
  const double diameter = model_diameter(triangles);
  check_parameter("the diameter of the mesh", diameter, smallest, largest);
  return diameter;
}

// The user's mesh as indexed triangles: face i of the result is the i-th of faces(tmesh), with its
// corners from source(halfedge(f)) on, and vertex i the i-th of vertices(tmesh). Refuses, with
// std::invalid_argument and before anything is modified, a mesh without faces, faces that are not
// triangles, and points that are not finite.
template <typename TriangleMesh, typename VertexPointMap, typename GeomTraits>
Indexed_triangles read_triangles(const TriangleMesh& tmesh, const VertexPointMap& points, const GeomTraits& traits,
                                 std::vector<typename boost::graph_traits<TriangleMesh>::face_descriptor>& face_descriptors)
{
  typedef boost::graph_traits<TriangleMesh> Graph_traits;
  typedef typename Graph_traits::vertex_descriptor vertex_descriptor;
  typedef typename Graph_traits::halfedge_descriptor halfedge_descriptor;
  typedef typename Graph_traits::face_descriptor face_descriptor;

  if(faces(tmesh).begin() == faces(tmesh).end())
    throw std::invalid_argument("the mesh has no face: there is nothing to remesh");

  const Point_reader<GeomTraits> read_point(traits);
  auto index = get(CGAL::dynamic_vertex_property_t<int>(), tmesh);

  Indexed_triangles result;
  for(const vertex_descriptor v : vertices(tmesh))
  {
    const Vector point = read_point(get(points, v));
    put(index, v, result.number_of_vertices());
    if(!point.allFinite())
      refuse("a coordinate of vertex " + std::to_string(result.number_of_vertices()), "not a finite number",
             "all coordinates must be finite");
    result.points.push_back(point);
  }
  for(const face_descriptor f : faces(tmesh))
  {
    const halfedge_descriptor h = halfedge(f, tmesh);
    const std::size_t degree = CGAL::halfedges_around_face(h, tmesh).size();
    if(degree != 3)
      refuse("the number of sides of face " + std::to_string(result.number_of_faces()), degree,
             "all faces must be triangles");
    result.triangles.push_back({{get(index, source(h, tmesh)), get(index, target(h, tmesh)),
                                 get(index, target(next(h, tmesh), tmesh))}});
    face_descriptors.push_back(f);
  }
  return result;
}

// Refuses what no manifold has: a vertex whose faces are not one fan (or several that are joined by the
// border), and two edges between the same vertices.
template <typename TriangleMesh>
void check_is_manifold(const TriangleMesh& tmesh,
                       const std::vector<typename boost::graph_traits<TriangleMesh>::vertex_descriptor>& vertex_descriptors,
                       const Indexed_triangles& triangles)
{
  typedef boost::graph_traits<TriangleMesh> Graph_traits;
  const int n = triangles.number_of_vertices();
  std::vector<int> number_of_corners(n, 0), last_center(n, -1);
  for(const std::array<int, 3>& t : triangles.triangles)
    for(int k = 0; k < 3; ++k)
    {
      ++number_of_corners[t[k]];
      if(t[k] == t[next(k)])
        refuse("a corner of a face", "repeated, at vertex " + std::to_string(t[k]), "a triangle needs three vertices");
    }
  auto index = get(CGAL::dynamic_vertex_property_t<int>(), tmesh);
  for(int i = 0; i < n; ++i)
    put(index, vertex_descriptors[i], i);
  for(int i = 0; i < n; ++i)
  {
    const auto v = vertex_descriptors[i];
    if(halfedge(v, tmesh) == Graph_traits::null_halfedge())
      continue;
    int number = 0;
    for(const auto h : CGAL::halfedges_around_target(v, tmesh))
    {
      number += !CGAL::is_border(h, tmesh);
      const int other = get(index, source(h, tmesh));
      if(last_center[other] == i)
        refuse("the number of edges between vertices " + std::to_string(other) + " and " + std::to_string(i),
               "more than one", "two vertices may be joined once");
      last_center[other] = i;
    }
    if(number != number_of_corners[i])
      refuse("the number of fans of faces at vertex " + std::to_string(i), "more than one",
             "a surface passes once through a vertex; "
             "CGAL::Polygon_mesh_processing::duplicate_non_manifold_vertices() separates them");
  }
}

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_VALIDATE_INPUT_H
