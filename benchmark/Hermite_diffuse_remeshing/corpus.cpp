// Remeshes every triangle mesh of a folder with one setting. Writes a line of figures for each as comma-separated
// values to the standard output, and a page that sums up to the standard error output. Polygons are
// triangulated first. Seconds are those of the processor, so that other programs do not count.
//
//   corpus FOLDER [largest size of a file in bytes] [part of the diagonal]

#include "../../examples/Hermite_diffuse_remeshing/report_output.h"
#include "../../test/Hermite_diffuse_remeshing/mesh_measures.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Polygon_mesh_processing/hermite_diffuse_classify_features.h>
#include <CGAL/Polygon_mesh_processing/hermite_diffuse_remesh.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/Real_timer.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <exception>
#include <filesystem>
#include <iostream>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace PMP = CGAL::Polygon_mesh_processing;

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;

// ends a run that takes too long
struct Time_limit
  : public CGAL::Hermite_diffuse_remeshing::Default_remeshing_visitor<Mesh>
{
  static constexpr double largest = 60.;
  const std::clock_t begin = std::clock();
  CGAL::Real_timer timer;
  unsigned number_of_questions = 0;

  Time_limit() { timer.start(); }
  double seconds() const { return double(std::clock() - begin) / CLOCKS_PER_SEC; }
  // The processor's time is never more than that of the wall, and asking for it takes a call of the system, a quarter
  // of the running time of some meshes. Even the wall's takes a hundredth if it is asked for at every question.
  bool is_stop_requested()
  {
    constexpr unsigned questions_per_look = 32;
    return ++number_of_questions % questions_per_look == 0 && timer.time() > largest && seconds() > largest;
  }
};

// with the classification of the package
std::set<Kernel::Point_3> corners(const Mesh& mesh)
{
  typedef CGAL::Hermite_diffuse_remeshing::Edge_class Edge_class;
  typedef CGAL::Hermite_diffuse_remeshing::Vertex_class Vertex_class;
  Mesh copy = mesh;
  const auto edge_class = copy.add_property_map<Mesh::Edge_index, Edge_class>("e:class").first;
  const auto vertex_class = copy.add_property_map<Mesh::Vertex_index, Vertex_class>("v:class").first;
  PMP::hermite_diffuse_classify_features(copy, edge_class, vertex_class);
  std::set<Kernel::Point_3> result;
  for(const auto v : copy.vertices())
    if(!copy.is_isolated(v) && CGAL::Hermite_diffuse_remeshing::is_corner(vertex_class[v]))
      result.insert(copy.point(v));
  return result;
}

std::size_t number_of_missing(std::set<Kernel::Point_3> points, const Mesh& mesh)
{
  for(const auto v : mesh.vertices())
    points.erase(mesh.point(v));
  return points.size();
}

long euler_characteristic(const Mesh& mesh)
{
  return long(mesh.number_of_vertices()) - long(mesh.number_of_edges()) + long(mesh.number_of_faces());
}

// numbers of the faces of low quality, by reason
template <typename Report>
std::string reasons(const Report& report)
{
  std::map<std::string, int> numbers;
  for(const auto& low : report.low_quality_faces)
    ++numbers[CGAL::Hermite_diffuse_remeshing::name(low.obstacle)];
  std::string result;
  for(const auto& entry : numbers)
    result += (result.empty() ? "" : " ") + std::to_string(entry.second) + " " + entry.first;
  return result;
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
  int not_met = 0;
  // what the summary names: meshes, by what there is to say of them
  std::map<std::string, std::vector<std::string> > remarks;
  std::vector<std::string> low_qualities;
  std::cout << "mesh,input faces,faces,Qmin,Qmean,deviation/diagonal,met,intersections before,after,corners lost,"
               "degenerate input faces,seconds,stop,faces below 0.3" << std::endl;
  for(const std::filesystem::path& file : files)
  {
    Mesh mesh;
    const std::string name = file.stem().string();
    if(!PMP::IO::read_polygon_mesh(file.string(), mesh) || mesh.number_of_faces() == 0)
    {
      remarks["no mesh of polygons"].push_back(name);
      continue;
    }
    PMP::triangulate_faces(mesh);
    const double diagonal = diagonal_of_box(mesh);
    const std::size_t intersections_before = number_of_intersections(mesh);
    const long characteristic = euler_characteristic(mesh);
    try
    {
      const std::set<Kernel::Point_3> corners_before = corners(mesh);
      Time_limit limit;
      const auto report = PMP::hermite_diffuse_remesh(mesh, CGAL::parameters::approximation_error(0.02)
        .maximum_deviation(part * diagonal).minimum_edge_length(0.003 * diagonal).maximum_edge_length(0.1 * diagonal)
        .visitor(std::ref(limit)));
      const double seconds_of_mesh = limit.seconds();
      const std::size_t intersections = number_of_intersections(mesh), lost = number_of_missing(corners_before, mesh);
      std::cout << name << "," << report.number_of_input_faces << "," << report.number_of_faces << ","
                << report.smallest_quality << "," << report.mean_quality << ","
                << report.largest_deviation / diagonal << "," << report.is_maximum_deviation_met << ","
                << intersections_before << "," << intersections << "," << lost << ","
                << report.number_of_degenerate_input_faces << "," << seconds_of_mesh << ","
                << CGAL::Hermite_diffuse_remeshing::name(report.stop_reason) << "," << reasons(report) << std::endl;
      if(report.is_deviation_measured)
        deviations.push_back(report.largest_deviation / diagonal);
      qualities.push_back(report.smallest_quality);
      seconds += seconds_of_mesh;
      not_met += !report.is_maximum_deviation_met;
      const auto remark = [&](const bool is_true, const char* what) { if(is_true) remarks[what].push_back(name); };
      remark(report.stop_reason == CGAL::Hermite_diffuse_remeshing::STOPPED_BY_VISITOR, "over the time limit");
      remark(seconds_of_mesh > 10., "longer than 10 s");
      remark(intersections_before == 0 && intersections > 0, "newly intersecting");
      remark(intersections > intersections_before, "more intersections than before");
      remark(euler_characteristic(mesh) != characteristic, "another topology");
      // those at degenerate and folded faces are no corners after the repair
      remark(lost > 0 && report.number_of_degenerate_input_faces + report.number_of_folded_input_faces == 0,
             "lost corners");
      if(report.smallest_quality < 0.1)
        low_qualities.push_back(name + ": " + std::to_string(report.smallest_quality) + ", "
                                + explanation(report.low_quality_faces.front()) + "; in all " + reasons(report));
    }
    catch(const std::exception& error)
    {
      remarks[std::string("refused, ") + error.what()].push_back(name);
    }
  }
  std::cerr << qualities.size() << " meshes remeshed in " << seconds << " s\n"
            << "median of the largest deviations over the diagonal " << median(deviations) << ", " << not_met
            << " above the bound of " << part << "\n"
            << "median of the smallest qualities " << median(qualities) << "\n";
  for(const auto& remark : remarks)
  {
    std::cerr << remark.first << ": " << remark.second.size() << " (";
    for(std::size_t i = 0; i < remark.second.size(); ++i)
      std::cerr << (i > 0 ? ", " : "") << remark.second[i];
    std::cerr << ")\n";
  }
  std::cerr << "smallest quality below 0.1: " << low_qualities.size() << "\n";
  for(const std::string& line : low_qualities)
    std::cerr << "  " << line << "\n";
  return EXIT_SUCCESS;
}
