// Curvatures at the vertices of a mesh, written as a VTP file, which ParaView and f3d read.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Polygon_mesh_processing/hermite_diffuse_curvatures.h>

#include <cstddef>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

typedef CGAL::Exact_predicates_inexact_constructions_kernel                     K;
typedef CGAL::Surface_mesh<K::Point_3>                                          Mesh;
typedef CGAL::Hermite_diffuse_remeshing::Principal_curvatures_and_directions<K> Principal_curvatures;

namespace PMP = CGAL::Polygon_mesh_processing;

typedef std::vector<std::pair<std::string, std::vector<double> > >              Fields;

// a mesh without removed elements, with values at its vertices
void write_vtp(std::ostream& os, const Mesh& mesh, const Fields& fields)
{
  os << "<VTKFile type=\"PolyData\" version=\"0.1\">\n<PolyData>\n<Piece NumberOfPoints=\"" << mesh.number_of_vertices()
     << "\" NumberOfPolys=\"" << mesh.number_of_faces() << "\">\n<PointData>\n";
  for(const auto& field : fields)
  {
    os << "<DataArray type=\"Float64\" Name=\"" << field.first << "\" format=\"ascii\">\n";
    for(const double value : field.second)
      os << value << '\n';
    os << "</DataArray>\n";
  }
  os << "</PointData>\n<Points>\n<DataArray type=\"Float64\" NumberOfComponents=\"3\" format=\"ascii\">\n";
  for(const Mesh::Vertex_index v : mesh.vertices())
    os << mesh.point(v) << '\n';
  os << "</DataArray>\n</Points>\n<Polys>\n<DataArray type=\"Int64\" Name=\"connectivity\" format=\"ascii\">\n";
  for(const Mesh::Face_index f : mesh.faces())
    for(const Mesh::Vertex_index v : mesh.vertices_around_face(mesh.halfedge(f)))
      os << std::size_t(v) << '\n';
  os << "</DataArray>\n<DataArray type=\"Int64\" Name=\"offsets\" format=\"ascii\">\n";
  for(std::size_t i = 1; i <= mesh.number_of_faces(); ++i)
    os << 3 * i << '\n';
  os << "</DataArray>\n</Polys>\n</Piece>\n</PolyData>\n</VTKFile>\n";
}

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
    mesh, CGAL::parameters::vertex_principal_curvatures_and_directions_map(curvatures));

  Fields fields = { {"mean_curvature", {}}, {"gaussian_curvature", {}}, {"max_curvature", {}},
                    {"min_curvature", {}} };
  for(const Mesh::Vertex_index v : mesh.vertices())
  {
    const Principal_curvatures& k = curvatures[v];
    fields[0].second.push_back(k.mean_curvature());
    fields[1].second.push_back(k.Gaussian_curvature());
    fields[2].second.push_back(k.max_curvature);
    fields[3].second.push_back(k.min_curvature);
  }

  std::ofstream os(output);
  write_vtp(os, mesh, fields);
  if(!os)
  {
    std::cerr << "Cannot write " << output << std::endl;
    return EXIT_FAILURE;
  }
  std::cout << mesh.number_of_vertices() << " vertices written to " << output << std::endl;
  return EXIT_SUCCESS;
}
