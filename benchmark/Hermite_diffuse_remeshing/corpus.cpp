// Remeshes every triangle mesh of a folder with one setting and prints a line of figures for each, as
// comma-separated values, then a summary. Polygons are triangulated first.
//
//   corpus FOLDER [largest size of a file in bytes] [part of the diagonal]

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Polygon_mesh_processing/bbox.h>
#include <CGAL/Polygon_mesh_processing/hermite_diffuse_remesh.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/Real_timer.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <iostream>
#include <string>
#include <vector>

namespace PMP = CGAL::Polygon_mesh_processing;

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;

// ends a run that takes too long
struct Time_limit
  : public CGAL::Hermite_diffuse_remeshing::Default_remeshing_visitor<Mesh>
{
  static constexpr double seconds = 60.;
  CGAL::Real_timer timer;

  Time_limit() { timer.start(); }
  bool is_stop_requested() { return timer.time() > seconds; }
};

std::size_t number_of_intersections(const Mesh& mesh)
{
  std::vector<std::pair<Mesh::Face_index, Mesh::Face_index> > pairs;
  PMP::self_intersections(faces(mesh), mesh, std::back_inserter(pairs));
  return pairs.size();
}

double median(std::vector<double> values)
{
  if(values.empty())
    return 0.;
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

int main(int argc, char** argv)
{
  if(argc < 2)
  {
    std::cerr << "corpus FOLDER [largest size of a file in bytes] [part of the diagonal]" << std::endl;
    return EXIT_FAILURE;
  }
  const double largest_size = argc > 2 ? std::atof(argv[2]) : 1.2e6;
  const double part = argc > 3 ? std::atof(argv[3]) : 1e-3;

  std::vector<std::filesystem::path> files;
  for(const auto& entry : std::filesystem::directory_iterator(argv[1]))
    if(entry.path().extension() == ".off" && entry.file_size() <= largest_size)
      files.push_back(entry.path());
  std::sort(files.begin(), files.end());

  std::vector<double> deviations, qualities;
  double seconds = 0.;
  int refused = 0, not_met = 0, newly_intersecting = 0, flat = 0, timed_out = 0, topology_changed = 0;
  std::cout << "mesh,input faces,faces,Qmin,Qmean,deviation/diagonal,met,intersections before,after,seconds,stop" << std::endl;
  for(const std::filesystem::path& file : files)
  {
    Mesh mesh;
    const std::string name = file.stem().string();
    if(!PMP::IO::read_polygon_mesh(file.string(), mesh) || mesh.number_of_faces() == 0)
    {
      std::cout << name << ",unreadable" << std::endl;
      continue;
    }
    PMP::triangulate_faces(mesh);
    const CGAL::Bbox_3 box = PMP::bbox(mesh);
    const double diagonal = std::sqrt(CGAL::square(box.xmax() - box.xmin()) + CGAL::square(box.ymax() - box.ymin())
                                      + CGAL::square(box.zmax() - box.zmin()));
    const std::size_t intersections_before = number_of_intersections(mesh);
    const long characteristic = long(mesh.number_of_vertices()) - long(mesh.number_of_edges()) + long(mesh.number_of_faces());
    Time_limit limit;
    try
    {
      const auto report = PMP::hermite_diffuse_remesh(mesh, CGAL::parameters::approximation_error(0.02)
        .maximum_deviation(part * diagonal).minimum_edge_length(0.003 * diagonal).maximum_edge_length(0.1 * diagonal)
        .visitor(std::ref(limit)));
      const std::size_t intersections = number_of_intersections(mesh);
      const long new_characteristic = long(mesh.number_of_vertices()) - long(mesh.number_of_edges()) + long(mesh.number_of_faces());
      std::cout << name << "," << report.number_of_input_faces << "," << report.number_of_faces << ","
                << report.smallest_quality << "," << report.mean_quality << ","
                << report.largest_deviation / diagonal << "," << report.is_maximum_deviation_met << ","
                << intersections_before << "," << intersections << "," << report.seconds << ","
                << CGAL::Hermite_diffuse_remeshing::name(report.stop_reason)
                << (new_characteristic != characteristic ? ",TOPOLOGY CHANGED" : "")
                << (intersections_before == 0 && intersections > 0 ? ",NEW INTERSECTIONS" : "") << std::endl;
      deviations.push_back(report.largest_deviation / diagonal);
      qualities.push_back(report.smallest_quality);
      seconds += report.seconds;
      not_met += !report.is_maximum_deviation_met;
      newly_intersecting += intersections_before == 0 && intersections > 0;
      flat += report.smallest_quality < 0.1;
      timed_out += report.stop_reason == CGAL::Hermite_diffuse_remeshing::STOPPED_BY_VISITOR;
      topology_changed += new_characteristic != characteristic;
    }
    catch(const std::exception& error)
    {
      std::cout << name << ",refused: " << error.what() << std::endl;
      ++refused;
    }
  }
  std::cout << deviations.size() << " remeshed, " << refused << " refused, " << timed_out << " over the time limit; "
            << newly_intersecting << " newly intersecting, " << topology_changed << " with another topology; "
            << "median deviation " << median(deviations) << ", " << not_met << " above the bound; "
            << "median smallest quality " << median(qualities) << ", " << flat << " below 0.1; "
            << seconds << " s in all" << std::endl;
  return EXIT_SUCCESS;
}
