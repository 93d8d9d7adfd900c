// A visitor shows the progress and stops the remeshing; the mesh is valid all the same.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Polygon_mesh_processing/hermite_diffuse_remesh.h>

#include <cstdlib>
#include <functional>
#include <iostream>
#include <string>

typedef CGAL::Exact_predicates_inexact_constructions_kernel   K;
typedef CGAL::Surface_mesh<K::Point_3>                        Mesh;

namespace PMP = CGAL::Polygon_mesh_processing;

class Progress_bar
  : public CGAL::Hermite_diffuse_remeshing::Default_remeshing_visitor<Mesh>
{
  std::size_t m_splits_left;
  int m_length = 0;

public:
  explicit Progress_bar(const std::size_t number_of_splits) : m_splits_left(number_of_splits) {}

  void stage_begins(const char* name)
  {
    std::cout << name << ": ";
    m_length = 0;
  }
  void progress(const double fraction)
  {
    for(; m_length < static_cast<int>(20. * fraction); ++m_length)
      std::cout << '#' << std::flush;
  }
  void stage_ends(const char*) { std::cout << std::endl; }

  void after_edge_split(Mesh::Vertex_index)
  {
    if(m_splits_left > 0)
      --m_splits_left;
  }
  bool is_stop_requested() { return m_splits_left == 0; }
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

  Progress_bar bar(1000);
  const auto report = PMP::hermite_diffuse_remesh(mesh, CGAL::parameters::approximation_error(0.005)
                                                          .visitor(std::ref(bar)));

  std::cout << name(report.stop_reason) << " after " << report.number_of_splits << " splits and " << report.seconds
            << " seconds: " << report.number_of_faces << " faces" << std::endl;
  return CGAL::is_valid_polygon_mesh(mesh) ? EXIT_SUCCESS : EXIT_FAILURE;
}
