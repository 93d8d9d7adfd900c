// Features are found, and what lies between them; the user adds to them, and protects some of them.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Polygon_mesh_processing/hermite_diffuse_classify_faces.h>
#include <CGAL/Polygon_mesh_processing/hermite_diffuse_classify_features.h>
#include <CGAL/Polygon_mesh_processing/hermite_diffuse_remesh.h>

#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <map>
#include <string>

typedef CGAL::Exact_predicates_inexact_constructions_kernel   K;
typedef CGAL::Surface_mesh<K::Point_3>                        Mesh;

namespace HDR = CGAL::Hermite_diffuse_remeshing;
namespace PMP = CGAL::Polygon_mesh_processing;

int main(int argc, char* argv[])
{
  const std::string filename = (argc > 1) ? argv[1] : CGAL::data_file_path("meshes/joint.off");
  Mesh mesh;
  if(!PMP::IO::read_polygon_mesh(filename, mesh))
  {
    std::cerr << "Cannot read a mesh from " << filename << std::endl;
    return EXIT_FAILURE;
  }

  // what is found by the angles alone
  const auto edge_classes = mesh.add_property_map<Mesh::Edge_index, HDR::Edge_class>("e:class").first;
  const auto vertex_classes = mesh.add_property_map<Mesh::Vertex_index, HDR::Vertex_class>("v:class").first;
  PMP::hermite_diffuse_classify_features(mesh, edge_classes, vertex_classes,
                                         CGAL::parameters::sharp_dihedral_angle(40.).corner_angle(60.));

  // the regions on planes, cylinders and other basic surfaces: a face has the rank of its own
  const auto regions = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:region").first;
  std::map<HDR::Basic_surface_type, int> number_of_regions;
  for(const auto& surface : PMP::hermite_diffuse_classify_faces(mesh, regions))
    ++number_of_regions[surface.type];
  std::cout << number_of_regions[HDR::PLANE_SURFACE] << " regions are planar, "
            << number_of_regions[HDR::CYLINDER_SURFACE] << " on cylinders" << std::endl;

  // Sharp edges in the first half of the mesh fit to another part: they stay exactly as they are. The other ones are
  // sampled anew. And one more vertex must not move.
  const auto policies = mesh.add_property_map<Mesh::Edge_index, HDR::Edge_policy>("e:policy", HDR::DETECTED_EDGE).first;
  std::size_t number_of_features = 0, number_of_protected = 0, number_of_corners = 0;
  for(const Mesh::Edge_index e : mesh.edges())
    if(HDR::is_feature(edge_classes[e]))
    {
      ++number_of_features;
      if(mesh.point(mesh.vertex(e, 0)).y() < 0. && mesh.point(mesh.vertex(e, 1)).y() < 0.)
      {
        policies[e] = HDR::PROTECTED_EDGE;
        ++number_of_protected;
      }
    }
  for(const Mesh::Vertex_index v : mesh.vertices())
    number_of_corners += HDR::is_corner(vertex_classes[v]);
  std::cout << number_of_features << " feature edges, " << number_of_protected << " of them protected, "
            << number_of_corners << " corners" << std::endl;
  const auto is_kept = mesh.add_property_map<Mesh::Vertex_index, bool>("v:is_kept", false).first;
  is_kept[*mesh.vertices().begin()] = true;

  const auto report = PMP::hermite_diffuse_remesh(mesh, CGAL::parameters::approximation_error(0.05)
                                                          .edge_policy_map(policies)
                                                          .vertex_is_constrained_map(is_kept)
                                                          .edge_class_map(edge_classes));
  number_of_features = 0;
  for(const Mesh::Edge_index e : mesh.edges())
    number_of_features += HDR::is_feature(edge_classes[e]);
  std::cout << report.number_of_faces << " faces, " << number_of_features << " feature edges, smallest quality "
            << report.smallest_quality << std::endl;
  mesh.collect_garbage();
  CGAL::IO::write_polygon_mesh("features.off", mesh, CGAL::parameters::stream_precision(17));
  return EXIT_SUCCESS;
}
