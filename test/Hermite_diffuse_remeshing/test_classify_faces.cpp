// Recognition of planes, spheres, cylinders, cones and tori, joined with and without sharp edges.

#include "irregular_meshes.h"
#include "is_refused.h"

#include <CGAL/Polygon_mesh_processing/hermite_diffuse_classify_faces.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>
#include <CGAL/squared_distance_3.h>

#include <algorithm>
#include <cassert>
#include <functional>
#include <iostream>

namespace PMP = CGAL::Polygon_mesh_processing;
namespace np = CGAL::parameters;
typedef CGAL::Simple_cartesian<double> Kernel;
typedef Kernel::Point_3 Point_3;
typedef CGAL::Surface_mesh<Point_3> Mesh;
typedef CGAL::Hermite_diffuse_remeshing::Basic_surface<Kernel> Surface;
using CGAL::Hermite_diffuse_remeshing::Basic_surface_type;

Mesh make_mesh(const analytic::Triangles& triangles)
{
  Mesh mesh;
  for(const analytic::Point& p : triangles.points)
    mesh.add_vertex(Point_3(p[0], p[1], p[2]));
  for(const auto& f : triangles.faces)
    mesh.add_face(Mesh::Vertex_index(f[0]), Mesh::Vertex_index(f[1]), Mesh::Vertex_index(f[2]));
  return mesh;
}

double area(const Mesh& mesh, const Mesh::Face_index f)
{
  const auto h = mesh.halfedge(f);
  return std::sqrt(CGAL::squared_area(mesh.point(mesh.source(h)), mesh.point(mesh.target(h)),
                                      mesh.point(mesh.target(mesh.next(h)))));
}

struct Labels
{
  std::vector<Surface> surfaces;
  Mesh::Property_map<Mesh::Face_index, std::size_t> label;
};

Labels classify(Mesh& mesh)
{
  Labels result;
  result.label = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:label", 0).first;
  result.surfaces = PMP::hermite_diffuse_classify_faces(mesh, result.label);
  return result;
}

// part of the area whose type is the expected one
double right_part(const Mesh& mesh, const Labels& labels,
                  const std::function<Basic_surface_type(Mesh::Face_index)>& expected)
{
  double right = 0., all = 0.;
  for(const auto f : mesh.faces())
  {
    all += area(mesh, f);
    if(labels.surfaces[labels.label[f]].type == expected(f))
      right += area(mesh, f);
  }
  return right / all;
}

bool is_near(const double a, const double b) { return std::abs(a - b) < 0.01 * std::abs(b); }

// A body of revolution with tangential joints: plane, torus (0.7, 0.3), cylinder 1, torus (0.5, 0.5), cone of
// 45 degrees, sphere of radius sqrt(0.5). The rows of vertices on the joints are regular, the others are not.
struct Segment
{
  Basic_surface_type type;
  double length;
  std::function<std::array<double, 2>(double)> point;        // radius and height at a part of the length
};

std::vector<Segment> profile()
{
  const auto line = [](const double r0, const double z0, const double r1, const double z1)
  { return [=](const double t) { return std::array<double, 2>{{r0 + t * (r1 - r0), z0 + t * (z1 - z0)}}; }; };
  const auto arc = [](const double r, const double z, const double radius, const double from, const double to)
  {
    return [=](const double t)
    {
      const double a = (from + t * (to - from)) * analytic::pi / 180.;
      return std::array<double, 2>{{r + radius * std::cos(a), z + radius * std::sin(a)}};
    };
  };
  using namespace CGAL::Hermite_diffuse_remeshing;
  const double s = std::sqrt(0.5), pi = analytic::pi, z = 1.3 + 0.5 * s, top = z + (0.5 + 0.5 * s - 0.5);
  return {{PLANE_SURFACE, 0.6, line(0.1, 0., 0.7, 0.)},
          {TORUS_SURFACE, 0.15 * pi, arc(0.7, 0.3, 0.3, -90., 0.)},
          {CYLINDER_SURFACE, 1., line(1., 0.3, 1., 1.3)},
          {TORUS_SURFACE, 0.125 * pi, arc(0.5, 1.3, 0.5, 0., 45.)},
          {CONE_SURFACE, 0.5, line(0.5 + 0.5 * s, z, 0.5, top)},
          {SPHERE_SURFACE, 0.25 * pi * s - 0.1, arc(0., top - 0.5, s, 45., 82.)}};
}

void test_fillets(const int columns, const double rounding)
{
  analytic::Random random(1);
  analytic::Triangles t;
  std::vector<Basic_surface_type> expected;
  int row = 0;
  const auto add_row = [&](const std::function<std::array<double, 2>(double)>& at, const double first,
                           const double amplitude)
  {
    for(int i = 0; i < columns; ++i)
    {
      const double a = 2. * analytic::pi * (i + random(-0.25, 0.25)) / columns;
      const std::array<double, 2> p = at(first + amplitude * random(-1., 1.));
      t.points.push_back({{p[0] * std::cos(a), p[0] * std::sin(a), p[1]}});
    }
    ++row;
  };
  const auto at = [&](const int i, const int j) { return std::size_t(j * columns + i % columns); };
  const std::vector<Segment> segments = profile();
  add_row(segments[0].point, 0., 0.);
  for(const Segment& segment : segments)
  {
    const int rows = (std::max)(3, int(std::lround(segment.length * columns / (2. * analytic::pi * 0.8))));
    for(int j = 1; j <= rows; ++j)
    {
      add_row(segment.point, double(j) / rows, j < rows ? 0.25 / rows : 0.);
      for(int i = 0; i < columns; ++i)
      {
        t.add_quadrangle({{at(i, row - 2), at(i + 1, row - 2), at(i + 1, row - 1), at(i, row - 1)}}, random);
        expected.insert(expected.end(), 2, segment.type);
      }
    }
  }
  // somewhere in space, so that nothing is aligned
  for(analytic::Point& p : t.points)
  {
    const analytic::Point q = p;
    p = {{0.36 * q[0] + 0.48 * q[1] - 0.8 * q[2] + 3., -0.8 * q[0] + 0.6 * q[1] - 1.,
          0.48 * q[0] + 0.64 * q[1] + 0.6 * q[2] + 2.}};
    if(rounding > 0.)
      for(double& x : p)
        x = double(float(x));
  }
  Mesh mesh = make_mesh(t);
  const Labels labels = classify(mesh);
  const double part = right_part(mesh, labels, [&](const Mesh::Face_index f) { return expected[f]; });
  if(part < 0.95)
    std::cerr << "right part " << part << " of the area, " << columns << " columns" << std::endl;
  assert(part >= 0.95);

  using namespace CGAL::Hermite_diffuse_remeshing;
  int tori = 0;
  for(const Surface& s : labels.surfaces)
  {
    if(s.number_of_faces < std::size_t(columns))
      continue;
    if(s.type == SPHERE_SURFACE)
      assert(is_near(s.radius, std::sqrt(0.5)));
    else if(s.type == CYLINDER_SURFACE)
      assert(is_near(s.radius, 1.));
    else if(s.type == CONE_SURFACE)
      assert(is_near(s.half_angle, analytic::pi / 4.));
    else if(s.type == TORUS_SURFACE)
    {
      ++tori;
      assert((is_near(s.radius, 0.7) && is_near(s.tube_radius, 0.3))
             || (is_near(s.radius, 0.5) && is_near(s.tube_radius, 0.5)));
    }
    if(s.type == CYLINDER_SURFACE || s.type == CONE_SURFACE || s.type == TORUS_SURFACE)
      assert(std::abs(s.direction * Kernel::Vector_3(-0.8, 0., 0.6)) > 0.9999);
  }
  assert(tori == 2);
}

// what is no basic surface must not become one
void test_free_form()
{
  for(const analytic::Test_surface& s : {analytic::sin_cos(), analytic::ellipsoid()})
    for(const int number_of_faces : {2000, 8000})
    {
      Mesh mesh = make_mesh(s.mesh(number_of_faces, 1));
      const Labels labels = classify(mesh);
      const double part = right_part(mesh, labels, [](Mesh::Face_index)
                                     { return CGAL::Hermite_diffuse_remeshing::FREE_FORM_SURFACE; });
      if(part < 0.95)
        std::cerr << s.name << ": free-form on " << part << " of the area" << std::endl;
      assert(part >= 0.95);
    }
}

// At a corner of the border the only facet, whose corners no plane misses, is no plane by itself.
void test_corner_facets()
{
  // a wave over 10 x 10 squares, the diagonals of which cut all corners off
  constexpr int n = 10;
  analytic::Triangles t;
  for(int j = 0; j <= n; ++j)
    for(int i = 0; i <= n; ++i)
    {
      const double u = double(i) / n, v = double(j) / n;
      t.points.push_back({{u, v, 0.1 * std::sin(6. * u + 0.3) * std::cos(5. * v + 0.2)}});
    }
  const auto at = [](const int i, const int j) { return std::size_t(j * (n + 1) + i); };
  for(int j = 0; j < n; ++j)
    for(int i = 0; i < n; ++i)
    {
      const std::size_t a = at(i, j), b = at(i + 1, j), c = at(i + 1, j + 1), d = at(i, j + 1);
      if((i < n / 2) == (j < n / 2))
      {
        t.faces.push_back({{a, b, d}});
        t.faces.push_back({{b, c, d}});
      }
      else
      {
        t.faces.push_back({{a, b, c}});
        t.faces.push_back({{a, c, d}});
      }
    }
  Mesh mesh = make_mesh(t);
  for(const Surface& surface : classify(mesh).surfaces)
    assert(surface.type != CGAL::Hermite_diffuse_remeshing::PLANE_SURFACE || surface.number_of_faces > 1);
}

void test_whole_surfaces()
{
  using namespace CGAL::Hermite_diffuse_remeshing;
  struct Case { analytic::Test_surface surface; Basic_surface_type type; };
  for(const Case& c : {Case{analytic::sphere(), SPHERE_SURFACE}, Case{analytic::torus(), TORUS_SURFACE},
                       Case{analytic::cylinder(), CYLINDER_SURFACE}, Case{analytic::cone(), CONE_SURFACE},
                       Case{analytic::torus(6.), TORUS_SURFACE}})
  {
    Mesh mesh = make_mesh(c.surface.mesh(5000, 1));
    const Labels labels = classify(mesh);
    const double part = right_part(mesh, labels, [&](Mesh::Face_index) { return c.type; });
    if(part < 0.95)
      std::cerr << c.surface.name << ": right on " << part << " of the area" << std::endl;
    assert(part >= 0.95);
  }
}

// six squares of two faces
void test_cube()
{
  analytic::Triangles t;
  for(int i = 0; i < 8; ++i)
    t.points.push_back({{double(i & 1), double(i >> 1 & 1), double(i >> 2)}});
  const std::size_t sides[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  for(const auto& s : sides)
  {
    t.faces.push_back({{s[0], s[1], s[2]}});
    t.faces.push_back({{s[0], s[2], s[3]}});
  }
  Mesh mesh = make_mesh(t);
  const Labels labels = classify(mesh);
  assert(labels.surfaces.size() == 6);
  for(const Surface& s : labels.surfaces)
    assert(s.type == CGAL::Hermite_diffuse_remeshing::PLANE_SURFACE && s.number_of_faces == 2);
}

// A cylinder or a cone with lids, as CAD systems tessellate it: long facets between few rings of vertices, as few as two,
// which would lie on a sphere, too.
void test_tessellated(const double upper_radius, const double height, const int number_of_rings)
{
  using namespace CGAL::Hermite_diffuse_remeshing;
  constexpr int columns = 48;
  analytic::Random random(1);
  std::vector<std::array<double, 2> > profile(1, {{0., 0.}});
  std::vector<Basic_surface_type> expected(columns, PLANE_SURFACE);
  for(int j = 0; j < number_of_rings; ++j)
  {
    const double part = double(j) / (number_of_rings - 1);
    profile.push_back({{1. + part * (upper_radius - 1.), part * height}});
    if(j > 0)
      expected.insert(expected.end(), 2 * columns, upper_radius == 1. ? CYLINDER_SURFACE : CONE_SURFACE);
  }
  profile.push_back({{0., height}});
  expected.insert(expected.end(), columns, PLANE_SURFACE);
  const analytic::Triangles t = analytic::surface_of_revolution(columns, profile, random);
  Mesh mesh = make_mesh(t);
  const Labels labels = classify(mesh);
  const double part = right_part(mesh, labels, [&](const Mesh::Face_index f) { return expected[f]; });
  if(part < 1. || labels.surfaces.size() != 3)
    std::cerr << "tessellated, radius " << upper_radius << ", height " << height << ", " << number_of_rings << " rings: right on "
              << part << " of the area, " << labels.surfaces.size() << " regions" << std::endl;
  assert(part == 1. && labels.surfaces.size() == 3);
}

// A part of a cylinder closed by a plane: the strips between two rulings at the rims belong to the cylinder.
void test_cylinder_panel(const int number_of_facets, const int number_of_rows, const double arc)
{
  using namespace CGAL::Hermite_diffuse_remeshing;
  Mesh mesh;
  std::vector<std::vector<Mesh::Vertex_index> > rows(number_of_rows + 1);
  for(int j = 0; j <= number_of_rows; ++j)
    for(int i = 0; i <= number_of_facets; ++i)
    {
      const double angle = arc * i / number_of_facets;
      rows[j].push_back(mesh.add_vertex(Point_3(std::cos(angle), std::sin(angle), 2. * j / number_of_rows)));
    }
  const auto add_quadrangle = [&](const int j, const int from, const int to)
  {
    mesh.add_face(rows[j][from], rows[j][to], rows[j + 1][from]);
    mesh.add_face(rows[j + 1][from], rows[j][to], rows[j + 1][to]);
  };
  for(int j = 0; j < number_of_rows; ++j)
  {
    for(int i = 0; i < number_of_facets; ++i)
      add_quadrangle(j, i, i + 1);
    add_quadrangle(j, number_of_facets, 0);
  }
  for(int i = 1; i < number_of_facets; ++i)
  {
    mesh.add_face(rows.front()[0], rows.front()[i + 1], rows.front()[i]);
    mesh.add_face(rows.back()[0], rows.back()[i], rows.back()[i + 1]);
  }
  const Labels labels = classify(mesh);
  const auto is_cylinder = [](const Surface& s) { return s.type == CYLINDER_SURFACE; };
  const auto found = std::find_if(labels.surfaces.begin(), labels.surfaces.end(), is_cylinder);
  assert(labels.surfaces.size() == 4 && found != labels.surfaces.end());
  assert(int(found->number_of_faces) == 2 * number_of_facets * number_of_rows && is_near(found->radius, 1.));
}

// vertices that have been moved belong to a plane by a distance, but not by default
void test_distance()
{
  using CGAL::Hermite_diffuse_remeshing::PLANE_SURFACE;
  Mesh mesh;
  const auto point = [](const std::size_t i, const std::size_t j)
  { return Point_3(double(i), double(j), i % 8 * (j % 8) > 0 && (i + j) % 2 > 0 ? 0.01 : 0.); };
  CGAL::make_grid(9, 9, mesh, point, true);
  auto labels = get(CGAL::dynamic_face_property_t<std::size_t>(), mesh);
  const auto surfaces = PMP::hermite_diffuse_classify_faces(mesh, labels, np::maximum_distance(0.02));
  assert(surfaces.size() == 1 && surfaces[0].type == PLANE_SURFACE);
  assert(PMP::hermite_diffuse_classify_faces(mesh, labels).size() > 1);
  assert(is_refused([&] { PMP::hermite_diffuse_classify_faces(mesh, labels, np::maximum_distance(-1.)); }));
}

int main()
{
  for(const double upper_radius : {1., 0.7})
    for(const double height : {0.1, 1., 4.})
      for(const int number_of_rings : {2, 3, 5})
        test_tessellated(upper_radius, height, number_of_rings);
  for(const int number_of_facets : {8, 16, 32})
    for(const int number_of_rows : {1, 4})
      for(const double arc : {analytic::pi, 2. / 3. * analytic::pi})
        test_cylinder_panel(number_of_facets, number_of_rows, arc);
  test_cube();
  test_corner_facets();
  test_whole_surfaces();
  test_fillets(48, 0.);
  test_fillets(96, 0.);
  test_fillets(64, 1.);
  test_free_form();
  test_distance();
  return 0;
}
