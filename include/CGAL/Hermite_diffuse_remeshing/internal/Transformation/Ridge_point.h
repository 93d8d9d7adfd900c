// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_RIDGE_POINT_H
#define CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_RIDGE_POINT_H

#include <CGAL/Hermite_diffuse_remeshing/internal/Model/crossing_of_ridge.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Transformation/closest_face.h>

#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Hermite_diffuse_remeshing {
namespace internal {

// A point of a ridge of the model. A ridge is farther from the mesh than the mesh from the slopes at its sides.
struct Ridge_point
{
  Location location;
  Vector point = Vector::Zero();
  double distance = 0.;                 // to the mesh
};

// `f`: a face of the mesh near it
template <typename UserMesh>
Ridge_point measure_ridge_point(const Working_mesh<UserMesh>& mesh, const Location& location,
                                const typename Working_mesh<UserMesh>::face_descriptor f)
{
  Ridge_point result;
  result.location = location;
  result.point = mesh.reference().surface_point(location);
  result.distance = std::sqrt(walk_to_closest(mesh, f, result.point).distance2);
  return result;
}

// those above the edge of h
template <typename UserMesh>
boost::container::small_vector<Ridge_point, 4>
ridge_points_over_edge(const Working_mesh<UserMesh>& mesh, const typename Working_mesh<UserMesh>::halfedge_descriptor h)
{
  const Reference& reference = mesh.reference();
  const Site& from = mesh.site(source(h, mesh.tmesh()));
  // of a place on a curve the face on our side
  const int first = from.has_normal() ? from.location.face : reference.locator.walk(from.point, mesh.hint(h)).face;
  boost::container::small_vector<Ridge_point, 4> result;
  for(const Location& crossing :
      crossings_of_ridges(reference.surface, first, from.point, mesh.point(target(h, mesh.tmesh()))))
    result.push_back(measure_ridge_point(mesh, crossing, face(h, mesh.tmesh())));
  return result;
}

// the edge of the reference that a place on a side of a face is on
inline int edge_of_reference(const Reference& reference, const Location& location)
{
  int side = 0;
  while(side < 2 && location.coordinates[previous(side)] != 0.)
    ++side;
  return reference.edges.edge(location.face, side);
}

// Between two edges of a face a ridge bends away from it. Halfway between two places on an edge of the reference, which is
// straight, is one on the same edge.
template <typename UserMesh>
Ridge_point ridge_point_between(const Working_mesh<UserMesh>& mesh, const Location& first, const Location& second,
                                const typename Working_mesh<UserMesh>::face_descriptor f)
{
  const Reference& reference = mesh.reference();
  const Indexed_triangles& triangles = reference.surface.triangles();
  const Location middle = reference.locator.walk((triangles.point(first) + triangles.point(second)) / 2., first.face);
  return measure_ridge_point(mesh, middle, f);
}

// where the edges of the face cross ridges, and between two places on the same edge of the reference
template <typename UserMesh>
std::vector<Ridge_point> ridge_points_over_face(const Working_mesh<UserMesh>& mesh,
                                                const typename Working_mesh<UserMesh>::face_descriptor f)
{
  std::vector<Ridge_point> result;
  for(const auto h : CGAL::halfedges_around_face(halfedge(f, mesh.tmesh()), mesh.tmesh()))
    if(!mesh.is_on_curve(h))
      for(const Ridge_point& ridge : ridge_points_over_edge(mesh, h))
        result.push_back(ridge);
  const std::size_t number_at_edges = result.size();
  for(std::size_t i = 0; i < number_at_edges; ++i)
    for(std::size_t j = 0; j < i; ++j)
      if(edge_of_reference(mesh.reference(), result[i].location) == edge_of_reference(mesh.reference(), result[j].location))
        result.push_back(ridge_point_between(mesh, result[j].location, result[i].location, f));
  return result;
}

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_RIDGE_POINT_H
