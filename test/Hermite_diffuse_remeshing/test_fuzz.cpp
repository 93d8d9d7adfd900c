// Small random meshes with random parameters: nothing crashes or hangs, what is refused is not changed, and
// what is accepted comes out valid.
//
//   test_fuzz [NUMBER [FIRST_SEED [SECONDS [FACES]]]]
//
// Without arguments the seeds that have found something come first. SECONDS of processor time are the most that a
// mesh may take; without them nothing is said about the time. FACES is the largest face budget that a mesh is given:
// nearly all of the time goes into the few with hundreds.

#include "test_helpers.h"

#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/repair.h>
#include <CGAL/Polygon_mesh_processing/repair_polygon_soup.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <limits>
#include <stdexcept>
#include <utility>

typedef Surface_mesh::Vertex_index Vertex;
typedef Surface_mesh::Halfedge_index Halfedge;
typedef Surface_mesh::Edge_index Edge;
typedef Surface_mesh::Face_index Face;
typedef std::vector<std::size_t> Polygon;

class Fuzzer
{
  analytic::Random m_random;

  double uniform(const double a, const double b) { return m_random(a, b); }
  int below(const int n) { return (std::min)(n - 1, int(uniform(0., n))); }
  bool chance(const double p) { return uniform(0., 1.) < p; }
  double power_of_ten(const double a, const double b) { return std::pow(10., uniform(a, b)); }

  // on a coarse lattice points coincide and triangles overlap in planes
  Point_3 point(const bool is_on_lattice, const bool is_planar)
  {
    double c[3];
    for(double& x : c)
      x = is_on_lattice ? double(below(5)) / 4. : uniform(0., 1.);
    return Point_3(c[0], c[1], is_planar ? 0. : c[2]);
  }

  Surface_mesh soup()
  {
    std::vector<Point_3> points;
    std::vector<Polygon> triangles;
    const bool is_on_lattice = chance(0.5), is_planar = chance(0.2);
    const int n = 3 + below(30);
    for(int i = 0; i < n; ++i)
      points.push_back(point(is_on_lattice, is_planar));
    for(int i = below(80); i >= 0; --i)
    {
      const Polygon t = {std::size_t(below(n)), std::size_t(below(n)), std::size_t(below(n))};
      if(t[0] != t[1] && t[1] != t[2] && t[2] != t[0])
        triangles.push_back(t);
    }
    if(chance(0.5))
      PMP::repair_polygon_soup(points, triangles);
    PMP::orient_polygon_soup(points, triangles);
    Surface_mesh mesh;
    if(PMP::is_polygon_soup_a_polygon_mesh(triangles))
      PMP::polygon_soup_to_polygon_mesh(points, triangles, mesh);
    return mesh;
  }

  Surface_mesh grid()
  {
    const int nx = 1 + below(8), ny = 1 + below(8);
    const double height = chance(0.3) ? 0. : uniform(0., 1.);
    std::vector<Point_3> points;
    std::vector<Polygon> triangles;
    for(int j = 0; j <= ny; ++j)
      for(int i = 0; i <= nx; ++i)
        points.push_back(Point_3(double(i) / nx, double(j) / ny, height * std::sin(3. * i / nx) * std::cos(2. * j / ny)));
    for(int j = 0; j < ny; ++j)
      for(int i = 0; i < nx; ++i)
      {
        const std::size_t v = j * (nx + 1) + i, w = v + nx + 1;
        triangles.push_back({v, v + 1, w + 1});
        triangles.push_back({v, w + 1, w});
      }
    Surface_mesh mesh;
    PMP::polygon_soup_to_polygon_mesh(points, triangles, mesh);
    return mesh;
  }

  Surface_mesh shape()
  {
    Surface_mesh mesh;
    switch(below(6))
    {
      case 0: return soup();
      case 1: return grid();
      case 2: return make_mesh<Surface_mesh>(analytic::Torus().mesh(60 + below(200), 1 + below(100)));
      case 3: CGAL::make_icosahedron(mesh, Point_3(0., 0., 0.), 1.); break;
      case 4:
        CGAL::make_tetrahedron(Point_3(0., 0., 0.), Point_3(1., 0., 0.), Point_3(0., 1., 0.),
                               Point_3(0., 0., power_of_ten(-12., 1.)), mesh);
        break;
      default: CGAL::make_triangle(Point_3(0., 0., 0.), Point_3(1., 0., 0.),
                                   Point_3(uniform(0., 1.), chance(0.2) ? 0. : power_of_ten(-17., 0.), 0.), mesh);
    }
    return mesh;
  }

  template <typename Index, typename Range>
  Index random_element(const Range& range)
  {
    return *std::next(range.begin(), below(int(std::distance(range.begin(), range.end()))));
  }

  void flip_some(Surface_mesh& mesh)
  {
    for(int i = below(30); i > 0; --i)
    {
      const Halfedge h = mesh.halfedge(random_element<Edge>(mesh.edges()));
      if(mesh.is_border(mesh.edge(h)))
        continue;
      const Vertex c = mesh.target(mesh.next(h)), d = mesh.target(mesh.next(mesh.opposite(h)));
      if(c != d && mesh.halfedge(c, d) == Surface_mesh::null_halfedge())
        CGAL::Euler::flip_edge(h, mesh);
    }
  }

  void collapse_some(Surface_mesh& mesh)
  {
    for(int i = below(10); i > 0; --i)
    {
      const Edge e = random_element<Edge>(mesh.edges());
      if(CGAL::Euler::does_satisfy_link_condition(e, mesh) && mesh.number_of_faces() > 4)
        CGAL::Euler::collapse_edge(e, mesh);
    }
  }

  void damage_points(Surface_mesh& mesh)
  {
    for(int i = 1 + below(6); i > 0; --i)
    {
      const Halfedge h = random_element<Halfedge>(mesh.halfedges());
      const Vertex v = mesh.source(h), w = mesh.target(h), u = mesh.target(mesh.next(h));
      switch(below(4))
      {
        case 0: mesh.point(v) = mesh.point(w); break;                                    // coincident
        case 1: mesh.point(v) = CGAL::midpoint(mesh.point(w), mesh.point(u)); break;     // collinear
        case 2: mesh.point(v) = mesh.point(v) + power_of_ten(-9., 2.) * Kernel::Vector_3(uniform(-1., 1.), uniform(-1., 1.),
                                                                                         uniform(-1., 1.)); break;
        default: mesh.point(v) = mesh.point(random_element<Vertex>(mesh.vertices()));
      }
    }
  }

  void remove_some(Surface_mesh& mesh)
  {
    for(int i = below(5); i > 0 && mesh.number_of_faces() > 1; --i)
      CGAL::Euler::remove_face(mesh.halfedge(random_element<Face>(mesh.faces())), mesh);
  }

  // may leave the range of numbers, and digits behind
  void transform(Surface_mesh& mesh)
  {
    const double scale = chance(0.3) ? power_of_ten(-9., 9.) : chance(0.1) ? power_of_ten(-320., 308.) : 1.;
    const double shift = chance(0.3) ? scale * power_of_ten(0., 17.) : 0.;
    const bool is_single = chance(0.3);
    for(const Vertex v : mesh.vertices())
    {
      double c[3];
      for(int i = 0; i < 3; ++i)
      {
        c[i] = scale * mesh.point(v)[i] + (i + 1) * shift;
        if(is_single && std::abs(c[i]) < 1e38)
          c[i] = double(float(c[i]));
      }
      mesh.point(v) = Point_3(c[0], c[1], c[2]);
    }
    if(chance(0.02))
      mesh.point(random_element<Vertex>(mesh.vertices())) = Point_3(0., std::numeric_limits<double>::quiet_NaN(), 0.);
  }

public:
  std::size_t number_of_selected_faces = 0;           // by `remesh()`

  explicit Fuzzer(const unsigned seed) : m_random(seed) {}

  Surface_mesh mesh()
  {
    Surface_mesh mesh = shape();
    while(chance(0.15))
      mesh += shape();
    if(mesh.number_of_faces() == 0)
      return mesh;
    if(chance(0.3))
      flip_some(mesh);
    if(chance(0.3))
      collapse_some(mesh);
    if(chance(0.2))
      remove_some(mesh);
    if(chance(0.4))
      damage_points(mesh);
    transform(mesh);
    if(chance(0.1))
      mesh.add_vertex(Point_3(0., 0., 0.));
    mesh.collect_garbage();
    return mesh;
  }

  // what goes wrong does so on few faces, and many meshes are to be tried
  std::size_t face_budget() { return std::size_t(power_of_ten(0.7, 2.7)); }

  HDR::Remeshing_report<Surface_mesh> remesh(Surface_mesh& mesh, const std::size_t budget)
  {
    auto is_constrained = mesh.add_property_map<Edge, bool>("e:constrained", false).first;
    auto is_corner = mesh.add_property_map<Vertex, bool>("v:corner", false).first;
    auto label = mesh.add_property_map<Face, int>("f:label", 0).first;
    if(chance(0.3))
      for(const Edge e : mesh.edges())
        is_constrained[e] = chance(0.2);
    if(chance(0.2))
      for(const Vertex v : mesh.vertices())
        is_corner[v] = chance(0.2);
    if(chance(0.2))
      for(const Face f : mesh.faces())
        label[f] = below(3);
    std::vector<Face> selected;
    const double part = chance(0.2) ? uniform(0., 1.) : 1.;
    for(const Face f : mesh.faces())
      if(uniform(0., 1.) < part)
        selected.push_back(f);
    number_of_selected_faces = selected.size();
    // a length that may have to do with the mesh
    const double length = mesh.number_of_vertices() == 0 ? 1.
      : std::sqrt(CGAL::squared_distance(mesh.point(Vertex(0)), mesh.point(Vertex(mesh.number_of_vertices() - 1))));
    const double size = length * power_of_ten(-12., 1.);
    const auto field = [size, length](const Point_3& p) { return size + 0.1 * std::abs(p.x()) + 0.02 * length; };
    const auto np = params::approximation_error(chance(0.1) ? 0. : power_of_ten(-12., 0.))
      .gradation(uniform(1., 2.)).sharp_dihedral_angle(uniform(0., 180.)).corner_angle(uniform(0., 180.))
      .apex_angular_defect(uniform(0., 180.)).polynomial_degree(2 + below(3)).hermite_weight(uniform(0.001, 0.999))
      .normal_estimation(HDR::Normal_estimation(below(4)))
      .maximum_deviation(chance(0.3) ? length * power_of_ten(-9., 0.) : std::numeric_limits<double>::infinity())
      .minimum_edge_length(chance(0.2) ? size : 0.)
      .maximum_edge_length(chance(0.2) ? length * power_of_ten(-3., 1.) : 0.)
      .edge_is_constrained_map(is_constrained).vertex_is_constrained_map(is_corner).face_patch_map(label)
      .protect_constraints(chance(0.5)).number_of_iterations(1 + below(10)).maximum_number_of_faces(budget);
    const bool has_field = chance(0.2);
    const auto bounded = np.maximum_displacement(chance(0.8) ? std::numeric_limits<double>::infinity()
                                                             : chance(0.3) ? 0. : length * power_of_ten(-9., 0.));
    return has_field ? PMP::hermite_diffuse_remesh(selected, mesh, bounded.size_field(field))
                     : PMP::hermite_diffuse_remesh(selected, mesh, bounded);
  }
};

// also where they are no numbers
bool are_same_points(const Surface_mesh& a, const Surface_mesh& b)
{
  for(const Vertex v : a.vertices())
    for(int i = 0; i < 3; ++i)
    {
      const double x = a.point(v)[i], y = b.point(v)[i];
      if(std::memcmp(&x, &y, sizeof(double)) != 0)
        return false;
    }
  return numbers(a) == numbers(b);
}

void check(const bool is_true, const char* what)
{
  if(!is_true)
    throw std::runtime_error(what);
}

bool has_double_edge(const Surface_mesh& mesh)
{
  std::vector<std::pair<Vertex, Vertex> > edges;
  for(const Edge e : mesh.edges())
    edges.push_back(std::minmax(mesh.vertex(e, 0), mesh.vertex(e, 1)));
  std::sort(edges.begin(), edges.end());
  return std::adjacent_find(edges.begin(), edges.end()) != edges.end();
}

// returns whether the mesh was accepted
bool run(const unsigned seed, const std::size_t largest_budget)
{
  Fuzzer fuzzer(seed);
  const Surface_mesh input = fuzzer.mesh();
  const std::size_t budget = (std::min)(largest_budget, fuzzer.face_budget());
  Surface_mesh output = input;
  try
  {
    const auto report = fuzzer.remesh(output, budget);
    check(report.number_of_faces == output.number_of_faces(), "the report counts other faces");
    // the budget is for the part that is remeshed, which may be above it at first
    const std::size_t number_of_others = input.number_of_faces() - fuzzer.number_of_selected_faces;
    check(output.number_of_faces() <= number_of_others + (std::max)(budget, fuzzer.number_of_selected_faces),
          "the budget is exceeded");
  }
  catch(const std::invalid_argument& refusal)
  {
    check(std::strlen(refusal.what()) > 10, "a refusal without a reason");
    check(are_same_points(input, output), "a refusal has changed the mesh");
    return false;
  }
  check(output.number_of_vertices() - PMP::remove_isolated_vertices(output) > 0
        && CGAL::is_valid_polygon_mesh(output), "the result is invalid");
  check(CGAL::is_triangle_mesh(output), "the result has faces with other than three sides");
  Surface_mesh connected = input;
  PMP::remove_isolated_vertices(connected);
  check(euler_characteristic(output) == euler_characteristic(connected), "the topology has changed");
  check(number_of_border_loops(output) == number_of_border_loops(input), "the border has changed");
  check(!has_double_edge(output), "two edges between the same vertices");
  for(const Vertex v : output.vertices())
    check(std::isfinite(output.point(v).x()) && std::isfinite(output.point(v).y()) && std::isfinite(output.point(v).z()),
          "a point is not finite");
  return true;
}

int main(int argc, char** argv)
{
  const unsigned number = argc > 1 ? unsigned(std::atoi(argv[1])) : 40;
  const unsigned first = argc > 2 ? unsigned(std::atoi(argv[2])) : 1;
  const double limit = argc > 3 ? std::atof(argv[3]) : std::numeric_limits<double>::infinity();
  const std::size_t largest_budget = argc > 4 ? std::size_t(std::atoi(argv[4])) : 1000;
  std::vector<unsigned> seeds;
  if(argc == 1)
    seeds = {453, 501,            // collapses of ears that touch other faces in their tips
             10770,               // a vertex as near to its neighbour on a curve as rounding lets it
             27515,               // a collapse between two triangles with the same corners
             40196};              // two triangles with the same corners
  for(unsigned i = 0; i < number; ++i)
    seeds.push_back(first + i);
  unsigned accepted = 0, failed = 0, slowest = first;
  double longest = 0.;
  for(const unsigned seed : seeds)
  {
    // of the processor, so that other programs do not count
    const std::clock_t begin = std::clock();
    double seconds = 0.;
    try
    {
      accepted += run(seed, largest_budget);
      seconds = double(std::clock() - begin) / CLOCKS_PER_SEC;
      check(seconds <= limit, "takes too long");
    }
    catch(const std::exception& error)
    {
      ++failed;
      std::cerr << "seed " << seed << ": " << error.what() << ", " << seconds << " s" << std::endl;
    }
    if(seconds > longest)
    {
      longest = seconds;
      slowest = seed;
    }
  }
  std::cout << accepted << " of " << seeds.size() << " accepted, " << failed << " failed, the slowest was seed " << slowest
            << " with " << longest << " s" << std::endl;
  assert(failed == 0);
  return EXIT_SUCCESS;
}
