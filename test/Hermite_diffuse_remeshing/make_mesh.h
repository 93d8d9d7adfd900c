#ifndef MAKE_MESH_H
#define MAKE_MESH_H

#include "analytic_surfaces.h"

#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/property_map.h>

#include <vector>

template <typename Mesh>
Mesh make_mesh(const analytic::Triangles& triangles)
{
  typedef typename boost::property_traits<typename boost::property_map<Mesh, CGAL::vertex_point_t>::type>::value_type
    Point;
  std::vector<Point> points;
  for(const analytic::Point& p : triangles.points)
    points.push_back(Point(p[0], p[1], p[2]));
  Mesh mesh;
  CGAL::Polygon_mesh_processing::polygon_soup_to_polygon_mesh(points, triangles.faces, mesh);
  return mesh;
}

#endif // MAKE_MESH_H
