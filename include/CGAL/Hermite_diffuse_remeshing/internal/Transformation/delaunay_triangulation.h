// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_DELAUNAY_TRIANGULATION_H
#define CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_DELAUNAY_TRIANGULATION_H

#include <CGAL/Hermite_diffuse_remeshing/internal/Indexed_triangles.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Transformation/polygon_triangulations.h>

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Constrained_triangulation_face_base_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_2_algorithms.h>
#include <CGAL/Triangulation_data_structure_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Hermite_diffuse_remeshing {
namespace internal {

// The constrained Delaunay triangulation of a polygon in the plane across `normal`, in O(n log n). There are no
// triangles where the plane does not see the polygon as a simple one, counterclockwise.
inline Polygon_triangulation delaunay_triangulation(const std::vector<Vector>& corners, const Vector& normal)
{
  typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
  typedef CGAL::Triangulation_vertex_base_with_info_2<int, Kernel> Vertex_base;
  typedef CGAL::Constrained_triangulation_face_base_2<Kernel> Face_base;
  typedef CGAL::Triangulation_data_structure_2<Vertex_base, Face_base> Data_structure;
  typedef CGAL::Constrained_Delaunay_triangulation_2<Kernel, Data_structure> Triangulation;

  const int n = static_cast<int>(corners.size());
  const Vector x = normal.unitOrthogonal(), y = normal.normalized().cross(x);
  std::vector<Kernel::Point_2> points;
  for(const Vector& corner : corners)
  {
    const Vector d = corner - corners.front();
    points.push_back(Kernel::Point_2(d.dot(x), d.dot(y)));
  }
  Polygon_triangulation result;
  if(!CGAL::is_simple_2(points.begin(), points.end(), Kernel())
     || CGAL::orientation_2(points.begin(), points.end(), Kernel()) != CGAL::COUNTERCLOCKWISE)
    return result;

  Triangulation triangulation;
  std::vector<Triangulation::Vertex_handle> vertices;
  for(int i = 0; i < n; ++i)
  {
    vertices.push_back(triangulation.insert(points[i]));
    vertices.back()->info() = i;
  }
  for(int i = 0; i < n; ++i)
    triangulation.insert_constraint(vertices[i], vertices[(i + 1) % n]);
  // Triangles inside have their corners in the order of the polygon, those between it and its hull in the other.
  for(const Triangulation::Face_handle f : triangulation.finite_face_handles())
  {
    Corner_triple t = {{f->vertex(0)->info(), f->vertex(1)->info(), f->vertex(2)->info()}};
    std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
    if(t[1] < t[2])
      result.push_back(t);
  }
  CGAL_postcondition(result.size() + 2 == corners.size());
  return result;
}

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_DELAUNAY_TRIANGULATION_H
