// The model where its assumptions fail: too few faces, apices, rounded coordinates, strips of long
// triangles, degenerate faces.

#include "model_measures.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <iostream>
#include <utility>

using namespace measures;
using CGAL::Hermite_diffuse_remeshing::MAX_NORMALS;

bool is_at_most(const std::string& what, const double value, const double bound)
{
  if(!(value <= bound))
    std::cerr << what << ": " << value << " exceeds " << bound << std::endl;
  return value <= bound;
}

// about eight edges around the tube: never worse than with Max normals, but for a hundredth
void test_coarse_meshes()
{
  constexpr double noticeable = 1.01;
  bool ok = true;
  for(const analytic::Test_surface& s : {analytic::torus(), analytic::torus(6.), analytic::sin_cos(),
                                        analytic::cylinder()})
    for(const int number_of_faces : {250, 500, 1000})
    {
      Accuracy fitted, maximum;
      for(int seed = 1; seed <= 3; ++seed)
      {
        const Indexed_triangles triangles = indexed(s.mesh(number_of_faces, seed));
        Model_options options;
        const Accuracy a = measure(*make_model(triangles, options), s, 3000);
        options.normals = MAX_NORMALS;
        const Accuracy b = measure(*make_model(triangles, options), s, 3000);
        fitted.position += a.position;
        fitted.normal += a.normal;
        fitted.curvature_median += a.curvature_median;
        maximum.position += b.position;
        maximum.normal += b.normal;
        maximum.curvature_median += b.curvature_median;
      }
      const std::string name = s.name + " of " + std::to_string(number_of_faces) + " faces, ";
      ok = is_at_most(name + "position", fitted.position, noticeable * maximum.position) && ok;
      ok = is_at_most(name + "normal", fitted.normal, noticeable * maximum.normal) && ok;
      ok = is_at_most(name + "curvature", fitted.curvature_median, noticeable * maximum.curvature_median) && ok;
    }
  assert(ok);
}

bool is_at_least(const std::string& what, const double value, const double bound)
{
  if(!(value >= bound))
    std::cerr << what << ": " << value << " is below " << bound << std::endl;
  return value >= bound;
}

// z = 1 - slope * r over a square, with its tip
struct Cone
{
  double slope;

  analytic::Point operator()(const double x, const double y) const { return {{x, y, 1. - slope * std::hypot(x, y)}}; }

  double distance(const Vector& p) const
  { return (p - vector(analytic::detail::cone_truth(point(p), 1. / slope, -1. / slope).point)).norm(); }

  // the curvature across the rulings
  double curvature(const Vector& p) const
  { return -slope / std::sqrt(1. + slope * slope) / std::hypot(p[0], p[1]); }

  // and the number of the tip
  std::pair<analytic::Triangles, int> mesh(const int seed) const
  {
    const analytic::Test_surface surface = analytic::graph("", 1., 1., 1., [=](const double x, const double y)
    { return analytic::detail::Jet{{(*this)(x, y)[2], 0., 0., 0., 0., 0.}}; });
    analytic::Triangles mesh = surface.mesh(1000, seed);
    const auto radius = [](const analytic::Point& p) { return std::hypot(p[0], p[1]); };
    int tip = 0;
    for(std::size_t i = 0; i < mesh.points.size(); ++i)
      if(radius(mesh.points[i]) < radius(mesh.points[tip]))
        tip = int(i);
    mesh.points[tip] = (*this)(0., 0.);
    return std::make_pair(mesh, tip);
  }

  // puts a vertex into every face at the tip: nodes of three neighbours, one of which is the tip
  void split_faces_at(const int tip, analytic::Triangles& mesh) const
  {
    for(std::size_t f = 0, n = mesh.faces.size(); f < n; ++f)
    {
      const std::array<std::size_t, 3> t = mesh.faces[f];
      if(std::count(t.begin(), t.end(), std::size_t(tip)) == 0)
        continue;
      const auto mean = [&](const int k)
      { return (mesh.points[t[0]][k] + mesh.points[t[1]][k] + mesh.points[t[2]][k]) / 3.; };
      const std::size_t middle = mesh.points.size();
      mesh.points.push_back((*this)(mean(0), mean(1)));
      mesh.faces[f] = {{t[0], t[1], middle}};
      mesh.faces.push_back({{t[1], t[2], middle}});
      mesh.faces.push_back({{t[2], t[0], middle}});
    }
  }
};

std::unique_ptr<Input_model> make_model_with_apices(const Indexed_triangles& triangles, const Model_options& options)
{
  return std::unique_ptr<Input_model>(
    new Input_model(triangles, Feature_options{infinite, infinite, analytic::pi / 6.}, options,
                    [](int, int) { return UNMARKED_EDGE; }, [](int) { return false; }));
}

// The tip of a cone is a node without a normal. Its faces are closer than facets all the same, the surface goes
// through it and is continuous across the edges to it, also where nodes of reduced degree are around it.
void test_apices()
{
  bool ok = true;
  for(const double slope : {0.6, 0.9, 1.5, 2.5})
    for(const int degree : {2, 3})
      for(const bool is_split : {false, true})
      {
        const Cone cone = {slope};
        Root_mean_square position, flat;
        for(int seed = 1; seed <= 3; ++seed)
        {
          auto [mesh, tip] = cone.mesh(seed);
          if(is_split)
            cone.split_faces_at(tip, mesh);
          const Indexed_triangles triangles = indexed(mesh);
          Model_options options;
          options.degree = degree;
          const auto model = make_model_with_apices(triangles, options);
          assert(model->vertex_classes[tip] == CGAL::Hermite_diffuse_remeshing::APEX_VERTEX);

          analytic::Random random(1);
          for(int f = 0; f < triangles.number_of_faces(); ++f)
            for(int k = 0; k < 3; ++k)
            {
              if(triangles.triangles[f][k] != tip)
                continue;
              for(int n = 0; n < 50; ++n)
              {
                const double r = std::sqrt(random(0., 1.)), s = random(0., 1.);
                const Local_quadric q = model->surface.evaluate({f, {{1. - r, r * (1. - s), r * s}}});
                position.add(cone.distance(q.point()));
                flat.add(cone.distance(q.origin));
              }
              // the tip itself, and both sides of an edge to it
              Location at = {f, {{0., 0., 0.}}};
              at.coordinates[k] = 1.;
              assert(model->surface.evaluate(at).point() == triangles.points[tip]);
              const int g = model->surface.cut_mesh().neighbor(f, k);
              for(int l = 0; l < 3; ++l)
                if(triangles.triangles[g][l] == tip)
                {
                  at.coordinates[k] = 0.25;
                  at.coordinates[next(k)] = 0.75;
                  Location other = {g, {{0., 0., 0.}}};
                  other.coordinates[l] = 0.25;
                  other.coordinates[previous(l)] = 0.75;
                  assert(model->surface.evaluate(at).point() == model->surface.evaluate(other).point());
                }
            }
        }
        const std::string name = "tip of a cone of slope " + std::to_string(slope) + ", degree " + std::to_string(degree)
                               + (is_split ? ", with nodes of three neighbours" : "");
        ok = is_at_least(name + ", closer than facets", flat() / position(), is_split ? 1.2 : 2.) && ok;
      }
  assert(ok);
}

// around the tip of a cone: normals, and the curvature across the rulings relative to the true one
void test_curvature_at_apices()
{
  bool ok = true;
  for(const double slope : {0.6, 0.9, 1.5, 2.5})
  {
    const Cone cone = {slope};
    std::vector<double> evaluated, fitted, along, turn;
    for(int seed = 1; seed <= 5; ++seed)
    {
      const auto [mesh, tip] = cone.mesh(seed);
      const auto model = make_model_with_apices(indexed(mesh), Model_options());
      const Cut_mesh& cut_mesh = model->surface.cut_mesh();
      Node_curvature_fitter fitter(model->surface);
      for(int i = 0; i < cut_mesh.number_of_nodes(); ++i)
        if(cut_mesh.vertex(i) == tip)
          for(const int j : cut_mesh.ring(i))
          {
            const Vector p = model->surface.node(j).position;
            const double truth = cone.curvature(p), r = std::hypot(p[0], p[1]);
            const Vector normal(slope * p[0] / r, slope * p[1] / r, 1.);
            turn.push_back(angle_between(model->surface.node(j).normal, normal) * 180. / analytic::pi);
            evaluated.push_back(
              model->surface.evaluate(model->surface.location_of_node(j)).monge_form().curvatures().second / truth);
            fitted.push_back(fitter(j).curvatures().second / truth);
            along.push_back(std::abs(fitter(j).curvatures().first / truth));
          }
    }
    const std::string name = "around the tip of a cone of slope " + std::to_string(slope) + ", ";
    for(const auto& [ratios, how] : {std::make_pair(evaluated, "evaluated"), std::make_pair(fitted, "fitted")})
    {
      const std::string curvature = name + how + " curvature, ";
      ok = is_at_least(curvature + "10 %", quantile(ratios, 0.1), 0.65) && ok;
      ok = is_at_least(curvature + "median", quantile(ratios, 0.5), 0.85) && ok;
      ok = is_at_most(curvature + "median", quantile(ratios, 0.5), 1.2) && ok;
      ok = is_at_most(curvature + "90 %", quantile(ratios, 0.9), 1.45) && ok;
    }
    ok = is_at_most(name + "fitted curvature along the rulings, median", quantile(along, 0.5), 0.1) && ok;
    ok = is_at_most(name + "normal, median", quantile(turn, 0.5), 3.) && ok;
    ok = is_at_most(name + "normal, 95 %", quantile(turn, 0.95), 15.) && ok;
  }
  assert(ok);
}

// Coordinates rounded to float, as in a binary STL file, far from the origin. At 100 diameters the
// rounding is 4e-5 of an edge and the bounds of clean meshes hold; at 1000 it is 4e-4.
void test_rounded_coordinates()
{
  struct Case { analytic::Test_surface surface; double shift, median, p95, position; };
  const Case cases[] = {{analytic::torus(), 100., 0.023, 0.04, 3.0e-4},
                        {analytic::sin_cos(), 100., 0.0055, 0.013, 4.7e-5},
                        {analytic::cylinder(), 100., 0.003, 0.005, 4e-5},
                        {analytic::torus(), 1000., 0.023, 0.04, 6e-4},
                        {analytic::sin_cos(), 1000., 0.01, 0.03, 3e-4},
                        {analytic::cylinder(), 1000., 0.01, 0.03, 4e-4}};
  bool ok = true;
  for(const Case& c : cases)
  {
    analytic::Triangles mesh = c.surface.mesh(5000, 1);
    for(analytic::Point& p : mesh.points)
      for(double& x : p)
        x = double(float(x + c.shift)) - c.shift;
    const Accuracy a = measure(*make_model(indexed(mesh)), c.surface);
    const std::string name = c.surface.name + " rounded at " + std::to_string(int(c.shift));
    ok = is_at_most(name + ", median", a.curvature_median, c.median) && ok;
    ok = is_at_most(name + ", 95 %", a.curvature_p95, c.p95) && ok;
    ok = is_at_most(name + ", position", a.position, c.position) && ok;
  }
  assert(ok);
}

// One row of long triangles between two sharp rims, as CAD systems write cylinders. The nodes lie on
// two lines, so that positions alone do not determine a normal.
void test_strips()
{
  struct Case { int sides; double height, closer, curvature; };
  bool ok = true;
  for(const Case& c : {Case{16, 2., 20., 0.1}, Case{64, 2., 400., 0.007}, Case{64, 0.01, 20., 0.1},
                       Case{360, 100., 100., 0.02}})
  {
    Indexed_triangles t;
    for(const double z : {0., c.height})
      for(int i = 0; i < c.sides; ++i)
      {
        const double a = 2. * analytic::pi * i / c.sides;
        t.points.push_back(Vector(std::cos(a), std::sin(a), z));
      }
    const int n = c.sides;
    for(int i = 0; i < n; ++i)
    {
      t.triangles.push_back({{i, (i + 1) % n, n + (i + 1) % n}});
      t.triangles.push_back({{i, n + (i + 1) % n, n + i}});
    }
    const auto model = make_model(t);
    Root_mean_square position, flat;
    double curvature = 0.;
    analytic::Random random(1);
    for(int f = 0; f < t.number_of_faces(); ++f)
      for(int k = 0; k < 10; ++k)
      {
        const double r = std::sqrt(random(0., 1.)), s = random(0., 1.);
        const Local_quadric q = model->surface.evaluate({f, {{1. - r, r * (1. - s), r * s}}});
        position.add(std::hypot(q.point()[0], q.point()[1]) - 1.);
        flat.add(std::hypot(q.origin[0], q.origin[1]) - 1.);
        const std::pair<double, double> curvatures = q.monge_form().curvatures();
        curvature = (std::max)({curvature, std::abs(curvatures.first), std::abs(curvatures.second + 1.)});
      }
    const std::string name = "strip of " + std::to_string(c.sides) + " sides, height " + std::to_string(c.height);
    ok = is_at_most(name + ", position", position() / flat(), 1. / c.closer) && ok;
    ok = is_at_most(name + ", curvature", curvature, c.curvature) && ok;
  }
  assert(ok);
}

// one row of facets between two chains the points of which alternate
void add_row_of_facets(const int number_of_steps, const bool is_mirrored, Indexed_triangles& strip)
{
  for(int i = 0; i < number_of_steps; ++i)
  {
    const int a = 2 * i, b = a + 1, c = a + 3, d = a + 2;
    strip.triangles.push_back(is_mirrored ? std::array<int, 3>{{a, b, d}} : std::array<int, 3>{{a, b, c}});
    strip.triangles.push_back(is_mirrored ? std::array<int, 3>{{b, c, d}} : std::array<int, 3>{{a, c, d}});
  }
}

// the largest error of the model at the middles of the sides and the centroids of the faces
template <typename Error>
double largest_between_nodes(const Reference_surface& surface, const Error& error)
{
  double largest = 0.;
  for(int f = 0; f < surface.triangles().number_of_faces(); ++f)
    for(const Barycentric& l : {Barycentric{{0.5, 0.5, 0.}}, Barycentric{{0., 0.5, 0.5}}, Barycentric{{0.5, 0., 0.5}},
                                Barycentric{{1. / 3., 1. / 3., 1. / 3.}}})
      largest = (std::max)(largest, std::abs(error(surface.evaluate({f, l}).point())));
  return largest;
}

// At the straight ends of half a cylinder, in one row of facets, these are on one side only. Without the tangents of the
// rims the model was off by .7 of the facets' distance there.
void test_ends_of_strips()
{
  bool ok = true;
  for(const int number_of_steps : {6, 12, 24})
  {
    const double step = analytic::pi / number_of_steps, facets = 1. - std::cos(step / 2.);
    Indexed_triangles strip;
    for(int i = 0; i <= number_of_steps; ++i)
      for(const double z : {0., 0.4})
        strip.points.push_back(Vector(std::cos(step * i), std::sin(step * i), z));
    add_row_of_facets(number_of_steps, false, strip);
    const auto model = make_model(strip);
    const double largest = largest_between_nodes(model->surface,
                                                 [](const Vector& p) { return std::hypot(p[0], p[1]) - 1.; });
    const std::string name = "half a cylinder of " + std::to_string(number_of_steps) + " steps";
    // of order four, of which two are those of the facets' distance
    ok = is_at_most(name, largest, 0.3 * step * step * facets) && ok;
  }
  assert(ok);
}

// One row of facets between two rims that are helices, whichever way their diagonals go: the model stays as near to the
// helicoid as the facets, which are up to 0.0048 off. Fits took the diagonals for a slope, and bulged by 0.016.
void test_helicoids()
{
  constexpr int number_of_steps = 200;
  const double inner = 0.3, turns = 3., pitch = 1. / (2. * analytic::pi);
  bool ok = true;
  for(const bool is_mirrored : {false, true})
  {
    Indexed_triangles strip;
    for(int i = 0; i <= number_of_steps; ++i)
      for(const double r : {inner, 1.})
      {
        const double angle = 2. * analytic::pi * turns * i / number_of_steps;
        strip.points.push_back(Vector(r * std::cos(angle), r * std::sin(angle), pitch * angle));
      }
    add_row_of_facets(number_of_steps, is_mirrored, strip);
    const auto model = make_model(strip, Model_options());
    const double largest = largest_between_nodes(model->surface, [&](const Vector& p)
    {
      const double height = p[2] - pitch * std::atan2(p[1], p[0]);
      return std::remainder(height, 2. * analytic::pi * pitch);
    });
    ok = is_at_most("strip of a helicoid", largest, 0.0048) && ok;
  }
  assert(ok);
}

// everything stays finite
void test_degenerate_faces()
{
  analytic::Triangles mesh = analytic::torus().mesh(500, 1);
  analytic::Random random(1);
  for(int n = 0; n < 30; ++n)
  {
    // coincident and collinear vertices
    const auto& f = mesh.faces[std::size_t(random(0., double(mesh.faces.size())))];
    mesh.points[f[0]] = mesh.points[f[1]];
    if(n % 2 == 1)
      for(int k = 0; k < 3; ++k)
        mesh.points[f[0]][k] = (mesh.points[f[1]][k] + mesh.points[f[2]][k]) / 2.;
  }
  const auto model = make_model(indexed(mesh), Model_options(), 40.);
  Node_curvature_fitter fitter(model->surface);
  for(int f = 0; f < model->surface.triangles().number_of_faces(); ++f)
    for(const Barycentric& l : {Barycentric{{1., 0., 0.}}, Barycentric{{0.5, 0.5, 0.}}, Barycentric{{0.3, 0.3, 0.4}}})
    {
      const Local_quadric q = model->surface.evaluate({f, l});
      assert(q.point().allFinite() && q.normal().allFinite());
      assert(std::isfinite(q.monge_form().principal_curvatures().largest_absolute()));
    }
  for(int i = 0; i < model->surface.cut_mesh().number_of_nodes(); ++i)
    assert(std::isfinite(fitter(i).principal_curvatures().largest_absolute()));
}

// points of a feature curve at one place: all that the spline says stays a number
void test_coincident_points_on_curves()
{
  const std::vector<Vector> points = {Vector(0., 0., 0.), Vector(1., 0., 0.), Vector(1., 0., 0.), Vector(1.5, 1., 0.),
                                      Vector(0., 1., 0.), Vector(0., 1., 0.)};
  constexpr int number_of_parameters = 100;
  for(const bool is_closed : {false, true})
  {
    const Feature_spline spline(points, is_closed);
    assert(std::isfinite(spline.length()));
    for(int i = 0; i <= number_of_parameters; ++i)
    {
      const double s = spline.length() * i / number_of_parameters;
      assert(spline.point(s).allFinite() && std::isfinite(spline.curvature(s)));
    }
  }
}

int main()
{
  test_coincident_points_on_curves();
  test_degenerate_faces();
  test_helicoids();
  test_strips();
  test_ends_of_strips();
  test_apices();
  test_curvature_at_apices();
  test_rounded_coordinates();
  test_coarse_meshes();
  return 0;
}
