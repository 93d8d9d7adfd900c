// How well the edges follow the sizes that were asked for, on surfaces with known curvature and on
// fields of the user. One line per case, the columns separated by tabs. An argument runs only the cases
// whose name contains it.

#include "../../test/Hermite_diffuse_remeshing/make_mesh.h"
#include "../../test/Hermite_diffuse_remeshing/sized_surfaces.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Hermite_diffuse_remeshing/Size_fields.h>
#include <CGAL/Hermite_diffuse_remeshing/Size_laws.h>
#include <CGAL/Polygon_mesh_processing/hermite_diffuse_remesh.h>
#include <CGAL/Surface_mesh.h>

#include <cmath>
#include <iostream>
#include <string>
#include <vector>

typedef CGAL::Exact_predicates_inexact_constructions_kernel   K;
typedef CGAL::Surface_mesh<K::Point_3>                        Mesh;
typedef boost::graph_traits<Mesh>::vertex_descriptor          vertex_descriptor;
typedef boost::graph_traits<Mesh>::face_descriptor            face_descriptor;

namespace PMP = CGAL::Polygon_mesh_processing;
namespace HDR = CGAL::Hermite_diffuse_remeshing;

std::string wanted;

bool is_wanted(const std::string& name) { return name.find(wanted) != std::string::npos; }

template <typename Parameters, typename Law>
void run(const std::string& name, const double value, const double gradation, const Mesh& input,
         const Parameters& parameters, const Law& law)
{
  Mesh mesh = input;
  const auto report = PMP::hermite_diffuse_remesh(mesh, parameters);
  const auto point = [&mesh](const vertex_descriptor v)
  { return analytic::Point{{mesh.point(v).x(), mesh.point(v).y(), mesh.point(v).z()}}; };
  const analytic::Size_statistics s = analytic::size_statistics(mesh, point, law);
  std::cout << name << "\t" << value << "\t" << gradation << "\t" << report.number_of_faces
            << "\t" << report.predicted_number_of_faces / double(report.number_of_faces)
            << "\t" << 100. * s.half_to_twice << "\t" << 100. * s.within_sqrt2 << "\t" << s.mean_log2
            << "\t" << s.adjacent_ratio_99 << "\t" << report.smallest_quality << "\t" << report.mean_quality
            << "\t" << report.number_of_iterations << "\t" << report.seconds << std::endl;
}

template <typename Surface>
void run_law(const std::string& name, const Surface& surface, const std::vector<double>& errors,
             const std::vector<double>& gradations, const int number_of_faces)
{
  if(!is_wanted(name))
    return;
  const Mesh input = make_mesh<Mesh>(surface.mesh(number_of_faces, 3));
  for(const double gradation : gradations)
    for(const double error : errors)
    {
      analytic::Sizes_asked asked;
      asked.length_over_radius = HDR::length_over_radius_of_error(error);
      asked.maximum_length = asked.length_over_radius * surface.largest_radius();
      asked.slope = std::sqrt(3.) * std::log(gradation);
      run(name, error, gradation, input,
          CGAL::parameters::approximation_error(error).gradation(gradation)
            .maximum_edge_length(asked.maximum_length),
          [&](const analytic::Point& p) { return surface.law(p, asked); });
    }
}

// sizes of the user on the flat square and on the torus
template <typename Field>
void run_field(const std::string& name, const Mesh& input, const Field& field, const double scale)
{
  if(!is_wanted(name))
    return;
  const double gradation = 2.;
  run(name, scale, gradation, input,
      CGAL::parameters::approximation_error(0.).size_field(field).gradation(gradation)
        .minimum_edge_length(1e-4).maximum_edge_length(1.),
      [&](const analytic::Point& p) { return field(K::Point_3(p[0], p[1], p[2])); });
}

void run_fields(const std::string& name, const Mesh& input, const K::Point_3& center)
{
  const auto distance = [center](const K::Point_3& p) { return std::sqrt(CGAL::squared_distance(p, center)); };
  for(const double scale : {1., 0.5})
  {
    const auto at_point = [=](const K::Point_3& p) { return scale * (0.01 + 0.15 * distance(p)); };
    const auto along_plane = [=](const K::Point_3& p) { return scale * (0.02 + 0.2 * std::abs(p.x() - center.x())); };
    const auto both = [=](const K::Point_3& p) { return (std::min)(at_point(p), along_plane(p)); };
    run_field(name + " point", input, at_point, scale);
    run_field(name + " plane", input, along_plane, scale);
    run_field(name + " minimum", input, both, scale);

    // per label: the left and the right half, the size growing from the left to the right
    if(!is_wanted(name + " label"))
      continue;
    Mesh mesh = input;
    const double fine = 0.03 * scale, coarse = 0.08 * scale, gradation = 2.;
    const double slope = std::sqrt(3.) * std::log(gradation);
    auto sizes = mesh.add_property_map<face_descriptor, double>("f:asked").first;
    double border = -1e9;
    for(const face_descriptor f : faces(mesh))
    {
      bool is_left = true;
      double largest = -1e9;
      for(const vertex_descriptor v : CGAL::vertices_around_face(halfedge(f, mesh), mesh))
      {
        is_left = is_left && mesh.point(v).x() <= center.x();
        largest = (std::max)(largest, mesh.point(v).x());
      }
      sizes[f] = is_left ? fine : coarse;
      if(is_left)
        border = (std::max)(border, largest);
    }
    const HDR::Face_size_field<Mesh, decltype(sizes)> field(mesh, sizes);
    run(name + " label", scale, gradation, mesh,
        CGAL::parameters::approximation_error(0.).size_field(field).gradation(gradation)
          .minimum_edge_length(1e-4).maximum_edge_length(1.),
        [&](const analytic::Point& p)
        { return p[0] <= border ? fine : (std::min)(coarse, fine + slope * (p[0] - border)); });
  }
}

int main(int argc, char* argv[])
{
  if(argc > 1)
    wanted = argv[1];
  std::cout << "case\tvalue\tgradation\tfaces\tpredicted/faces\t% half to twice\t% within sqrt2\tmean log2"
               "\tadjacent ratio p99\tsmallest quality\tmean quality\titerations\tseconds" << std::endl;
  const std::vector<double> errors = {0.1, 0.05, 0.02, 0.01, 0.001};
  const std::vector<double> only_law = {2.};
  analytic::Frustum cylinder, cone;
  cone.top = 0.5;
  run_law("torus", analytic::Sized_torus(), errors, only_law, 20000);
  run_law("cylinder", cylinder, errors, only_law, 20000);
  run_law("cone frustum", cone, errors, only_law, 20000);
  run_law("ellipsoid", analytic::Ellipsoid_123(), {0.02, 0.01, 0.002}, only_law, 20000);
  run_law("gradation ellipsoid", analytic::Ellipsoid_123(), {0.01}, {1.1, 1.3, 2.}, 20000);
  run_law("gradation cone frustum", cone, {0.01}, {1.1, 1.3, 2.}, 20000);

  run_fields("square", make_mesh<Mesh>(analytic::irregular_grid(8, 8, false, false, 0.3, 5,
    [](const double u, const double v) { return analytic::Point{{u, v, 0.}}; })), K::Point_3(0.41, 0.33, 0.));
  const analytic::Torus torus;
  run_fields("on torus", make_mesh<Mesh>(torus.mesh(5000, 3)), K::Point_3(0.6, 0.7, 0.3));
  return EXIT_SUCCESS;
}
