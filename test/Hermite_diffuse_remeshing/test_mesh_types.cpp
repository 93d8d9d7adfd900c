// Types of meshes, kernels, traits and point maps: all of them give the result of Surface_mesh with CGAL's
// default kernel.

#include "archetypes.h"
#include "test_helpers.h"

#include <CGAL/Hermite_diffuse_remeshing/sizes_from_errors.h>
#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/Linear_cell_complex_for_bgl_combinatorial_map_helper.h>
#include <CGAL/Polygon_mesh_processing/Hermite_diffuse_sizing_field.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/boost/graph/graph_traits_Linear_cell_complex_for_combinatorial_map.h>

#ifdef HAS_OPENMESH
#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <CGAL/boost/graph/graph_traits_PolyMesh_ArrayKernelT.h>
#include <CGAL/boost/graph/graph_traits_TriMesh_ArrayKernelT.h>
#endif

#include <functional>
#include <limits>
#include <map>

// joint.off: 446 slivers and 12 corners
struct Soup
{
  std::vector<Point_3> points;
  std::vector<std::array<std::size_t, 3> > triangles;
};

Soup read_soup()
{
  Soup soup;
  const bool is_read = CGAL::IO::read_polygon_soup(CGAL::data_file_path("meshes/joint.off"), soup.points, soup.triangles);
  assert(is_read);
  return soup;
}

template <typename Mesh>
Mesh make(const Soup& soup)
{
  typedef typename boost::graph_traits<Mesh>::vertex_descriptor vertex_descriptor;
  typedef typename boost::property_traits<typename boost::property_map<Mesh, CGAL::vertex_point_t>::type>::value_type
    Point;
  Mesh mesh;
  auto points = get(CGAL::vertex_point, mesh);
  std::vector<vertex_descriptor> vertices;
  for(const Point_3& p : soup.points)
  {
    vertices.push_back(add_vertex(mesh));
    put(points, vertices.back(), Point(p.x(), p.y(), p.z()));
  }
  for(const auto& t : soup.triangles)
    CGAL::Euler::add_face(std::array<vertex_descriptor, 3>{{vertices[t[0]], vertices[t[1]], vertices[t[2]]}}, mesh);
  return mesh;
}

// the points of a mesh, in any order
template <typename Mesh>
std::multiset<analytic::Point> points_of(const Mesh& mesh)
{
  std::multiset<analytic::Point> result;
  const auto points = get(CGAL::vertex_point, mesh);
  for(const auto v : vertices(mesh))
  {
    const auto& p = get(points, v);
    result.insert({{double(p.x()), double(p.y()), double(p.z())}});
  }
  return result;
}

constexpr double approximation_error = 0.05;

template <typename Mesh>
HDR::Remeshing_report<Mesh> remesh_and_check(const char* name, Mesh& mesh)
{
  std::cout << name << std::flush;
  const long characteristic = euler_characteristic(mesh);
  const auto report = PMP::hermite_diffuse_remesh(mesh, params::approximation_error(approximation_error));
  std::cout << ": " << report.number_of_faces << " faces, smallest quality " << report.smallest_quality << std::endl;
  assert(CGAL::is_valid_polygon_mesh(mesh));
  assert(CGAL::is_triangle_mesh(mesh));
  assert(euler_characteristic(mesh) == characteristic);
  assert(report.stop_reason == HDR::CONVERGED);
  assert(std::size_t(numbers(mesh)[0]) == report.number_of_vertices);
  assert(std::size_t(numbers(mesh)[2]) == report.number_of_faces);
  return report;
}

double distance_to(const std::multiset<analytic::Point>& points, const analytic::Point& p)
{
  double smallest = std::numeric_limits<double>::infinity();
  for(const analytic::Point& q : points)
    smallest = (std::min)(smallest, std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]));
  return smallest;
}

// A mesh with points in single precision gives, but for the rounding of the result, what the same points give in
// double precision.
template <typename Mesh>
void test_single_precision(const char* name, const Soup& soup)
{
  Mesh mesh = make<Mesh>(soup);
  Soup rounded = soup;
  auto p = rounded.points.begin();
  for(const auto v : vertices(mesh))
  {
    const auto& q = get(CGAL::vertex_point, mesh, v);
    *p++ = Point_3(q.x(), q.y(), q.z());
  }
  const Surface_mesh input = make<Surface_mesh>(rounded);
  Surface_mesh expected = input;
  PMP::hermite_diffuse_remesh(expected, params::approximation_error(approximation_error));

  remesh_and_check(name, mesh);
  assert(numbers(mesh) == numbers(expected));
  const std::multiset<analytic::Point> result = points_of(mesh), expected_result = points_of(expected);
  // coordinates are below 1
  for(const analytic::Point& q : result)
    assert(distance_to(expected_result, q) < std::numeric_limits<float>::epsilon());
  for(const analytic::Point& corner : corners(input))
    assert(result.count(corner) == 1);
}

template <typename Mesh>
void test_double_precision(const char* name, const Soup& soup, const Surface_mesh& expected)
{
  Mesh mesh = make<Mesh>(soup);
  remesh_and_check(name, mesh);
  assert(numbers(mesh) == numbers(expected));
  assert(points_of(mesh) == points_of(expected));
}

// ---- points outside of the mesh, and traits that are no kernel

struct External_points
{
  typedef Surface_mesh::Vertex_index key_type;
  typedef archetype::Point value_type;
  typedef value_type reference;
  typedef boost::read_write_property_map_tag category;

  std::map<key_type, value_type>* points;

  friend value_type get(const External_points& map, const key_type v) { return map.points->at(v); }
  friend void put(const External_points& map, const key_type v, const value_type& p)
  {
    map.points->erase(v);
    map.points->emplace(v, p);
  }
};

typedef std::map<Surface_mesh::Vertex_index, archetype::Point> Point_table;

// the mesh of a soup, its points outside
Surface_mesh make_without_points(const Soup& soup, Point_table& points)
{
  Surface_mesh mesh = make<Surface_mesh>(soup);
  for(const auto v : mesh.vertices())
  {
    const Point_3 p = mesh.point(v);
    points.emplace(v, archetype::Point(p.x(), p.y(), p.z()));
    mesh.point(v) = Point_3(0., 0., 0.);                           // where nobody looks
  }
  return mesh;
}

void test_archetypes(const Soup& soup, const Surface_mesh& expected)
{
  std::cout << "archetypes" << std::endl;
  Point_table points;
  Surface_mesh mesh = make_without_points(soup, points);
  archetype::Calls calls;
  archetype::Visitor<Surface_mesh> visitor;
  const auto report = PMP::hermite_diffuse_remesh(mesh, params::approximation_error(approximation_error)
    .size_field(archetype::Size_field(1e3))                        // larger than the mesh
    .vertex_point_map(External_points{&points})
    .geom_traits(archetype::Traits(calls))
    .visitor(std::ref(visitor)));
  assert(numbers(mesh) == numbers(expected));
  std::multiset<analytic::Point> result;
  for(const auto v : mesh.vertices())
  {
    const archetype::Point& p = points.at(v);
    result.insert({{p.c[0], p.c[1], p.c[2]}});
  }
  assert(result == points_of(expected));
  assert(visitor.number_of_stages == report.stages.size() && visitor.number_of_splits == report.number_of_splits);
  // the coordinates are read once, and a point is made for every change and every question to the field
  assert(calls.reads == 3 * soup.points.size());
  assert(calls.constructions > report.number_of_splits + report.number_of_relocations);
}

// what gives sizes reads points by the traits alone
void test_archetypes_of_sizes(const Soup& soup)
{
  std::cout << "archetypes of sizes" << std::endl;
  const Surface_mesh plain = make<Surface_mesh>(soup);
  Point_table points;
  Surface_mesh mesh = make_without_points(soup, points);
  const External_points point_map{&points};
  archetype::Calls calls;

  const PMP::Hermite_diffuse_sizing_field<Surface_mesh, archetype::Traits, External_points> sizing(
    mesh, params::approximation_error(approximation_error).vertex_point_map(point_map)
                                                          .geom_traits(archetype::Traits(calls)));
  const PMP::Hermite_diffuse_sizing_field<Surface_mesh> plain_sizing(plain,
                                                                     params::approximation_error(approximation_error));
  int number_of_long_edges = 0, number_of_short_edges = 0;
  for(const auto h : halfedges(mesh))
  {
    const auto v = source(h, mesh), w = target(h, mesh);
    assert(sizing.at(v, mesh) == plain_sizing.at(v, plain));
    assert(sizing.is_too_long(v, w, mesh) == plain_sizing.is_too_long(v, w, plain));
    assert(sizing.is_too_short(h, mesh) == plain_sizing.is_too_short(h, plain));
    number_of_long_edges += bool(sizing.is_too_long(v, w, mesh));
    number_of_short_edges += bool(sizing.is_too_short(h, mesh));
    const Point_3 middle = plain_sizing.split_placement(h, plain);
    const archetype::Point p = sizing.split_placement(h, mesh);
    assert(Point_3(p.c[0], p.c[1], p.c[2]) == middle);
    assert(CGAL::squared_distance(middle, CGAL::midpoint(plain.point(v), plain.point(w))) < 1e-30);
  }
  assert(number_of_long_edges > 100 && number_of_short_edges > 100);

  const auto errors = mesh.add_property_map<Surface_mesh::Face_index, double>("f:error", 1.).first;
  const auto sizes = mesh.add_property_map<Surface_mesh::Vertex_index, double>("v:size").first;
  const auto plain_sizes = mesh.add_property_map<Surface_mesh::Vertex_index, double>("v:plain_size").first;
  calls = archetype::Calls();
  HDR::sizes_for_error(mesh, errors, 1., 10., sizes,
                       CGAL::parameters::vertex_point_map(point_map).geom_traits(archetype::Traits(calls)));
  HDR::sizes_for_error(plain, errors, 1., 10., plain_sizes);
  assert(calls.reads == 3 * soup.points.size() && calls.constructions == 0);
  for(const auto v : vertices(mesh))
    assert(sizes[v] > 0. && sizes[v] == plain_sizes[v]);
}

int main()
{
  const Soup soup = read_soup();
  Surface_mesh expected = make<Surface_mesh>(soup);
  remesh_and_check("Surface_mesh", expected);

  test_double_precision<CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3> >
    ("Surface_mesh, Simple_cartesian<double>", soup, expected);
  test_single_precision<CGAL::Surface_mesh<CGAL::Simple_cartesian<float>::Point_3> >
    ("Surface_mesh, Simple_cartesian<float>", soup);
  typedef CGAL::Linear_cell_complex_traits<3, Kernel> LCC_traits;
  test_double_precision<CGAL::Linear_cell_complex_for_bgl_combinatorial_map_helper<2, 3, LCC_traits>::type>
    ("Linear_cell_complex", soup, expected);
#ifdef HAS_OPENMESH
  // CGAL's map of their points rounds to single precision
  test_single_precision<OpenMesh::TriMesh_ArrayKernelT<> >("OpenMesh::TriMesh_ArrayKernelT", soup);
  test_single_precision<OpenMesh::PolyMesh_ArrayKernelT<> >("OpenMesh::PolyMesh_ArrayKernelT", soup);
#else
  std::cout << "OpenMesh was not found" << std::endl;
#endif
  test_archetypes(soup, expected);
  test_archetypes_of_sizes(soup);
  std::cout << "done" << std::endl;
  return EXIT_SUCCESS;
}
