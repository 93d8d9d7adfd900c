// A Polyhedron_3, and a traits class that is no kernel: the points are those of another program, in single precision.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/boost/graph/graph_traits_Polyhedron_3.h>
#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Polygon_mesh_processing/hermite_diffuse_remesh.h>

#include <boost/property_map/property_map.hpp>

#include <cstdlib>
#include <iostream>
#include <map>

typedef CGAL::Exact_predicates_inexact_constructions_kernel   K;
typedef CGAL::Polyhedron_3<K>                                 Mesh;
typedef boost::graph_traits<Mesh>::vertex_descriptor          vertex_descriptor;

namespace PMP = CGAL::Polygon_mesh_processing;

struct Coordinates
{
  float x, y, z;
};

// a model of HermiteDiffuseRemeshingTraits
struct Traits
{
  typedef float FT;
  typedef Coordinates Point_3;
  typedef Coordinates Vector_3;
  struct Compute_x_3 { FT operator()(const Coordinates& c) const { return c.x; } };
  struct Compute_y_3 { FT operator()(const Coordinates& c) const { return c.y; } };
  struct Compute_z_3 { FT operator()(const Coordinates& c) const { return c.z; } };
  struct Construct
  {
    Coordinates operator()(const FT x, const FT y, const FT z) const { return {x, y, z}; }
  };
  typedef Construct Construct_point_3;
  typedef Construct Construct_vector_3;

  Compute_x_3 compute_x_3_object() const { return {}; }
  Compute_y_3 compute_y_3_object() const { return {}; }
  Compute_z_3 compute_z_3_object() const { return {}; }
  Construct_point_3 construct_point_3_object() const { return {}; }
  Construct_vector_3 construct_vector_3_object() const { return {}; }
};

int main(int argc, char* argv[])
{
  const std::string filename = (argc > 1) ? argv[1] : CGAL::data_file_path("meshes/joint.off");
  Mesh mesh;
  if(!PMP::IO::read_polygon_mesh(filename, mesh))
  {
    std::cerr << "Cannot read a mesh from " << filename << std::endl;
    return EXIT_FAILURE;
  }
  std::map<vertex_descriptor, Coordinates> points;
  for(const vertex_descriptor v : vertices(mesh))
    points[v] = {float(v->point().x()), float(v->point().y()), float(v->point().z())};

  // the mesh has the connectivity alone: nobody looks at the points in its vertices
  const auto report =
    PMP::hermite_diffuse_remesh(mesh, CGAL::parameters::approximation_error(0.05)
                                        .vertex_point_map(boost::make_assoc_property_map(points))
                                        .geom_traits(Traits()));

  std::cout << mesh.size_of_facets() << " faces, " << mesh.size_of_vertices() << " vertices, smallest quality "
            << report.smallest_quality << std::endl;
  for(const vertex_descriptor v : vertices(mesh))
    v->point() = K::Point_3(points[v].x, points[v].y, points[v].z);
  CGAL::IO::write_polygon_mesh("polyhedron.off", mesh);
  return EXIT_SUCCESS;
}
