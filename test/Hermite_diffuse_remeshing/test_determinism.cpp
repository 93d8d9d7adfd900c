// The same input and parameters give the same mesh bit for bit: run again, in another type of mesh, by several
// threads, and beside other remeshings in other threads. Run with the sanitizer of threads too, see run_tests.sh.

#include "test_helpers.h"

#include <CGAL/Hermite_diffuse_size_map.h>
#include <CGAL/Hermite_diffuse_surface.h>
#include <CGAL/Polygon_mesh_processing/hermite_diffuse_remesh_triangle_soup.h>
#include <CGAL/Polyhedron_3.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#endif

#include <algorithm>
#include <thread>

typedef CGAL::Polyhedron_3<Kernel> Polyhedron;
typedef std::array<analytic::Point, 3> Triangle;

// The points of the faces, each from its smallest on, sorted: what a mesh is, without the order in which
// its type stores it.
template <typename Mesh>
std::vector<Triangle> triangles_of(const Mesh& mesh)
{
  std::vector<Triangle> result;
  for(const auto f : faces(mesh))
  {
    const auto h = halfedge(f, mesh);
    Triangle t = {{coordinates(mesh, source(h, mesh)), coordinates(mesh, target(h, mesh)),
                   coordinates(mesh, target(next(h, mesh), mesh))}};
    std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
    result.push_back(t);
  }
  std::sort(result.begin(), result.end());
  return result;
}

struct Case { const char* name; double error; };
const Case cases[] = {{"fandisk.off", 0.05}, {"joint.off", 0.02}, {"elephant.off", 0.1}};

template <typename Mesh, typename ConcurrencyTag = CGAL::Sequential_tag>
Mesh remeshed(const std::string& name, const double error)
{
  Mesh mesh = read_data<Mesh>(name);
  PMP::hermite_diffuse_remesh<ConcurrencyTag>(mesh, params::approximation_error(error).maximum_deviation(0.005));
  return mesh;
}

// the visitor is called by one thread alone, in the same order for any number of threads
struct Recorder : HDR::Default_remeshing_visitor<Surface_mesh>
{
  std::thread::id thread = std::this_thread::get_id();
  std::vector<unsigned> operations;
  std::size_t number_of_questions = 0;

  void add(const char kind, const unsigned element)
  {
    assert(std::this_thread::get_id() == thread);
    operations.push_back(unsigned(kind) << 24 ^ element);
  }
  bool is_stop_requested()
  {
    assert(std::this_thread::get_id() == thread);
    ++number_of_questions;
    return false;
  }
  void progress(double) { assert(std::this_thread::get_id() == thread); }
  void after_edge_split(vertex_descriptor v) { add('s', v); }
  void after_edge_collapse(vertex_descriptor v) { add('c', v); }
  void after_edge_flip(edge_descriptor e) { add('f', unsigned(e)); }
  void after_vertex_removal() { add('r', 0); }
  void after_vertex_relocation(vertex_descriptor v) { add('m', v); }
};

template <typename ConcurrencyTag>
std::vector<unsigned> operations_on_soup()
{
  const Surface_mesh mesh = read_data<Surface_mesh>("fandisk.off");
  std::vector<Point_3> points;
  std::vector<std::array<std::size_t, 3> > triangles;
  for(const auto v : vertices(mesh))
    points.push_back(mesh.point(v));
  for(const auto f : faces(mesh))
  {
    const auto h = halfedge(f, mesh);
    triangles.push_back({{source(h, mesh), target(h, mesh), target(next(h, mesh), mesh)}});
  }
  Recorder recorder;
  PMP::hermite_diffuse_remesh_triangle_soup<ConcurrencyTag>(points, triangles, params::approximation_error(0.1)
                                                              .size_field([id = recorder.thread](const Point_3&)
  {
    assert(std::this_thread::get_id() == id);
    return 0.1;
  }).visitor(std::ref(recorder)));
  assert(recorder.number_of_questions > 0 && !recorder.operations.empty());
  return recorder.operations;
}

// the sizes at the vertices of a mesh
template <typename ConcurrencyTag>
std::vector<double> sizes(const HDR::Normal_estimation normals)
{
  const Surface_mesh mesh = read_data<Surface_mesh>("fandisk.off");
  const CGAL::Hermite_diffuse_size_map<Surface_mesh, Kernel, ConcurrencyTag> map(
    mesh, params::approximation_error(0.05).normal_estimation(normals));
  std::vector<double> result;
  for(const auto v : vertices(mesh))
    result.push_back(map.size(mesh.point(v)));
  return result;
}

// limits the threads of TBB while it lives
struct Number_of_threads
{
#ifdef CGAL_LINKED_WITH_TBB
  tbb::global_control control;
  explicit Number_of_threads(const int n) : control(tbb::global_control::max_allowed_parallelism, n) {}
#else
  explicit Number_of_threads(int) {}
#endif
};

// threads may ask one surface at the same time
void test_queries_in_threads()
{
  const Surface_mesh mesh = read_data<Surface_mesh>("fandisk.off");
  const CGAL::Hermite_diffuse_surface<Surface_mesh> surface(mesh);
  const auto ask = [&]
  {
    std::vector<Point_3> answers;
    for(const auto v : vertices(mesh))
      if(int(v) % 50 == 0)
        answers.push_back(surface.point(surface.project(mesh.point(v) + Kernel::Vector_3(0.01, 0.02, 0.03))));
    return answers;
  };
  const std::vector<Point_3> expected = ask();
  std::vector<std::vector<Point_3> > answers(2);
  std::vector<std::thread> threads;
  for(auto& a : answers)
    threads.emplace_back([&] { a = ask(); });
  for(std::thread& thread : threads)
    thread.join();
  for(const auto& a : answers)
    assert(a == expected);
}

int main()
{
  std::vector<Surface_mesh> results;
  for(const Case& c : cases)
  {
    std::cout << c.name << std::endl;
    results.push_back(remeshed<Surface_mesh>(c.name, c.error));
    const Number_of_threads two(2);
    const Surface_mesh again = remeshed<Surface_mesh, CGAL::Parallel_if_available_tag>(c.name, c.error);
    assert(is_image(results.back(), again, [](const Point_3& p) { return p; }, 0.));
    assert(triangles_of(results.back())
           == triangles_of(remeshed<Polyhedron, CGAL::Parallel_if_available_tag>(c.name, c.error)));
  }
  const std::vector<unsigned> operations = operations_on_soup<CGAL::Sequential_tag>();
  for(const int number : {1, 3})
  {
    const Number_of_threads threads(number);
    assert(operations_on_soup<CGAL::Parallel_if_available_tag>() == operations);
    for(const HDR::Normal_estimation normals : {HDR::FITTED_NORMALS, HDR::SMOOTH_NORMALS})
      assert(sizes<CGAL::Parallel_if_available_tag>(normals) == sizes<CGAL::Sequential_tag>(normals));
  }

  std::cout << "threads" << std::endl;
  test_queries_in_threads();
  std::vector<Surface_mesh> in_threads(results.size());
  std::vector<std::thread> threads;
  for(std::size_t i = 0; i < results.size(); ++i)
    threads.emplace_back([&, i] { in_threads[i] = remeshed<Surface_mesh>(cases[i].name, cases[i].error); });
  for(std::thread& thread : threads)
    thread.join();
  for(std::size_t i = 0; i < results.size(); ++i)
    assert(is_image(results[i], in_threads[i], [](const Point_3& p) { return p; }, 0.));
  std::cout << "done" << std::endl;
  return EXIT_SUCCESS;
}
