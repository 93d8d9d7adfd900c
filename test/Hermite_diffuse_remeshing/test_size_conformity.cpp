// The edges follow the law for the true curvature, the gradation, and fields of the user; the number of
// faces is the predicted one.

#include "sized_surfaces.h"
#include "test_helpers.h"

#include <CGAL/Hermite_diffuse_remeshing/Size_fields.h>
#include <CGAL/Hermite_diffuse_remeshing/Size_laws.h>

#include <initializer_list>

// returns the number of faces
template <typename Parameters, typename Law>
double check(const Surface_mesh& input, const Parameters& parameters, const Law& law, const double gradation)
{
  Surface_mesh mesh = input;
  const auto report = PMP::hermite_diffuse_remesh(mesh, parameters);
  const analytic::Size_statistics s =
    analytic::size_statistics(mesh, [&mesh](const auto v) { return coordinates(mesh, v); }, law);
  assert(s.half_to_twice >= 0.97);
  assert(s.within_sqrt2 >= 0.85);
  assert(std::abs(s.mean_log2) <= 0.15);
  assert(s.adjacent_ratio_99 <= 1.35 * gradation);
  const double number_of_faces = double(report.number_of_faces);
  assert(std::abs(report.predicted_number_of_faces / number_of_faces - 1.) <= 0.15);
  return number_of_faces;
}

// errors that are halved from one to the next
template <typename Surface>
void test_law(const Surface& surface, const std::initializer_list<double> errors)
{
  const double gradation = 2.;
  const Surface_mesh input = make_mesh<Surface_mesh>(surface.mesh(12000, 3));
  double before = 0.;
  for(const double error : errors)
  {
    analytic::Sizes_asked asked;
    asked.length_over_radius = HDR::length_over_radius_of_error(error);
    asked.maximum_length = asked.length_over_radius * surface.largest_radius();
    asked.slope = std::sqrt(3.) * std::log(gradation);
    const double faces = check(input, params::approximation_error(error).gradation(gradation)
                                        .maximum_edge_length(asked.maximum_length),
                               [&](const analytic::Point& p) { return surface.law(p, asked); }, gradation);
    assert(before == 0. || std::abs(faces / before / 2. - 1.) <= 0.15);
    before = faces;
  }
}

void test_gradation()
{
  const analytic::Ellipsoid_123 ellipsoid;
  const Surface_mesh input = make_mesh<Surface_mesh>(ellipsoid.mesh(12000, 3));
  for(const double gradation : {1.1, 1.3, 2.})
  {
    Surface_mesh mesh = input;
    PMP::hermite_diffuse_remesh(mesh, params::approximation_error(0.01).gradation(gradation).maximum_edge_length(10.));
    const analytic::Size_statistics s = analytic::size_statistics(
      mesh, [&mesh](const auto v) { return coordinates(mesh, v); }, [](const analytic::Point&) { return 1.; });
    assert(s.adjacent_ratio_99 <= 1.35 * gradation);
  }
}

void test_fields()
{
  const Point_3 center(0.6, 0.7, 0.3);
  const auto at_point = [center](const Point_3& p)
  { return 0.02 + 0.2 * std::sqrt(CGAL::squared_distance(p, center)); };
  const auto along_plane = [center](const Point_3& p) { return 0.03 + 0.3 * std::abs(p.x() - center.x()); };
  const auto both = [=](const Point_3& p) { return (std::min)(at_point(p), along_plane(p)); };
  const Surface_mesh input = make_mesh<Surface_mesh>(analytic::Torus().mesh(3000, 3));
  const double gradation = 2.;
  const auto check_field = [&](const auto& field, const auto& expected)
  {
    check(input, params::approximation_error(0.).size_field(field).gradation(gradation).minimum_edge_length(1e-4)
                   .maximum_edge_length(1.),
          [&](const analytic::Point& p) { return expected(Point_3(p[0], p[1], p[2])); }, gradation);
  };
  check_field(at_point, at_point);
  check_field(along_plane, along_plane);
  check_field(HDR::minimum_size_field(at_point, along_plane), both);
}

int main()
{
  analytic::Frustum cylinder, cone;
  cone.top = 0.5;
  test_law(analytic::Sized_torus(), {0.1, 0.05});
  test_law(analytic::Sized_torus(), {0.02, 0.01});
  test_law(cylinder, {0.1, 0.05});
  test_law(cylinder, {0.02, 0.01});
  test_law(cone, {0.1, 0.05});
  test_law(cone, {0.02, 0.01});
  test_law(analytic::Ellipsoid_123(), {0.02, 0.01});
  test_gradation();
  test_fields();
  std::cout << "done" << std::endl;
  return EXIT_SUCCESS;
}
