// Shows the input coloured by its mean curvature, then the result, in CGAL's viewer.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/draw_surface_mesh.h>
#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Polygon_mesh_processing/hermite_diffuse_curvatures.h>
#include <CGAL/Polygon_mesh_processing/hermite_diffuse_remesh.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <string>

typedef CGAL::Exact_predicates_inexact_constructions_kernel   K;
typedef CGAL::Surface_mesh<K::Point_3>                        Mesh;

namespace PMP = CGAL::Polygon_mesh_processing;

// blue where the surface is convex, white where it is flat, red in folds
void color_by_curvature(Mesh& mesh)
{
  const auto curvature = mesh.add_property_map<Mesh::Vertex_index, double>("v:curvature").first;
  PMP::hermite_diffuse_curvatures(mesh, CGAL::parameters::mean_curvature_map(curvature));
  double sum = 0.;
  for(const Mesh::Vertex_index v : mesh.vertices())
    sum += std::abs(curvature[v]);
  const double usual = 2. * sum / mesh.number_of_vertices();

  const auto color = mesh.add_property_map<Mesh::Face_index, CGAL::IO::Color>("f:color").first;
  for(const Mesh::Face_index f : mesh.faces())
  {
    double mean = 0.;
    for(const Mesh::Vertex_index v : mesh.vertices_around_face(mesh.halfedge(f)))
      mean += curvature[v] / 3.;
    const double share = (std::max)(-1., (std::min)(1., mean / usual));
    const auto rest = static_cast<unsigned char>(255. * (1. - std::abs(share)));
    color[f] = share > 0. ? CGAL::IO::Color(255, rest, rest) : CGAL::IO::Color(rest, rest, 255);
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
  color_by_curvature(mesh);
  CGAL::draw(mesh, "Input and its mean curvature");

  PMP::hermite_diffuse_remesh(mesh, CGAL::parameters::approximation_error(0.02));
  mesh.collect_garbage();
  color_by_curvature(mesh);
  CGAL::draw(mesh, "Result");
  return EXIT_SUCCESS;
}
