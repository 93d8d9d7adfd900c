#include "test_helpers.h"

#include <limits>
#include <stdexcept>

// Remeshing a copy must throw std::invalid_argument with a message that contains `name`, and leave
// the copy as it was.
template <typename NamedParameters>
void expect_refusal(const Surface_mesh& input, const NamedParameters& np, const std::string& name)
{
  Surface_mesh mesh = input;
  bool is_refused = false;
  try
  {
    PMP::hermite_diffuse_remesh(mesh, np);
  }
  catch(const std::invalid_argument& error)
  {
    is_refused = std::string(error.what()).find(name) != std::string::npos;
    if(!is_refused)
      std::cerr << "unexpected message: " << error.what() << std::endl;
  }
  assert(is_refused);
  assert(numbers(mesh) == numbers(input));
  for(const auto v : vertices(input))
    for(int i = 0; i < 3; ++i)
    {
      const double before = input.point(v)[i], after = mesh.point(v)[i];
      assert(before == after || (std::isnan(before) && std::isnan(after)));
    }
}

int main()
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  const Surface_mesh cube = read_data<Surface_mesh>("cube.off");

  expect_refusal(Surface_mesh(), params::default_values(), "no face");

  const Surface_mesh quads = read_data<Surface_mesh>("cube_quad.off");
  expect_refusal(quads, params::default_values(), "sides of face 0 is 4");

  for(const double bad : {nan, infinity, -infinity})
  {
    Surface_mesh mesh = cube;
    mesh.point(Surface_mesh::Vertex_index(5)) = Point_3(0., bad, 0.);
    expect_refusal(mesh, params::default_values(), "vertex 5");
  }

  for(const double bad : {-0.01, nan})
  {
    expect_refusal(cube, params::approximation_error(bad), "approximation_error");
    expect_refusal(cube, params::maximum_deviation(bad), "maximum_deviation");
    expect_refusal(cube, params::minimum_edge_length(bad), "minimum_edge_length");
    expect_refusal(cube, params::maximum_edge_length(bad), "maximum_edge_length");
    expect_refusal(cube, params::gradation(bad), "gradation");
    expect_refusal(cube, params::sharp_dihedral_angle(bad), "sharp_dihedral_angle");
    expect_refusal(cube, params::corner_angle(bad), "corner_angle");
    expect_refusal(cube, params::apex_angular_defect(bad), "apex_angular_defect");
    expect_refusal(cube, params::hermite_weight(bad), "hermite_weight");
  }
  expect_refusal(cube, params::approximation_error(infinity), "approximation_error");
  expect_refusal(cube, params::maximum_deviation(0.), "maximum_deviation");
  expect_refusal(cube, params::minimum_edge_length(infinity), "minimum_edge_length");
  expect_refusal(cube, params::gradation(0.99), "gradation");
  expect_refusal(cube, params::gradation(2.01), "gradation");
  expect_refusal(cube, params::sharp_dihedral_angle(181.), "sharp_dihedral_angle");
  expect_refusal(cube, params::hermite_weight(1.), "hermite_weight");
  expect_refusal(cube, params::polynomial_degree(1), "polynomial_degree");
  expect_refusal(cube, params::polynomial_degree(5), "polynomial_degree");
  expect_refusal(cube, params::minimum_edge_length(0.2).maximum_edge_length(0.1), "minimum_edge_length");
  expect_refusal(cube, params::approximation_error(0.01).number_of_iterations(0), "number_of_iterations");
  expect_refusal(cube, params::size_field([](const Point_3&) { return -1.; }), "size_field");
  expect_refusal(cube, params::size_field([nan](const Point_3&) { return nan; }), "size_field");

  std::cout << "done" << std::endl;
  return EXIT_SUCCESS;
}
