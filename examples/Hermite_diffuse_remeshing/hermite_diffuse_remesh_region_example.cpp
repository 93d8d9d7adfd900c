// A part of a mesh is made finer; the rest stays as it is, to the last bit.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Polygon_mesh_processing/hermite_diffuse_remesh.h>

#include <cstdlib>
#include <iostream>
#include <string>
#include <vector>

typedef CGAL::Exact_predicates_inexact_constructions_kernel   K;
typedef CGAL::Surface_mesh<K::Point_3>                        Mesh;

namespace PMP = CGAL::Polygon_mesh_processing;

int main(int argc, char* argv[])
{
  const std::string filename = (argc > 1) ? argv[1] : CGAL::data_file_path("meshes/elephant.off");
  Mesh mesh;
  if(!PMP::IO::read_polygon_mesh(filename, mesh))
  {
    std::cerr << "Cannot read a mesh from " << filename << std::endl;
    return EXIT_FAILURE;
  }

  // the upper end of the trunk of the elephant
  std::vector<Mesh::Face_index> region;
  for(const Mesh::Face_index f : mesh.faces())
    if(mesh.point(mesh.target(mesh.halfedge(f))).y() > 0.4)
      region.push_back(f);

  const auto report =
    PMP::hermite_diffuse_remesh(region, mesh, CGAL::parameters::approximation_error(0.01).maximum_edge_length(0.01));

  std::cout << region.size() << " of " << report.number_of_input_faces << " faces were remeshed, there are "
            << report.number_of_faces << " now; smallest quality among the new ones " << report.smallest_quality
            << std::endl;
  mesh.collect_garbage();
  CGAL::IO::write_polygon_mesh("region.off", mesh, CGAL::parameters::stream_precision(17));
  return EXIT_SUCCESS;
}
