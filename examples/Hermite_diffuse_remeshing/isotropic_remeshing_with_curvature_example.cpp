// CGAL's own isotropic remeshing with the sizes of this package: the error at the edges is relative to the curvature
// of the smooth surface, and the sizes are scaled to a number of faces. Sizing fields are known to CGAL 6 and later.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Polygon_mesh_processing/Hermite_diffuse_sizing_field.h>
#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Polygon_mesh_processing/remesh.h>

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

  PMP::Hermite_diffuse_sizing_field<Mesh> sizing(mesh,
    CGAL::parameters::approximation_error(0.02).gradation(1.5).maximum_number_of_faces(20000));
  PMP::isotropic_remeshing(faces(mesh), sizing, mesh, CGAL::parameters::number_of_iterations(5));
  mesh.collect_garbage();
  std::cout << mesh.number_of_faces() << " faces" << std::endl;
  CGAL::IO::write_polygon_mesh("isotropic.off", mesh, CGAL::parameters::stream_precision(17));
  return EXIT_SUCCESS;
}
