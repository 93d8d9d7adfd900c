// A surface is remeshed before its inside is filled with tetrahedra: Mesh_3 gets the features of the result. Without
// the first step it would approximate the facets of the input.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Mesh_complex_3_in_triangulation_3.h>
#include <CGAL/Mesh_criteria_3.h>
#include <CGAL/Mesh_triangulation_3.h>
#include <CGAL/Polyhedral_mesh_domain_with_features_3.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/split_graph_into_polylines.h>
#include <CGAL/make_mesh_3.h>
#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Polygon_mesh_processing/hermite_diffuse_remesh.h>

#include <boost/graph/adjacency_list.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <map>
#include <string>
#include <vector>

typedef CGAL::Exact_predicates_inexact_constructions_kernel        K;
typedef CGAL::Surface_mesh<K::Point_3>                             Mesh;
typedef CGAL::Polyhedral_mesh_domain_with_features_3<K, Mesh>      Domain;
typedef CGAL::Mesh_triangulation_3<Domain>::type                   Triangulation;
typedef CGAL::Mesh_complex_3_in_triangulation_3<Triangulation, Domain::Corner_index, Domain::Curve_index> Complex;
typedef CGAL::Mesh_criteria_3<Triangulation>                       Criteria;
typedef boost::adjacency_list<boost::setS, boost::vecS, boost::undirectedS, K::Point_3> Graph;
typedef std::vector<std::vector<K::Point_3> >                      Polylines;

namespace HDR = CGAL::Hermite_diffuse_remeshing;
namespace PMP = CGAL::Polygon_mesh_processing;

struct Polyline_visitor
{
  const Graph& graph;
  Polylines& polylines;

  void start_new_polyline() { polylines.emplace_back(); }
  void add_node(const Graph::vertex_descriptor v) { polylines.back().push_back(graph[v]); }
  void end_polyline() {}
};

// three times the radius of the inscribed sphere over that of the circumscribed one: 1 if all edges are equal
double quality(const K::Tetrahedron_3& t)
{
  double area = 0.;
  for(int i = 0; i < 4; ++i)
    area += std::sqrt(K::Triangle_3(t[i], t[i + 1], t[i + 2]).squared_area());
  return 9. * std::abs(t.volume()) / area
       / std::sqrt(CGAL::squared_distance(t[0], CGAL::circumcenter(t[0], t[1], t[2], t[3])));
}

int main(int argc, char* argv[])
{
  const std::string filename = (argc > 1) ? argv[1] : CGAL::data_file_path("meshes/joint.off");
  Mesh mesh;
  if(!PMP::IO::read_polygon_mesh(filename, mesh))
  {
    std::cerr << "Cannot read a mesh from " << filename << std::endl;
    return EXIT_FAILURE;
  }
  const auto edge_classes = mesh.add_property_map<Mesh::Edge_index, HDR::Edge_class>("e:class").first;
  PMP::hermite_diffuse_remesh(mesh, CGAL::parameters::approximation_error(0.02).edge_class_map(edge_classes));
  mesh.collect_garbage();

  Graph graph;
  std::map<Mesh::Vertex_index, Graph::vertex_descriptor> vertex_of_graph;
  const auto find_or_add = [&](const Mesh::Vertex_index v)
  {
    const auto found = vertex_of_graph.find(v);
    return found != vertex_of_graph.end() ? found->second
                                          : vertex_of_graph[v] = add_vertex(mesh.point(v), graph);
  };
  for(const Mesh::Edge_index e : mesh.edges())
    if(HDR::is_feature(edge_classes[e]))
      add_edge(find_or_add(mesh.vertex(e, 0)), find_or_add(mesh.vertex(e, 1)), graph);
  Polylines polylines;
  Polyline_visitor visitor{graph, polylines};
  CGAL::split_graph_into_polylines(graph, visitor);

  Domain domain(mesh);
  domain.add_features(polylines.begin(), polylines.end());
  const Criteria criteria(CGAL::parameters::edge_size = 0.1, CGAL::parameters::facet_angle = 25,
                          CGAL::parameters::facet_size = 0.1, CGAL::parameters::facet_distance = 0.005,
                          CGAL::parameters::cell_radius_edge_ratio = 2, CGAL::parameters::cell_size = 0.1);
  const Complex complex = CGAL::make_mesh_3<Complex>(domain, criteria);

  double smallest = 1., sum = 0.;
  std::size_t number = 0;
  for(auto cell = complex.cells_in_complex_begin(); cell != complex.cells_in_complex_end(); ++cell)
  {
    const double q = quality(complex.triangulation().tetrahedron(cell));
    smallest = (std::min)(smallest, q);
    sum += q;
    ++number;
  }
  std::cout << polylines.size() << " feature curves, " << mesh.number_of_faces() << " faces, " << number
            << " tetrahedra, smallest quality " << smallest << ", mean " << sum / number << std::endl;
  std::ofstream os("volume.mesh");
  complex.output_to_medit(os);
  return number > 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
