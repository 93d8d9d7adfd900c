// Remeshes known meshes to given numbers of faces, by trying approximation errors, and prints what CGAL
// measures on the results: one line per mesh, the columns separated by tabs, and the reasons for low qualities.
//
//   quality_table [error|sagitta] [part of a name] [gradation [displacement deviation]]
//
// The sizes follow the relative error, or a sagitta that is the same everywhere. A small gradation makes better
// triangles, a large one spends the faces where the curvature is; 1.3 is the default. The last two are bounds, of
// `maximum_displacement` and `maximum_deviation`, in parts of the two-sided distance to the input with as many faces
// that the best other program has been seen to reach; without them there are no bounds.

#include "../../examples/Hermite_diffuse_remeshing/report_output.h"
#include "../../test/Hermite_diffuse_remeshing/make_mesh.h"
#include "../../test/Hermite_diffuse_remeshing/mesh_measures.h"
#include "../../test/Hermite_diffuse_remeshing/sized_surfaces.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Polygon_mesh_processing/distance.h>
#include <CGAL/Polygon_mesh_processing/hermite_diffuse_remesh.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <iterator>
#include <limits>
#include <string>
#include <vector>

namespace PMP = CGAL::Polygon_mesh_processing;

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef Kernel::Point_3                                     Point;
typedef CGAL::Surface_mesh<Point>                           Mesh;
typedef CGAL::Hermite_diffuse_remeshing::Remeshing_report<Mesh> Report;

struct Case
{
  const char* name;
  std::size_t number_of_faces;
  double distance;                      // of other programs, relative to the diagonal; infinite where it is not known
};

constexpr double unknown = std::numeric_limits<double>::infinity();
const Case cases[] = {{"fandisk", 6000, 9e-4}, {"joint", 6000, unknown}, {"elephant", 8000, 3e-3},
                      {"anchor_dense", 8000, 2e-3}, {"couplingdown", 6000, 6e-3}, {"mech-holes-shark", 8000, 1.3e-3},
                      {"armadillo", 50000, 1.6e-3}, {"bunny00", 100000, 7.6e-4}, {"torus", 6000, unknown},
                      {"ellipsoid", 6000, unknown}};

Mesh read(const std::string& name)
{
  constexpr int number_of_faces = 20000, seed = 1;
  if(name == "torus")
    return make_mesh<Mesh>(analytic::Sized_torus().mesh(number_of_faces, seed));
  if(name == "ellipsoid")
    return make_mesh<Mesh>(analytic::Ellipsoid_123().mesh(number_of_faces, seed));
  Mesh mesh;
  PMP::IO::read_polygon_mesh(CGAL::data_file_path("meshes/" + name + ".off"), mesh);
  return mesh;
}

std::vector<double> sorted_qualities(const Mesh& mesh)
{
  std::vector<double> result;
  for(const Mesh::Face_index f : mesh.faces())
  {
    const auto h = mesh.halfedge(f);
    const Point& a = mesh.point(mesh.source(h));
    const Point& b = mesh.point(mesh.target(h));
    const Point& c = mesh.point(mesh.target(mesh.next(h)));
    const double l = std::sqrt(CGAL::squared_distance(a, b)), m = std::sqrt(CGAL::squared_distance(b, c)),
                 n = std::sqrt(CGAL::squared_distance(c, a));
    const double area = std::sqrt(CGAL::squared_area(a, b, c));
    result.push_back(4. * std::sqrt(3.) * area / ((l + m + n) * (std::max)({l, m, n})));
  }
  std::sort(result.begin(), result.end());
  return result;
}

bool is_sagitta = false;
double gradation = 1.3;
double displacement = unknown, deviation = unknown;     // of the mesh at hand

// `value` is the relative error, or the sagitta relative to the diagonal
Report remesh(Mesh& mesh, const double value, const bool is_guarded = true)
{
  const auto bounds = CGAL::parameters::gradation(gradation).maximum_displacement(displacement)
                                       .maximum_deviation(deviation).do_self_intersection_tests(is_guarded);
  return is_sagitta ? PMP::hermite_diffuse_remesh(mesh, bounds.sagitta(value * diagonal_of_box(mesh)))
                    : PMP::hermite_diffuse_remesh(mesh, bounds.approximation_error(value));
}

// rms distances to the surface that the input is made of: of the vertices, and of points on the faces
template <typename Surface>
void print_true_distances(const Mesh& mesh, const Surface& surface)
{
  const auto rms = [&](const std::vector<Point>& points)
  {
    double sum = 0.;
    for(const Point& p : points)
      sum += CGAL::square(surface.distance({{p.x(), p.y(), p.z()}}));
    return std::sqrt(sum / double(points.size()));
  };
  std::vector<Point> vertices, samples;
  for(const Mesh::Vertex_index v : mesh.vertices())
    vertices.push_back(mesh.point(v));
  PMP::sample_triangle_mesh(mesh, std::back_inserter(samples),
                            CGAL::parameters::random_seed(0).number_of_points_on_faces(200000));
  std::cout << "  rms distance to the true surface: vertices " << rms(vertices) << ", points on the faces " << rms(samples)
            << std::endl;
}

// the part of the edges that another run with the same parameters does not keep
double changed_edges(Mesh first, const double value)
{
  first.collect_garbage();
  Mesh second = first;
  remesh(second, value);
  std::size_t kept = 0;
  for(const Mesh::Edge_index e : first.edges())
  {
    const Mesh::Vertex_index v = first.vertex(e, 0), w = first.vertex(e, 1);
    kept += !second.is_removed(v) && !second.is_removed(w) && second.halfedge(v, w) != Mesh::null_halfedge();
  }
  return 1. - double(kept) / double(first.number_of_edges());
}

// the part of the time that the tests of intersections take; the shorter of two runs counts
double share_of_guard(const Mesh& input, const double value)
{
  double seconds[2];
  for(const bool is_guarded : {false, true})
  {
    seconds[is_guarded] = unknown;
    for(int i = 0; i < 2; ++i)
    {
      Mesh mesh = input;
      seconds[is_guarded] = (std::min)(seconds[is_guarded], remesh(mesh, value, is_guarded).seconds);
    }
  }
  return 1. - seconds[false] / seconds[true];
}

// `result` gets the mesh with the number of faces closest to the one wanted
double find_value(const Mesh& input, const std::size_t number_of_faces, Mesh& result, Report& report)
{
  constexpr int maximum_number_of_trials = 6;
  constexpr double enough = 0.02;
  double value = is_sagitta ? 1e-3 : 1e-2, best_value = value, best = 1e9;
  for(int i = 0; i < maximum_number_of_trials; ++i)
  {
    Mesh mesh = input;
    const Report r = remesh(mesh, value);
    const double ratio = double(r.number_of_faces) / double(number_of_faces);
    if(std::abs(std::log(ratio)) < best)
    {
      best = std::abs(std::log(ratio));
      best_value = value;
      result = mesh;
      report = r;
    }
    if(best < enough)
      break;
    value = (std::min)(0.5, value * ratio);
  }
  return best_value;
}

int main(int argc, char* argv[])
{
  is_sagitta = argc > 1 && std::string(argv[1]) == "sagitta";
  const std::string wanted = argc > 2 ? argv[2] : "";
  if(argc > 3)
    gradation = std::atof(argv[3]);
  std::cout << "mesh\t" << (is_sagitta ? "sagitta" : "error") << "\tfaces\tQmin\tQ1%\tQmean\tbelow 0.3\tdistance of the diagonal there\tback"
               "\tmodel largest\trms\tintersections before\tafter\tchanged by a second run\tseconds"
               "\tof them intersections" << std::endl;
  for(const Case& c : cases)
  {
    const std::string name = c.name;
    if(name.find(wanted) == std::string::npos)
      continue;
    const Mesh input = read(name);
    if(argc > 5)
    {
      displacement = std::atof(argv[4]) * c.distance * diagonal_of_box(input);
      deviation = std::atof(argv[5]) * c.distance * diagonal_of_box(input);
    }
    Mesh mesh;
    Report report;
    const double value = find_value(input, c.number_of_faces, mesh, report);
    const std::vector<double> q = sorted_qualities(mesh);
    double sum = 0.;
    for(const double quality : q)
      sum += quality;
    const double length = diagonal_of_box(input);
    std::cout << name << "\t" << value << "\t" << q.size() << "\t" << q.front() << "\t" << q[q.size() / 100]
              << "\t" << sum / double(q.size())
              << "\t" << std::lower_bound(q.begin(), q.end(), 0.3) - q.begin()
              << "\t" << largest_distance(mesh, input) / length << "\t" << largest_distance(input, mesh) / length
              << "\t" << report.largest_deviation / length << "\t" << report.mean_deviation / length
              << "\t" << number_of_intersections(input) << "\t" << number_of_intersections(mesh)
              << "\t" << changed_edges(mesh, value) << "\t" << report.seconds << "\t" << share_of_guard(input, value)
              << std::endl;
    if(name == "torus")
      print_true_distances(mesh, analytic::Sized_torus());
    if(name == "ellipsoid")
      print_true_distances(mesh, analytic::Ellipsoid_123());
    for(const auto& low : report.low_quality_faces)
      std::cout << "  quality " << low.quality << ": " << explanation(low) << std::endl;
  }
  return EXIT_SUCCESS;
}
