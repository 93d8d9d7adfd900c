// Curvatures at the vertices of a mesh, written as a VTP file, which ParaView and f3d read.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Polygon_mesh_processing/hermite_diffuse_curvatures.h>

#include "vtp_io.h"

#include <cstddef>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <string>
#include <vector>

typedef CGAL::Exact_predicates_inexact_constructions_kernel                     K;
typedef CGAL::Surface_mesh<K::Point_3>                                          Mesh;
typedef CGAL::Hermite_diffuse_remeshing::Principal_curvatures_and_directions<K> Principal_curvatures;

namespace PMP = CGAL::Polygon_mesh_processing;

int main(int argc, char* argv[])
{
  const std::string filename =
    (argc > 1) ? argv[1] : CGAL::data_file_path("meshes/elephant.off");
  const std::string output = (argc > 2) ? argv[2] : "curvatures.vtp";

  Mesh mesh;
  if(!PMP::IO::read_polygon_mesh(filename, mesh))
  {
    std::cerr << "Cannot read a mesh from " << filename << std::endl;
    return EXIT_FAILURE;
  }

  const auto curvatures = mesh.add_property_map<Mesh::Vertex_index, Principal_curvatures>("v:curvatures").first;
  PMP::hermite_diffuse_curvatures<CGAL::Parallel_if_available_tag>(
    mesh, CGAL::parameters::principal_curvatures_map(curvatures));

  std::vector<K::Point_3> points;
  std::vector<std::vector<std::size_t> > polygons;
  std::vector<vtp::Data_array> fields = { {"mean_curvature", {}}, {"gaussian_curvature", {}},
                                          {"maximum_curvature", {}}, {"minimum_curvature", {}} };
  std::vector<std::size_t> index(mesh.num_vertices());
  for(const Mesh::Vertex_index v : mesh.vertices())
  {
    index[v] = points.size();
    points.push_back(mesh.point(v));
    const Principal_curvatures& k = curvatures[v];
    fields[0].second.push_back(k.mean_curvature());
    fields[1].second.push_back(k.gaussian_curvature());
    fields[2].second.push_back(k.maximum_curvature);
    fields[3].second.push_back(k.minimum_curvature);
  }
  for(const Mesh::Face_index f : mesh.faces())
  {
    polygons.emplace_back();
    for(const Mesh::Vertex_index v : mesh.vertices_around_face(mesh.halfedge(f)))
      polygons.back().push_back(index[v]);
  }

  std::ofstream os(output);
  vtp::write(os, points, polygons, fields);
  if(!os)
  {
    std::cerr << "Cannot write " << output << std::endl;
    return EXIT_FAILURE;
  }
  std::cout << points.size() << " vertices written to " << output << std::endl;
  return EXIT_SUCCESS;
}
