// Remeshes meshes at several approximation errors and prints one line per case, the columns
// separated by tabs. Arguments: mesh files; without any, three of CGAL's own.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Polygon_mesh_processing/hermite_diffuse_remesh.h>
#include <CGAL/Real_timer.h>

#include <cstdlib>
#include <exception>
#include <iostream>
#include <string>
#include <vector>

typedef CGAL::Exact_predicates_inexact_constructions_kernel   K;
typedef CGAL::Surface_mesh<K::Point_3>                        Mesh;

namespace PMP = CGAL::Polygon_mesh_processing;

void run(const std::string& filename, const Mesh& input, const double error)
{
  Mesh mesh = input;
  CGAL::Real_timer timer;
  timer.start();
  const auto report =
    PMP::hermite_diffuse_remesh(mesh, CGAL::parameters::approximation_error(error));
  timer.stop();
  std::cout << filename.substr(filename.find_last_of('/') + 1) << "\t" << error
            << "\t" << report.number_of_input_faces << "\t" << report.number_of_faces
            << "\t" << report.smallest_quality << "\t" << report.mean_quality
            << "\t" << report.largest_deviation << "\t" << report.mean_deviation
            << "\t" << report.size_conformity << "\t" << report.number_of_iterations
            << "\t" << timer.time() << std::endl;
}

int main(int argc, char* argv[])
{
  std::vector<std::string> filenames(argv + 1, argv + argc);
  if(filenames.empty())
    for(const char* name : { "meshes/elephant.off", "meshes/fandisk.off", "meshes/bunny00.off" })
      filenames.push_back(CGAL::data_file_path(name));

  std::cout << "mesh\terror\tinput faces\tfaces\tsmallest quality\tmean quality\tlargest deviation"
               "\tmean deviation\tsize conformity\titerations\tseconds" << std::endl;
  int result = EXIT_SUCCESS;
  for(const std::string& filename : filenames)
  {
    Mesh mesh;
    if(!PMP::IO::read_polygon_mesh(filename, mesh))
    {
      std::cerr << "Cannot read a mesh from " << filename << std::endl;
      result = EXIT_FAILURE;
      continue;
    }
    for(const double error : { 0.05, 0.02, 0.01, 0.005 })
    {
      try { run(filename, mesh, error); }
      catch(const std::exception& e)
      {
        std::cerr << filename << ": " << e.what() << std::endl;
        result = EXIT_FAILURE;
      }
    }
  }
  return result;
}
