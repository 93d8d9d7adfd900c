// How long a stop request waits: the longest time between two questions to the visitor, in every stage and between
// them, and the time from the answer "stop" to the return, on a mesh of 100000 faces or on the file that is given.
// All times are of the processor, so that other programs do not count.
//
//   stop_latency [FILE [approximation error [part of the diagonal]]]

#include "../../test/Hermite_diffuse_remeshing/analytic_surfaces.h"
#include "../../test/Hermite_diffuse_remeshing/mesh_measures.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Polygon_mesh_processing/hermite_diffuse_remesh.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <functional>
#include <iostream>
#include <string>
#include <vector>

namespace PMP = CGAL::Polygon_mesh_processing;
typedef CGAL::Exact_predicates_inexact_constructions_kernel     K;
typedef CGAL::Surface_mesh<K::Point_3>                          Mesh;

double milliseconds_since(const std::clock_t begin)
{
  return 1e3 * double(std::clock() - begin) / CLOCKS_PER_SEC;
}

struct Visitor : public CGAL::Hermite_diffuse_remeshing::Default_remeshing_visitor<Mesh>
{
  std::string stage, stop_stage;
  double stop_after = 0.;                      // milliseconds within the stage
  double longest = 0.;
  std::clock_t last = std::clock(), stage_begin = last;

  void look()
  {
    longest = (std::max)(longest, milliseconds_since(last));
    last = std::clock();
  }
  void tell(const std::string& what)
  {
    if(stop_stage.empty())
      std::cout << what << ": " << milliseconds_since(stage_begin) << " ms, longest silence " << longest << " ms" << std::endl;
    longest = 0.;
    stage_begin = last;
  }
  void stage_begins(const char* name)
  {
    look();
    tell("before " + std::string(name));
    stage = name;
  }
  void stage_ends(const char* name)
  {
    look();
    tell(name);
  }
  bool is_stop_requested()
  {
    look();
    return stage == stop_stage && milliseconds_since(stage_begin) >= stop_after;
  }
};

int main(int argc, char** argv)
{
  Mesh input;
  if(argc > 1)
  {
    if(!PMP::IO::read_polygon_mesh(argv[1], input))
      return 1;
  }
  else
  {
    constexpr int number_of_faces = 100000;
    const analytic::Triangles torus = analytic::Torus().mesh(number_of_faces, 1);
    std::vector<K::Point_3> points;
    for(const analytic::Point& p : torus.points)
      points.push_back(K::Point_3(p[0], p[1], p[2]));
    PMP::polygon_soup_to_polygon_mesh(points, torus.faces, input);
  }
  std::cout << input.number_of_faces() << " faces\n";
  const double error = argc > 2 ? std::atof(argv[2]) : 0.001;
  const double deviation = (argc > 3 ? std::atof(argv[3]) : 5e-5) * diagonal_of_box(input);
  const auto parameters = [=](Visitor& visitor)
  { return CGAL::parameters::approximation_error(error).maximum_deviation(deviation).visitor(std::ref(visitor)); };
  Visitor watching;
  Mesh mesh = input;
  const auto report = PMP::hermite_diffuse_remesh(mesh, parameters(watching));
  watching.look();
  watching.tell("after the last stage");
  std::cout << report.number_of_faces << " faces, " << report.number_of_deviation_rounds << " rounds" << std::endl;
  double longest = 0.;
  for(const char* const stage : {"model", "size map", "adaptation", "optimisation", "deviation"})
    for(const double after : {0., 20., 50.})
    {
      mesh = input;
      Visitor visitor;
      visitor.stop_stage = stage;
      visitor.stop_after = after;
      PMP::hermite_diffuse_remesh(mesh, parameters(visitor));
      longest = (std::max)(longest, milliseconds_since(visitor.last));
      std::cout << "stopped in " << stage << " after " << after << " ms: returned " << milliseconds_since(visitor.last)
                << " ms later" << std::endl;
    }
  std::cout << "longest from the answer to the return: " << longest << " ms" << std::endl;
  return 0;
}
