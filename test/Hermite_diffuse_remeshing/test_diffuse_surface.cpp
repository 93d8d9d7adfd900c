// The public surface as an object: what it asks of its traits, how much memory it takes, threads, and meshes
// that are stored in any order.

#include "archetypes.h"
#include "irregular_meshes.h"
#include "is_refused.h"

#include <CGAL/Hermite_diffuse_surface.h>
#include <CGAL/Polygon_mesh_processing/hermite_diffuse_classify_faces.h>
#include <CGAL/Polygon_mesh_processing/hermite_diffuse_curvatures.h>

#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/Euler_operations.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#endif

#ifdef __GLIBC__
#include <malloc.h>
#endif

#include <algorithm>
#include <cassert>
#include <iostream>
#include <limits>
#include <map>

namespace PMP = CGAL::Polygon_mesh_processing;
namespace np = CGAL::parameters;
typedef CGAL::Simple_cartesian<double> Kernel;

template <typename Mesh>
Mesh make_mesh(const analytic::Triangles& triangles)
{
  typedef typename boost::graph_traits<Mesh>::vertex_descriptor vertex_descriptor;
  Mesh mesh;
  const auto vpm = get(CGAL::vertex_point, mesh);
  std::vector<vertex_descriptor> vertices;
  for(const analytic::Point& p : triangles.points)
  {
    vertices.push_back(add_vertex(mesh));
    put(vpm, vertices.back(), Kernel::Point_3(p[0], p[1], p[2]));
  }
  for(const auto& f : triangles.faces)
    CGAL::Euler::add_face(std::array<vertex_descriptor, 3>{{vertices[f[0]], vertices[f[1]], vertices[f[2]]}}, mesh);
  return mesh;
}

typedef CGAL::Surface_mesh<Kernel::Point_3> Surface_mesh;
typedef CGAL::Polyhedron_3<Kernel> Polyhedron;

// points that are kept outside of the mesh
struct Archetype_point_map
{
  typedef Surface_mesh::Vertex_index key_type;
  typedef archetype::Point value_type;
  typedef value_type reference;
  typedef boost::readable_property_map_tag category;

  const Surface_mesh* mesh;

  friend value_type get(const Archetype_point_map& map, const key_type v)
  {
    const Kernel::Point_3& p = map.mesh->point(v);
    return value_type(p.x(), p.y(), p.z());
  }
};

void test_archetype()
{
  const Surface_mesh mesh = make_mesh<Surface_mesh>(analytic::torus().mesh(500, 1));
  const Archetype_point_map points{&mesh};
  typedef CGAL::Hermite_diffuse_remeshing::Principal_curvatures_and_directions<archetype::Traits> Principal;
  const auto np_of_archetype = np::polynomial_degree(3).vertex_point_map(points).geom_traits(archetype::Traits());
  const CGAL::Hermite_diffuse_surface<Surface_mesh, archetype::Traits> surface(mesh, np_of_archetype);
  const CGAL::Hermite_diffuse_surface<Surface_mesh> expected(mesh);
  for(const auto f : mesh.faces())
  {
    const std::array<double, 3> l = {{0.2, 0.3, 0.5}};
    const archetype::Point p = surface.point({f, l});
    const Kernel::Point_3 q = expected.point({f, l});
    assert(p.c[0] == q.x() && p.c[1] == q.y() && p.c[2] == q.z());
    const archetype::Vector n = surface.normal({f, l});
    const Kernel::Vector_3 m = expected.normal({f, l});
    assert(n.c[0] == m.x() && n.c[1] == m.y() && n.c[2] == m.z());
    assert(surface.principal_curvatures({f, l}) == expected.principal_curvatures({f, l}));
    const Principal k = surface.principal_curvatures_and_directions({f, l});
    assert(k.max_curvature > k.min_curvature);
    assert(surface.principal_curvatures({f, l}) == std::make_pair(k.max_curvature, k.min_curvature));
    assert(surface.project(p).first != Surface_mesh::null_face());
    assert(surface.project(p, {f, l}) == expected.project(q, {f, l}));
    assert(surface.locate(p) == expected.locate(q));
  }

  std::map<Surface_mesh::Vertex_index, double> mean;
  std::map<Surface_mesh::Vertex_index, double> gaussian;
  PMP::hermite_diffuse_curvatures(mesh, np::vertex_mean_curvature_map(boost::make_assoc_property_map(mean))
                                          .vertex_Gaussian_curvature_map(boost::make_assoc_property_map(gaussian))
                                          .vertex_point_map(points).geom_traits(archetype::Traits()));
  double one = 0.;
  PMP::hermite_diffuse_curvatures(*mesh.vertices().begin(), mesh,
                                  np::vertex_mean_curvature(std::ref(one)).vertex_point_map(points)
                                    .geom_traits(archetype::Traits()));
  assert(mean.size() == mesh.number_of_vertices() && gaussian.size() == mean.size());
  assert(std::abs(one - mean[*mesh.vertices().begin()]) < 1e-9);

  std::map<Surface_mesh::Face_index, std::size_t> labels, expected_labels;
  const auto shapes = PMP::hermite_diffuse_classify_faces(
    mesh, boost::make_assoc_property_map(labels), np::vertex_point_map(points).geom_traits(archetype::Traits()));
  const auto expected_shapes =
    PMP::hermite_diffuse_classify_faces(mesh, boost::make_assoc_property_map(expected_labels));
  assert(labels == expected_labels && shapes.size() == expected_shapes.size());
  assert(shapes[0].number_of_faces == expected_shapes[0].number_of_faces);
  assert(shapes[0].point.c[0] == expected_shapes[0].point.x() && shapes[0].radius == expected_shapes[0].radius);
}

// ---- memory

#if defined(__GLIBC__) && defined(__GLIBC_PREREQ)
#if __GLIBC_PREREQ(2, 33)
#define CAN_COUNT_BYTES
double bytes_in_use()
{
  const struct mallinfo2 info = mallinfo2();
  return double(info.uordblks) + double(info.hblkhd);
}
#endif
#endif

void test_memory()
{
#ifdef CAN_COUNT_BYTES
  for(const analytic::Test_surface& s : {analytic::torus(), analytic::sin_cos()})
  {
    const Surface_mesh mesh = make_mesh<Surface_mesh>(s.mesh(20000, 1));
    const double before = bytes_in_use();
    const CGAL::Hermite_diffuse_surface<Surface_mesh> surface(mesh);
    surface.locate(Kernel::Point_3(0., 0., 0.));        // nothing is left to be built by the first query
    const double per_face = (bytes_in_use() - before) / mesh.number_of_faces();
    std::cout << s.name << ": " << per_face << " bytes per face" << std::endl;
    assert(per_face < 150.);
  }
#endif
}

// ---- threads

#ifdef CGAL_LINKED_WITH_TBB
void test_threads()
{
  const Surface_mesh mesh = make_mesh<Surface_mesh>(analytic::sin_cos(6.).mesh(4000, 1));
  typedef CGAL::Hermite_diffuse_remeshing::Principal_curvatures_and_directions<Kernel> Principal;
  typedef CGAL::Hermite_diffuse_surface<Surface_mesh, Kernel, CGAL::Parallel_tag> Parallel_surface;
  const CGAL::Hermite_diffuse_surface<Surface_mesh> expected(mesh);
  auto expected_curvatures = get(CGAL::dynamic_vertex_property_t<Principal>(), mesh);
  PMP::hermite_diffuse_curvatures(mesh, np::vertex_principal_curvatures_and_directions_map(expected_curvatures));
  const Surface_mesh torus = make_mesh<Surface_mesh>(analytic::torus().mesh(2000, 1));
  auto expected_labels = get(CGAL::dynamic_face_property_t<std::size_t>(), torus);
  const auto expected_shapes = PMP::hermite_diffuse_classify_faces(torus, expected_labels);
  for(const int number_of_threads : {1, 2, 4})
  {
    const tbb::global_control control(tbb::global_control::max_allowed_parallelism, number_of_threads);
    const Parallel_surface surface(mesh);
    const Parallel_surface paper(mesh, np::surface_model(CGAL::Hermite_diffuse_remeshing::PAPER_MODEL));
    const CGAL::Hermite_diffuse_surface<Surface_mesh>
      expected_paper(mesh, np::surface_model(CGAL::Hermite_diffuse_remeshing::PAPER_MODEL));
    for(const auto f : mesh.faces())
    {
      const std::array<double, 3> l = {{0.2, 0.3, 0.5}};
      assert(surface.point({f, l}) == expected.point({f, l}));
      assert(surface.principal_curvatures({f, l}) == expected.principal_curvatures({f, l}));
      assert(paper.point({f, l}) == expected_paper.point({f, l}));
    }
    auto curvatures = get(CGAL::dynamic_vertex_property_t<Principal>(), mesh);
    PMP::hermite_diffuse_curvatures<CGAL::Parallel_tag>(mesh, np::vertex_principal_curvatures_and_directions_map(curvatures));
    for(const auto v : mesh.vertices())
    {
      const Principal k = get(curvatures, v), e = get(expected_curvatures, v);
      assert(k.max_curvature == e.max_curvature && k.min_curvature == e.min_curvature);
      assert(k.max_direction == e.max_direction);
    }
    auto labels = get(CGAL::dynamic_face_property_t<std::size_t>(), torus);
    const auto shapes = PMP::hermite_diffuse_classify_faces<CGAL::Parallel_tag>(torus, labels);
    assert(shapes.size() == expected_shapes.size() && shapes[0].radius > 0.);
    for(std::size_t i = 0; i < shapes.size(); ++i)
      assert(shapes[i].type == expected_shapes[i].type && shapes[i].radius == expected_shapes[i].radius);
    for(const auto f : torus.faces())
      assert(get(labels, f) == get(expected_labels, f));
  }
}
#endif

// ---- the order in which a mesh is stored

// An isolated vertex in front, faces and vertices in another order, two components: the same surface but for
// rounding.
void test_order()
{
  analytic::Triangles mesh = analytic::torus().mesh(1000, 1);
  const std::size_t n = mesh.points.size();
  for(std::size_t i = 0; i < n; ++i)
    mesh.points.push_back({{mesh.points[i][0] + 5., mesh.points[i][1], mesh.points[i][2]}});
  for(std::size_t f = 0, faces = mesh.faces.size(); f < faces; ++f)
    mesh.faces.push_back({{mesh.faces[f][0] + n, mesh.faces[f][1] + n, mesh.faces[f][2] + n}});

  analytic::Triangles shuffled;
  shuffled.points.push_back({{0., 0., 9.}});
  for(std::size_t i = 0; i < 2 * n; ++i)
    shuffled.points.push_back(mesh.points[2 * n - 1 - i]);
  const std::size_t stride = 7;                                  // the number of faces is no multiple of it
  assert(mesh.faces.size() % stride != 0);
  for(std::size_t i = 0; i < mesh.faces.size(); ++i)
  {
    const auto& f = mesh.faces[i * stride % mesh.faces.size()];
    shuffled.faces.push_back({{2 * n - f[0], 2 * n - f[1], 2 * n - f[2]}});
  }

  const Surface_mesh a = make_mesh<Surface_mesh>(mesh);
  const Polyhedron b = make_mesh<Polyhedron>(shuffled);
  const CGAL::Hermite_diffuse_surface<Surface_mesh> surface(a);
  const CGAL::Hermite_diffuse_surface<Polyhedron> other(b);
  for(const auto f : a.faces())
  {
    const Kernel::Point_3 p = surface.point({f, {{0.2, 0.3, 0.5}}});
    const Kernel::Point_3 q = other.point(other.project(p));
    assert(CGAL::squared_distance(p, q) < 1e-12);
  }
}

// points that have no place, and meshes that are too small or too large for the fits
void test_refusals()
{
  typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;
  typedef Kernel::Point_3 Point;
  const Mesh mesh = make_mesh<Mesh>(analytic::Torus().mesh(500, 1));
  const CGAL::Hermite_diffuse_surface<Mesh> surface(mesh);
  for(const double far : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(), 1e200})
  {
    assert(is_refused([&] { surface.locate(Point(far, 0., 0.)); }));
    assert(is_refused([&] { surface.project(Point(0., far, 0.)); }));
  }
  for(const double scale : {1e-60, 1e60})
  {
    Mesh scaled = mesh;
    for(const auto v : vertices(scaled))
      scaled.point(v) = CGAL::ORIGIN + scale * (mesh.point(v) - CGAL::ORIGIN);
    assert(is_refused([&] { CGAL::Hermite_diffuse_surface<Mesh> other(scaled); }));
  }
}

int main()
{
  test_archetype();
  test_refusals();
  test_memory();
  test_order();
#ifdef CGAL_LINKED_WITH_TBB
  test_threads();
#endif
  return 0;
}
