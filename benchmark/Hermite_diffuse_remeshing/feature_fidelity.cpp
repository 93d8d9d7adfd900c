// How far the feature curves of a result are from those of the input: corners that are missing, the two-sided
// distance between the feature edges, relative to the diagonal, and by how much that to the splines exceeds the
// sagitta that the error law allows there.
//
//   feature_fidelity [FILE...]

#include "../../test/Hermite_diffuse_remeshing/feature_measures.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Real_timer.h>

#include <cstdio>
#include <filesystem>
#include <iostream>
#include <string>
#include <vector>

namespace PMP = CGAL::Polygon_mesh_processing;

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;

void print(const std::string& name, const Mesh& input)
{
  for(const double error : {0.02, 0.005})
  {
    Mesh output;
    CGAL::Real_timer timer;
    timer.start();
    const features::Fidelity f = features::measure(input, output, error, CGAL::parameters::sharp_dihedral_angle(40.));
    std::printf("%-22s %-6g %7zu %8zu %7zu %8zu %11.2e %11.2e %7.1f\n", name.c_str(), error,
                std::size_t(output.number_of_faces()), f.number_of_edges, f.number_of_corners,
                f.number_of_missing_corners, f.largest_distance / f.diagonal, f.largest_excess / f.diagonal,
                timer.time());
    std::fflush(stdout);
  }
}

int main(int argc, char** argv)
{
  std::printf("%-22s %-6s %7s %8s %7s %8s %11s %11s %7s\n", "mesh", "error", "faces", "features", "corners",
              "missing", "distance", "excess", "seconds");
  std::vector<std::string> files(argv + 1, argv + argc);
  if(files.empty())
    for(const char* name : {"cube", "fandisk", "anchor_dense", "joint", "couplingdown", "mech-holes-shark"})
      files.push_back(CGAL::data_file_path(std::string("meshes/") + name + ".off"));
  for(const std::string& file : files)
  {
    Mesh mesh;
    if(!PMP::IO::read_polygon_mesh(file, mesh))
    {
      std::cerr << "cannot read " << file << std::endl;
      return EXIT_FAILURE;
    }
    print(std::filesystem::path(file).stem().string(), mesh);
  }
  if(argc == 1)
    print("capped cylinder", features::capped_cylinder<Mesh>(48));
  return EXIT_SUCCESS;
}
