// Shows side by side in CGAL's viewer: a mesh, its mean curvature, and the result of the remeshing with its own. The
// viewer knows the colours of the faces from CGAL 6 on; before, it paints each face in one of its own.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/draw_surface_mesh.h>
#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Polygon_mesh_processing/bbox.h>
#include <CGAL/Polygon_mesh_processing/hermite_diffuse_curvatures.h>
#include <CGAL/Polygon_mesh_processing/hermite_diffuse_remesh.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <string>
#include <vector>

typedef CGAL::Exact_predicates_inexact_constructions_kernel   K;
typedef CGAL::Surface_mesh<K::Point_3>                        Mesh;
typedef CGAL::IO::Color                                       Color;

namespace PMP = CGAL::Polygon_mesh_processing;

// red where the surface is convex, white where it is flat, blue in folds
std::vector<Color> colors_by_curvature(const Mesh& mesh, const double length)
{
  Mesh copy = mesh;
  const auto curvature = copy.add_property_map<Mesh::Vertex_index, double>("v:curvature").first;
  PMP::hermite_diffuse_curvatures(copy, CGAL::parameters::vertex_mean_curvature_map(curvature));

  std::vector<Color> colors;
  for(const Mesh::Face_index f : copy.faces())
  {
    double mean = 0.;
    for(const Mesh::Vertex_index v : copy.vertices_around_face(copy.halfedge(f)))
      mean += curvature[v] / 3.;
    // full colours at a radius of a tenth of the length
    const double share = std::clamp(mean * length / 10., -1., 1.);
    const auto rest = static_cast<unsigned char>(255. * (1. - std::abs(share)));
    colors.push_back(share > 0. ? Color(255, rest, rest) : Color(rest, rest, 255));
  }
  return colors;
}

void add_to_scene(const Mesh& mesh, const std::vector<Color>& colors, const K::Vector_3& shift, Mesh& scene)
{
  const auto color = scene.add_property_map<Mesh::Face_index, Color>("f:color").first;
  const Mesh::size_type first = scene.number_of_vertices();
  for(const Mesh::Vertex_index v : mesh.vertices())
    scene.add_vertex(mesh.point(v) + shift);
  std::size_t i = 0;
  for(const Mesh::Face_index f : mesh.faces())
  {
    std::vector<Mesh::Vertex_index> corners;
    for(const Mesh::Vertex_index v : mesh.vertices_around_face(mesh.halfedge(f)))
      corners.push_back(Mesh::Vertex_index(first + v));
    color[scene.add_face(corners)] = colors[i++];
  }
}

int main(int argc, char* argv[])
{
  const std::string filename = (argc > 1) ? argv[1] : CGAL::data_file_path("meshes/elephant.off");
  Mesh mesh;
  if(!PMP::IO::read_polygon_mesh(filename, mesh))
  {
    std::cerr << "Cannot read a mesh from " << filename << std::endl;
    return EXIT_FAILURE;
  }
  Mesh result = mesh;
  PMP::hermite_diffuse_remesh(result, CGAL::parameters::approximation_error(0.05));
  result.collect_garbage();

  const CGAL::Bbox_3 box = PMP::bbox(mesh);
  const double length = (std::max)({box.x_span(), box.y_span(), box.z_span()});
  const K::Vector_3 step(1.1 * box.x_span(), 0., 0.);
  Mesh scene;
  add_to_scene(mesh, std::vector<Color>(mesh.number_of_faces(), CGAL::IO::white()), 0. * step, scene);
  add_to_scene(mesh, colors_by_curvature(mesh, length), step, scene);
  add_to_scene(result, colors_by_curvature(result, length), 2. * step, scene);
  CGAL::draw(scene, "Input, its mean curvature, and the result");
  return EXIT_SUCCESS;
}
