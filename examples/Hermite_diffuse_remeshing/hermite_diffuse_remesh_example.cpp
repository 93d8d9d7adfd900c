// A mesh is remeshed with one parameter; the program prints the number of faces, the quality of the worst one, and the
// largest distance to the model, and writes remeshed.off.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Polygon_mesh_processing/hermite_diffuse_remesh.h>

#include <cstdlib>
#include <iostream>
#include <string>

typedef CGAL::Exact_predicates_inexact_constructions_kernel   K;
typedef CGAL::Surface_mesh<K::Point_3>                        Mesh;

namespace PMP = CGAL::Polygon_mesh_processing;

int main(int argc, char* argv[])
{
  const std::string filename =
    (argc > 1) ? argv[1] : CGAL::data_file_path("meshes/elephant.off");

  Mesh mesh;
  if(!PMP::IO::read_polygon_mesh(filename, mesh))
  {
    std::cerr << "Cannot read a mesh from " << filename << std::endl;
    return EXIT_FAILURE;
  }

  const auto report =
    PMP::hermite_diffuse_remesh(mesh, CGAL::parameters::approximation_error(0.02));

  std::cout << report.number_of_faces << " faces, smallest quality " << report.smallest_quality
            << ", largest deviation " << report.largest_deviation << std::endl;
  CGAL::IO::write_polygon_mesh("remeshed.off", mesh, CGAL::parameters::stream_precision(17));
  return EXIT_SUCCESS;
}
