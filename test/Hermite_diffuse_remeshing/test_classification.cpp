#include "test_helpers.h"

using namespace HDR;
using namespace HDR::internal;

struct Classification
{
  Indexed_triangles triangles;
  Edge_table edges;
  std::vector<Edge_class> edge_classes;
  Cut_mesh cut_mesh;
  std::vector<Vertex_class> vertex_classes;

  explicit Classification(const Indexed_triangles& t, const double sharp = 40., const double corner = 60.,
                          const double apex = 30.)
    : triangles(t), edges(t)
    , edge_classes(classify_edges(t, edges, radians(sharp), [](int, int) { return HDR::internal::UNMARKED_EDGE; }))
    , cut_mesh(t, edges, edge_classes)
    , vertex_classes(classify_vertices(t, edges, edge_classes, cut_mesh, radians(corner), radians(apex),
                                       [](int, int) { return HDR::internal::UNMARKED_EDGE; }, [](int) { return false; }))
  {}

  static double radians(const double degrees) { return degrees * analytic::pi / 180.; }

  long number(const Edge_class c) const { return std::count(edge_classes.begin(), edge_classes.end(), c); }
  long number(const Vertex_class c) const { return std::count(vertex_classes.begin(), vertex_classes.end(), c); }
};

Indexed_triangles indexed(const std::vector<Vector>& points, const std::vector<std::array<int, 3> >& triangles)
{
  Indexed_triangles result;
  result.points = points;
  result.triangles = triangles;
  return result;
}

Indexed_triangles read_indexed(const std::string& name)
{
  const Surface_mesh mesh = read_data<Surface_mesh>(name);
  std::vector<Surface_mesh::Face_index> faces;
  return read_triangles(mesh, mesh.points(), Kernel(), faces);
}

void test_cube()
{
  const Classification cube(read_indexed("cube.off"));
  assert(cube.number(SHARP_EDGE) == 12 && cube.number(INTERIOR_EDGE) == 6);
  assert(cube.number(JUNCTION_VERTEX) == 8);
  // a node per side of the cube and corner of it
  assert(cube.cut_mesh.number_of_nodes() == 24 && cube.cut_mesh.number_of_patches() == 6);

  // areas of tiny cubes are the squares of their lengths, and angles are found from products of areas
  for(const double scale : {1e-50, 1e50})
  {
    Indexed_triangles scaled = read_indexed("cube.off");
    for(Vector& p : scaled.points)
      p *= scale;
    assert(Classification(scaled).number(SHARP_EDGE) == 12);
  }

  const Classification smooth(read_indexed("cube.off"), 180., 180., 180.);
  assert(smooth.number(INTERIOR_EDGE) == 18 && smooth.number(SURFACE_VERTEX) == 8);
  assert(smooth.cut_mesh.number_of_nodes() == 8 && smooth.cut_mesh.number_of_patches() == 1);
}

// an open cone of n sides: the tip is an apex, the rim a smooth border
void test_cone_apex()
{
  const int n = 24;
  std::vector<Vector> points(1, Vector(0., 0., 1.));
  std::vector<std::array<int, 3> > triangles;
  for(int ring = 1; ring <= 4; ++ring)
    for(int i = 0; i < n; ++i)
    {
      const double s = 2. * analytic::pi * i / n, r = ring / 4.;
      points.push_back(Vector(r * std::cos(s), r * std::sin(s), 1. - r));
    }
  for(int i = 0; i < n; ++i)
    triangles.push_back({{0, 1 + i, 1 + (i + 1) % n}});
  for(int ring = 0; ring < 3; ++ring)
    for(int i = 0; i < n; ++i)
    {
      const int a = 1 + ring * n + i, b = 1 + ring * n + (i + 1) % n;
      triangles.push_back({{a, a + n, b + n}});
      triangles.push_back({{a, b + n, b}});
    }
  const Classification cone(indexed(points, triangles));
  assert(cone.vertex_classes[0] == APEX_VERTEX);
  assert(cone.number(APEX_VERTEX) == 1 && cone.number(JUNCTION_VERTEX) == 0);
  assert(cone.number(BOUNDARY_EDGE) == n && cone.number(CURVE_VERTEX) == n);
}

void test_square_border()
{
  std::vector<Vector> points;
  std::vector<std::array<int, 3> > triangles;
  for(int j = 0; j < 4; ++j)
    for(int i = 0; i < 4; ++i)
      points.push_back(Vector(i, j, 0.));
  for(int j = 0; j < 3; ++j)
    for(int i = 0; i < 3; ++i)
    {
      const int a = 4 * j + i;
      triangles.push_back({{a, a + 1, a + 5}});
      triangles.push_back({{a, a + 5, a + 4}});
    }
  const Classification square(indexed(points, triangles));
  assert(square.number(BOUNDARY_EDGE) == 12);
  assert(square.number(KINK_VERTEX) == 4 && square.number(CURVE_VERTEX) == 8 && square.number(SURFACE_VERTEX) == 4);
  assert(is_corner(square.vertex_classes[0]) && is_corner(square.vertex_classes[15]));
}

// three half planes on one line, and two triangles that are oriented against each other
void test_non_manifold()
{
  const Classification fan(indexed({Vector(0, 0, 0), Vector(0, 0, 1), Vector(1, 0, 0), Vector(-1, 1, 0), Vector(-1, -1, 0)},
                                   {{{0, 1, 2}}, {{0, 1, 3}}, {{0, 1, 4}}}));
  assert(fan.number(NON_MANIFOLD_EDGE) == 1 && fan.number(BOUNDARY_EDGE) == 6);
  assert(fan.cut_mesh.number_of_nodes() == 9);

  const Classification incoherent(indexed({Vector(0, 0, 0), Vector(1, 0, 0), Vector(0, 1, 0), Vector(1, -1, 0)},
                                          {{{0, 1, 2}}, {{0, 1, 3}}}));
  assert(incoherent.number(NON_MANIFOLD_EDGE) == 1);

  // two tetrahedra that share one vertex: two sheets touch there
  const Classification touching(indexed({Vector(0, 0, 0), Vector(1, 0, 0), Vector(0, 1, 0), Vector(0, 0, 1),
                                         Vector(-1, 0, 0), Vector(0, -1, 0), Vector(0, 0, -1)},
                                        {{{0, 2, 1}}, {{0, 1, 3}}, {{0, 3, 2}}, {{1, 2, 3}},
                                         {{0, 4, 5}}, {{0, 5, 6}}, {{0, 6, 4}}, {{4, 6, 5}}}), 180., 180., 180.);
  assert(touching.cut_mesh.number_of_nodes() == 8 && touching.vertex_classes[0] == TOUCHING_VERTEX);
}

// short chains of slightly sharp edges with a free end are noise, long or sharper ones are not
void test_isolated_sharp_edges()
{
  // a roof over a square, steep along `length` edges of its ridge and fading to flat before and after
  const auto roof = [](const int length, const double angle)
  {
    std::vector<Vector> points;
    std::vector<std::array<int, 3> > triangles;
    const int fading = 8, n = length + 2 * fading, half_width = 4;
    for(int i = 0; i <= n; ++i)
    {
      const int outside = (std::max)({0, fading - i, i - fading - length});
      const double slope = std::tan(Classification::radians(angle / 2.)) * (1. - double(outside) / fading);
      for(int j = -half_width; j <= half_width; ++j)
        points.push_back(Vector(i, j, -slope * std::abs(j)));
    }
    const int row = 2 * half_width + 1;
    for(int i = 0; i < n; ++i)
      for(int j = 0; j + 1 < row; ++j)
      {
        const int a = row * i + j;
        triangles.push_back({{a, a + row, a + row + 1}});
        triangles.push_back({{a, a + row + 1, a + 1}});
      }
    return Classification(indexed(points, triangles));
  };
  assert(roof(2, 44.).number(SHARP_EDGE) == 0);
  assert(roof(10, 44.).number(SHARP_EDGE) >= 10);
  assert(roof(2, 70.).number(SHARP_EDGE) >= 2);
}

// The seam of two tubes is a feature all around, also where it fades, if their facets are long; what the user says goes
// before.
void test_fading_creases()
{
  constexpr double radius = 0.4, length = 3.;
  const auto tubes = [](const int columns, const int rows, const double bend)
  {
    analytic::Random random(1);
    return indexed(analytic::mitred_tubes(columns, rows, radius, length, Classification::radians(bend), random));
  };
  for(const int columns : {15, 16, 33, 64})
    for(const double bend : {55., 90., 120.})
    {
      const Classification mitre(tubes(columns, 1, bend));
      assert(mitre.number(SHARP_EDGE) == columns);
      for(int e = 0; e < mitre.edges.number_of_edges(); ++e)
        if(mitre.edge_classes[e] == SHARP_EDGE)
          for(const int v : mitre.edges.vertices(e))
            assert(v >= columns && v < 2 * columns);
    }
  // of tubes with many rows of facets nothing is closed
  const Classification fine(tubes(16, 20, 90.));
  assert(fine.number(SHARP_EDGE) == 12);
  // nor where there is no crease
  assert(Classification(tubes(16, 1, 35.)).number(SHARP_EDGE) == 0);
  const Indexed_triangles t = tubes(16, 1, 90.);
  const auto is_at_middle = [&](const int f, const int k) { return std::abs(t.point(f, k)[1]) < 0.2 * radius; };
  const std::vector<Edge_class> classes = classify_edges(t, Edge_table(t), Classification::radians(40.),
    [&](const int f, const int k)
    { return is_at_middle(f, k) || is_at_middle(f, next(k)) ? MARKED_FREE : HDR::internal::UNMARKED_EDGE; });
  assert(std::count(classes.begin(), classes.end(), SHARP_EDGE) == 12);
}

// A needle whose normal is turned away from the faces around it is no piece of two features.
void test_needles()
{
  // two halves that meet along the x axis at an angle, with a vertex almost on the edge between (0,0,0) and (1,0,0)
  const auto roof = [](const double slope, const double offset, const double height)
  {
    const std::vector<Vector> points =
      {Vector(-1., 0., 0.), Vector(0., 0., 0.), Vector(1., 0., 0.), Vector(2., 0., 0.), Vector(0.5, offset, height),
       Vector(-1., -1., -slope), Vector(2., -1., -slope), Vector(-1., 1., -slope), Vector(2., 1., -slope),
       Vector(0.5, -1., -slope), Vector(0.5, 1., -slope)};
    return indexed(points, {{{1, 2, 4}}, {{1, 5, 9}}, {{1, 0, 5}}, {{1, 9, 2}}, {{2, 9, 6}}, {{2, 6, 3}},
                            {{1, 4, 10}}, {{4, 2, 10}}, {{0, 1, 7}}, {{1, 10, 7}}, {{2, 8, 10}}, {{2, 3, 8}}});
  };
  const Classification flat(roof(0., 0.02, 0.03));
  assert(flat.number(SHARP_EDGE) == 0);
  // the crease goes along the needle, on one side of it
  const Classification crease(roof(1., 0.02, 0.));
  assert(crease.number(SHARP_EDGE) == 4 && crease.number(JUNCTION_VERTEX) == 2);
  // a thicker one, with an edge behind its tip, is a shape of its own
  const Classification thick(roof(0., 0.2, 0.25));
  assert(thick.number(SHARP_EDGE) == 4);

  // a strip that is turned out of a plane and grows from a tip begins behind the needle
  const double width = 0.02;
  const Classification strip(indexed(
    {Vector(0., 0., 0.), Vector(1., -width, -width), Vector(1., width, width), Vector(2., -2. * width, -2. * width),
     Vector(2., 2. * width, 2. * width), Vector(-1., -1., 0.), Vector(2., -1., 0.), Vector(-1., 1., 0.),
     Vector(2., 1., 0.)},
    {{{0, 7, 5}}, {{0, 1, 2}}, {{1, 3, 4}}, {{1, 4, 2}}, {{0, 5, 1}}, {{1, 5, 6}}, {{1, 6, 3}}, {{0, 2, 7}},
     {{2, 8, 7}}, {{2, 4, 8}}}));
  assert(strip.number(SHARP_EDGE) == 3);
  assert(is_feature(strip.edge_classes[strip.edges.edge(1, 1)]));

  // the tip of a ramp between two slopes keeps its features
  std::vector<Vector> points(1, Vector(0., 0., 0.));
  for(int i = 1; i <= 2; ++i)
    for(const double side : {-1., 1.})
    {
      points.push_back(Vector(i, side * i * width, 0.));
      points.push_back(Vector(i, side * (1. + i * width), -1.));
    }
  points.push_back(Vector(0., -1., -1.));
  points.push_back(Vector(0., 1., -1.));
  const Classification ramp(indexed(points,
    {{{0, 1, 3}}, {{1, 5, 7}}, {{1, 7, 3}}, {{0, 9, 2}}, {{0, 2, 1}}, {{1, 2, 6}}, {{1, 6, 5}},
     {{0, 4, 10}}, {{0, 3, 4}}, {{3, 8, 4}}, {{3, 7, 8}}}));
  assert(ramp.number(SHARP_EDGE) == 4);
}

int main()
{
  test_cube();
  test_cone_apex();
  test_square_border();
  test_non_manifold();
  test_isolated_sharp_edges();
  test_fading_creases();
  test_needles();
  std::cout << "done" << std::endl;
  return EXIT_SUCCESS;
}
