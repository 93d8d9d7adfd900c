// This package beside the isotropic remeshing of CGAL, and, from CGAL 6 on, its adaptive sizes: on a torus that is
// known, and on two of CGAL's meshes with sharp edges. The isotropic meshes get as many faces as ours within 3 %: their
// lengths are searched. One line per case, the columns separated by tabs; distances of the vertices to the true torus in
// edge lengths of the input.

#include "../../test/Hermite_diffuse_remeshing/analytic_surfaces.h"
#include "../../test/Hermite_diffuse_remeshing/make_mesh.h"
#include "../../test/Hermite_diffuse_remeshing/mesh_measures.h"
#include "find_value.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Polygon_mesh_processing/bbox.h>
#include <CGAL/Polygon_mesh_processing/detect_features.h>
#include <CGAL/Polygon_mesh_processing/hermite_diffuse_remesh.h>
#include <CGAL/Polygon_mesh_processing/remesh.h>
#include <CGAL/Real_timer.h>
#include <CGAL/Surface_mesh.h>

#if __has_include(<CGAL/Polygon_mesh_processing/Adaptive_sizing_field.h>)
#include <CGAL/Polygon_mesh_processing/Adaptive_sizing_field.h>
#define HAS_ADAPTIVE_SIZES
#endif

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <iostream>
#include <string>

typedef CGAL::Exact_predicates_inexact_constructions_kernel   K;
typedef CGAL::Surface_mesh<K::Point_3>                        Mesh;
typedef std::function<double(const analytic::Point&)>         Distance;

namespace PMP = CGAL::Polygon_mesh_processing;

constexpr double error = 0.01, sharp_angle = 40.;
constexpr int number_of_iterations = 10;

Mesh::Property_map<Mesh::Edge_index, bool> sharp_edges(Mesh& mesh)
{
  const auto is_sharp = mesh.add_property_map<Mesh::Edge_index, bool>("e:is_sharp", false).first;
  PMP::detect_sharp_edges(mesh, sharp_angle, is_sharp);
  return is_sharp;
}

// runs a remesher on a copy, and prints what it has made
template <typename Remesh>
std::size_t run(const std::string& name, const char* method, const Mesh& input, const Distance& distance,
                const Remesh& remesh)
{
  Mesh mesh = input;
  CGAL::Real_timer timer;
  timer.start();
  remesh(mesh);
  timer.stop();
  mesh.collect_garbage();

  double length = 0., smallest = 1., sum = 0., square = 0., largest = 0.;
  for(const auto e : input.edges())
    length += PMP::edge_length(input.halfedge(e), input) / input.number_of_edges();
  for(const auto f : mesh.faces())
  {
    const auto h = mesh.halfedge(f);
    const double a = PMP::edge_length(h, mesh), b = PMP::edge_length(mesh.next(h), mesh),
                 c = PMP::edge_length(mesh.prev(h), mesh);
    const double quality = 4. * std::sqrt(3.) * PMP::face_area(f, mesh) / ((a + b + c) * (std::max)({a, b, c}));
    smallest = (std::min)(smallest, quality);
    sum += quality;
  }
  if(distance)
    for(const auto v : mesh.vertices())
    {
      const K::Point_3& p = mesh.point(v);
      const double d = std::abs(distance({{p.x(), p.y(), p.z()}})) / length;
      square += d * d;
      largest = (std::max)(largest, d);
    }
  std::cout << name << '\t' << method << '\t' << mesh.number_of_faces() << '\t' << smallest << '\t'
            << sum / mesh.number_of_faces() << '\t';
  if(distance)
    std::cout << std::sqrt(square / mesh.number_of_vertices()) << '\t' << largest;
  else
    std::cout << "-\t-";
  std::cout << '\t' << timer.time() << std::endl;
  return mesh.number_of_faces();
}

void compare(const std::string& name, const Mesh& input, const Distance& distance, const double sagitta)
{
  const std::size_t number_of_faces = run(name, "this package", input, distance, [](Mesh& mesh)
  { PMP::hermite_diffuse_remesh(mesh, CGAL::parameters::approximation_error(error).sharp_dihedral_angle(sharp_angle)); });
  const double size = size_for(input, double(number_of_faces));
  const auto number_of_faces_of = [&](const auto& remesh)
  {
    Mesh mesh = input;
    remesh(mesh);
    return double(mesh.number_of_faces());
  };
  const auto parameters_for = [](Mesh& mesh)
  {
    return CGAL::parameters::number_of_iterations(number_of_iterations).edge_is_constrained_map(sharp_edges(mesh));
  };
  const auto isotropic = [&](const double length)
  { return [&, length](Mesh& mesh) { PMP::isotropic_remeshing(faces(mesh), length, mesh, parameters_for(mesh)); }; };
  run(name, "isotropic", input, distance,
      isotropic(find_value(size, double(number_of_faces), 2.,
                           [&](const double length) { return number_of_faces_of(isotropic(length)); })));
#ifdef HAS_ADAPTIVE_SIZES
  const auto adaptive = [&](const double tolerance)
  {
    return [&, tolerance](Mesh& mesh)
    {
      PMP::Adaptive_sizing_field<Mesh> sizes(tolerance, std::make_pair(0.2 * size, 5. * size), faces(mesh), mesh);
      PMP::isotropic_remeshing(faces(mesh), sizes, mesh, parameters_for(mesh));
    };
  };
  run(name, "isotropic, adaptive sizes", input, distance,
      adaptive(find_value(sagitta, double(number_of_faces), 1.,
                          [&](const double tolerance) { return number_of_faces_of(adaptive(tolerance)); })));
#else
  CGAL_USE(sagitta);
#endif
}

int main()
{
  std::cout << "mesh\tmethod\tfaces\tsmallest quality\tmean quality\trms distance\tlargest distance\tseconds" << std::endl;
  const analytic::Torus torus;
  for(const int number : {2000, 20000})
    compare("torus " + std::to_string(number), make_mesh<Mesh>(torus.mesh(number, 1)),
            [&](const analytic::Point& p) { return torus.distance(p); }, 0.007 / torus.largest_curvature());
  for(const char* name : {"fandisk", "joint"})
  {
    Mesh mesh;
    if(!PMP::IO::read_polygon_mesh(CGAL::data_file_path(std::string("meshes/") + name + ".off"), mesh))
      return EXIT_FAILURE;
    const CGAL::Bbox_3 box = PMP::bbox(mesh);
    compare(name, mesh, Distance(), 0.001 * (box.xmax() - box.xmin()));
  }
  return EXIT_SUCCESS;
}
