// The tables of the manual: what is refused, what is repaired, what is accepted as it is, and why
// triangles of the result are bad.

#include "is_refused.h"
#include "test_helpers.h"

#include <CGAL/Polygon_mesh_processing/orientation.h>

#include <limits>
#include <stdexcept>

// Remeshing a copy must throw std::invalid_argument with a message that contains `name`, and leave
// the copy as it was.
template <typename NamedParameters>
void expect_refusal(const Surface_mesh& input, const NamedParameters& np, const std::string& name)
{
  Surface_mesh mesh = input;
  bool is_refused = false;
  try
  {
    PMP::hermite_diffuse_remesh(mesh, np);
  }
  catch(const std::invalid_argument& error)
  {
    is_refused = std::string(error.what()).find(name) != std::string::npos;
    if(!is_refused)
      std::cerr << "unexpected message: " << error.what() << std::endl;
  }
  assert(is_refused);
  assert(numbers(mesh) == numbers(input));
  for(const auto v : vertices(input))
    for(int i = 0; i < 3; ++i)
    {
      const double before = input.point(v)[i], after = mesh.point(v)[i];
      assert(before == after || (std::isnan(before) && std::isnan(after)));
    }
}

// ---- meshes with one defect -------------------------------------------------------------------------

Surface_mesh tetrahedron(const double scale = 1., const double shift = 0.)
{
  Surface_mesh mesh;
  CGAL::make_tetrahedron(Point_3(shift, shift, shift), Point_3(shift + scale, shift, shift),
                         Point_3(shift, shift + scale, shift), Point_3(shift, shift, shift + scale), mesh);
  return mesh;
}

// the flip of an edge of a tetrahedron joins two vertices that are joined already
Surface_mesh mesh_with_double_edge()
{
  Surface_mesh mesh = tetrahedron();
  CGAL::Euler::flip_edge(mesh.halfedge(*mesh.edges().begin()), mesh);
  return mesh;
}

void join_vertices(const Surface_mesh::Vertex_index kept, const Surface_mesh::Vertex_index gone, Surface_mesh& mesh)
{
  for(const auto h : mesh.halfedges())
    if(mesh.target(h) == gone)
      mesh.set_target(h, kept);
  mesh.remove_vertex(gone);
}

// two closed surfaces with one vertex in common
Surface_mesh mesh_with_pinched_vertex()
{
  Surface_mesh mesh = tetrahedron(), other = tetrahedron(-1.);
  mesh += other;
  join_vertices(Surface_mesh::Vertex_index(0), Surface_mesh::Vertex_index(4), mesh);
  return mesh;
}

// a face that begins and ends an edge at the same vertex
Surface_mesh mesh_with_repeated_corner()
{
  Surface_mesh mesh = tetrahedron();
  join_vertices(Surface_mesh::Vertex_index(0), Surface_mesh::Vertex_index(1), mesh);
  return mesh;
}

// An ear that touches another face in its tip, where a collapse of its short side would be wanted.
Surface_mesh mesh_with_touching_ear()
{
  Surface_mesh mesh;
  std::vector<Surface_mesh::Vertex_index> v;
  for(const Point_3& p : {Point_3(0., 0., 0.), Point_3(1., 0., 0.), Point_3(0.5, 0.9, 0.), Point_3(0.95, 0.1, 0.),
                          Point_3(1.8, 0.6, 0.), Point_3(1.8, -0.6, 0.)})
    v.push_back(mesh.add_vertex(p));
  mesh.add_face(v[0], v[3], v[2]);
  mesh.add_face(v[0], v[1], v[3]);
  mesh.add_face(v[1], v[5], v[4]);
  return mesh;
}

// Two faces with the same corners: a split of an edge would make two edges between its middle and the third corner.
Surface_mesh coincident_faces()
{
  Surface_mesh mesh;
  const auto a = mesh.add_vertex(Point_3(0., 0., 0.)), b = mesh.add_vertex(Point_3(1., 0., 0.)),
             c = mesh.add_vertex(Point_3(0., 1., 0.));
  mesh.add_face(a, b, c);
  mesh.add_face(a, c, b);
  return mesh;
}

Surface_mesh grid(const int n, const double height)
{
  analytic::Triangles t;
  for(int j = 0; j <= n; ++j)
    for(int i = 0; i <= n; ++i)
      t.points.push_back({{double(i) / n, double(j) / n, height * std::cos(3. * i / n)}});
  for(int j = 0; j < n; ++j)
    for(int i = 0; i < n; ++i)
    {
      const std::size_t v = j * (n + 1) + i, w = v + n + 1;
      t.faces.push_back({{v, v + 1, w + 1}});
      t.faces.push_back({{v, w + 1, w}});
    }
  return make_mesh<Surface_mesh>(t);
}

// Splits an inner edge at a point and joins it to the two opposite vertices. The point may be one of the mesh, which
// moves its points when it grows.
Surface_mesh::Vertex_index split_at(Surface_mesh& mesh, const Surface_mesh::Halfedge_index h, const Point_3 p)
{
  const auto o = mesh.opposite(h);
  const auto first = CGAL::Euler::split_edge(h, mesh);
  const auto v = mesh.target(first);
  mesh.point(v) = p;
  CGAL::Euler::split_face(first, mesh.next(h), mesh);
  CGAL::Euler::split_face(o, mesh.next(mesh.opposite(first)), mesh);
  return v;
}

Surface_mesh::Halfedge_index inner_halfedge(const Surface_mesh& mesh)
{
  for(const auto h : mesh.halfedges())
    if(!mesh.is_border(mesh.source(h)) && !mesh.is_border(mesh.target(h)))
      return h;
  return Surface_mesh::null_halfedge();
}

// ---- faces of low quality ----------------------------------------------------------------------------

double quality(const Surface_mesh& mesh, const Surface_mesh::Face_index f)
{
  const auto h = mesh.halfedge(f);
  const Point_3 &p = mesh.point(mesh.source(h)), &q = mesh.point(mesh.target(h)),
                &r = mesh.point(mesh.target(mesh.next(h)));
  const double a = std::sqrt(CGAL::squared_distance(p, q)), b = std::sqrt(CGAL::squared_distance(q, r)),
               c = std::sqrt(CGAL::squared_distance(r, p));
  return 4. * std::sqrt(3. * CGAL::squared_area(p, q, r)) / ((a + b + c) * (std::max)({a, b, c}));
}

// every face of low quality is reported, the worst first; returns the number for a reason
std::size_t count_low_qualities(const Surface_mesh& mesh, const HDR::Remeshing_report<Surface_mesh>& report,
                                const HDR::Quality_obstacle obstacle)
{
  std::size_t number = 0, expected = 0;
  double last = 0.;
  for(const auto& low : report.low_quality_faces)
  {
    assert(std::abs(low.quality - quality(mesh, low.face)) < 1e-9);
    assert(low.quality < low.low_quality && low.quality >= last);
    assert(low.quality <= low.best_quality + 1e-9 && low.size > 0.);
    last = low.quality;
    number += low.obstacle == obstacle;
  }
  for(const auto f : faces(mesh))
    expected += quality(mesh, f) < HDR::Low_quality_face<Surface_mesh::Face_index>::low_quality;
  assert(report.low_quality_faces.size() == expected);
  assert(expected == 0 || report.low_quality_faces.front().quality == report.smallest_quality);
  return number;
}

// ---- tests ------------------------------------------------------------------------------------------

void test_refusals()
{
  expect_refusal(mesh_with_double_edge(), params::default_values(), "edges between vertices");
  expect_refusal(mesh_with_pinched_vertex(), params::default_values(), "fans of faces at vertex 0");
  expect_refusal(mesh_with_repeated_corner(), params::default_values(), "repeated, at vertex 0");
  Surface_mesh flat = tetrahedron();
  for(const auto v : flat.vertices())
    flat.point(v) = Point_3(flat.point(v).x() + 2. * flat.point(v).y(), 0., 0.);
  expect_refusal(flat, params::default_values(), "degenerate");
  flat = grid(3, 0.);
  for(const auto v : flat.vertices())
    flat.point(v) = Point_3(flat.point(v).x() + flat.point(v).y(), 0., 0.);
  expect_refusal(flat, params::default_values(), "degenerate");
  for(const double scale : {1e-60, 1e60, 1e200, 1e-300})
    expect_refusal(tetrahedron(scale), params::default_values(), "diameter");
  expect_refusal(tetrahedron(), params::approximation_error(0.01).maximum_edge_length(1e-16), "maximum_edge_length");
  expect_refusal(tetrahedron(), params::approximation_error(0.01).maximum_number_of_faces(-1), "maximum_number_of_faces");
  expect_refusal(tetrahedron(), params::approximation_error(0.01).maximum_running_time(-1.), "maximum_running_time");

  // named by its rank in the mesh
  Surface_mesh mesh = grid(8, 0.1);
  const auto normals = mesh.add_property_map<Surface_mesh::Vertex_index, Kernel::Vector_3>("v:normal", CGAL::NULL_VECTOR).first;
  const Surface_mesh::Vertex_index in_middle(mesh.number_of_vertices() / 2);
  normals[in_middle] = Kernel::Vector_3(std::numeric_limits<double>::quiet_NaN(), 0., 0.);
  expect_refusal(mesh, params::vertex_normal_map(normals), "vertex " + std::to_string(std::size_t(in_middle)) + " ");

  // a face that is none any more
  const auto removed = *faces(mesh).begin();
  CGAL::Euler::remove_face(mesh.halfedge(removed), mesh);
  assert(is_refused([&] { PMP::hermite_diffuse_remesh(std::vector<Surface_mesh::Face_index>(1, removed), mesh); }));
}

// degenerate faces go before features are looked for: the result has none, and no corner for them
void test_repairs()
{
  for(const double height : {0., 0.1})
  {
    // two vertices at one place: the four faces around the edge between them
    Surface_mesh mesh = grid(8, height);
    const auto h = inner_halfedge(mesh);
    split_at(mesh, h, mesh.point(mesh.target(h)));
    Surface_mesh input = mesh;
    auto report = PMP::hermite_diffuse_remesh(mesh);
    assert(report.number_of_degenerate_input_faces == 2 && report.number_of_unrepaired_faces == 0);
    assert(report.number_of_coincident_vertices == 1);
    assert(report.number_of_corners == 4 && report.number_of_feature_edges == 32);
    assert(report.smallest_quality > 0.3);
    assert(CGAL::is_valid_polygon_mesh(mesh) && euler_characteristic(mesh) == euler_characteristic(input));
    assert(has_all_points(mesh, corners(grid(8, height))));

    // a vertex inside the longest edge of a face: the edge is split for one of its faces only
    for(const bool is_single : {false, true})
    {
      mesh = grid(8, height);
      const auto g = inner_halfedge(mesh);
      Point_3 p = CGAL::midpoint(mesh.point(mesh.source(g)), mesh.point(mesh.target(g)));
      if(is_single)
      {
        for(const auto v : mesh.vertices())
          mesh.point(v) = Point_3(float(mesh.point(v).x()), float(mesh.point(v).y()), float(mesh.point(v).z()));
        p = Point_3(float(p.x()) + 3e-8, float(p.y()) - 3e-8, float(p.z()));
        p = Point_3(float(p.x()), float(p.y()), float(p.z()));
      }
      // the face at the other side becomes a thin one and two others
      const auto c = CGAL::Euler::add_center_vertex(g, mesh);
      mesh.point(mesh.target(c)) = p;
      input = mesh;
      report = PMP::hermite_diffuse_remesh(mesh);
      assert(report.number_of_degenerate_input_faces == 1 && report.number_of_unrepaired_faces == 0);
      assert(report.number_of_corners == 4 && report.number_of_feature_edges == 32);
      assert(report.smallest_quality > 0.3);
      assert(CGAL::is_valid_polygon_mesh(mesh) && euler_characteristic(mesh) == euler_characteristic(input));
    }
  }

  // what is protected stays, and is reported
  Surface_mesh mesh = grid(4, 0.1);
  const auto h = inner_halfedge(mesh);
  const auto v = split_at(mesh, h, mesh.point(mesh.target(h)));
  auto is_corner = mesh.add_property_map<Surface_mesh::Vertex_index, bool>("v:corner", false).first;
  is_corner[v] = is_corner[mesh.target(h)] = true;
  const auto report = PMP::hermite_diffuse_remesh(mesh, params::approximation_error(0.05).vertex_is_constrained_map(is_corner));
  assert(report.number_of_degenerate_input_faces == 2 && report.number_of_unrepaired_faces == 2);
  assert(CGAL::is_valid_polygon_mesh(mesh));
}

// A size per face is that of the face, also where degenerate ones are taken away before it is read.
void test_sizes_of_faces_beside_repairs()
{
  const auto number_of_faces = [](Surface_mesh mesh)
  {
    auto size_of_face = mesh.add_property_map<Surface_mesh::Face_index, double>("f:size", 1.).first;
    for(const auto f : mesh.faces())
    {
      const auto h = mesh.halfedge(f);
      const Point_3 c = CGAL::centroid(mesh.point(mesh.source(h)), mesh.point(mesh.target(h)),
                                       mesh.point(mesh.target(mesh.next(h))));
      if(c.x() < 0.25 && c.y() < 0.25)
        size_of_face[f] = 0.01;
    }
    const auto field = [size_of_face](const Point_3&, const Surface_mesh::Face_index f, const std::array<double, 3>&)
    { return size_of_face[f]; };
    PMP::hermite_diffuse_remesh(mesh, params::size_field(field));
    return double(mesh.number_of_faces());
  };
  Surface_mesh mesh = grid(8, 0.);
  const double number = number_of_faces(mesh);
  const auto h = inner_halfedge(mesh);
  split_at(mesh, h, mesh.point(mesh.target(h)));
  const double number_beside_repair = number_of_faces(mesh);
  std::cout << "  sizes of faces: " << number << " faces, beside a repair " << number_beside_repair << std::endl;
  assert(std::abs(number_beside_repair / number - 1.) < 0.1);
}

Surface_mesh::Vertex_index vertex_in_middle(const Surface_mesh& mesh)
{
  const Point_3 middle(0.5, 0.5, 0.);
  return *std::min_element(vertices(mesh).begin(), vertices(mesh).end(), [&](const auto v, const auto w)
    { return CGAL::compare_distance_to_point(middle, mesh.point(v), mesh.point(w)) == CGAL::SMALLER; });
}

// A grid of which one vertex has been moved over a side of a face: the face lies upside down on the one beside it. Its
// apex is the part `rise` of the side above that.
struct Folded_grid
{
  Surface_mesh mesh = grid(8, 0.);
  Surface_mesh::Vertex_index apex = vertex_in_middle(mesh);
  Surface_mesh::Halfedge_index side = mesh.prev(mesh.halfedge(apex));       // of the face that is folded over
  Point_3 apex_beside = mesh.point(mesh.target(mesh.next(mesh.opposite(side))));

  explicit Folded_grid(const double rise)
  {
    const Point_3 a = mesh.point(mesh.source(side)), b = mesh.point(mesh.target(side)), m = CGAL::midpoint(a, b);
    const Point_3 p = m + 0.2 * (m - mesh.point(apex));
    mesh.point(apex) = Point_3(p.x(), p.y(), p.z() + rise * std::sqrt(CGAL::squared_distance(a, b)));
  }
};

// a face upside down has no crease around it in the result, unless the user wants it or it stands too high
void test_unfolding()
{
  const auto is_flat = [](const Surface_mesh& mesh)
  {
    return std::all_of(mesh.faces().begin(), mesh.faces().end(), [&](const auto f)
                       { return CGAL::scalar_product(PMP::compute_face_normal(f, mesh), Kernel::Vector_3(0., 0., 1.)) > 0.9; });
  };
  for(const double rise : {0., 0.02})
  {
    const Folded_grid input(rise);
    Surface_mesh mesh = input.mesh;
    assert(!is_flat(mesh));
    auto report = PMP::hermite_diffuse_remesh(mesh);
    assert(report.number_of_folded_input_faces == 1 && report.number_of_unrepaired_faces == 0);
    assert((report.largest_unfolding > 0.) == (rise > 0.) && report.largest_unfolding < 0.02);
    assert(report.number_of_corners == 4 && report.number_of_feature_edges == 32);
    assert(report.smallest_quality > 0.3 && is_flat(mesh));
    assert(CGAL::is_valid_polygon_mesh(mesh) && euler_characteristic(mesh) == euler_characteristic(input.mesh));

    // a bound of the distance that the unfolding would take a tenth of, and more
    mesh = input.mesh;
    report = PMP::hermite_diffuse_remesh(mesh, params::maximum_displacement(0.1 * rise));
    assert(report.number_of_unrepaired_faces == (rise > 0. ? 1 : 0));

    // the side is a feature of the user
    mesh = input.mesh;
    auto is_constrained = mesh.add_property_map<Surface_mesh::Edge_index, bool>("e:constrained", false).first;
    is_constrained[mesh.edge(input.side)] = true;
    report = PMP::hermite_diffuse_remesh(mesh, params::approximation_error(0.01).edge_is_constrained_map(is_constrained));
    assert(report.number_of_folded_input_faces == 1 && report.number_of_unrepaired_faces == 1);
    assert(CGAL::is_valid_polygon_mesh(mesh));

    // so is another face that the unfolded ones would go through
    mesh = Folded_grid(0.09).mesh;
    const Point_3 p = mesh.point(input.apex), q = input.apex_beside;
    const auto on_ridge = [&](const double u, const double x, const double z)
    { return CGAL::barycenter(p, 1. - u, q, u) + Kernel::Vector_3(x, x, z); };
    CGAL::Euler::add_face(std::vector<Surface_mesh::Vertex_index>{
      mesh.add_vertex(on_ridge(0.3, 0., rise > 0. ? 1e-3 : -1e-3)), mesh.add_vertex(on_ridge(0.4, 0.01, 1.)),
      mesh.add_vertex(on_ridge(0.5, -0.01, 1.))}, mesh);
    report = PMP::hermite_diffuse_remesh(mesh, params::approximation_error(0.).maximum_edge_length(0.2));
    assert(report.number_of_folded_input_faces == 1 && report.number_of_unrepaired_faces == (rise > 0. ? 0 : 1));
  }
  Surface_mesh mesh = Folded_grid(0.12).mesh;
  assert(PMP::hermite_diffuse_remesh(mesh).number_of_unrepaired_faces == 1);

  // the faces of a spike stand back to back, but they are not folded
  mesh = tetrahedron();
  mesh.point(Surface_mesh::Vertex_index(3)) = Point_3(0.3, 0.3, 100.);
  assert(PMP::hermite_diffuse_remesh(mesh).number_of_folded_input_faces == 0);
}

void test_accepted_as_they_are()
{
  // sizes without an end are as those beyond the mesh, and an isolated vertex far away has nothing to do with them
  for(const double length : {1e100, std::numeric_limits<double>::infinity()})
  {
    Surface_mesh mesh = grid(8, 0.);
    mesh.add_vertex(Point_3(1e14, 0., 0.));
    const auto report = PMP::hermite_diffuse_remesh(mesh, params::approximation_error(0.).maximum_edge_length(length));
    assert(report.number_of_faces == 2 && report.smallest_quality > 0.7);
    mesh = grid(8, 0.3);
    Surface_mesh other = mesh;
    other.add_vertex(Point_3(1e14, 0., 0.));
    PMP::hermite_diffuse_remesh(mesh);
    assert(PMP::hermite_diffuse_remesh(other).number_of_faces == mesh.number_of_faces());
  }

  // isolated vertices stay
  Surface_mesh mesh = tetrahedron();
  const auto isolated = mesh.add_vertex(Point_3(7., 8., 9.));
  auto report = PMP::hermite_diffuse_remesh(mesh);
  assert(report.number_of_isolated_vertices == 1 && !mesh.is_removed(isolated));
  assert(mesh.point(isolated) == Point_3(7., 8., 9.));

  // borders that touch are not stitched: a slit may be meant
  mesh = grid(4, 0.);
  Surface_mesh other = mesh;
  for(const auto v : other.vertices())
    other.point(v) = Point_3(other.point(v).x() + 1., other.point(v).y(), other.point(v).z());
  mesh += other;
  report = PMP::hermite_diffuse_remesh(mesh);
  assert(report.number_of_coincident_vertices == 5);
  assert(number_of_border_loops(mesh) == 2);

  // an ear keeps the other faces at its tip
  mesh = mesh_with_touching_ear();
  Surface_mesh ear = mesh;
  PMP::hermite_diffuse_remesh(mesh, params::approximation_error(0.).maximum_edge_length(3.).apex_angular_defect(180.)
                                      .corner_angle(180.));
  assert(CGAL::is_valid_polygon_mesh(mesh) && euler_characteristic(mesh) == euler_characteristic(ear));
  assert(number_of_border_loops(mesh) == number_of_border_loops(ear));

  // two faces back to back stay two, and what is beside them is remeshed
  mesh = coincident_faces();
  mesh += tetrahedron(1., 5.);
  report = PMP::hermite_diffuse_remesh(mesh, params::approximation_error(0.).maximum_edge_length(0.1));
  assert(CGAL::is_valid_polygon_mesh(mesh) && mesh.number_of_faces() > 102);
  assert(mesh.degree(Surface_mesh::Vertex_index(0)) == 2);

  // components of very different sizes, closed and open
  mesh = tetrahedron(1e-6, 5.);
  mesh += grid(4, 0.1);
  mesh += tetrahedron(10., -20.);
  Surface_mesh input = mesh;
  PMP::hermite_diffuse_remesh(mesh);
  check_result(input, mesh);

  // needles that are thin, but not degenerate
  mesh = tetrahedron();
  mesh.point(Surface_mesh::Vertex_index(1)) = Point_3(1e-9, 0., 0.);
  input = mesh;
  report = PMP::hermite_diffuse_remesh(mesh);
  assert(report.number_of_degenerate_input_faces == 0);
  check_result(input, mesh);

  // two sheets through each other
  mesh = grid(4, 0.1);
  other = grid(4, 0.1);
  for(const auto v : other.vertices())
    other.point(v) = Point_3(other.point(v).x(), other.point(v).z() + 0.5, other.point(v).y() - 0.5);
  mesh += other;
  assert(PMP::does_self_intersect(mesh));
  PMP::hermite_diffuse_remesh(mesh);
  assert(CGAL::is_valid_polygon_mesh(mesh));
}

// units do not matter, and neither does a place where rounding leaves a dozen digits, or six
void test_extreme_coordinates()
{
  for(const double scale : {1e-40, 1e-9, 1., 1e9, 1e40})
    for(const double shift : {0., 1., 1e6, 1e9})
    {
      Surface_mesh mesh = grid(6, 0.1);
      for(const auto v : mesh.vertices())
      {
        const Point_3 p = mesh.point(v);
        mesh.point(v) = Point_3(scale * (p.x() + shift), scale * (p.y() - shift), scale * (p.z() + 2. * shift));
      }
      const Surface_mesh input = mesh;
      const auto report = PMP::hermite_diffuse_remesh(mesh, params::approximation_error(0.02));
      check_result(input, mesh);
      assert(report.smallest_quality > 0.3 && report.stop_reason == HDR::CONVERGED);
      assert(report.number_of_faces > 100 && report.number_of_faces < 400);
    }
}

// what makes it impossible that all faces are well shaped is found, and told with its measures
void test_low_qualities()
{
  std::cout << "low qualities" << std::endl;
  const auto polygon = [](const std::vector<analytic::Point>& points)
  {
    analytic::Triangles t;
    t.points = points;
    for(std::size_t i = 1; i + 1 < points.size(); ++i)
      t.faces.push_back({{0, i, i + 1}});
    return make_mesh<Surface_mesh>(t);
  };
  const auto strip = [&](const double width)
  { return polygon({{{0., 0., 0.}}, {{1., 0., 0.}}, {{1., width, 0.}}, {{0., width, 0.}}}); };

  constexpr double degree = 0.01745329251994329577;
  for(const double angle : {8., 30.})
  {
    Surface_mesh mesh =
      polygon({{{0., 0., 0.}}, {{1., 0., 0.}}, {{std::cos(angle * degree), std::sin(angle * degree), 0.}}});
    const auto report = PMP::hermite_diffuse_remesh(mesh, params::maximum_edge_length(0.1));
    const std::size_t number = count_low_qualities(mesh, report, HDR::QUALITY_AT_FEATURE_ANGLE);
    assert(number == report.low_quality_faces.size() && (number > 0) == (angle == 8.));
    for(const auto& low : report.low_quality_faces)
    {
      assert(std::abs(low.angle - angle) < 1e-6);
      // of the isosceles triangle, by the formula for the inscribed circle of a triangle with two legs of length 1
      const double radius = std::sin(angle * degree / 2.) * std::sqrt((1. - std::sin(angle * degree / 2.))
                                                                     / (1. + std::sin(angle * degree / 2.)));
      assert(std::abs(low.best_quality - 2. * std::sqrt(3.) * radius) < 1e-9);
    }
  }

  const double width = 0.02;
  Surface_mesh mesh = strip(width);
  auto report = PMP::hermite_diffuse_remesh(mesh, params::minimum_edge_length(0.2));
  assert(count_low_qualities(mesh, report, HDR::QUALITY_AT_CLOSE_CORNERS) > 0);
  for(const auto& low : report.low_quality_faces)
    assert(low.obstacle != HDR::QUALITY_AT_CLOSE_CORNERS || std::abs(low.distance - width) < 1e-12);
  // a split of one face alone would leave a smallest quality of 0.13
  assert(report.smallest_quality > 0.24);

  mesh = strip(width);
  auto is_constrained = mesh.add_property_map<Surface_mesh::Edge_index, bool>("e:constrained", false).first;
  for(const auto e : edges(mesh))
    is_constrained[e] = mesh.is_border(e);
  report = PMP::hermite_diffuse_remesh(mesh, params::edge_is_constrained_map(is_constrained).protect_constraints(true));
  const std::size_t number_at_protected = count_low_qualities(mesh, report, HDR::QUALITY_AT_PROTECTED_EDGE);
  assert(number_at_protected > 0 && number_at_protected == report.low_quality_faces.size());

  // a ring that is narrower than the smallest size
  analytic::Triangles ring;
  constexpr std::size_t n = 40;
  for(std::size_t i = 0; i < n; ++i)
  {
    const double a = 360. * degree * double(i) / double(n);
    ring.points.push_back({{std::cos(a), std::sin(a), 0.}});
    ring.points.push_back({{(1. - width) * std::cos(a), (1. - width) * std::sin(a), 0.}});
    const std::size_t v = 2 * i, w = 2 * ((i + 1) % n);
    ring.faces.push_back({{v, w, w + 1}});
    ring.faces.push_back({{v, w + 1, v + 1}});
  }
  mesh = make_mesh<Surface_mesh>(ring);
  report = PMP::hermite_diffuse_remesh(mesh, params::minimum_edge_length(0.2));
  // closed curves have two ends, which are as close
  const std::size_t number = count_low_qualities(mesh, report, HDR::QUALITY_BETWEEN_FEATURES);
  const std::size_t number_at_ends = count_low_qualities(mesh, report, HDR::QUALITY_AT_CLOSE_CORNERS);
  if(number == 0 || number + number_at_ends != report.low_quality_faces.size())
    for(const auto& low : report.low_quality_faces)
      std::cerr << low.quality << " " << name(low.obstacle) << " " << low.distance << std::endl;
  assert(number > 0 && number + number_at_ends == report.low_quality_faces.size());
  assert(report.low_quality_faces.front().distance < 1.2 * width);

  // closed surfaces of so few faces that there is little to do: a flat tetrahedron, on whose model most normals are
  // turned away from the faces, and a lozenge
  const auto remesh_flat = [](const std::vector<analytic::Point>& points,
                              const std::vector<std::array<std::size_t, 3> >& triangles, Surface_mesh& mesh)
  {
    analytic::Triangles t;
    t.points = points;
    t.faces = triangles;
    mesh = make_mesh<Surface_mesh>(t);
    return PMP::hermite_diffuse_remesh(mesh, params::sharp_dihedral_angle(180.).corner_angle(180.)
                                               .apex_angular_defect(180.).minimum_edge_length(3.));
  };
  report = remesh_flat({{{0., 0., 0.}}, {{1., 0., 0.}}, {{0.5, 0.1, 0.}}, {{0.5, 0.05, 0.01}}},
                       {{{0, 2, 1}}, {{0, 1, 3}}, {{1, 2, 3}}, {{2, 0, 3}}}, mesh);
  assert(count_low_qualities(mesh, report, HDR::QUALITY_AT_FOLD) > 0);
  report = remesh_flat({{{1., 0., 0.}}, {{-0.5, 0.2, 0.}}, {{-0.5, -0.2, 0.}}, {{0., 0., 0.05}}, {{0., 0., -0.05}}},
                       {{{0, 1, 3}}, {{1, 2, 3}}, {{2, 0, 3}}, {{1, 0, 4}}, {{2, 1, 4}}, {{0, 2, 4}}}, mesh);
  assert(count_low_qualities(mesh, report, HDR::QUALITY_AT_OTHER_FACES) > 0);

  // the other diagonal of a quadrangle that is not flat makes better triangles, unless another face stands in its way
  for(const bool is_blocked : {false, true})
  {
    analytic::Triangles bent;
    bent.points = {{{0., 0., 0.}}, {{0.5, -0.03, 0.03}}, {{1., 0., 0.}}, {{0.5, 1., 0.}},
                   {{0.45, 0.1, 0.005}}, {{0.55, 0.1, 0.05}}, {{0.45, 0.3, 0.005}}};
    bent.faces = {{{0, 1, 2}}, {{0, 2, 3}}};
    if(is_blocked)
      bent.faces.push_back({{4, 5, 6}});
    mesh = make_mesh<Surface_mesh>(bent);
    const auto is_fixed = mesh.add_property_map<Surface_mesh::Vertex_index, bool>("v:fixed", true).first;
    const std::vector<Surface_mesh::Face_index> quadrangle = {Surface_mesh::Face_index(0), Surface_mesh::Face_index(1)};
    report = PMP::hermite_diffuse_remesh(quadrangle, mesh, params::sharp_dihedral_angle(180.).minimum_edge_length(3.)
                                                             .vertex_is_constrained_map(is_fixed));
    if(is_blocked)
      assert(report.low_quality_faces.size() == 1
             && report.low_quality_faces.front().obstacle == HDR::QUALITY_AT_INTERSECTION);
    else
      assert(report.low_quality_faces.empty());
  }

  struct Stop : public HDR::Default_remeshing_visitor<Surface_mesh>
  {
    bool is_adapting = false;
    void stage_begins(const char* name) { is_adapting = std::string(name) == "adaptation"; }
    bool is_stop_requested() { return is_adapting; }
  };
  mesh = strip(0.1);
  report = PMP::hermite_diffuse_remesh(mesh, params::maximum_edge_length(0.05).visitor(Stop()));
  assert(count_low_qualities(mesh, report, HDR::QUALITY_AFTER_STOP) == 2);
  report = PMP::hermite_diffuse_remesh(mesh, params::maximum_edge_length(0.05));
  assert(report.low_quality_faces.empty());
}

int main()
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  const Surface_mesh cube = read_data<Surface_mesh>("cube.off");

  expect_refusal(Surface_mesh(), params::default_values(), "no face");

  const Surface_mesh quads = read_data<Surface_mesh>("cube_quad.off");
  expect_refusal(quads, params::default_values(), "sides of face 0 is 4");

  for(const double bad : {nan, infinity, -infinity})
  {
    Surface_mesh mesh = cube;
    mesh.point(Surface_mesh::Vertex_index(5)) = Point_3(0., bad, 0.);
    expect_refusal(mesh, params::default_values(), "vertex 5");
  }

  for(const double bad : {-0.01, nan})
  {
    expect_refusal(cube, params::approximation_error(bad), "approximation_error");
    expect_refusal(cube, params::maximum_deviation(bad), "maximum_deviation");
    expect_refusal(cube, params::maximum_displacement(bad), "maximum_displacement");
    expect_refusal(cube, params::minimum_edge_length(bad), "minimum_edge_length");
    expect_refusal(cube, params::maximum_edge_length(bad), "maximum_edge_length");
    expect_refusal(cube, params::gradation(bad), "gradation");
    expect_refusal(cube, params::sharp_dihedral_angle(bad), "sharp_dihedral_angle");
    expect_refusal(cube, params::corner_angle(bad), "corner_angle");
    expect_refusal(cube, params::apex_angular_defect(bad), "apex_angular_defect");
    expect_refusal(cube, params::hermite_weight(bad), "hermite_weight");
  }
  expect_refusal(cube, params::approximation_error(infinity), "approximation_error");
  expect_refusal(cube, params::maximum_deviation(0.), "maximum_deviation");
  expect_refusal(cube, params::minimum_edge_length(infinity), "minimum_edge_length");
  expect_refusal(cube, params::gradation(0.99), "gradation");
  expect_refusal(cube, params::gradation(2.01), "gradation");
  expect_refusal(cube, params::sharp_dihedral_angle(181.), "sharp_dihedral_angle");
  expect_refusal(cube, params::hermite_weight(1.), "hermite_weight");
  expect_refusal(cube, params::polynomial_degree(1), "polynomial_degree");
  expect_refusal(cube, params::polynomial_degree(5), "polynomial_degree");
  expect_refusal(cube, params::minimum_edge_length(0.2).maximum_edge_length(0.1), "minimum_edge_length");
  expect_refusal(cube, params::approximation_error(0.01).number_of_iterations(0), "number_of_iterations");
  expect_refusal(cube, params::size_field([](const Point_3&) { return -1.; }), "size_field");
  expect_refusal(cube, params::size_field([nan](const Point_3&) { return nan; }), "size_field");

  test_refusals();
  test_repairs();
  test_sizes_of_faces_beside_repairs();
  test_unfolding();
  test_accepted_as_they_are();
  test_extreme_coordinates();
  test_low_qualities();
  std::cout << "done" << std::endl;
  return EXIT_SUCCESS;
}
