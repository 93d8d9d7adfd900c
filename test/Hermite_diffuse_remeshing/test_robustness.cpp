// Stops, exceptions and failing allocations at any moment leave a valid mesh; what would never end is cut off.

#include "mesh_measures.h"
#include "test_helpers.h"

#include <CGAL/Hermite_diffuse_remeshing/internal/Transformation/Refinement_attempts.h>
#include <CGAL/Polyhedron_3.h>

#include <cmath>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <new>
#include <stdexcept>

typedef CGAL::Polyhedron_3<Kernel> Polyhedron;

// ---- allocations that fail on request -------------------------------------------------------------

namespace allocations {
long number = 0;
long number_of_failing = -1;            // of the one that fails; -1: none
}

// both sides of the pairs are replaced, which the compiler does not see where it inlines one of them
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic ignored "-Wmismatched-new-delete"
#endif
void* operator new(const std::size_t size)
{
  if(allocations::number++ == allocations::number_of_failing)
    throw std::bad_alloc();
  if(void* const memory = std::malloc(size == 0 ? 1 : size))
    return memory;
  throw std::bad_alloc();
}
void* operator new[](const std::size_t size) { return operator new(size); }
// that of the address sanitizer, of `std::stable_sort()`'s buffers, would not go with the ones below
void* operator new(const std::size_t size, const std::nothrow_t&) noexcept
{
  try { return operator new(size); }
  catch(const std::bad_alloc&) { return nullptr; }
}
void operator delete(void* const memory, const std::nothrow_t&) noexcept { std::free(memory); }
void operator delete(void* const memory) noexcept { std::free(memory); }
void operator delete(void* const memory, std::size_t) noexcept { std::free(memory); }
void operator delete[](void* const memory) noexcept { std::free(memory); }
void operator delete[](void* const memory, std::size_t) noexcept { std::free(memory); }

// ---- helpers --------------------------------------------------------------------------------------

// points and corners of the faces, in the order of the mesh
template <typename Mesh>
std::vector<analytic::Point> faces_of(const Mesh& mesh)
{
  std::vector<analytic::Point> result;
  for(const auto v : vertices(mesh))
    result.push_back(coordinates(mesh, v));
  for(const auto f : faces(mesh))
    for(const auto h : CGAL::halfedges_around_face(halfedge(f, mesh), mesh))
      result.push_back(coordinates(mesh, source(h, mesh)));
  return result;
}

// A pyramid on a square with bent sides: corners, sharp edges, a border and round parts.
template <typename Mesh>
Mesh make_tent()
{
  analytic::Triangles t;
  constexpr int n = 12;
  for(int j = 0; j <= n; ++j)
    for(int i = 0; i <= n; ++i)
    {
      const double x = 2. * i / n - 1., y = 2. * j / n - 1.;
      t.points.push_back({{x, y, 1. - (std::max)(std::abs(x), std::abs(y)) + 0.2 * std::cos(2. * x) * std::cos(2. * y)}});
    }
  for(int j = 0; j < n; ++j)
    for(int i = 0; i < n; ++i)
    {
      const std::size_t v = j * (n + 1) + i, w = v + n + 1;
      if((i < n / 2) == (j < n / 2))
      {
        t.faces.push_back({{v, v + 1, w + 1}});
        t.faces.push_back({{v, w + 1, w}});
      }
      else
      {
        t.faces.push_back({{v, v + 1, w}});
        t.faces.push_back({{v + 1, w + 1, w}});
      }
    }
  return make_mesh<Mesh>(t);
}

struct Hook_exception {};

// Counts the calls; the one with a given number stops the remeshing or throws.
template <typename Mesh>
struct Counting_visitor
  : public HDR::Default_remeshing_visitor<Mesh>
{
  typedef HDR::Default_remeshing_visitor<Mesh> Base;
  typedef typename Base::vertex_descriptor vertex_descriptor;
  typedef typename Base::halfedge_descriptor halfedge_descriptor;
  typedef typename Base::edge_descriptor edge_descriptor;
  typedef typename Base::face_descriptor face_descriptor;

  const Mesh& mesh;
  long questions = 0, last_question = -1, throwing_question = -1;
  long hooks = 0, last_hook = -1;
  bool is_stopped = false;
  int open_stages = 0;
  double last_fraction = 0.;
  vertex_descriptor kept = boost::graph_traits<Mesh>::null_vertex(), moved = boost::graph_traits<Mesh>::null_vertex();

  explicit Counting_visitor(const Mesh& mesh) : mesh(mesh) {}

  void hook()
  {
    assert(!is_stopped);
    if(hooks++ == last_hook)
      throw Hook_exception();
  }

  void stage_begins(const char*) { ++open_stages; last_fraction = 0.; }
  void stage_ends(const char*) { --open_stages; }
  void progress(const double fraction)
  {
    assert(fraction >= last_fraction && fraction <= 1.);
    last_fraction = fraction;
  }
  bool is_stop_requested()
  {
    assert(!is_stopped);
    if(questions == throwing_question)
      throw Hook_exception();
    is_stopped = questions++ == last_question;
    return is_stopped;
  }
  void before_edge_split(edge_descriptor) { hook(); }
  void after_edge_split(vertex_descriptor) { hook(); }
  void after_face_split(const face_descriptor f, const face_descriptor part) { assert(f != part); hook(); }
  void before_edge_collapse(const halfedge_descriptor h) { kept = target(h, mesh); hook(); }
  void after_edge_collapse(const vertex_descriptor v) { assert(v == kept); hook(); }
  void before_edge_flip(edge_descriptor) { hook(); }
  void after_edge_flip(edge_descriptor) { hook(); }
  void before_vertex_removal(vertex_descriptor) { hook(); }
  void after_vertex_removal() { hook(); }
  void before_vertex_relocation(const vertex_descriptor v) { moved = v; hook(); }
  void after_vertex_relocation(const vertex_descriptor v) { assert(v == moved); hook(); }
};

auto parameters_of_tent()
{
  return params::approximation_error(0.02).maximum_edge_length(0.25).maximum_deviation(1e-3);
}

// ---- tests ----------------------------------------------------------------------------------------

template <typename Mesh>
void test_stops_and_exceptions(const int number_of_moments)
{
  std::cout << "stops and exceptions" << std::endl;
  const Mesh input = make_tent<Mesh>();
  Mesh complete = input;
  Counting_visitor<Mesh> counter(complete);
  PMP::hermite_diffuse_remesh(complete, parameters_of_tent().visitor(std::ref(counter)));
  check_result(input, complete);
  assert(counter.questions > 1000 && counter.hooks > 1000);

  analytic::Random random(1);
  for(int i = 0; i < number_of_moments; ++i)
  {
    Mesh mesh = input;
    Counting_visitor<Mesh> visitor(mesh);
    visitor.last_question = long(random(0., double(counter.questions)));
    const auto report = PMP::hermite_diffuse_remesh(mesh, parameters_of_tent().visitor(std::ref(visitor)));
    assert(report.stop_reason == HDR::STOPPED_BY_VISITOR && visitor.is_stopped && visitor.open_stages == 0);
    assert(!report.is_deviation_measured || visitor.last_question + 1 >= counter.questions);
    assert(report.number_of_faces == std::size_t(numbers(mesh)[2]));
    check_result(input, mesh);
  }
  for(int i = 0; i < number_of_moments; ++i)
  {
    Mesh mesh = input;
    Counting_visitor<Mesh> visitor(mesh);
    if(i % 5 == 0)
      visitor.throwing_question = long(random(0., double(counter.questions)));
    else
      visitor.last_hook = long(random(0., double(counter.hooks)));
    bool is_thrown = false;
    try { PMP::hermite_diffuse_remesh(mesh, parameters_of_tent().visitor(std::ref(visitor))); }
    catch(const Hook_exception&) { is_thrown = true; }
    assert(is_thrown);
    check_result(input, mesh);
  }
}

// A mesh with large sizes comes first. Whenever a stop comes, the sizes that are written are those that were asked for.
void test_stops_at_coarse_levels()
{
  std::cout << "stops at coarse levels" << std::endl;
  // stops soon after it has been told of progress for the n-th time
  struct Visitor : public HDR::Default_remeshing_visitor<Surface_mesh>
  {
    bool is_adapting = false;
    int reports = 0, last_report = -1, questions = 0;
    void stage_begins(const char* name) { is_adapting = std::strcmp(name, "adaptation") == 0; }
    void progress(double) { reports += is_adapting; }
    bool is_stop_requested()
    {
      // the first one comes from the passes themselves, those that follow from within an operator
      constexpr int question_of_operator = 3;
      return is_adapting && reports == last_report && ++questions == question_of_operator;
    }
  };
  const Surface_mesh input = make_mesh<Surface_mesh>(analytic::Torus().mesh(1000, 1));
  const double size = size_for(input, 20000.);
  const auto remesh = [&](Surface_mesh& mesh, Visitor& visitor)
  {
    const auto sizes = mesh.add_property_map<Surface_mesh::Vertex_index, double>("v:size", 0.).first;
    const auto report = PMP::hermite_diffuse_remesh(mesh, params::approximation_error(0.).minimum_edge_length(size)
      .maximum_edge_length(size).vertex_size_map(sizes).visitor(std::ref(visitor)));
    for(const auto v : mesh.vertices())
      assert(std::abs(sizes[v] - size) < 1e-9 * size);
    return report;
  };
  Surface_mesh complete = input;
  Visitor counter;
  assert(remesh(complete, counter).number_of_faces > 16000);
  for(int i = 0; i < counter.reports; ++i)
  {
    Surface_mesh mesh = input;
    Visitor visitor;
    visitor.last_report = i;
    assert(remesh(mesh, visitor).stop_reason == HDR::STOPPED_BY_VISITOR);
  }
}

// as many passes as there are numbers are no fewer than some
void test_most_iterations()
{
  std::cout << "most iterations" << std::endl;
  const auto remeshed = [](const int number_of_iterations)
  {
    Surface_mesh mesh = make_mesh<Surface_mesh>(analytic::Torus().mesh(1000, 1));
    const auto parameters = [&](const double number)
    {
      const double size = size_for(mesh, number);
      return params::approximation_error(0.).minimum_edge_length(size).maximum_edge_length(size)
                    .number_of_iterations(number_of_iterations);
    };
    PMP::hermite_diffuse_remesh(mesh, parameters(20000.));
    PMP::hermite_diffuse_remesh(mesh, parameters(21000.));
    return mesh;
  };
  assert(faces_of(remeshed(100)) == faces_of(remeshed((std::numeric_limits<int>::max)())));
}

template <typename Mesh>
void test_failing_allocations(const int number_of_failures)
{
  std::cout << "failing allocations" << std::endl;
  struct Visitor : public HDR::Default_remeshing_visitor<Mesh>
  {
    long before_changes = 0;
    void stage_begins(const char* name)
    {
      if(std::strcmp(name, "adaptation") == 0)
        before_changes = allocations::number;
    }
  };
  const Mesh input = make_tent<Mesh>();
  const std::vector<analytic::Point> before = faces_of(input);
  const auto field = [](const Point_3& p) { return 0.1 + 0.1 * std::abs(p.x()); };
  const auto remesh = [&](Mesh& mesh, Visitor& visitor)
  {
    PMP::hermite_diffuse_remesh(mesh, params::approximation_error(0.05).size_field(field).visitor(std::ref(visitor)));
  };
  Mesh complete = input;
  Visitor visitor;
  allocations::number = 0;
  remesh(complete, visitor);
  const long number = visitor.before_changes;
  assert(number > number_of_failures);
  int number_of_refusals = 0;
  for(int i = 0; i < number_of_failures; ++i)
  {
    Mesh mesh = input;
    bool is_failed = false;
    allocations::number = 0;
    allocations::number_of_failing = long(double(i) / number_of_failures * double(number));
    try { remesh(mesh, visitor); }
    catch(const std::bad_alloc&) { is_failed = true; }
    allocations::number_of_failing = -1;
    // the standard library goes on without some of its buffers
    number_of_refusals += is_failed;
    assert(faces_of(mesh) == (is_failed ? before : faces_of(complete)));
    assert(CGAL::is_valid_polygon_mesh(mesh));
    if(!is_failed)
      continue;
    if(i % 50 == 0)
    {
      // nothing is left behind either
      remesh(mesh, visitor);
      assert(faces_of(mesh) == faces_of(complete));
    }
  }
  assert(number_of_refusals > number_of_failures / 2);
}

void test_time_budget()
{
  std::cout << "time budget" << std::endl;
  const Surface_mesh input = make_tent<Surface_mesh>();
  Surface_mesh mesh = input;
  const auto report = PMP::hermite_diffuse_remesh(mesh, parameters_of_tent().maximum_running_time(1e-9));
  assert(report.stop_reason == HDR::TIME_BUDGET && std::string(name(report.stop_reason)) == "time_budget");
  assert(faces_of(mesh) == faces_of(input));
  // one that is not used up changes nothing
  Surface_mesh other = input;
  PMP::hermite_diffuse_remesh(mesh, parameters_of_tent().maximum_running_time(1e9));
  PMP::hermite_diffuse_remesh(other, parameters_of_tent());
  assert(faces_of(mesh) == faces_of(other));
}

// an absurd size asks for the cap of the number of faces, not for all the memory
void test_face_cap()
{
  std::cout << "face cap" << std::endl;
  struct Visitor : public HDR::Default_remeshing_visitor<Surface_mesh>
  {
    bool is_adapting = false;
    void stage_begins(const char* name) { is_adapting = std::strcmp(name, "adaptation") == 0; }
    bool is_stop_requested() { return is_adapting; }
  };
  const Surface_mesh input = make_tent<Surface_mesh>();
  for(const double error : {1e-9, 1e-300})
  {
    Surface_mesh mesh = input;
    Visitor visitor;
    const auto report = PMP::hermite_diffuse_remesh(mesh, params::approximation_error(error).visitor(std::ref(visitor)));
    assert(report.size_scale > 1.);
    assert(report.predicted_number_of_faces > 0.5e6 && report.predicted_number_of_faces <= 1e6);
  }
  // met where it is given
  Surface_mesh mesh = input;
  const auto report = PMP::hermite_diffuse_remesh(mesh, params::approximation_error(1e-9).maximum_number_of_faces(3000));
  assert(report.number_of_faces <= 3000 && report.number_of_faces > 2000);
  check_result(input, mesh);
}

// Features make more faces than the sizes predict. A budget of a third of the input's faces is met all the same.
void test_budget_with_features()
{
  std::cout << "budget with features" << std::endl;
  for(const char* const name : {"rotor.off", "couplingdown.off"})
  {
    const Surface_mesh input = read_data<Surface_mesh>(name);
    const std::size_t budget = num_faces(input) / 3;
    Surface_mesh mesh = input;
    const auto report =
      PMP::hermite_diffuse_remesh(mesh, params::approximation_error(0.001).maximum_number_of_faces(budget));
    assert(report.number_of_faces <= budget && 2 * report.number_of_faces > budget);
    assert(report.predicted_number_of_faces <= double(budget) && report.size_scale > 1.);
    check_result(input, mesh);
  }
}

// A stop before anything was changed: the maps tell where the vertices and faces are, and no bound counts as met.
HDR::Remeshing_report<Surface_mesh> check_early_stop(Surface_mesh mesh)
{
  typedef std::pair<std::size_t, std::array<double, 3> > Location;
  const std::size_t unknown = num_faces(mesh);
  const auto locations = mesh.add_property_map<Surface_mesh::Vertex_index, Location>("v:location", {unknown, {}}).first;
  const auto origins = mesh.add_property_map<Surface_mesh::Face_index, std::size_t>("f:origin", unknown).first;
  // a variable of faces is not taken for the mesh
  std::vector<Surface_mesh::Face_index> all_faces(faces(mesh).begin(), faces(mesh).end());
  const auto report = PMP::hermite_diffuse_remesh(all_faces, mesh, params::maximum_deviation(1.)
    .vertex_location_map(locations).face_origin_map(origins).maximum_running_time(1e-9));
  assert(report.stop_reason == HDR::TIME_BUDGET && !report.is_maximum_deviation_met);
  assert(num_faces(mesh) == unknown);
  for(const auto f : faces(mesh))
    assert(origins[f] == std::size_t(f));
  for(const auto v : vertices(mesh))
  {
    assert(locations[v].first < unknown);
    const auto h = mesh.halfedge(all_faces[locations[v].first]);
    const Surface_mesh::Vertex_index corners[3] = {mesh.source(h), mesh.target(h), mesh.target(mesh.next(h))};
    for(int k = 0; k < 3; ++k)
      assert(locations[v].second[k] == (corners[k] == v ? 1. : 0.));
  }
  assert(PMP::hermite_diffuse_remesh(all_faces, mesh).is_maximum_deviation_met);
  return report;
}

void test_early_stop()
{
  std::cout << "early stop" << std::endl;
  assert(check_early_stop(make_tent<Surface_mesh>()).number_of_unrepaired_faces == 0);
  // a face without height, which a flip would mend, and one with two vertices at one place
  const Surface_mesh cap = make_mesh<Surface_mesh>({{{{0., 0., 0.}}, {{2., 0., 0.}}, {{1., 0., 0.}}, {{1., 2., 0.}}},
                                                    {{{0, 1, 2}}, {{1, 0, 3}}}});
  const Surface_mesh twins = make_mesh<Surface_mesh>({{{{0., 0., 0.}}, {{1., 0., 0.}}, {{1., 1., 0.}}, {{1., 1., 0.}},
                                                       {{0., 1., 0.}}}, {{{0, 1, 2}}, {{0, 2, 3}}, {{0, 3, 4}}}});
  for(const Surface_mesh& input : {cap, twins})
    assert(check_early_stop(input).number_of_unrepaired_faces == 1);
}

// Where the faces that there may be do not do for the bound, they are shared out: edges keep to their sizes, and triangles
// their shapes.
void test_bound_beyond_face_cap()
{
  std::cout << "bound beyond the face cap" << std::endl;
  const Surface_mesh input = read_data<Surface_mesh>("elephant.off");
  Surface_mesh mesh = input;
  const std::size_t cap = 8000;
  const auto report =
    PMP::hermite_diffuse_remesh(mesh, params::maximum_deviation(1e-4).maximum_number_of_faces(cap));
  assert(report.stop_reason == HDR::FACE_BUDGET && !report.is_maximum_deviation_met && report.number_of_faces <= cap);
  for(const HDR::Deviation_obstacle obstacle : report.deviation_obstacles)
    assert(obstacle != HDR::DEVIATION_AT_SMALLEST_SIZE);
  assert(report.size_conformity > 0.8 && report.smallest_quality > 0.3);
  check_result(input, mesh);
}

// Where refining has failed is found again among as many places over one face as the mesh may have faces: a look at all
// of them for each would take hours.
void test_refinement_attempts()
{
  std::cout << "refinement attempts" << std::endl;
  constexpr int number_at_side = 600;
  constexpr double step = 1. / number_at_side, bound = 1.;
  HDR::internal::Refinement_attempts attempts(1.);
  const auto count_hopeless = [&](const double deviation)
  {
    const std::array<int, 1> reference_faces = {{0}};
    attempts.begin_round();
    int number = 0;
    for(int i = 0; i < number_at_side; ++i)
      for(int j = 0; j < number_at_side; ++j)
        number += attempts.is_hopeless(reference_faces, HDR::internal::Vector(i * step, j * step, 0.), step / 2.,
                                       deviation, bound);
    return number;
  };
  for(const double deviation : {8., 4., 3.9, 3.9})
    assert(count_hopeless(deviation) == 0);
  assert(count_hopeless(3.9) == number_at_side * number_at_side);
}

// A lens with a sharp rim of few edges, whose arcs lie beyond the narrow facets beside them by half the height of these:
// distances to the model are found there, and no faces are refined for nothing.
void test_rim_of_lens()
{
  std::cout << "rim of a lens" << std::endl;
  constexpr int number_of_rings = 24;
  constexpr double height = 0.02, diagonal = 2.83;
  std::vector<std::array<double, 2> > profile;
  for(int i = 0; i <= number_of_rings; ++i)
  {
    const double angle = CGAL_PI * i / number_of_rings;
    profile.push_back({{i % number_of_rings == 0 ? 0. : std::sin(angle), -height * std::cos(angle)}});
  }
  analytic::Random random(1);
  Surface_mesh mesh = make_mesh<Surface_mesh>(analytic::surface_of_revolution(32, profile, random));
  const auto report = PMP::hermite_diffuse_remesh(mesh, params::maximum_deviation(5e-3 * diagonal));
  assert(report.is_maximum_deviation_met && report.number_of_deviation_rounds == 0);
  assert(report.largest_deviation < 1e-3 * diagonal);
}

// vertices of a degree that nothing may take the cube of
void test_high_degree()
{
  std::cout << "high degree" << std::endl;
  constexpr int degree = 500;
  std::vector<std::array<double, 2> > profile;
  for(int i = 3; i >= 0; --i)
    profile.push_back({{std::sin(0.3 * i), std::cos(0.3 * i)}});
  analytic::Random random(1);
  const Surface_mesh input = make_mesh<Surface_mesh>(analytic::surface_of_revolution(degree, profile, random));
  Surface_mesh mesh = input;
  const auto report = PMP::hermite_diffuse_remesh(mesh);
  assert(report.smallest_quality > 0.3);
  check_result(input, mesh);
}

// Equal needles side by side, of which a collapse makes worse ones first
void test_row_of_needles()
{
  std::cout << "row of needles" << std::endl;
  for(const int number_of_columns : {200, 400})
    for(const double height : {0.2, 1., 3.})
    {
      analytic::Random random(1);
      const Surface_mesh input =
        make_mesh<Surface_mesh>(analytic::surface_of_revolution(number_of_columns, {{{1., 0.}}, {{1., height}}}, random));
      Surface_mesh mesh = input;
      const auto report = PMP::hermite_diffuse_remesh(mesh);
      assert(report.number_of_faces < 1.6 * report.predicted_number_of_faces && report.size_conformity > 0.9);
      assert(report.smallest_quality > 0.5 && report.mean_quality > 0.65);
      check_result(input, mesh);
    }
}

// Needles across the direction in which the surface bends: it rises over them by more than they are wide, and each of
// them alone could not be split.
void test_needles_across_curvature()
{
  std::cout << "needles across curvature" << std::endl;
  std::vector<std::array<double, 2> > profile;
  for(const double degrees : {-60., -36., -12., 12., 36., 60.})
    profile.push_back({{std::cos(degrees / 180. * CGAL_PI), std::sin(degrees / 180. * CGAL_PI)}});
  analytic::Random random(1);
  const Surface_mesh input = make_mesh<Surface_mesh>(analytic::surface_of_revolution(400, profile, random));
  Surface_mesh mesh = input;
  const auto report = PMP::hermite_diffuse_remesh(mesh);
  assert(report.stop_reason == HDR::CONVERGED && report.size_conformity > 0.9);
  assert(report.smallest_quality > 0.5 && report.largest_deviation < 0.02);       // the facets of the input: 0.022
  check_result(input, mesh);
}

// The sizes of a fillet reach far into the flat sides, of which the facets end at it: elements that step over it would
// leave a chamfer.
void test_fillets_beside_large_facets()
{
  std::cout << "fillets beside large facets" << std::endl;
  analytic::Random random(1);
  const Surface_mesh input = make_mesh<Surface_mesh>(analytic::rounded_box({{5., 4., 2.5}}, 0.3, 8, random));
  Surface_mesh mesh = input;
  const auto report = PMP::hermite_diffuse_remesh(mesh);
  assert(report.stop_reason == HDR::CONVERGED && report.size_conformity > 0.95 && report.mean_quality > 0.85);
  assert(report.largest_deviation < 0.03);                                        // a tenth of the radius
  assert(report.number_of_faces > 0.8 * report.predicted_number_of_faces);
  check_result(input, mesh);
}

// A plate with a hole, whose flat faces touch the hole nearly tangentially: many are lower than the arcs that their sides are
// chords of.
void test_needles_beside_hole()
{
  std::cout << "needles beside a hole" << std::endl;
  constexpr std::size_t n = 24, shift = 4;
  analytic::Triangles plate;
  for(const std::array<double, 2>& ring : std::vector<std::array<double, 2> >({{{1., 0.}}, {{2.62, 0.}}, {{2.62, 0.5}}, {{1., 0.5}}}))
    for(std::size_t i = 0; i < n; ++i)
    {
      const double angle = 2. * CGAL_PI * double(i) / double(n);
      plate.points.push_back({{ring[0] * std::cos(angle), ring[0] * std::sin(angle), ring[1]}});
    }
  for(std::size_t ring = 0; ring < 4; ++ring)
    for(std::size_t i = 0; i < n; ++i)
    {
      // the corners of the flat faces are `shift` columns apart, those of the walls none
      const std::size_t turn = ring % 2 == 1 ? 0 : ring == 0 ? shift : n - shift;
      const std::size_t next_ring = (ring + 1) % 4 * n;
      const std::size_t a = ring * n + i, b = ring * n + (i + 1) % n, c = next_ring + (i + turn) % n,
                        d = next_ring + (i + 1 + turn) % n;
      // the hole's side is with the corner that is farther
      if(ring == 0)
      {
        plate.faces.push_back({{a, d, b}});
        plate.faces.push_back({{a, c, d}});
      }
      else
      {
        plate.faces.push_back({{a, c, b}});
        plate.faces.push_back({{b, c, d}});
      }
    }
  const Surface_mesh input = make_mesh<Surface_mesh>(plate);
  Surface_mesh mesh = input;
  const auto report = PMP::hermite_diffuse_remesh(mesh, params::maximum_deviation(0.002));  // the arcs are 0.009 high
  assert(report.stop_reason == HDR::CONVERGED && report.is_maximum_deviation_met);
  assert(report.smallest_quality > 0.5);
  check_result(input, mesh);
}

// Two shallow caps on a common rim, with sizes beyond their height: of each of them two triangles would be enough for the
// sizes, but those of both would lie on each other.
void test_coarse_lens()
{
  std::cout << "coarse lens" << std::endl;
  std::vector<std::array<double, 2> > profile;
  for(int i = -8; i <= 8; ++i)
  {
    const double r = 1. - std::abs(i) / 8.;
    profile.push_back({{r, (i < 0 ? -0.1 : 0.1) * (1. - r * r)}});
  }
  analytic::Random random(1);
  const Surface_mesh input = make_mesh<Surface_mesh>(analytic::surface_of_revolution(48, profile, random));
  Surface_mesh mesh = input;
  PMP::hermite_diffuse_remesh(mesh, params::approximation_error(1.).maximum_edge_length(2.));
  check_result(input, mesh);
}

// Small sizes beside long edges that must stay: the faces there stay long too, and nothing cascades.
void test_protected_long_edges()
{
  std::cout << "protected long edges" << std::endl;
  for(const double size : {0.3, 0.1, 0.03})
  {
    analytic::Triangles square;
    square.points = {{{0., 0., 0.}}, {{1., 0., 0.}}, {{1., 1., 0.}}, {{0., 1., 0.}}, {{0.4, 0.5, 0.}}};
    square.faces = {{{0, 1, 4}}, {{1, 2, 4}}, {{2, 3, 4}}, {{3, 0, 4}}};
    Surface_mesh mesh = make_mesh<Surface_mesh>(square);
    auto is_constrained = mesh.add_property_map<Surface_mesh::Edge_index, bool>("e:constrained", false).first;
    for(const auto e : edges(mesh))
      is_constrained[e] = mesh.is_border(e);
    const auto remesh = [&]
    {
      return PMP::hermite_diffuse_remesh(mesh, params::approximation_error(0.).maximum_edge_length(size)
        .edge_is_constrained_map(is_constrained).protect_constraints(true));
    };
    const auto report = remesh();
    // two faces more for each element along the long edges, and some for their corners
    const double bound = 1.25 * report.predicted_number_of_faces + 2. * 4. / size + 8.;
    assert(report.number_of_faces <= bound);
    std::size_t number = 0;
    for(const auto e : edges(mesh))
      number += mesh.is_border(e) && is_constrained[e];
    assert(number == 4);
    for(int i = 0; i < 2; ++i)
      assert(remesh().number_of_faces <= bound);
  }
}

// Attributes that are carried by the hooks alone: labels of faces, and the corners that vertices are.
void test_attributes()
{
  std::cout << "attributes" << std::endl;
  struct Visitor : public HDR::Default_remeshing_visitor<Surface_mesh>
  {
    Surface_mesh::Property_map<Surface_mesh::Face_index, int> carried;
    void after_face_split(const face_descriptor f, const face_descriptor part) { carried[part] = carried[f]; }
  };
  const Surface_mesh input = make_tent<Surface_mesh>();
  Surface_mesh mesh = input;
  auto label = mesh.add_property_map<Surface_mesh::Face_index, int>("f:label", 0).first;
  Visitor visitor;
  visitor.carried = mesh.add_property_map<Surface_mesh::Face_index, int>("f:carried", -1).first;
  auto corner = mesh.add_property_map<Surface_mesh::Vertex_index, int>("v:corner", -1).first;
  for(const auto f : faces(mesh))
    visitor.carried[f] = label[f] = mesh.point(mesh.target(mesh.halfedge(f))).x() > 0.3;
  const std::vector<analytic::Point> kept = corners(input);
  for(const auto v : vertices(mesh))
    for(std::size_t i = 0; i < kept.size(); ++i)
      if(coordinates(mesh, v) == kept[i])
        corner[v] = int(i);
  const auto report = PMP::hermite_diffuse_remesh(mesh, parameters_of_tent().face_patch_map(label)
                                                          .visitor(std::ref(visitor)));
  assert(report.number_of_splits > 100 && report.number_of_collapses > 10);
  for(const auto f : faces(mesh))
    assert(label[f] == visitor.carried[f]);
  // the descriptor of a corner stays with the corner
  for(const auto v : vertices(mesh))
    for(std::size_t i = 0; i < kept.size(); ++i)
      assert((coordinates(mesh, v) == kept[i]) == (corner[v] == int(i)));
}

int main()
{
  test_stops_and_exceptions<Surface_mesh>(50);
  test_stops_and_exceptions<Polyhedron>(10);
  test_stops_at_coarse_levels();
  test_most_iterations();
  test_failing_allocations<Surface_mesh>(100);
  test_failing_allocations<Polyhedron>(50);
  test_time_budget();
  test_face_cap();
  test_budget_with_features();
  test_early_stop();
  test_bound_beyond_face_cap();
  test_refinement_attempts();
  test_rim_of_lens();
  test_high_degree();
  test_row_of_needles();
  test_needles_across_curvature();
  test_fillets_beside_large_facets();
  test_needles_beside_hole();
  test_coarse_lens();
  test_protected_long_edges();
  test_attributes();
  std::cout << "done" << std::endl;
  return EXIT_SUCCESS;
}
