// The speed of the remeshing, beside the isotropic remeshing of CGAL, with the quality and the distance of what is made
// beside each time. Prints comma-separated lines; see README.md, and run_benchmark.sh for plots.
//
//   hermite_diffuse_remesh_benchmark TABLE [NUMBER | MESH]...
//
//   comparison   meshes remeshed to one size, with 100000 and 400000 faces; also without the parts that cost most
//   adaptive     the same with sizes that follow the curvature, beside CGAL's adaptive sizes, from CGAL 6 on
//   scaling      one mesh from 10000 to 4000000 faces, with one thread and with two
//   regimes      refinement, coarsening, and a mesh that has its sizes already; the number is the factor between them
//
// Without numbers those above are taken, without names fandisk, bunny00, torus and elephant; other names are those of
// CGAL's meshes.

#include "../../test/Hermite_diffuse_remeshing/analytic_surfaces.h"
#include "../../test/Hermite_diffuse_remeshing/make_mesh.h"
#include "../../test/Hermite_diffuse_remeshing/mesh_measures.h"
#include "find_value.h"

#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Memory_sizer.h>
#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Polygon_mesh_processing/detect_features.h>
#include <CGAL/Polygon_mesh_processing/distance.h>
#include <CGAL/Polygon_mesh_processing/hermite_diffuse_remesh.h>
#include <CGAL/Polygon_mesh_processing/remesh.h>
#include <CGAL/Real_timer.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/tags.h>

#if __has_include(<CGAL/Polygon_mesh_processing/Adaptive_sizing_field.h>)
#include <CGAL/Polygon_mesh_processing/Adaptive_sizing_field.h>
#define HAS_ADAPTIVE_SIZES
#endif

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#endif

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <iostream>
#include <iterator>
#include <map>
#include <string>
#include <utility>
#include <vector>

typedef CGAL::Exact_predicates_inexact_constructions_kernel             K;
typedef CGAL::Surface_mesh<K::Point_3>                                  Mesh;
typedef CGAL::Hermite_diffuse_remeshing::Default_remeshing_visitor<Mesh> Visitor;
typedef std::vector<std::pair<std::string, double> >                    Stages;

namespace PMP = CGAL::Polygon_mesh_processing;
namespace params = CGAL::parameters;

constexpr double sharp_angle = 40.;
// of a larger mesh one run is enough, and a median of several needs an hour
constexpr std::size_t largest_repeated_mesh = 500000;
constexpr int number_of_repetitions = 5;

// The largest resident memory since it was reset, where the system tells it, otherwise that of now; in bytes.
void reset_peak_memory() { std::ofstream("/proc/self/clear_refs") << 5; }

double peak_memory()
{
  std::ifstream status("/proc/self/status");
  for(std::string word; status >> word; )
    if(word == "VmHWM:")
    {
      double kilobytes = 0.;
      status >> kilobytes;
      return 1024. * kilobytes;
    }
  return double(CGAL::Memory_sizer().resident_size());
}

struct Measurement
{
  double seconds = 0., peak_memory = 0.;
  Stages stages;
  Mesh mesh;
};

// `remesh(mesh)` returns the stages; the median run counts
Measurement measure(const Mesh& input, const std::function<Stages(Mesh&)>& remesh)
{
  std::vector<double> seconds;
  Measurement result;
  std::vector<Stages> stages;
  do
  {
    result.mesh = input;
    reset_peak_memory();
    CGAL::Real_timer timer;
    timer.start();
    stages.push_back(remesh(result.mesh));
    timer.stop();
    result.peak_memory = peak_memory();
    seconds.push_back(timer.time());
  }
  while(seconds.size() < std::size_t(number_of_repetitions) && result.mesh.number_of_faces() <= largest_repeated_mesh);
  std::vector<std::size_t> order(seconds.size());
  for(std::size_t i = 0; i < order.size(); ++i)
    order[i] = i;
  std::sort(order.begin(), order.end(), [&](const std::size_t a, const std::size_t b) { return seconds[a] < seconds[b]; });
  result.seconds = seconds[order[order.size() / 2]];
  result.stages = stages[order[order.size() / 2]];
  return result;
}

// 99.9 % of the points of one mesh are that close to another, and the farthest; of the diagonal
std::pair<double, double> distances(const Mesh& from, const Mesh& to)
{
  typedef CGAL::AABB_face_graph_triangle_primitive<Mesh> Primitive;
  const CGAL::AABB_tree<CGAL::AABB_traits<K, Primitive> > tree(faces(to).begin(), faces(to).end(), to);
  std::vector<K::Point_3> samples;
  PMP::sample_triangle_mesh(from, std::back_inserter(samples),
                            params::random_seed(0).use_random_uniform_sampling(true).number_of_points_on_faces(50000));
  std::vector<double> squares;
  for(const K::Point_3& p : samples)
    squares.push_back(tree.squared_distance(p));
  std::sort(squares.begin(), squares.end());
  const double diagonal = diagonal_of_box(to);
  return std::make_pair(std::sqrt(squares[squares.size() - squares.size() / 1000 - 1]) / diagonal,
                        std::sqrt(squares.back()) / diagonal);
}

const char* const stage_names[] = {"model", "size map", "adaptation", "optimisation", "deviation", "report"};

void print_header()
{
  std::cout << "table,mesh,method,threads,input faces,faces,seconds,faces per second";
  for(const char* name : stage_names)
    std::cout << ',' << name;
  std::cout << ",smallest quality,quality of 1 %,mean quality,distance of 99.9 %,largest distance"
               ",peak memory in MiB,bytes per face" << std::endl;
}

void print(const std::string& table, const std::string& name, const std::string& method, const int number_of_threads,
           const Mesh& input, const Mesh& shape, Measurement& m, const double memory_before)
{
  m.mesh.collect_garbage();
  std::vector<double> qualities;
  double sum = 0.;
  for(const Mesh::Face_index f : m.mesh.faces())
  {
    const auto h = m.mesh.halfedge(f);
    const double a = PMP::edge_length(h, m.mesh), b = PMP::edge_length(m.mesh.next(h), m.mesh),
                 c = PMP::edge_length(m.mesh.prev(h), m.mesh);
    const double longest = (std::max)({a, b, c});
    qualities.push_back(longest > 0. ? 4. * std::sqrt(3.) * PMP::face_area(f, m.mesh) / ((a + b + c) * longest) : 0.);
    sum += qualities.back();
  }
  std::sort(qualities.begin(), qualities.end());
  const double n = double(qualities.size());
  const std::pair<double, double> distance = distances(m.mesh, shape);
  std::cout << table << ',' << name << ',' << method << ',' << number_of_threads << ',' << input.number_of_faces() << ','
            << m.mesh.number_of_faces() << ',' << m.seconds << ',' << n / m.seconds;
  for(const char* stage : stage_names)
  {
    double seconds = 0.;
    for(const auto& entry : m.stages)
      if(entry.first == stage)
        seconds += entry.second;
    std::cout << ',' << seconds;
  }
  std::cout << ',' << qualities.front() << ',' << qualities[qualities.size() / 100] << ',' << sum / n << ','
            << distance.first << ',' << distance.second << ',' << m.peak_memory / 1048576. << ','
            << (m.peak_memory - memory_before) / n << std::endl;
}

// The stages in one thread, or in two.
template <typename Parameters>
Stages run(Mesh& mesh, const Parameters& parameters, const int number_of_threads = 1)
{
#ifdef CGAL_LINKED_WITH_TBB
  if(number_of_threads > 1)
  {
    const tbb::global_control control(tbb::global_control::max_allowed_parallelism, number_of_threads);
    return PMP::hermite_diffuse_remesh<CGAL::Parallel_tag>(mesh, parameters).stages;
  }
#endif
  CGAL_USE(number_of_threads);
  return PMP::hermite_diffuse_remesh(mesh, parameters).stages;
}

auto uniform(const double size)
{
  return params::minimum_edge_length(size).maximum_edge_length(size).sharp_dihedral_angle(sharp_angle)
                .maximum_number_of_faces(std::size_t(20000000));
}

// `size`: a length, or a field, which follows the mesh
template <typename Size>
void remesh_isotropically(Mesh& mesh, Size&& size, const int number_of_iterations)
{
  const auto is_sharp = mesh.add_property_map<Mesh::Edge_index, bool>("e:is_sharp", false).first;
  PMP::detect_sharp_edges(mesh, sharp_angle, is_sharp);
  PMP::isotropic_remeshing(faces(mesh), size, mesh, params::number_of_iterations(number_of_iterations)
                                                      .edge_is_constrained_map(is_sharp));
}

// the adaptation alone
struct Without_improvement : Visitor
{
  bool is_adapted = false;

  void stage_ends(const char* name) { is_adapted = is_adapted || name == std::string("adaptation"); }
  bool is_stop_requested() { return is_adapted; }
};

Mesh read(const std::string& name)
{
  if(name == "torus")
    return make_mesh<Mesh>(analytic::Torus().mesh(20000, 1));
  Mesh mesh;
  if(!PMP::IO::read_polygon_mesh(CGAL::data_file_path("meshes/" + name + ".off"), mesh))
    std::exit(EXIT_FAILURE);
  return mesh;
}

class Table
{
  std::string m_table, m_name;
  Mesh m_input;
  double m_memory_before;

public:
  Table(const std::string& table, const std::string& name)
    : m_table(table), m_name(name), m_input(read(name)), m_memory_before(double(CGAL::Memory_sizer().resident_size()))
  {}

  const Mesh& input() const { return m_input; }

  // returns the number of faces
  double add(const std::string& method, const std::function<Stages(Mesh&)>& remesh, const int number_of_threads = 1)
  {
    return add(m_input, method, remesh, number_of_threads);
  }

  double add(const Mesh& input, const std::string& method, const std::function<Stages(Mesh&)>& remesh,
             const int number_of_threads = 1)
  {
    Measurement m = measure(input, remesh);
    print(m_table, m_name, method, number_of_threads, input, m_input, m, m_memory_before);
    return double(m.mesh.number_of_faces());
  }

  // with as many faces as wanted
  void add_isotropic(const Mesh& input, const double wanted)
  {
    const double size = find_value(size_for(input, wanted), wanted, 2., [&](const double s)
    {
      Mesh mesh = input;
      remesh_isotropically(mesh, s, 5);
      return double(mesh.number_of_faces());
    });
    for(const int n : {5, 10})
      add(input, "CGAL isotropic " + std::to_string(n) + " iterations",
          [&](Mesh& mesh) { remesh_isotropically(mesh, size, n); return Stages(); });
  }
};

void compare(const std::string& name, const double wanted)
{
  Table table("comparison", name);
  const double size = size_for(table.input(), wanted);
  const double number = table.add("this package", [&](Mesh& mesh) { return run(mesh, uniform(size)); });
  table.add("without test of intersections",
            [&](Mesh& mesh) { return run(mesh, uniform(size).do_self_intersection_tests(false)); });
  table.add("without final improvement", [&](Mesh& mesh)
  {
    Without_improvement visitor;
    return run(mesh, uniform(size).visitor(std::ref(visitor)));
  });
  table.add("model of the paper", [&](Mesh& mesh)
            { return run(mesh, uniform(size).surface_model(CGAL::Hermite_diffuse_remeshing::PAPER_MODEL)); });
  table.add_isotropic(table.input(), number);
}

void compare_adaptive(const std::string& name, const double wanted)
{
  Table table("adaptive", name);
  const double extent = size_for(table.input(), 1.);
  // bounds of the sizes, the same for both
  const double smallest = 0.2 * size_for(table.input(), wanted), largest = 5. * size_for(table.input(), wanted);
  const auto parameters = [&](const double sagitta)
  {
    return params::sagitta(sagitta).minimum_edge_length(smallest).maximum_edge_length(largest)
                  .sharp_dihedral_angle(sharp_angle);
  };
  const double sagitta = find_value(1e-4 * extent, wanted, 1., [&](const double s)
  {
    Mesh mesh = table.input();
    run(mesh, parameters(s));
    return double(mesh.number_of_faces());
  });
  const double number = table.add("this package", [&](Mesh& mesh) { return run(mesh, parameters(sagitta)); });
#ifdef HAS_ADAPTIVE_SIZES
  const auto remesh = [&](Mesh& mesh, const double tolerance)
  {
    PMP::Adaptive_sizing_field<Mesh> sizes(tolerance, std::make_pair(smallest, largest), faces(mesh), mesh);
    remesh_isotropically(mesh, sizes, 5);
    return double(mesh.number_of_faces());
  };
  const double tolerance = find_value(sagitta, number, 1., [&](const double t)
  {
    Mesh mesh = table.input();
    return remesh(mesh, t);
  });
  table.add("CGAL adaptive 5 iterations", [&](Mesh& mesh) { remesh(mesh, tolerance); return Stages(); });
#else
  CGAL_USE(number);
#endif
}

void scale(const double wanted)
{
  // sizes of this mesh are far above its details, and far below them
  Table table("scaling", "bunny00");
  const double size = size_for(table.input(), wanted);
  for(const int threads : {1, 2})
    table.add("this package", [&](Mesh& mesh) { return run(mesh, uniform(size), threads); }, threads);
  if(wanted < 2e6)
    table.add("CGAL isotropic 5 iterations",
              [&](Mesh& mesh) { remesh_isotropically(mesh, size, 5); return Stages(); });
}

void compare_regimes(const std::string& name, const double factor)
{
  const auto compare = [&](const char* regime, const Mesh& input, const double wanted)
  {
    Table table(regime, name);
    const double size = size_for(input, wanted);
    for(const int threads : {1, 2})
      table.add(input, "this package", [&](Mesh& mesh) { return run(mesh, uniform(size), threads); }, threads);
    table.add_isotropic(input, wanted);
  };
  const Mesh input = read(name);
  const double number = double(input.number_of_faces());
  compare("refinement", input, factor * number);
  compare("coarsening", input, number / factor);
  Mesh fine = input;
  run(fine, uniform(size_for(input, factor * number)));
  fine.collect_garbage();
  compare("coarsening of a fine mesh", fine, number);
  compare("identity", fine, double(fine.number_of_faces()));
}

int main(int argc, char* argv[])
{
  const std::map<std::string, std::vector<double> > default_numbers =
    {{"comparison", {1e5, 4e5}}, {"adaptive", {1e5}}, {"scaling", {1e4, 4e4, 1.6e5, 6.4e5, 2e6, 4e6}}, {"regimes", {5.}}};
  const std::string table = argc > 1 ? argv[1] : "";
  if(default_numbers.count(table) == 0)
  {
    std::cerr << "usage: " << argv[0] << " comparison|adaptive|scaling|regimes [number | mesh]..." << std::endl;
    return EXIT_FAILURE;
  }
  std::vector<double> numbers;
  std::vector<std::string> meshes;
  for(int i = 2; i < argc; ++i)
  {
    const double number = std::atof(argv[i]);
    if(number > 0.)
      numbers.push_back(number);
    else
      meshes.push_back(argv[i]);
  }
  if(numbers.empty())
    numbers = default_numbers.at(table);
  if(meshes.empty())
    meshes = {"fandisk", "bunny00", "torus", "elephant"};

  print_header();
  for(const double number : numbers)
  {
    if(table == "scaling")
      scale(number);
    else
      for(const std::string& name : meshes)
        if(table == "comparison")
          compare(name, number);
        else if(table == "adaptive")
          compare_adaptive(name, number);
        else
          compare_regimes(name, number);
  }
  return EXIT_SUCCESS;
}
