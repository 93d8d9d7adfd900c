#include "irregular_meshes.h"
#include "is_refused.h"
#include "marching_tetrahedra.h"
#include "test_helpers.h"

#include <CGAL/Hermite_diffuse_remeshing/Size_laws.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Sizing/limit_number_of_faces.h>

#include <array>
#include <limits>
#include <map>
#include <stdexcept>
#include <utility>
#include <vector>

using namespace HDR::internal;

void test_error_law()
{
  // both directions, and the expansion of the paper
  for(double error = 1e-8; error < 3.; error *= 1.7)
  {
    const double length = length_of_error(error);
    assert(length > 0. && length < 2.);
    assert(std::abs(error_of_length(length) / error - 1.) < 1e-10);
    if(error < 0.05)
      assert(std::abs(length / (std::sqrt(2. * error) * (1.68179 - 0.594604 * error)) - 1.) < 1e-3);
  }
  // twenty-six edges on a circle at one percent
  const double angle = 2. * std::asin(length_of_error(0.01) / 2.);
  assert(std::abs(2. * analytic::pi / angle - 26.4) < 0.1);
}

// each law and its inverse, the table of the reference manual, and the limits
void test_size_laws()
{
  for(double xi = 1e-6; xi < 2.; xi *= 1.3)
  {
    const auto is_same = [xi](const double value) { return std::abs(value / xi - 1.) < 1e-9; };
    assert(is_same(HDR::length_over_radius_of_error(HDR::error_of_length_over_radius(xi))));
    assert(is_same(HDR::length_over_radius_of_sagitta(HDR::sagitta_of_length_over_radius(xi))));
    assert(is_same(HDR::length_over_radius_of_elements_per_circle(HDR::elements_per_circle_of_length_over_radius(xi))));
    assert(is_same(HDR::length_over_radius_of_angle(HDR::angle_of_length_over_radius(xi))));
    assert(is_same(HDR::length_over_radius_of_sagitta_over_length(HDR::sagitta_over_length_of_length_over_radius(xi))));
  }
  const double xi = HDR::length_over_radius_of_error(0.02);
  assert(std::abs(xi - 0.3340) < 5e-5);
  assert(std::abs(HDR::sagitta_of_length_over_radius(xi) - 0.0140) < 5e-5);
  assert(std::abs(HDR::elements_per_circle_of_length_over_radius(xi) - 18.7) < 0.05);
  assert(std::abs(HDR::angle_of_length_over_radius(xi) - 19.2) < 0.05);
  assert(std::abs(HDR::sagitta_over_length_of_length_over_radius(xi) - 0.0420) < 5e-5);
  // half a circle
  assert(HDR::length_over_radius_of_elements_per_circle(2.) == 2.);
  assert(HDR::length_over_radius_of_angle(180.) == 2.);
  assert(HDR::length_over_radius_of_sagitta(1.) == 2.);
  assert(HDR::length_over_radius_of_sagitta_over_length(0.5) == 2.);

  for(const double bad : {0., -1., std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()})
    for(const auto law : {&HDR::length_over_radius_of_error, &HDR::error_of_length_over_radius,
                          &HDR::length_over_radius_of_sagitta, &HDR::length_over_radius_of_elements_per_circle,
                          &HDR::length_over_radius_of_angle, &HDR::length_over_radius_of_sagitta_over_length})
      assert(is_refused([&] { law(bad); }));
}

// the same mesh in the words of every law
void test_laws_in_call()
{
  const analytic::Torus torus;
  const Surface_mesh input = make_mesh<Surface_mesh>(torus.mesh(2000, 3));
  const double xi = HDR::length_over_radius_of_error(0.05);
  const auto faces_with = [&input](const auto& parameters)
  {
    Surface_mesh mesh = input;
    return PMP::hermite_diffuse_remesh(mesh, parameters).number_of_faces;
  };
  const std::size_t expected = faces_with(params::approximation_error(0.05));
  const auto is_near = [expected](const std::size_t n) { return std::abs(double(n) / expected - 1.) < 0.02; };
  assert(is_near(faces_with(params::elements_per_circle(HDR::elements_per_circle_of_length_over_radius(xi)))));
  assert(is_near(faces_with(params::angle_per_element(HDR::angle_of_length_over_radius(xi)))));
  assert(is_near(faces_with(params::sagitta_over_length(HDR::sagitta_over_length_of_length_over_radius(xi)))));
  // The smallest radius of curvature is the same everywhere on this thin torus. Errors of the curvature
  // count half: with the square root of the radius.
  const double sagitta = HDR::sagitta_of_length_over_radius(xi) * torus.r;
  assert(std::abs(double(faces_with(params::sagitta(sagitta))) / expected - 1.) < 0.1);
  // of several the smallest
  assert(is_near(faces_with(params::elements_per_circle(4).approximation_error(0.05))));
  for(const double bad : {0., -1., std::numeric_limits<double>::quiet_NaN()})
  {
    assert(is_refused([&] { faces_with(params::elements_per_circle(bad)); }));
    assert(is_refused([&] { faces_with(params::angle_per_element(bad)); }));
    assert(is_refused([&] { faces_with(params::sagitta_over_length(bad)); }));
    assert(is_refused([&] { faces_with(params::sagitta(bad)); }));
  }
}

struct Sized_model
{
  Input_model model;
  Size_map sizes;

  Sized_model(const Indexed_triangles& triangles, const Size_options& options,
              const Model_options& model_options = Model_options())
    : model(triangles, Feature_options{0.7, 1.05, 0.52}, model_options, [](int, int) { return HDR::internal::UNMARKED_EDGE; },
            [](int) { return false; })
    , sizes(model.surface, model.edges, model.curves, options)
  {}
};

void test_torus_sizes()
{
  const analytic::Torus torus;
  Size_options options;
  options.length_over_radius = length_of_error(0.02);
  options.minimum_length = 1e-3;
  options.maximum_length = 10.;
  const Indexed_triangles triangles = indexed(torus.mesh(5000, 3));
  const Sized_model sized(triangles, options);
  const double expected = length_of_error(0.02) * torus.r;
  for(int f = 0; f < triangles.number_of_faces(); ++f)
  {
    Location location;
    location.face = f;
    location.coordinates.fill(1. / 3.);
    assert(std::abs(sized.sizes(location) / expected - 1.) < 0.1);
  }
}

// the unit square, of two triangles
Indexed_triangles unit_square()
{
  Indexed_triangles square;
  square.points = {Vector(0, 0, 0), Vector(1, 0, 0), Vector(1, 1, 0), Vector(0, 1, 0)};
  square.triangles = {{{0, 1, 2}}, {{0, 2, 3}}};
  return square;
}

// two large triangles with one small hole in the user's sizes: bisected there, limited in slope
void test_gradation_on_large_faces()
{
  const Indexed_triangles square = unit_square();
  for(const double gradation : {1.1, 1.3, 2.})
  {
    Size_options options;
    options.minimum_length = 1e-4;
    options.maximum_length = 0.5;
    options.gradation = gradation;
    options.user_size = [](const Vector& p, const Location&) { return (p - Vector(1, 0, 0)).norm() < 1e-9 ? 0.01 : 0.5; };
    const Sized_model sized(square, options);
    const double slope = slope_of_gradation(gradation);
    const auto size_at = [&](const double x, const double y)
    {
      Location location;
      location.face = y <= x ? 0 : 1;
      location.coordinates = y <= x ? Barycentric{{1. - x, x - y, y}} : Barycentric{{1. - y, x, y - x}};
      return sized.sizes(location);
    };
    assert(std::abs(size_at(1., 0.) - 0.01) < 1e-12);
    analytic::Random random(7);
    for(int i = 0; i < 2000; ++i)
    {
      const double x = random(0., 1.), y = random(0., 1.);
      const double distance = std::hypot(x - 1., y);
      const double expected = (std::min)(0.5, 0.01 + slope * distance);
      // propagated along the sides of the cells, which are a little longer than the straight way
      assert(size_at(x, y) > 0.75 * expected && size_at(x, y) < 1.35 * expected);
    }
  }
}

// with the gradation 1 all sizes are the smallest: there is nothing to bisect for
void test_equal_sizes()
{
  const Indexed_triangles square = unit_square();
  std::size_t number_of_questions = 0;
  Size_options options;
  options.minimum_length = 1e-4;
  options.maximum_length = 0.5;
  options.gradation = 1.;
  options.user_size = [&number_of_questions](const Vector& p, const Location&)
  {
    ++number_of_questions;
    return (p - Vector(1, 0, 0)).norm() < 1e-9 ? 0.01 : 0.5;
  };
  options.maximum_number_of_probes = 0;
  const Sized_model sized(square, options);
  assert(std::abs(sized.sizes({0, {{0.3, 0.3, 0.4}}}) - 0.01) < 1e-12);
  assert(number_of_questions < 100);
}

// a flat face between fine rims has a coarse middle
void test_coarse_middle()
{
  std::vector<Vector> points;
  Indexed_triangles cylinder;
  const int n = 48;
  for(const double z : {0., 1.})
    for(int i = 0; i < n; ++i)
      cylinder.points.push_back(Vector(std::cos(2. * analytic::pi * i / n), std::sin(2. * analytic::pi * i / n), z));
  for(int i = 0; i < n; ++i)
  {
    const int j = (i + 1) % n;
    cylinder.triangles.push_back({{i, j, j + n}});
    cylinder.triangles.push_back({{i, j + n, i + n}});
  }
  // caps as fans from a vertex of the rim
  for(int i = 1; i + 1 < n; ++i)
  {
    cylinder.triangles.push_back({{0, i + 1, i}});
    cylinder.triangles.push_back({{n, n + i, n + i + 1}});
  }
  Size_options options;
  options.length_over_radius = length_of_error(0.001);
  options.minimum_length = 1e-4;
  options.maximum_length = 0.4;
  const Sized_model sized(cylinder, options);
  const double fine = length_of_error(0.001);
  double largest_on_cap = 0., largest_on_side = 0.;
  for(int f = 0; f < cylinder.number_of_faces(); ++f)
  {
    Location location;
    location.face = f;
    location.coordinates.fill(1. / 3.);
    double& largest = f < 2 * n ? largest_on_side : largest_on_cap;
    largest = (std::max)(largest, sized.sizes(location));
  }
  assert(largest_on_side < 1.1 * fine);
  assert(largest_on_cap > 4. * fine);
}

// Where the slope of the sizes rules, their number of faces falls slowly with the scale, and then faster. The budget is
// met all the same, and not missed from below.
void test_budget_with_gradation()
{
  const Indexed_triangles square = unit_square();
  for(const double gradation : {1.05, 1.3})
    for(const double share : {0.5, 0.1, 0.01})
    {
      Size_options options;
      options.minimum_length = 1e-4;
      options.maximum_length = 0.5;
      options.gradation = gradation;
      options.user_size = [](const Vector& p, const Location&) { return (p - Vector(1, 0, 0)).norm() < 1e-9 ? 1e-3 : 0.5; };
      Sized_model sized(square, options);
      const auto is_selected = [](int) { return true; };
      const double limit = share * sized.sizes.number_of_faces(is_selected);
      limit_number_of_faces(sized.sizes, limit, is_selected, Progress());
      const double number = sized.sizes.number_of_faces(is_selected);
      std::cout << "  gradation " << gradation << ", budget " << limit << ": " << number << std::endl;
      assert(number <= 1.002 * limit && number >= 0.998 * limit);
    }
}

// The tip of a notch comes close to the middle of an edge, but not to its ends: the size is small there, seen from both
// of its faces, also from the one of which it is not the longest side.
void test_strip_beside_long_face()
{
  constexpr double width = 0.01, length = 0.3;
  Indexed_triangles notched;
  notched.points = {Vector(0, 0, 0), Vector(1, 0, 0), Vector(0.5, width, 0), Vector(1, 1, 0), Vector(0, 1, 0),
                    Vector(0.5, 0, -2)};
  notched.triangles = {{{0, 1, 2}}, {{1, 3, 2}}, {{0, 2, 4}}, {{1, 0, 5}}};
  Size_options options;
  options.minimum_length = 1e-4;
  options.maximum_length = length;
  options.gradation = 2.;
  const Sized_model sized(notched, options);
  for(const int face : {0, 3})
  {
    const double size = sized.sizes(Location{face, {{0.5, 0.5, 0.}}});
    std::cout << "  size in a strip " << size << std::endl;
    assert(size < length / 4.);
  }
}

Indexed_triangles marching_torus(const analytic::Torus& torus)
{
  // off the vertices of the grid
  const auto height = [&](const analytic::Point& p)
  { return std::hypot(std::hypot(p[0] + 1e-3, p[1] + 2e-3) - torus.R, p[2] + 3e-3) - torus.r; };
  return indexed(analytic::Marching_tetrahedra(height, 1.5, 40).triangles);
}

Size_options options_of_torus(const double error)
{
  Size_options options;
  options.length_over_radius = length_of_error(error);
  options.minimum_length = 1e-3;
  options.maximum_length = 0.3;
  return options;
}

// Sizes of a noisy surface follow its curvature, not that of the noise, where they are above the distances of its vertices.
void test_noisy_torus()
{
  const analytic::Torus torus;
  const Indexed_triangles triangles = marching_torus(torus);
  for(const double error : {0.005, 0.01, 0.02})
  {
    Model_options smooth;
    smooth.normals = HDR::SMOOTH_NORMALS;
    const Sized_model sized(triangles, options_of_torus(error), smooth);
    const double size = length_of_error(error) * torus.r;
    const double expected = 4. * analytic::pi * analytic::pi * torus.R * torus.r / (std::sqrt(3.) / 4. * size * size);
    const double number = sized.sizes.number_of_faces([](int) { return true; });
    std::cout << "  of " << triangles.number_of_faces() << " noisy faces " << number / expected
              << " times as many as without noise" << std::endl;
    assert(number > 0.9 * expected && number < 1.7 * expected);
  }
}

// While cells are bisected sizes are graded again only where something has come across these. All anew gives the same.
void test_regrading()
{
  const Indexed_triangles triangles = marching_torus(analytic::Torus());
  Sized_model sized(triangles, options_of_torus(0.01));
  std::vector<Location> locations;
  std::vector<double> sizes;
  for(int f = 0; f < triangles.number_of_faces(); ++f)
    for(const Barycentric& l : {Barycentric{{1. / 3., 1. / 3., 1. / 3.}}, Barycentric{{0.7, 0.2, 0.1}}})
    {
      locations.push_back({f, l});
      sizes.push_back(sized.sizes(locations.back()));
    }
  sized.sizes.scale_by(1.);
  double largest_change = 0.;
  for(std::size_t i = 0; i < locations.size(); ++i)
    largest_change = (std::max)(largest_change, std::abs(sized.sizes(locations[i]) / sizes[i] - 1.));
  std::cout << "  graded anew sizes differ by at most " << largest_change << std::endl;
  // a size is not lowered for the sake of its last digits
  assert(largest_change < 1e-7);
}

// the largest difference, relative, between the sizes from both sides of an edge
double largest_jump(const Indexed_triangles& triangles, const Size_map& sizes)
{
  constexpr int n = 32;
  std::map<std::array<int, 2>, std::vector<double> > sizes_on_edges;
  double result = 0.;
  for(int f = 0; f < triangles.number_of_faces(); ++f)
    for(int k = 0; k < 3; ++k)
    {
      const int v = triangles.triangles[f][k], w = triangles.triangles[f][(k + 1) % 3];
      std::vector<double> on_side;
      for(int i = 1; i < n; ++i)
      {
        Location location{f, {{0., 0., 0.}}};
        location.coordinates[k] = double(v < w ? i : n - i) / n;
        location.coordinates[(k + 1) % 3] = 1. - location.coordinates[k];
        on_side.push_back(sizes(location));
      }
      const auto inserted = sizes_on_edges.insert(std::make_pair(std::array<int, 2>{{(std::min)(v, w), (std::max)(v, w)}},
                                                                 on_side));
      for(int i = 0; i < n - 1; ++i)
        result = (std::max)(result, std::abs(on_side[i] / inserted.first->second[i] - 1.));
    }
  return result;
}

// Cells match where faces meet, whatever is bisected: sizes of curvature, of the user, and those that are asked for later.
void test_continuity()
{
  const Indexed_triangles triangles = indexed(analytic::sin_cos(5.).mesh(300, 3));
  Size_options options;
  options.length_over_radius = length_of_error(0.01);
  options.minimum_length = 1e-3;
  options.maximum_length = 2.;
  constexpr double rounding = 1e-9;
  Sized_model sized(triangles, options);
  assert(largest_jump(triangles, sized.sizes) < rounding);
  analytic::Random random(11);
  for(int i = 0; i < 20; ++i)
  {
    const int face = static_cast<int>(random(0., triangles.number_of_faces() - 1.));
    const double u = random(0., 0.5), v = random(0., 0.5);
    const Location location{face, {{1. - u - v, u, v}}};
    sized.sizes.add_cap(location, sized.sizes(location) / 10.);
  }
  sized.sizes.refine();
  assert(largest_jump(triangles, sized.sizes) < rounding);
  options.user_size = [](const Vector& p, const Location&) { return 0.05 + 0.5 * (p - Vector(1., 1., 0.)).norm(); };
  assert(largest_jump(triangles, Sized_model(triangles, options).sizes) < rounding);
}

int main()
{
  test_error_law();
  test_size_laws();
  test_laws_in_call();
  test_torus_sizes();
  test_gradation_on_large_faces();
  test_equal_sizes();
  test_coarse_middle();
  test_budget_with_gradation();
  test_strip_beside_long_face();
  test_noisy_torus();
  test_regrading();
  test_continuity();
  std::cout << "done" << std::endl;
  return EXIT_SUCCESS;
}
