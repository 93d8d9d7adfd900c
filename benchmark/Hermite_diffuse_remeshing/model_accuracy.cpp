// Accuracy, speed and memory of the Hermite diffuse model on irregular meshes of known surfaces, against
// jets and, where CGAL has them, interpolated corrected curvatures. Times are those of the processor, in one
// thread, the best of several runs.
//
//   model_accuracy [number of faces ...]           default: 2000 8000

#include "../../test/Hermite_diffuse_remeshing/model_measures.h"

#include <CGAL/Hermite_diffuse_surface.h>
#include <CGAL/Monge_via_jet_fitting.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#if __has_include(<CGAL/Polygon_mesh_processing/interpolated_corrected_curvatures.h>)
#include <CGAL/Polygon_mesh_processing/interpolated_corrected_curvatures.h>
#define HAS_CORRECTED_CURVATURES
#endif

#ifdef __GLIBC__
#include <malloc.h>
#endif

#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

using namespace measures;
using analytic::Test_surface;
using CGAL::Hermite_diffuse_remeshing::SMOOTH_NORMALS;

typedef CGAL::Simple_cartesian<double> Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;
typedef std::vector<std::pair<double, double> > Curvatures;      // of the nodes, larger first

struct Result
{
  Accuracy accuracy;
  double microseconds = 0.;                                      // per vertex
};
typedef std::map<std::string, Result> Results;                   // by method

Model_options paper_options()
{
  Model_options options;
  options.degree = 2;
  options.exponent = 1;
  options.hermite_weight = 0.5;
  options.normals = AREA_NORMALS;
  return options;
}

Model_options smooth_options()
{
  Model_options options;
  options.exponent = 1;
  options.normals = SMOOTH_NORMALS;
  return options;
}

Mesh make_surface_mesh(const Indexed_triangles& triangles)
{
  Mesh mesh;
  for(const Vector& p : triangles.points)
    mesh.add_vertex(Kernel::Point_3(p[0], p[1], p[2]));
  for(const auto& t : triangles.triangles)
    mesh.add_face(Mesh::Vertex_index(t[0]), Mesh::Vertex_index(t[1]), Mesh::Vertex_index(t[2]));
  return mesh;
}

// the best of several runs, in microseconds of the processor per item
double time_per_item(const std::size_t number_of_items, const std::function<void()>& work)
{
  constexpr int number_of_runs = 5;
  double best = infinite;
  for(int run = 0; run < number_of_runs; ++run)
  {
    const std::clock_t start = std::clock();
    work();
    best = (std::min)(best, 1e6 * double(std::clock() - start) / CLOCKS_PER_SEC / double(number_of_items));
  }
  return best;
}

// ---- methods: our times include the construction of the model from the triangles, those of jets not the search of
// the rings


Curvatures evaluated(const Indexed_triangles& triangles, const Model_options& options)
{
  const auto model = make_model<Input_surface>(triangles, options);
  Curvatures result;
  for(int i = 0; i < model->surface.cut_mesh().number_of_nodes(); ++i)
    result.push_back(model->surface.evaluate(model->surface.location_of_node(i)).monge_form().curvatures());
  return result;
}

Curvatures fitted(const Indexed_triangles& triangles, const Model_options& options)
{
  const auto model = make_model<Input_surface>(triangles, options);
  Node_curvature_fitter fitter(model->surface);
  Curvatures result;
  for(int i = 0; i < model->surface.cut_mesh().number_of_nodes(); ++i)
    result.push_back(fitter(i).curvatures());
  return result;
}

// A jet of degree `degree` at every vertex, over `rings` rings of neighbours, more if they are too few.
Curvatures jets(const Input_model& model, const std::size_t degree, const int rings)
{
  const Reference_surface& surface = model.surface;
  Node_neighborhood neighborhood(surface.cut_mesh(), surface.nodes());
  const auto to_point = [](const Vector& p) { return Kernel::Point_3(p[0], p[1], p[2]); };
  const int needed = number_of_monomials(int(degree));
  Curvatures result;
  for(int i = 0; i < surface.cut_mesh().number_of_nodes(); ++i)
  {
    neighborhood.collect(i, rings);
    while(neighborhood.size() + 1 < needed)
      neighborhood.add_ring();
    std::vector<Kernel::Point_3> points(1, to_point(surface.node(i).position));
    for(const int j : neighborhood.neighbors())
      points.push_back(to_point(surface.node(j).position));
    CGAL::Monge_via_jet_fitting<Kernel> fit;
    auto monge = fit(points.begin(), points.end(), degree, 2);
    const Vector n = fan_normal(surface.triangles(), surface.cut_mesh(), i, false);
    monge.comply_wrt_given_normal(Kernel::Vector_3(n[0], n[1], n[2]));
    result.push_back(std::make_pair(monge.principal_curvatures(0), monge.principal_curvatures(1)));
  }
  return result;
}

#ifdef HAS_CORRECTED_CURVATURES
Curvatures corrected(const Indexed_triangles& triangles, const double radius)
{
  namespace PMP = CGAL::Polygon_mesh_processing;
  typedef PMP::Principal_curvatures_and_directions<Kernel> Principal;
  Mesh mesh = make_surface_mesh(triangles);
  const auto map = mesh.add_property_map<Mesh::Vertex_index, Principal>("v:principal").first;
  const auto np = CGAL::parameters::vertex_principal_curvatures_and_directions_map(map);
  if(radius > 0.)
    PMP::interpolated_corrected_curvatures(mesh, np.ball_radius(radius));
  else
    PMP::interpolated_corrected_curvatures(mesh, np);
  Curvatures result;
  for(const Mesh::Vertex_index v : mesh.vertices())              // their sign is the opposite of that of fits
    result.push_back(std::make_pair(-map[v].min_curvature, -map[v].max_curvature));
  return result;
}
#endif

// ---- tables

// nodes are numbered by faces, vertices by points: results by vertex are moved to nodes
Result run(const Input_model& model, const Test_surface& surface, const bool is_by_vertex,
           const std::function<Curvatures()>& method)
{
  Result result;
  Curvatures curvatures;
  result.microseconds = time_per_item(model.surface.nodes().size(), [&] { curvatures = method(); });
  measure_curvature(model, surface, [&](const int i)
                    { return curvatures[is_by_vertex ? model.surface.cut_mesh().vertex(i) : i]; }, result.accuracy);
  return result;
}

Results compare_curvatures(const Test_surface& surface, const Indexed_triangles& triangles)
{
  const auto model = make_model(triangles);
  const double h = mean_edge_length(triangles);
  CGAL_USE(h);
  Results results;
  results["paper"] = run(*model, surface, false, [&] { return evaluated(triangles, paper_options()); });
  results["default"] = run(*model, surface, false, [&] { return evaluated(triangles, Model_options()); });
  results["VF4"] = run(*model, surface, false, [&] { return fitted(triangles, Model_options()); });
  results["smooth, VF3"] = run(*model, surface, false, [&] { return fitted(triangles, smooth_options()); });
  results["jet 2, 1 ring"] = run(*model, surface, false, [&] { return jets(*model, 2, 1); });
  results["jet 2, 2 rings"] = run(*model, surface, false, [&] { return jets(*model, 2, 2); });
  results["jet 4, 2 rings"] = run(*model, surface, false, [&] { return jets(*model, 4, 2); });
#ifdef HAS_CORRECTED_CURVATURES
  results["corrected, 1 ring"] = run(*model, surface, true, [&] { return corrected(triangles, 0.); });
  results["corrected, 2 h"] = run(*model, surface, true, [&] { return corrected(triangles, 2. * h); });
#endif
  return results;
}

void print(const std::string& name, const Results& results)
{
  std::printf("%s\n", name.c_str());
  for(const auto& r : results)
    std::printf("  %-18s median %.2e  95%% %.2e  max %.2e   %6.2f us per vertex\n", r.first.c_str(),
                r.second.accuracy.curvature_median, r.second.accuracy.curvature_p95,
                r.second.accuracy.curvature_max, r.second.microseconds);
}

void print_curvatures(const int number_of_faces)
{
  std::printf("\nCurvature at vertices away from borders, relative error, about %d faces\n", number_of_faces);
  int median_won = 0, p95_won = 0, within_factor = 0, maximum_won = 0, faster = 0;
  const std::vector<Test_surface> surfaces = analytic::all_test_surfaces();
  for(const Test_surface& s : surfaces)
  {
    const Results r = compare_curvatures(s, indexed(s.mesh(number_of_faces, 1)));
    print(s.name, r);
    const auto accuracy = [&](const char* method) -> const Accuracy& { return r.at(method).accuracy; };
    median_won += accuracy("default").curvature_median < (std::min)(accuracy("jet 2, 1 ring").curvature_median,
                                                                    accuracy("jet 2, 2 rings").curvature_median);
    p95_won += accuracy("default").curvature_p95 < (std::min)(accuracy("jet 2, 1 ring").curvature_p95,
                                                              accuracy("jet 2, 2 rings").curvature_p95);
    within_factor += accuracy("VF4").curvature_median < 2.5 * accuracy("jet 4, 2 rings").curvature_median;
    maximum_won += accuracy("VF4").curvature_max < accuracy("jet 4, 2 rings").curvature_max;
    faster += r.at("VF4").microseconds < r.at("jet 4, 2 rings").microseconds / 10.;
  }
  std::printf("of %d surfaces, default better than both jets of degree 2: %d in median, %d in 95 %%\n"
              "VF4 within a factor 2.5 of jets of degree 4 in median: %d, better in maximum: %d, "
              "ten times faster: %d\n",
              int(surfaces.size()), median_won, p95_won, within_factor, maximum_won, faster);
}

void print_positions(const int number_of_faces)
{
  std::printf("\nPoints of faces away from borders, rms relative to the mean edge length, about %d faces\n"
              "%-24s %9s %9s %9s %9s %9s | %9s\n", number_of_faces, "", "facets", "PN, area", "paper", "degree 2",
              "default", "normal (degrees)");
  for(const Test_surface& s : analytic::all_test_surfaces())
  {
    const Indexed_triangles triangles = indexed(s.mesh(number_of_faces, 1));
    Model_options paper = paper_options(), quadratic;
    paper.is_solved_at_centroids = true;
    quadratic.degree = 2;
    const Accuracy a = measure(*make_model(triangles), s);
    std::printf("%-24s %9.1e %9.1e %9.1e %9.1e %9.1e | %9.1e\n", s.name.c_str(), a.flat, a.pn_area,
                measure(*make_model(triangles, paper), s).position,
                measure(*make_model(triangles, quadratic), s).position, a.position, a.normal);
  }
}

void print_noise(const int number_of_faces)
{
  std::printf("\nCurvature with noise of 1 %% of the edge length, about %d faces\n", number_of_faces);
  for(const Test_surface& s : {analytic::torus(), analytic::sin_cos()})
  {
    Indexed_triangles triangles = indexed(s.mesh(number_of_faces, 1));
    const double h = mean_edge_length(triangles);
    analytic::Random random(1);
    for(Vector& p : triangles.points)
    {
      const double z = random(-1., 1.), a = random(0., 2. * analytic::pi), r = std::sqrt(1. - z * z);
      p += 0.01 * h * Vector(r * std::cos(a), r * std::sin(a), z);
    }
    print(s.name, compare_curvatures(s, triangles));
  }
}

// what the program has allocated, or 0 where the system does not tell
double bytes_in_use()
{
#if defined(__GLIBC__) && defined(__GLIBC_PREREQ)
#if __GLIBC_PREREQ(2, 33)
  const struct mallinfo2 info = mallinfo2();
  return double(info.uordblks) + double(info.hblkhd);
#endif
#endif
  return 0.;
}

void print_speed(const int number_of_faces)
{
  const Indexed_triangles triangles = indexed(analytic::torus().mesh(number_of_faces, 1));
  const int n = triangles.number_of_faces();
  std::printf("\nSpeed in one thread, torus of %d faces\n", n);
  typedef CGAL::Hermite_diffuse_surface<Mesh> Surface;
  const Mesh mesh = make_surface_mesh(triangles);
  std::printf("construction            %6.2f us per face\n", time_per_item(n, [&] { Surface surface(mesh); }));
  const double before = bytes_in_use();
  const Surface surface(mesh);
  std::printf("memory                  %6.0f bytes per face\n", (bytes_in_use() - before) / n);
  double sum = surface.point({*mesh.faces().begin(), {{1., 0., 0.}}}).x();
  std::vector<Location> locations;
  analytic::Random random(1);
  for(int f = 0; f < n; ++f)
  {
    const double r = std::sqrt(random(0., 1.)), s = random(0., 1.);
    locations.push_back({f, {{1. - r, r * (1. - s), r * s}}});
  }
  for(const int degree : {2, 3, 4})
  {
    Model_options options;
    options.degree = degree;
    const auto model = make_model(triangles, options);
    std::printf("evaluation, degree %d    %6.2f us\n", degree, time_per_item(n, [&]
    {
      for(const Location& location : locations)
        sum += model->surface.evaluate(location).a[0];
    }));
  }
  const auto model = make_model(triangles);
  model->locator.build_tree();
  std::vector<Vector> queries;
  for(const Location& location : locations)
  {
    const Local_quadric q = model->surface.evaluate(location);
    queries.push_back(q.point() + random(-0.3, 0.3) * q.size * q.normal());
  }
  std::printf("projection with a hint  %6.2f us\n", time_per_item(n, [&]
  {
    for(int f = 0; f < n; ++f)
      sum += model->locator.project(queries[f], f).quadric.a[0];
  }));
  std::printf("closest facet, no hint  %6.2f us\n", time_per_item(n, [&]
  {
    for(const Vector& query : queries)
      sum += model->locator.closest(query).coordinates[0];
  }));
  if(sum == 0.)                          // keeps the work from being optimised away
    std::printf(" \n");
}

int main(int argc, char* argv[])
{
  std::vector<int> sizes;
  for(int i = 1; i < argc; ++i)
    sizes.push_back(std::atoi(argv[i]));
  if(sizes.empty())
    sizes = {2000, 8000};
  for(const int size : sizes)
  {
    if(size < 100)
    {
      std::fprintf(stderr, "model_accuracy: a number of faces must be at least 100\n");
      return EXIT_FAILURE;
    }
    print_curvatures(size);
    print_positions(size);
    print_noise(size);
    print_speed(size);
  }
  return EXIT_SUCCESS;
}
