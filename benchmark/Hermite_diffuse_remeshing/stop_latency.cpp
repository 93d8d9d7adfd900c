// How long a stop request waits: the longest time between two questions to the visitor, per stage, and the time
// from the answer "stop" to the return, on a mesh of 100000 faces or on the file that is given.

#include "../../test/Hermite_diffuse_remeshing/analytic_surfaces.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Polygon_mesh_processing/hermite_diffuse_remesh.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <chrono>
#include <functional>
#include <iostream>
#include <string>
#include <vector>

namespace PMP = CGAL::Polygon_mesh_processing;
typedef CGAL::Exact_predicates_inexact_constructions_kernel     K;
typedef CGAL::Surface_mesh<K::Point_3>                          Mesh;
typedef std::chrono::steady_clock                               Clock;

double milliseconds_since(const Clock::time_point begin)
{
  return std::chrono::duration<double, std::milli>(Clock::now() - begin).count();
}

struct Visitor : public CGAL::Hermite_diffuse_remeshing::Default_remeshing_visitor<Mesh>
{
  std::string stage, stop_stage;
  double stop_after = 0.;                      // milliseconds within the stage
  double longest = 0.;
  Clock::time_point last = Clock::now(), stage_begin = last;

  void look()
  {
    longest = (std::max)(longest, milliseconds_since(last));
    last = Clock::now();
  }
  void stage_begins(const char* name)
  {
    look();
    stage = name;
    stage_begin = last;
    longest = 0.;
  }
  void stage_ends(const char*)
  {
    look();
    if(stop_stage.empty())
      std::cout << stage << ": " << milliseconds_since(stage_begin) << " ms, longest silence " << longest << " ms" << std::endl;
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
  // as many faces as the input has, and a deviation that takes some rounds
  const auto parameters = [](Visitor& visitor)
  { return CGAL::parameters::approximation_error(0.0005).maximum_deviation(1e-5).visitor(std::ref(visitor)); };
  Visitor watching;
  Mesh mesh = input;
  PMP::hermite_diffuse_remesh(mesh, parameters(watching));
  for(const char* const stage : {"model", "size map", "adaptation", "optimisation", "deviation"})
    for(const double after : {0., 20., 50.})
    {
      mesh = input;
      Visitor visitor;
      visitor.stop_stage = stage;
      visitor.stop_after = after;
      PMP::hermite_diffuse_remesh(mesh, parameters(visitor));
      std::cout << "stopped in " << stage << " after " << after << " ms: returned " << milliseconds_since(visitor.last)
                << " ms later" << std::endl;
    }
  return 0;
}
