// The same input and parameters give the same mesh bit for bit: run again, in another type of mesh, and
// beside other remeshings in other threads. Run with the sanitizer of threads too, see run_tests.sh.

#include "test_helpers.h"

#include <CGAL/Hermite_diffuse_surface.h>
#include <CGAL/Polyhedron_3.h>

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

template <typename Mesh>
Mesh remeshed(const std::string& name, const double error)
{
  Mesh mesh = read_data<Mesh>(name);
  PMP::hermite_diffuse_remesh(mesh, params::approximation_error(error).maximum_deviation(0.005));
  return mesh;
}

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

struct Case { const char* name; double error; };

int main()
{
  const Case cases[] = {{"fandisk.off", 0.05}, {"joint.off", 0.02}, {"elephant.off", 0.1}};
  std::vector<Surface_mesh> results;
  for(const Case& c : cases)
  {
    std::cout << c.name << std::endl;
    results.push_back(remeshed<Surface_mesh>(c.name, c.error));
    const Surface_mesh again = remeshed<Surface_mesh>(c.name, c.error);
    assert(is_image(results.back(), again, [](const Point_3& p) { return p; }, 0.));
    assert(triangles_of(results.back()) == triangles_of(remeshed<Polyhedron>(c.name, c.error)));
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
