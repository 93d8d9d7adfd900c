// The edges follow the law for the true curvature, the gradation, and fields of the user; the number of
// faces is the predicted one. The largest deviation that is asked for is met, or reported as not met with the
// faces and the reasons; and what is reported is what CGAL measures.

#include "mesh_measures.h"
#include "sampled_model.h"
#include "sized_surfaces.h"
#include "test_helpers.h"

#include <CGAL/Hermite_diffuse_remeshing/Size_fields.h>
#include <CGAL/Hermite_diffuse_remeshing/Size_laws.h>
#include <CGAL/Polygon_mesh_processing/distance.h>

#include <algorithm>
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

// `part`: of the diagonal
void test_contract(const Surface_mesh& input, const double part, const double least_quality)
{
  const double bound = part * diagonal_of_box(input);
  const auto parameters = params::approximation_error(0.1).maximum_deviation(bound);
  Surface_mesh mesh = input;
  const auto report = PMP::hermite_diffuse_remesh(mesh, parameters);
  assert(report.is_maximum_deviation_met && report.largest_deviation <= bound);
  assert(report.faces_above_maximum_deviation.empty() && report.deviation_obstacles.empty());
  assert(report.number_of_deviation_rounds > 0);
  assert(report.stop_reason != HDR::DEVIATION_NOT_MET);
  assert(report.smallest_quality >= least_quality);

  // CGAL's measure knows nothing of ours; no place may be farther away than the report says.
  const double tolerance = 0.03 * bound;
  const Surface_mesh model = sampled_model(input, parameters, tolerance);
  typedef CGAL::Sequential_tag Tag;
  const double independent = (std::max)(PMP::bounded_error_Hausdorff_distance<Tag>(mesh, model, tolerance),
                                        PMP::bounded_error_Hausdorff_distance<Tag>(model, mesh, tolerance));
  assert(independent <= report.largest_deviation + tolerance);
  assert(independent >= report.largest_deviation - 0.15 * bound);

  const double to_input = PMP::approximate_Hausdorff_distance<Tag>(mesh, input, params::random_seed(0));
  assert(report.distance_of_model_from_input > 0.);
  assert(to_input <= report.largest_deviation + report.distance_of_model_from_input);
}

// What the report says of the distance to the input is no less than CGAL finds, also where the model is highest between
// the middles of the sides and the centroids: on a sphere of 8 by 4 cells.
void test_distance_of_model()
{
  std::vector<std::array<double, 2> > profile;
  for(int i = 0; i <= 4; ++i)
    profile.push_back({{i % 4 == 0 ? 0. : std::sin(analytic::pi * i / 4.), -std::cos(analytic::pi * i / 4.)}});
  analytic::Random random(1);
  const Surface_mesh input = make_mesh<Surface_mesh>(analytic::surface_of_revolution(8, profile, random));
  Surface_mesh mesh = input;
  const auto report = PMP::hermite_diffuse_remesh(mesh);
  const double promised = report.largest_deviation + report.distance_of_model_from_input;
  typedef CGAL::Sequential_tag Tag;
  const auto dense = params::random_seed(0).number_of_points_on_faces(100000);
  assert(PMP::approximate_Hausdorff_distance<Tag>(mesh, input, dense) <= promised);
  assert(PMP::approximate_Hausdorff_distance<Tag>(input, mesh, dense) <= promised);
}

// The fits of coarse needles meet with ridges of many degrees, which small faces of the result see between their
// middles alone.
void test_ridges()
{
  const Surface_mesh input = read_data<Surface_mesh>("joint.off");
  const double bound = 2e-4 * diagonal_of_box(input);
  const auto parameters = params::maximum_deviation(bound);
  Surface_mesh mesh = input;
  const auto report = PMP::hermite_diffuse_remesh(mesh, parameters);
  assert(report.is_maximum_deviation_met);
  const Surface_mesh model = sampled_model(input, parameters, 0.03 * bound);
  assert(PMP::approximate_Hausdorff_distance<CGAL::Sequential_tag>(model, mesh,
           params::random_seed(0).number_of_points_on_faces(300000)) <= bound);
}

// edges that may not change decide where the bound cannot be met
void test_protected_edges()
{
  Surface_mesh mesh = make_mesh<Surface_mesh>(analytic::Frustum().mesh(1000, 3));
  const auto is_on_rim = [](const Point_3& p)
  { return std::abs(std::hypot(p.x(), p.y()) - 1.) < 1e-9 && (p.z() < 1e-9 || p.z() > 2. - 1e-9); };
  auto is_constrained = mesh.add_property_map<Surface_mesh::Edge_index, bool>("e:constrained", false).first;
  for(const auto e : edges(mesh))
    is_constrained[e] = is_on_rim(mesh.point(source(e, mesh))) && is_on_rim(mesh.point(target(e, mesh)));
  auto deviations = mesh.add_property_map<Surface_mesh::Face_index, double>("f:deviation", 0.).first;
  const double bound = 1e-3;
  const auto report = PMP::hermite_diffuse_remesh(mesh, params::maximum_deviation(bound)
    .edge_is_constrained_map(is_constrained).protect_constraints(true).face_deviation_map(deviations));
  assert(!report.is_maximum_deviation_met && report.largest_deviation > bound);
  assert(report.stop_reason == HDR::DEVIATION_NOT_MET);
  assert(!report.faces_above_maximum_deviation.empty());
  assert(report.deviation_obstacles.size() == report.faces_above_maximum_deviation.size());
  for(std::size_t i = 0; i < report.deviation_obstacles.size(); ++i)
  {
    assert(deviations[report.faces_above_maximum_deviation[i]] > bound);
    assert(report.deviation_obstacles[i] == HDR::DEVIATION_AT_PROTECTED_EDGE);
  }
  // finer faces at the rims would not help, and are not made
  assert(report.number_of_faces <= 1.5 * report.predicted_number_of_faces && report.smallest_quality >= 0.5);
}

// what no mesh can meet ends at the budget, or at the smallest size
void test_absurd_tolerances()
{
  const Surface_mesh input = make_mesh<Surface_mesh>(analytic::Torus().mesh(1000, 3));
  const std::size_t budget = 5000;
  Surface_mesh mesh = input;
  auto report = PMP::hermite_diffuse_remesh(mesh, params::maximum_deviation(1e-6).maximum_number_of_faces(budget));
  assert(!report.is_maximum_deviation_met && report.stop_reason == HDR::FACE_BUDGET);
  assert(report.number_of_faces <= budget && !report.faces_above_maximum_deviation.empty());

  // not even the smallest size would do: no round is made
  mesh = input;
  report = PMP::hermite_diffuse_remesh(mesh, params::maximum_deviation(1e-12).maximum_number_of_faces(budget));
  assert(!report.is_maximum_deviation_met && report.number_of_faces <= budget);
  assert(report.number_of_deviation_rounds == 0 && !report.deviation_obstacles.empty());
  for(const HDR::Deviation_obstacle obstacle : report.deviation_obstacles)
    assert(obstacle == HDR::DEVIATION_AT_SMALLEST_SIZE);

  mesh = input;
  report = PMP::hermite_diffuse_remesh(mesh, params::approximation_error(1e-12).maximum_number_of_faces(budget));
  assert(report.number_of_faces <= budget && std::abs(report.predicted_number_of_faces / budget - 0.9) <= 0.05);

  mesh = input;
  report = PMP::hermite_diffuse_remesh(mesh, params::maximum_deviation(1e-5).minimum_edge_length(0.1));
  assert(!report.is_maximum_deviation_met && report.stop_reason == HDR::DEVIATION_NOT_MET);
  for(const HDR::Deviation_obstacle obstacle : report.deviation_obstacles)
    assert(obstacle == HDR::DEVIATION_AT_SMALLEST_SIZE);
}

int main()
{
  test_contract(make_mesh<Surface_mesh>(analytic::Torus().mesh(1000, 3)), 4e-3, 0.5);
  test_contract(make_mesh<Surface_mesh>(analytic::Frustum().mesh(1000, 3)), 4e-3, 0.5);
  // so coarse that the model bends between the vertices of the input
  test_contract(make_mesh<Surface_mesh>(analytic::Ellipsoid_123().mesh(200, 3)), 4e-3, 0.4);
  test_distance_of_model();
  test_ridges();
  test_protected_edges();
  test_absurd_tolerances();
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
