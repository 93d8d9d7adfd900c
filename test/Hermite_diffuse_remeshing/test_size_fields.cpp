// The user's sizes: every model of the field, what the map finds of them, the prediction and the budget.

#include "is_refused.h"
#include "test_helpers.h"

#include <CGAL/Aff_transformation_3.h>
#include <CGAL/Hermite_diffuse_remeshing/Background_size_fields.h>
#include <CGAL/Hermite_diffuse_remeshing/Size_fields.h>
#include <CGAL/Hermite_diffuse_remeshing/sizes_from_errors.h>
#include <CGAL/Hermite_diffuse_size_map.h>
#include <CGAL/Polygon_mesh_processing/measure.h>

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <utility>

typedef CGAL::Hermite_diffuse_size_map<Surface_mesh> Size_map;
typedef boost::graph_traits<Surface_mesh>::face_descriptor face_descriptor;
typedef boost::graph_traits<Surface_mesh>::vertex_descriptor vertex_descriptor;

const double infinity = std::numeric_limits<double>::infinity();

Surface_mesh square(const int n)
{
  return make_mesh<Surface_mesh>(analytic::irregular_grid(n, n, false, false, 0.3, 5,
    [](const double u, const double v) { return analytic::Point{{u, v, 0.}}; }));
}

// no curvature, and gradation 2, so that the field rules
template <typename Field>
auto only(const Field& field)
{
  return params::approximation_error(0.).size_field(field).minimum_edge_length(1e-3).maximum_edge_length(0.25)
    .gradation(2.);
}

bool is_close(const double a, const double b, const double tolerance) { return std::abs(a / b - 1.) <= tolerance; }

void test_models()
{
  Surface_mesh mesh = square(8);
  const auto at = [](const Size_map& map, const double x, const double y) { return map.size(Point_3(x, y, 0.)); };

  const Size_map constant(mesh, only(HDR::Constant_size_field(0.07)));
  assert(is_close(at(constant, 0.3, 0.6), 0.07, 1e-9));

  auto vertex_sizes = mesh.add_property_map<vertex_descriptor, double>("v:asked").first;
  for(const vertex_descriptor v : vertices(mesh))
    vertex_sizes[v] = 0.02 + 0.1 * mesh.point(v).x();
  const HDR::Vertex_size_field<Surface_mesh, decltype(vertex_sizes)> vertex_field(mesh, vertex_sizes);
  const Size_map of_vertices(mesh, only(vertex_field));
  for(double x = 0.; x <= 1.; x += 0.05)
    assert(is_close(at(of_vertices, x, 0.37), 0.02 + 0.1 * x, 0.01));

  auto face_sizes = mesh.add_property_map<face_descriptor, float>("f:asked").first;
  const auto is_left = [&](const face_descriptor f)
  { return mesh.point(source(halfedge(f, mesh), mesh)).x() < 0.4; };
  for(const face_descriptor f : faces(mesh))
    face_sizes[f] = is_left(f) ? 0.05f : 0.2f;
  const HDR::Face_size_field<Surface_mesh, decltype(face_sizes)> face_field(mesh, face_sizes);
  const Size_map of_faces(mesh, only(face_field));
  assert(is_close(at(of_faces, 0.1, 0.5), 0.05, 1e-6));
  assert(is_close(at(of_faces, 0.9, 0.5), 0.2, 0.01));

  const auto field = HDR::minimum_size_field(vertex_field, face_field, [](const Point_3&) { return 0.11; });
  const Size_map of_minimum(mesh, only(field));
  assert(is_close(at(of_minimum, 0.1, 0.5), 0.03, 0.02));
  assert(is_close(at(of_minimum, 0.95, 0.5), 0.11, 0.02));

  std::vector<std::pair<Point_3, double> > sized_points;
  analytic::Random random(11);
  for(int i = 0; i < 2000; ++i)
  {
    const Point_3 p(random(-0.1, 1.1), random(-0.1, 1.1), 0.);
    sized_points.push_back(std::make_pair(p, 0.05 + 0.05 * p.y()));
  }
  const HDR::Scattered_size_field<Kernel> scattered(sized_points);
  assert(scattered(sized_points[7].first) == sized_points[7].second);
  const Size_map of_points(mesh, only(scattered));
  const Surface_mesh background = square(3);
  Surface_mesh sized_background = background;
  auto background_sizes = sized_background.add_property_map<vertex_descriptor, double>("v:asked").first;
  for(const vertex_descriptor v : vertices(sized_background))
    background_sizes[v] = 0.05 + 0.05 * sized_background.point(v).y();
  const Size_map of_background(mesh, only(HDR::Background_size_field<Kernel>(sized_background, background_sizes)));
  for(double y = 0.; y <= 1.; y += 0.05)
  {
    assert(is_close(at(of_points, 0.4, y), 0.05 + 0.05 * y, 0.02));
    assert(is_close(at(of_background, 0.4, y), 0.05 + 0.05 * y, 0.01));
  }
  // equally far from all points
  const std::vector<std::pair<Point_3, double> > two = {{Point_3(-1, 0, 0), 1.}, {Point_3(1, 0, 0), 3.}};
  const HDR::Scattered_size_field<Kernel> between(two);
  assert(is_close(between(Point_3(0, 0, 0)), 2., 1e-12));
  // one of a few points, where the other is nine times as far, squared
  assert(is_close(between(Point_3(-0.5, 0, 0)), (9. * 1. + 1. * 3.) / 10., 1e-12));

  typedef std::vector<std::pair<Point_3, double> > Sized_points;
  const double not_finite = std::numeric_limits<double>::infinity();
  for(const Sized_points& bad : {Sized_points(), Sized_points(1, {Point_3(0, 0, not_finite), 1.}),
                                 Sized_points(1, {Point_3(0, 0, 0), not_finite}), Sized_points(1, {Point_3(0, 0, 0), 0.})})
    assert(is_refused([&] { HDR::Scattered_size_field<Kernel>{bad}; }));
  background_sizes[*vertices(sized_background).begin()] = 0.;
  assert(is_refused([&] { HDR::Background_size_field<Kernel>(sized_background, background_sizes); }));
}

// the mesh has two faces, and the field its small sizes inside one of them
void test_feature_inside_face()
{
  const Surface_mesh mesh = square(1);
  const Point_3 center(0.62, 0.31, 0.);
  const double slope = HDR::internal::slope_of_gradation(2.);
  const auto distance = [center](const Point_3& p) { return std::sqrt(CGAL::squared_distance(p, center)); };

  const auto pit = [distance](const Point_3& p) { return 0.01 + 0.3 * distance(p); };
  const Size_map of_pit(mesh, only(pit));
  const auto line = [](const Point_3& p) { return 0.01 + 0.3 * std::abs(p.x() - 0.43); };
  const Size_map of_line(mesh, only(line));
  // as wide as the elements around it, with a jump at its border
  const auto disc = [distance](const Point_3& p) { return distance(p) < 0.15 ? 0.02 : 0.25; };
  const Size_map of_disc(mesh, only(disc));
  for(double x = 0.; x <= 1.; x += 0.02)
    for(double y = 0.; y <= 1.; y += 0.02)
    {
      const Point_3 p(x, y, 0.);
      assert(is_close(of_pit.size(p), (std::min)(0.25, pit(p)), 0.15));
      assert(is_close(of_line.size(p), (std::min)(0.25, line(p)), 0.15));
      const double graded = (std::min)(0.25, 0.02 + slope * (std::max)(0., distance(p) - 0.15));
      assert(is_close(of_disc.size(p), graded, 0.35));
    }
}

void test_prediction_and_budget()
{
  const Surface_mesh input = square(20);
  const double L = 0.03;
  const Size_map map(input, only(HDR::Constant_size_field(L)));
  assert(is_close(map.predicted_number_of_faces(), 4. / (std::sqrt(3.) * L * L), 1e-6));

  const auto field = [](const Point_3& p) { return 0.01 + 0.1 * p.x(); };
  for(const std::size_t budget : {std::size_t(100000), std::size_t(2000), std::size_t(600)})
  {
    Surface_mesh mesh = input;
    const auto report = PMP::hermite_diffuse_remesh(mesh, only(field).maximum_number_of_faces(budget));
    assert(report.number_of_faces <= budget);
    assert(is_close(report.predicted_number_of_faces, double(report.number_of_faces), 0.15));
    assert((report.size_scale == 1.) == (budget == 100000));
    if(budget < 100000)
      assert(double(report.number_of_faces) > 0.75 * budget);
  }
}

// the input has more faces than the budget
void test_budget_of_coarsening()
{
  const Surface_mesh input = make_mesh<Surface_mesh>(analytic::Torus().mesh(10000, 3));
  for(const std::size_t budget : {4000, 1000, 400})
  {
    Surface_mesh mesh = input;
    const auto report =
      PMP::hermite_diffuse_remesh(mesh, params::approximation_error(0.001).maximum_number_of_faces(budget));
    assert(report.number_of_faces <= budget && double(report.number_of_faces) > 0.75 * budget);
    assert(report.size_scale > 1. && report.stop_reason == HDR::CONVERGED);
  }
}

// nothing is changed when the field is refused, and a field that refers to the mesh is safe
void test_reading()
{
  const Surface_mesh input = square(6);
  Surface_mesh mesh = input;
  for(const double bad : {0., -1., -infinity, std::numeric_limits<double>::quiet_NaN()})
  {
    const auto field = [bad](const Point_3& p) { return p.x() > 0.8 && p.y() > 0.8 ? bad : 0.2; };
    assert(is_refused([&] { PMP::hermite_diffuse_remesh(mesh, only(field)); }));
    assert(numbers(mesh) == numbers(input));
  }
  // what is no number does not hide behind another field
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for(const double other : {0.3, infinity})
  {
    const HDR::Constant_size_field good(other), bad(nan);
    assert(is_refused([&] { PMP::hermite_diffuse_remesh(mesh, only(HDR::minimum_size_field(bad, good))); }));
    assert(is_refused([&] { PMP::hermite_diffuse_remesh(mesh, only(HDR::minimum_size_field(good, bad))); }));
  }
  const Size_map none(mesh, only(HDR::Constant_size_field(infinity)));
  for(const double far : {nan, infinity, 1e200})
    assert(is_refused([&] { none.size(Point_3(far, 0., 0.)); }));
  assert(none.size(Point_3(0.5, 0.5, 0.)) == 0.25);

  const auto bump = [](const double u, const double v)
  { return analytic::Point{{u, v, 0.3 * std::sin(3. * u) * std::cos(2. * v)}}; };
  Surface_mesh sized = make_mesh<Surface_mesh>(analytic::irregular_grid(10, 10, false, false, 0.3, 5, bump));
  auto sizes = sized.add_property_map<vertex_descriptor, double>("v:asked", 0.2).first;
  for(const vertex_descriptor v : vertices(sized))
    sizes[v] = 0.1 + 0.1 * sized.point(v).x();
  bool is_changed = false;
  struct Visitor : public HDR::Default_remeshing_visitor<Surface_mesh>
  {
    bool& is_changed;
    explicit Visitor(bool& is_changed) : is_changed(is_changed) {}
    void after_edge_split(const vertex_descriptor) { is_changed = true; }
  } visitor(is_changed);
  const HDR::Vertex_size_field<Surface_mesh, decltype(sizes)> of_vertices(sized, sizes);
  const auto field = [&](const Point_3& p, const face_descriptor f, const std::array<double, 3>& l)
  {
    assert(!is_changed);
    return of_vertices(p, f, l);
  };
  // the deviation makes the map finer when the mesh has changed already
  PMP::hermite_diffuse_remesh(sized, params::approximation_error(0.5).size_field(field).maximum_deviation(2e-4)
                                     .visitor(std::ref(visitor)));
  assert(is_changed);
}

// errors of elements to sizes and back
void test_sizes_from_errors()
{
  Surface_mesh mesh = square(20);
  auto errors = mesh.add_property_map<face_descriptor, double>("f:error").first;
  auto sizes = mesh.add_property_map<vertex_descriptor, double>("v:asked").first;
  const HDR::Vertex_size_field<Surface_mesh, decltype(sizes)> field(mesh, sizes);
  const double order = 1.;
  // the error of linear elements for a solution with the second derivative g
  const auto error_at = [&](const face_descriptor f, const double g)
  {
    const double area = PMP::face_area(f, mesh);
    return g * std::sqrt(4. / std::sqrt(3.) * area) * std::sqrt(area);
  };
  for(const face_descriptor f : faces(mesh))
    errors[f] = error_at(f, 1.);
  // a constant density of error: the same size everywhere
  HDR::sizes_for_number_of_elements(mesh, errors, order, 5000., sizes);
  for(const vertex_descriptor v : vertices(mesh))
    assert(is_close(sizes[v], std::sqrt(4. / std::sqrt(3.) / 5000.), 1e-6));
  assert(is_close(Size_map(mesh, only(field)).predicted_number_of_faces(), 5000., 1e-6));
  // the error is the size: for g = 1 on the area 1
  HDR::sizes_for_error(mesh, errors, order, 0.03, sizes);
  for(const vertex_descriptor v : vertices(mesh))
    assert(is_close(sizes[v], 0.03, 1e-6));
  // the size goes with the root of the derivative
  const auto is_right = [&](const face_descriptor f)
  { return mesh.point(source(halfedge(f, mesh), mesh)).x() > 0.5; };
  for(const face_descriptor f : faces(mesh))
    errors[f] = error_at(f, is_right(f) ? 4. : 1.);
  HDR::sizes_for_number_of_elements(mesh, errors, order, 5000., sizes);
  double left = 0., right = 0.;
  for(const vertex_descriptor v : vertices(mesh))
    if(mesh.point(v).x() < 0.3)
      left = sizes[v];
    else if(mesh.point(v).x() > 0.7)
      right = sizes[v];
  assert(is_close(left / right, 2., 1e-6));
  assert(is_close(Size_map(mesh, only(field)).predicted_number_of_faces(), 5000., 0.1));
  // no error anywhere: no wish
  for(const face_descriptor f : faces(mesh))
    errors[f] = 0.;
  HDR::sizes_for_number_of_elements(mesh, errors, order, 5000., sizes);
  assert(Size_map(mesh, only(field)).size(Point_3(0.5, 0.5, 0.)) == 0.25);

  const auto is_refused_for = [&](const double p, const double number)
  { return is_refused([&] { HDR::sizes_for_number_of_elements(mesh, errors, p, number, sizes); }); };
  assert(is_refused_for(0., 100.));
  assert(is_refused_for(1., 0.));
  errors[*faces(mesh).begin()] = -1.;
  assert(is_refused_for(1., 100.));
  errors[*faces(mesh).begin()] = std::numeric_limits<double>::quiet_NaN();
  assert(is_refused_for(1., 100.));
}

// a turned, scaled and shifted mesh with the field turned, scaled and shifted
void test_invariance()
{
  typedef CGAL::Aff_transformation_3<Kernel> Transformation;
  const double c = std::cos(0.7), s = std::sin(0.7), scale = 50.;
  const Transformation transformation = Transformation(CGAL::SCALING, scale)
    * Transformation(c, -s, 0., s, c, 0., 0., 0., 1.) * Transformation(CGAL::TRANSLATION, Kernel::Vector_3(3., -2., 1.));
  const Surface_mesh input = make_mesh<Surface_mesh>(analytic::Torus().mesh(1500, 3));
  const auto field_around = [](const Point_3& center, const double unit)
  {
    return [=](const Point_3& p)
    {
      const double d = std::sqrt(CGAL::squared_distance(p, center)) / unit;
      return unit * (d < 0.2 ? 0.03 : 0.06 + 0.2 * d);
    };
  };
  const auto remeshed = [&](const Surface_mesh& mesh, const Point_3& center, const double unit, const std::size_t budget)
  {
    Surface_mesh result = mesh;
    auto labels = result.add_property_map<face_descriptor, double>("f:asked").first;
    std::size_t i = 0;
    for(const face_descriptor f : faces(result))
      labels[f] = unit * (i++ < 100 ? 0.05 : infinity);
    const HDR::Face_size_field<Surface_mesh, decltype(labels)> of_faces(result, labels);
    PMP::hermite_diffuse_remesh(result, params::approximation_error(0.05).maximum_number_of_faces(budget)
      .size_field(HDR::minimum_size_field(of_faces, field_around(center, unit))));
    return result;
  };
  const Point_3 center(0.7, 0.75, 0.35);
  for(const std::size_t budget : {100000, 1500})
  {
    Surface_mesh image = input;
    for(const vertex_descriptor v : vertices(image))
      image.point(v) = transformation(image.point(v));
    const Surface_mesh result = remeshed(input, center, 1., budget);
    const Surface_mesh result_of_image = remeshed(image, transformation(center), scale, budget);
    assert(is_image(result, result_of_image, transformation, 1e-5 * scale));
  }
}

int main()
{
  test_invariance();
  test_sizes_from_errors();
  test_models();
  test_feature_inside_face();
  test_prediction_and_budget();
  test_budget_of_coarsening();
  test_reading();
  std::cout << "done" << std::endl;
  return EXIT_SUCCESS;
}
