// A coloured and textured mesh keeps its colours and texture. Writes textured_input.obj and textured_output.obj, which
// use the texture of textured.mtl, and colored_output.ply.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh/IO/PLY.h>
#include <CGAL/Hermite_diffuse_remeshing/Attribute_transfer.h>
#include <CGAL/Polygon_mesh_processing/hermite_diffuse_remesh.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

typedef CGAL::Exact_predicates_inexact_constructions_kernel   K;
typedef CGAL::Surface_mesh<K::Point_3>                        Mesh;
typedef std::array<double, 2>                                 Texture_coordinates;
typedef std::pair<std::size_t, std::array<double, 3> >        Location;
typedef Mesh::Property_map<Mesh::Halfedge_index, Texture_coordinates> Texture_map;

namespace HDR = CGAL::Hermite_diffuse_remeshing;
namespace PMP = CGAL::Polygon_mesh_processing;

// A vase that is closed around the axis: texture coordinates jump from 1 to 0 where it closes.
Mesh make_vase(const int n, const int m)
{
  Mesh mesh;
  std::vector<Mesh::Vertex_index> vertices;
  auto color = mesh.add_property_map<Mesh::Vertex_index, CGAL::IO::Color>("v:color").first;
  auto uv = mesh.add_property_map<Mesh::Halfedge_index, Texture_coordinates>("h:uv").first;
  for(int j = 0; j <= m; ++j)
    for(int i = 0; i < n; ++i)
    {
      const double angle = 6.283185307179586 * i / n, z = double(j) / m, r = 0.4 + 0.15 * std::sin(6. * z);
      vertices.push_back(mesh.add_vertex(K::Point_3(r * std::cos(angle), r * std::sin(angle), z)));
      const auto level = static_cast<unsigned char>(255. * z);
      color[vertices.back()] = CGAL::IO::Color(level, 60, static_cast<unsigned char>(255 - level));
    }
  for(int j = 0; j < m; ++j)
    for(int i = 0; i < n; ++i)
      for(const bool is_lower : {true, false})
      {
        const int column[3] = {i, i + 1, is_lower ? i + 1 : i}, row[3] = {j, is_lower ? j : j + 1, j + 1};
        Mesh::Vertex_index v[3];
        for(int k = 0; k < 3; ++k)
          v[k] = vertices[row[k] * n + column[k] % n];
        mesh.add_face(v[0], v[1], v[2]);
        for(int k = 0; k < 3; ++k)
          uv[mesh.halfedge(v[(k + 2) % 3], v[k])] = {{double(column[k]) / n, double(row[k]) / m}};
      }
  return mesh;
}

void write_obj(const Mesh& mesh, const Texture_map& uv, const std::string& filename)
{
  std::ofstream os(filename);
  os << "mtllib textured.mtl\nusemtl textured\n";
  for(const Mesh::Vertex_index v : mesh.vertices())
    os << "v " << mesh.point(v) << '\n';
  std::size_t number = 0;
  for(const Mesh::Face_index f : mesh.faces())
  {
    std::string corners;
    for(const Mesh::Halfedge_index h : mesh.halfedges_around_face(mesh.halfedge(f)))
    {
      os << "vt " << uv[h][0] << ' ' << uv[h][1] << '\n';
      corners += ' ' + std::to_string(mesh.target(h) + 1) + '/' + std::to_string(++number);
    }
    os << 'f' << corners << '\n';
  }
}

int main()
{
  Mesh mesh = make_vase(40, 30);
  const auto color = mesh.add_property_map<Mesh::Vertex_index, CGAL::IO::Color>("v:color").first;
  const Texture_map uv = mesh.add_property_map<Mesh::Halfedge_index, Texture_coordinates>("h:uv").first;
  Mesh input = mesh;                                  // with its own color and uv
  write_obj(mesh, uv, "textured_input.obj");

  // the seam is a feature
  const auto is_seam = mesh.add_property_map<Mesh::Edge_index, bool>("e:is_seam", false).first;
  HDR::mark_seams(mesh, uv, is_seam);

  const auto locations = mesh.add_property_map<Mesh::Vertex_index, Location>("v:location").first;
  const auto origins = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:origin").first;
  const auto report = PMP::hermite_diffuse_remesh(mesh, CGAL::parameters::approximation_error(0.02)
                                                          .edge_is_constrained_map(is_seam)
                                                          .vertex_location_map(locations)
                                                          .face_origin_map(origins));

  const HDR::Attribute_transfer<Mesh, Mesh::Property_map<Mesh::Vertex_index, Location>,
                                Mesh::Property_map<Mesh::Face_index, std::size_t> >
    transfer(input, mesh, locations, origins);
  transfer.transfer_vertex_values(input.add_property_map<Mesh::Vertex_index, CGAL::IO::Color>("v:color").first, color);
  transfer.transfer_corner_values(input.add_property_map<Mesh::Halfedge_index, Texture_coordinates>("h:uv").first, uv);

  // the properties go with the elements
  mesh.collect_garbage();
  std::cout << report.number_of_faces << " faces" << std::endl;
  write_obj(mesh, uv, "textured_output.obj");
  std::ofstream("textured.mtl") << "newmtl textured\nmap_Kd textured.png\n";
  std::ofstream os("colored_output.ply");
  CGAL::IO::write_PLY(os, mesh);
  return EXIT_SUCCESS;
}
