// Asks for a largest deviation, and measures what is delivered twice: by the package, and by CGAL between the
// result and a fine sampling of the model: with bounded_error_Hausdorff_distance() or, where that would take minutes
// or if it is asked for, approximate_Hausdorff_distance(). One line per case, the columns separated by tabs.
//
//   deviation_contract [--sampled] [part of the name [seconds [part of the diagonal]...]]

#include "../../test/Hermite_diffuse_remeshing/make_mesh.h"
#include "../../test/Hermite_diffuse_remeshing/mesh_measures.h"
#include "../../test/Hermite_diffuse_remeshing/sampled_model.h"
#include "../../test/Hermite_diffuse_remeshing/sized_surfaces.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Polygon_mesh_processing/distance.h>
#include <CGAL/Polygon_mesh_processing/hermite_diffuse_remesh.h>
#include <CGAL/Real_timer.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <string>
#include <vector>

typedef CGAL::Exact_predicates_inexact_constructions_kernel   K;
typedef CGAL::Surface_mesh<K::Point_3>                        Mesh;

namespace PMP = CGAL::Polygon_mesh_processing;
namespace HDR = CGAL::Hermite_diffuse_remeshing;

std::string wanted;
double seconds_at_most = 300.;
bool is_sampling_asked_for = false;
std::vector<double> parts = {0.01, 0.001, 0.0002};

// the distance from a to b
double distance(const Mesh& a, const Mesh& b, const double tolerance, const bool is_bounded)
{
  constexpr std::size_t least_number_of_points = 300000, points_per_face = 3;
  return is_bounded ? PMP::bounded_error_Hausdorff_distance<CGAL::Sequential_tag>(a, b, tolerance)
                    : PMP::approximate_Hausdorff_distance<CGAL::Sequential_tag>(a, b, CGAL::parameters::random_seed(0)
                        .number_of_points_on_faces((std::max)(least_number_of_points, points_per_face * a.number_of_faces())));
}

void run(const std::string& name, const Mesh& input)
{
  const double diagonal = diagonal_of_box(input);
  for(const double part : parts)
  {
    const double bound = part * diagonal;
    const auto parameters = CGAL::parameters::approximation_error(0.02).maximum_deviation(bound)
                              .maximum_running_time(seconds_at_most);
    Mesh mesh = input;
    const auto report = PMP::hermite_diffuse_remesh(mesh, parameters);

    // a tenth of the bound is near enough to agree or not; the model is sampled finer, so that chords of it do not count
    const double tolerance = 0.1 * bound;
    const Mesh model = sampled_model(input, parameters, 0.03 * bound);
    constexpr std::size_t largest_number_of_samples = 100000;
    const bool is_bounded = !is_sampling_asked_for && model.number_of_faces() <= largest_number_of_samples;
    CGAL::Real_timer timer;
    timer.start();
    const double to_model = distance(mesh, model, tolerance, is_bounded);
    const double from_model = distance(model, mesh, tolerance, is_bounded);
    timer.stop();
    std::string obstacles;
    for(const auto obstacle : {HDR::DEVIATION_AT_PROTECTED_EDGE, HDR::DEVIATION_AT_SMALLEST_SIZE,
                               HDR::DEVIATION_AT_FOLD, HDR::DEVIATION_AFTER_STOP})
      if(const auto n = std::count(report.deviation_obstacles.begin(), report.deviation_obstacles.end(), obstacle))
        obstacles += " " + std::to_string(n) + " " + HDR::name(obstacle);
    double seconds = 0.;
    for(const auto& stage : report.stages)
      if(stage.first == "deviation")
        seconds = stage.second;
    std::cout << name << "\t" << 100. * part << "\t" << report.number_of_input_faces << "\t" << report.number_of_faces
              << "\t" << report.number_of_deviation_rounds << "\t" << report.seconds << "\t" << seconds
              << "\t" << report.smallest_quality << "\t" << report.mean_quality
              << "\t" << report.distance_of_model_from_input / bound
              << "\t" << report.largest_deviation / bound << "\t" << to_model / bound << "\t" << from_model / bound
              << "\t" << (report.is_maximum_deviation_met ? "met" : "not met")
              << "\t" << report.faces_above_maximum_deviation.size() << obstacles
              << "\t" << HDR::name(report.stop_reason)
              << "\t" << (is_bounded ? "bounded" : "sampled") << "\t" << model.number_of_faces() << "\t" << timer.time() << std::endl;
  }
}

template <typename MakeMesh>
void run_if_wanted(const std::string& name, const MakeMesh& make_input)
{
  if(name.find(wanted) != std::string::npos)
    run(name, make_input());
}

int main(int argc, char* argv[])
{
  if(argc > 1 && argv[1] == std::string("--sampled"))
  {
    is_sampling_asked_for = true;
    --argc;
    ++argv;
  }
  if(argc > 1)
    wanted = argv[1];
  if(argc > 2)
    seconds_at_most = std::atof(argv[2]);
  if(argc > 3)
    parts.clear();
  for(int i = 3; i < argc; ++i)
    parts.push_back(std::atof(argv[i]));

  std::cout << "mesh\t% of diagonal\tinput faces\tfaces\trounds\tseconds\tof them deviation\tQmin\tQmean"
               "\tinput to model/bound\treported/bound\tto model/bound\tfrom model/bound\tmet\tfaces above\tstop\tCGAL\tsamples\tseconds of CGAL"
            << std::endl;
  constexpr int number_of_faces = 5000;
  analytic::Ellipsoid_123 sphere;
  sphere.b = sphere.c = sphere.a;
  run_if_wanted("sphere", [&] { return make_mesh<Mesh>(sphere.mesh(number_of_faces, 3)); });
  run_if_wanted("torus", [&] { return make_mesh<Mesh>(analytic::Torus().mesh(number_of_faces, 3)); });
  run_if_wanted("ellipsoid", [&] { return make_mesh<Mesh>(analytic::Ellipsoid_123().mesh(number_of_faces, 3)); });
  run_if_wanted("cylinder", [&] { return make_mesh<Mesh>(analytic::Frustum().mesh(number_of_faces, 3)); });
  for(const char* name : {"fandisk", "elephant", "joint", "anchor_dense", "couplingdown", "camel", "ChineseDragon-10kv",
                          "anchor", "blobby"})
    run_if_wanted(name, [&]
    {
      Mesh mesh;
      if(!PMP::IO::read_polygon_mesh(CGAL::data_file_path("meshes/" + std::string(name) + ".off"), mesh))
        std::cerr << "Cannot read " << name << std::endl;
      return mesh;
    });
  return EXIT_SUCCESS;
}
