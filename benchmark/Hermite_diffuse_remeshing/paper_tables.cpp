// Remeshes stand-ins for the meshes of the paper's Tables I to IV, which are not public, at the paper's errors, and
// prints the columns of its tables: faces and smallest quality of the input, error, faces, smallest quality, seconds;
// and the reasons for low qualities.
//
//   paper_tables [cup.off]
//
// The cup stands for the sheet metal of Table I; `make_sheet_metal_cup` of the examples writes it. The other meshes
// are made here: a tank with domed ends and a hole for a pipe (Table II), a rough ore body (Table III), and a gearbox
// housing of blocks, bosses and bores (Table IV), with the slivers that cutting surfaces by each other leaves.

#include "../../examples/Hermite_diffuse_remeshing/report_output.h"
#include "../../test/Hermite_diffuse_remeshing/mesh_measures.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Polygon_mesh_processing/clip.h>
#include <CGAL/Polygon_mesh_processing/corefinement.h>
#include <CGAL/Polygon_mesh_processing/hermite_diffuse_remesh.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>
#include <CGAL/subdivision_method_3.h>

#include <boost/math/constants/constants.hpp>

#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

namespace PMP = CGAL::Polygon_mesh_processing;

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef Kernel::Point_3                                     Point;
typedef Kernel::Vector_3                                    Vector;
typedef CGAL::Surface_mesh<Point>                           Mesh;

constexpr double two_pi = boost::math::constants::two_pi<double>();

// A profile of (radius, height), from the bottom to the top and zero at both ends, turned about an axis through
// `base`; u, v and `axis` are orthonormal.
Mesh make_solid_of_revolution(const std::vector<std::pair<double, double> >& profile, const int number_of_sides,
                              const Point& base, const Vector& u, const Vector& v, const Vector& axis)
{
  Mesh mesh;
  std::vector<std::vector<Mesh::Vertex_index> > rings;
  for(const std::pair<double, double>& p : profile)
  {
    rings.emplace_back();
    const int n = p.first == 0. ? 1 : number_of_sides;
    for(int i = 0; i < n; ++i)
    {
      // turned from ring to ring by half a side, so that triangles are not all alike
      const double angle = two_pi * (i + 0.5 * double(rings.size() % 2)) / number_of_sides;
      rings.back().push_back(mesh.add_vertex(base + p.first * (std::cos(angle) * u + std::sin(angle) * v)
                                             + p.second * axis));
    }
  }
  for(std::size_t k = 1; k < rings.size(); ++k)
    for(int i = 0; i < number_of_sides; ++i)
    {
      const auto at = [&](const std::size_t ring, const int j) { return rings[ring][j % rings[ring].size()]; };
      // the rings with a shift of half a side are every second
      const int shift = k % 2;
      if(rings[k - 1].size() > 1)
        mesh.add_face(at(k - 1, i), at(k - 1, i + 1), at(k, i + 1 - shift));
      if(rings[k].size() > 1)
        mesh.add_face(at(k, i), at(k - 1, i + shift), at(k, i + 1));
    }
  if(!PMP::is_outward_oriented(mesh))
    PMP::reverse_face_orientations(mesh);
  return mesh;
}

Mesh make_cylinder(const double radius, const double height, const int number_of_sides, const Point& base,
                   const Vector& u, const Vector& v, const Vector& axis)
{
  return make_solid_of_revolution({{0., 0.}, {radius, 0.}, {radius, height}, {0., height}}, number_of_sides, base,
                                  u, v, axis);
}

const Vector x_axis(1, 0, 0), y_axis(0, 1, 0), z_axis(0, 0, 1);

// a cylinder of radius 1 and length 3 with ends that are caps of spheres of radius 1.25
Mesh make_tank()
{
  constexpr int number_of_sides = 64, number_of_rings = 30, rings_of_cap = 12;
  constexpr double length = 3., radius_of_cap = 1.25;
  const double angle_of_cap = std::asin(1. / radius_of_cap), depth = radius_of_cap * std::cos(angle_of_cap);
  std::vector<std::pair<double, double> > profile;
  for(int i = 0; i < rings_of_cap; ++i)
  {
    const double angle = angle_of_cap * i / rings_of_cap;
    profile.push_back({radius_of_cap * std::sin(angle), depth - radius_of_cap * std::cos(angle)});
  }
  for(int i = 0; i <= number_of_rings; ++i)
    profile.push_back({1., length * i / number_of_rings});
  for(int i = rings_of_cap - 1; i >= 0; --i)
    profile.push_back({profile[i].first, length - profile[i].second});
  Mesh tank = make_solid_of_revolution(profile, number_of_sides, Point(0, 0, 0), x_axis, y_axis, z_axis);
  Mesh pipe = make_cylinder(0.35, 2., 40, Point(0, 0, 1.8), y_axis, z_axis, x_axis);
  PMP::reverse_face_orientations(pipe);            // what is outside the pipe stays
  PMP::clip(tank, pipe, CGAL::parameters::clip_volume(false));
  return tank;
}

// a sphere with noise of several wave lengths, and folds where the deformation is steep
Mesh make_ore_body()
{
  constexpr int number_of_subdivisions = 5, number_of_octaves = 5;
  Mesh mesh;
  CGAL::make_icosahedron(mesh, Point(0, 0, 0), 1.);
  CGAL::Subdivision_method_3::Loop_subdivision(mesh, CGAL::parameters::number_of_iterations(number_of_subdivisions));
  for(const Mesh::Vertex_index v : mesh.vertices())
  {
    const Vector d = mesh.point(v) - CGAL::ORIGIN;
    const Vector p = d / std::sqrt(d.squared_length());
    Vector moved = p;
    double amplitude = 0.16, frequency = 2.;
    for(int i = 0; i < number_of_octaves; ++i, amplitude *= 0.5, frequency *= 1.9)
    {
      const double a = amplitude * std::sin(frequency * p.x() + 1.7 * i) * std::cos(frequency * 1.1 * p.y() - 0.6 * i);
      const double b = amplitude * (std::abs(std::sin(frequency * (p.z() + 0.4 * p.x()) + i)) - 0.5);
      // across the radius too: folds
      moved = moved + (a + b) * p + 0.6 * a * Vector(-p.y(), p.x(), 0.3 * p.z());
    }
    mesh.point(v) = CGAL::ORIGIN + moved;
  }
  return mesh;
}

Mesh make_block(const double x0, const double y0, const double z0, const double x1, const double y1, const double z1)
{
  Mesh mesh;
  CGAL::make_hexahedron(Point(x0, y0, z0), Point(x1, y0, z0), Point(x1, y1, z0), Point(x0, y1, z0),
                        Point(x0, y1, z1), Point(x0, y0, z1), Point(x1, y0, z1), Point(x1, y1, z1), mesh);
  PMP::triangulate_faces(mesh);
  if(!PMP::is_outward_oriented(mesh))
    PMP::reverse_face_orientations(mesh);
  return mesh;
}

void join(Mesh& mesh, Mesh part) { PMP::corefine_and_compute_union(mesh, part, mesh); }
void cut(Mesh& mesh, Mesh part) { PMP::corefine_and_compute_difference(mesh, part, mesh); }

Mesh make_gearbox()
{
  Mesh mesh = make_block(0, 0, 0, 6, 4, 2.5);
  const auto make_upright_cylinder = [](const double x, const double y, const double r, const double z0, const double z1)
  { return make_cylinder(r, z1 - z0, 48, Point(x, y, z0), x_axis, y_axis, z_axis); };
  join(mesh, make_block(-0.8, 0.3, 0., 6.8, 3.7, 0.35));                             // foot
  for(const double y : {0.77, 2.03, 3.31})
    join(mesh, make_block(5.9, y - 0.06, 0.2, 6.6, y + 0.07, 1.9));                  // ribs
  join(mesh, make_upright_cylinder(1.7, 2.05, 1.2, 2.3, 3.1));                       // bosses
  join(mesh, make_upright_cylinder(4.3, 1.95, 0.9, 2.3, 2.9));
  cut(mesh, make_block(0.31, 0.29, 0.33, 5.71, 3.72, 2.18));                         // the inside
  cut(mesh, make_upright_cylinder(1.7, 2.05, 0.8, -1., 4.));                         // bores
  cut(mesh, make_upright_cylinder(4.3, 1.95, 0.5, -1., 4.));
  cut(mesh, make_cylinder(0.55, 3., 40, Point(-1.5, 2., 1.25), y_axis, z_axis, x_axis));
  for(const double x : {-0.42, 6.43})
    for(const double y : {0.61, 3.38})
      cut(mesh, make_upright_cylinder(x, y, 0.16, -0.5, 1.));                        // bolts
  return mesh;
}

void print_rows(const std::string& name, const Mesh& input, const std::vector<double>& errors)
{
  for(const double error : errors)
  {
    Mesh mesh = input;
    const auto report = PMP::hermite_diffuse_remesh(mesh, CGAL::parameters::approximation_error(error));
    std::cout << name << "\t" << report.number_of_input_faces << "\t" << report.smallest_input_quality << "\t" << error
              << "\t" << report.number_of_faces << "\t" << report.smallest_quality << "\t" << report.mean_quality
              << "\t" << number_of_intersections(input) << "\t" << number_of_intersections(mesh)
              << "\t" << report.seconds << std::endl;
    for(const auto& low : report.low_quality_faces)
      std::cout << "  quality " << low.quality << ": " << explanation(low) << std::endl;
  }
}

int main(int argc, char* argv[])
{
  std::cout << "mesh\tfaces of the input\tits Qmin\terror\tfaces\tQmin\tQmean\tintersections before\tafter\tseconds"
            << std::endl;
  Mesh cup;
  if(argc > 1 && PMP::IO::read_polygon_mesh(argv[1], cup))
    print_rows("sheet metal", cup, {0.05, 0.02, 0.01, 0.001});
  print_rows("tank", make_tank(), {0.1, 0.01, 0.001});
  print_rows("ore body", make_ore_body(), {0.1, 0.01});
  print_rows("gearbox", make_gearbox(), {0.01});
  return EXIT_SUCCESS;
}
