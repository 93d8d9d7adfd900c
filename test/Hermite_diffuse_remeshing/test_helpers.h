#ifndef TEST_HELPERS_H
#define TEST_HELPERS_H

#include "analytic_surfaces.h"
#include "make_mesh.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Polygon_mesh_processing/hermite_diffuse_remesh.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/helpers.h>

#include <array>
#include <cassert>
#include <cmath>
#include <iostream>
#include <limits>
#include <set>
#include <string>
#include <vector>

namespace PMP = CGAL::Polygon_mesh_processing;
namespace params = CGAL::parameters;
namespace HDR = CGAL::Hermite_diffuse_remeshing;

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef Kernel::Point_3 Point_3;
typedef CGAL::Surface_mesh<Point_3> Surface_mesh;

inline HDR::internal::Indexed_triangles indexed(const analytic::Triangles& triangles)
{
  HDR::internal::Indexed_triangles result;
  for(const analytic::Point& p : triangles.points)
    result.points.push_back(HDR::internal::Vector(p[0], p[1], p[2]));
  for(const auto& f : triangles.faces)
    result.triangles.push_back({{int(f[0]), int(f[1]), int(f[2])}});
  return result;
}

template <typename Mesh>
Mesh read_data(const std::string& name)
{
  Mesh mesh;
  const bool is_read = PMP::IO::read_polygon_mesh(CGAL::data_file_path("meshes/" + name), mesh);
  assert(is_read && !CGAL::is_empty(mesh));
  return mesh;
}

template <typename Mesh>
analytic::Point coordinates(const Mesh& mesh, const typename boost::graph_traits<Mesh>::vertex_descriptor v)
{
  const Point_3& p = get(CGAL::vertex_point, mesh, v);
  return {{p.x(), p.y(), p.z()}};
}

template <typename Mesh>
std::size_t number_of_border_loops(const Mesh& mesh)
{
  typedef typename boost::graph_traits<Mesh>::halfedge_descriptor halfedge_descriptor;
  std::set<halfedge_descriptor> seen;
  std::size_t number = 0;
  for(const halfedge_descriptor h : halfedges(mesh))
    if(is_border(h, mesh) && seen.insert(h).second)
    {
      ++number;
      for(halfedge_descriptor g = next(h, mesh); g != h; g = next(g, mesh))
        seen.insert(g);
    }
  return number;
}

// number of vertices, edges and faces; the containers may hold removed elements
template <typename Mesh>
std::array<long, 3> numbers(const Mesh& mesh)
{
  std::array<long, 3> n = {{0, 0, 0}};
  n[0] = long(std::distance(vertices(mesh).begin(), vertices(mesh).end()));
  n[1] = long(std::distance(edges(mesh).begin(), edges(mesh).end()));
  n[2] = long(std::distance(faces(mesh).begin(), faces(mesh).end()));
  return n;
}

template <typename Mesh>
long euler_characteristic(const Mesh& mesh)
{
  const std::array<long, 3> n = numbers(mesh);
  return n[0] - n[1] + n[2];
}

// The corners that the classification finds in a mesh after its repair, and the vertices at which the remeshing, in its
// own order of the faces, cuts closed feature curves. `bound`: of the distance, which the repair keeps
template <typename Mesh>
std::vector<analytic::Point> corners(const Mesh& mesh, const double sharp_angle = 40.,
                                     const double bound = std::numeric_limits<double>::infinity())
{
  using namespace HDR::internal;
  const auto named = pack(params::sharp_dihedral_angle(sharp_angle).maximum_displacement(bound));
  auto input = read_input<Kernel>(mesh, named);
  order_for_locality(get(CGAL::dynamic_face_property_t<int>(), mesh), input);
  std::vector<char> is_remeshed(input.face_descriptors.size(), true);
  HDR::Remeshing_report<Mesh> report;
  plan_repairs(input, named, is_remeshed, report);
  const Indexed_triangles& triangles = input.triangles;
  const Input_model model(triangles, read_feature_options(named), Model_options(),
                          [](int, int) { return HDR::internal::UNMARKED_EDGE; }, [](int) { return false; });
  std::vector<analytic::Point> result;
  for(int v = 0; v < triangles.number_of_vertices(); ++v)
    if(is_corner(model.vertex_classes[v]))
      result.push_back({{triangles.points[v][0], triangles.points[v][1], triangles.points[v][2]}});
  return result;
}

template <typename Mesh>
bool has_all_points(const Mesh& mesh, const std::vector<analytic::Point>& points)
{
  std::set<analytic::Point> present;
  for(const auto v : vertices(mesh))
    present.insert(coordinates(mesh, v));
  for(const analytic::Point& p : points)
    if(present.count(p) == 0)
      return false;
  return true;
}

// what every result must satisfy
template <typename Mesh>
void check_result(const Mesh& input, const Mesh& output, const double sharp_angle = 40.,
                  const double bound = std::numeric_limits<double>::infinity())
{
  assert(CGAL::is_valid_polygon_mesh(output));
  assert(CGAL::is_triangle_mesh(output));
  assert(euler_characteristic(output) == euler_characteristic(input));
  assert(number_of_border_loops(output) == number_of_border_loops(input));
  assert(!PMP::does_self_intersect(output));
  assert(has_all_points(output, corners(input, sharp_angle, bound)));
}

// same connectivity, element by element, and points that differ by at most `tolerance`
template <typename Mesh, typename Transformation>
bool is_image(const Mesh& mesh, const Mesh& image, const Transformation& transformation, const double tolerance)
{
  if(numbers(mesh) != numbers(image))
    return false;
  auto v = vertices(image).begin();
  for(const auto u : vertices(mesh))
  {
    const Point_3 expected = transformation(get(CGAL::vertex_point, mesh, u));
    if(CGAL::squared_distance(expected, get(CGAL::vertex_point, image, *v++)) > tolerance * tolerance)
      return false;
  }
  auto index = get(CGAL::dynamic_vertex_property_t<std::size_t>(), mesh);
  auto image_index = get(CGAL::dynamic_vertex_property_t<std::size_t>(), image);
  std::size_t i = 0;
  for(const auto u : vertices(mesh))
    put(index, u, i++);
  i = 0;
  for(const auto u : vertices(image))
    put(image_index, u, i++);
  auto f = faces(image).begin();
  for(const auto g : faces(mesh))
  {
    auto h = halfedge(g, mesh), k = halfedge(*f++, image);
    for(int side = 0; side < 3; ++side, h = next(h, mesh), k = next(k, image))
      if(get(index, target(h, mesh)) != get(image_index, target(k, image)))
        return false;
  }
  return true;
}

#endif // TEST_HELPERS_H
