#include "feature_measures.h"
#include "is_refused.h"
#include "test_helpers.h"

#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polyhedron_3.h>

#include <map>

typedef Surface_mesh::Edge_index Edge_index;
typedef Surface_mesh::Vertex_index Vertex_index;

template <typename Map, typename Range, typename Class>
std::size_t number(const Range& range, const Map& map, const Class c)
{
  return std::count_if(range.begin(), range.end(), [&](const auto x) { return map[x] == c; });
}

// a cone over a polygon of n sides that is open at its base, or has a base
Surface_mesh cone(const int n, const bool has_base)
{
  Surface_mesh mesh;
  const int rows = 4;
  const Vertex_index tip = mesh.add_vertex(Point_3(0, 0, 1));
  std::vector<std::vector<Vertex_index> > ring(rows + 1);
  for(int j = 1; j <= rows; ++j)
    for(int i = 0; i < n; ++i)
    {
      const double s = 2. * analytic::pi * i / n, r = double(j) / rows;
      ring[j].push_back(mesh.add_vertex(Point_3(r * std::cos(s), r * std::sin(s), 1. - r)));
    }
  const Vertex_index center = has_base ? mesh.add_vertex(Point_3(0, 0, 0)) : Vertex_index();
  for(int i = 0; i < n; ++i)
  {
    const int k = (i + 1) % n;
    mesh.add_face(tip, ring[1][i], ring[1][k]);
    for(int j = 1; j < rows; ++j)
    {
      mesh.add_face(ring[j][i], ring[j+1][i], ring[j+1][k]);
      mesh.add_face(ring[j][i], ring[j+1][k], ring[j][k]);
    }
    if(has_base)
      mesh.add_face(center, ring[rows][k], ring[rows][i]);
  }
  return mesh;
}

// a square of n by n cells over [0,1]^2
Surface_mesh square(const int n)
{
  Surface_mesh mesh;
  std::vector<Vertex_index> v;
  for(int j = 0; j <= n; ++j)
    for(int i = 0; i <= n; ++i)
      v.push_back(mesh.add_vertex(Point_3(double(i) / n, double(j) / n, 0)));
  for(int j = 0; j < n; ++j)
    for(int i = 0; i < n; ++i)
    {
      const int a = (n + 1) * j + i;
      mesh.add_face(v[a], v[a+1], v[a+n+2]);
      mesh.add_face(v[a], v[a+n+2], v[a+n+1]);
    }
  return mesh;
}

// a cone tip, a kinked border and a corner of three edges are found without help
void test_detection()
{
  std::cout << "detection" << std::endl;
  Surface_mesh open_cone = cone(24, false);
  features::Maps<Surface_mesh> maps(open_cone);
  PMP::hermite_diffuse_classify_features(open_cone, maps.edge_classes, maps.vertex_classes);
  assert(maps.vertex_classes[Vertex_index(0)] == HDR::APEX_VERTEX);
  assert(number(vertices(open_cone), maps.vertex_classes, HDR::APEX_VERTEX) == 1);
  assert(number(vertices(open_cone), maps.vertex_classes, HDR::CURVE_VERTEX) == 24);
  assert(number(edges(open_cone), maps.edge_classes, HDR::BOUNDARY_EDGE) == 24);
  assert(number(edges(open_cone), maps.edge_classes, HDR::SHARP_EDGE) == 0);

  Surface_mesh plate = square(4);
  maps = features::Maps<Surface_mesh>(plate);
  PMP::hermite_diffuse_classify_features(plate, maps.edge_classes, maps.vertex_classes);
  assert(number(vertices(plate), maps.vertex_classes, HDR::KINK_VERTEX) == 4);
  assert(number(vertices(plate), maps.vertex_classes, HDR::CURVE_VERTEX) == 12);

  Surface_mesh cube = read_data<Surface_mesh>("cube.off");
  maps = features::Maps<Surface_mesh>(cube);
  PMP::hermite_diffuse_classify_features(cube, maps.edge_classes, maps.vertex_classes);
  assert(number(vertices(cube), maps.vertex_classes, HDR::JUNCTION_VERTEX) == 8);
  assert(number(edges(cube), maps.edge_classes, HDR::SHARP_EDGE) == 12);
  for(const double scale : {1e-60, 1e60})
  {
    Surface_mesh scaled = cube;
    for(const auto v : vertices(scaled))
      scaled.point(v) = CGAL::ORIGIN + scale * (cube.point(v) - CGAL::ORIGIN);
    assert(is_refused([&] { PMP::hermite_diffuse_classify_features(scaled, maps.edge_classes, maps.vertex_classes); }));
  }

  // the function takes any kind of mesh and map
  CGAL::Polyhedron_3<Kernel> polyhedron = read_data<CGAL::Polyhedron_3<Kernel> >("cube.off");
  auto edge_classes = get(CGAL::dynamic_edge_property_t<HDR::Edge_class>(), polyhedron);
  auto vertex_classes = get(CGAL::dynamic_vertex_property_t<HDR::Vertex_class>(), polyhedron);
  PMP::hermite_diffuse_classify_features(polyhedron, edge_classes, vertex_classes, params::sharp_dihedral_angle(80.));
  for(const auto v : vertices(polyhedron))
    assert(get(vertex_classes, v) == HDR::JUNCTION_VERTEX);
}

// with the detection off and maps of the user, his features and no others
void test_user_features()
{
  std::cout << "features of the user" << std::endl;
  Surface_mesh cube = read_data<Surface_mesh>("cube.off");
  PMP::hermite_diffuse_remesh(cube, params::maximum_edge_length(0.3));
  cube.collect_garbage();
  auto is_constrained = cube.add_property_map<Edge_index, bool>("e:constrained", false).first;
  auto is_corner = cube.add_property_map<Vertex_index, bool>("v:corner", false).first;
  auto policies = cube.add_property_map<Edge_index, HDR::Edge_policy>("e:policy", HDR::DETECTED_EDGE).first;
  // the edges of the top, one vertex of its rim, and one vertex elsewhere
  const CGAL::Bbox_3 box = PMP::bbox(cube);
  const auto is_at_top = [&](const Vertex_index v) { return cube.point(v).z() == box.zmax(); };
  const auto is_on_rim = [&](const Vertex_index v)
  {
    const Point_3& p = cube.point(v);
    return is_at_top(v) && (p.x() == box.xmin() || p.x() == box.xmax() || p.y() == box.ymin() || p.y() == box.ymax());
  };
  std::size_t number_of_edges = 0;
  for(const auto e : edges(cube))
  {
    const Vertex_index s = cube.vertex(e, 0), t = cube.vertex(e, 1);
    const bool is_along_side = cube.point(s).x() == cube.point(t).x() || cube.point(s).y() == cube.point(t).y();
    is_constrained[e] = is_on_rim(s) && is_on_rim(t) && is_along_side;
    number_of_edges += is_constrained[e];
  }
  std::set<Vertex_index> chosen;
  for(const auto v : vertices(cube))
    if(chosen.size() < 2 && is_on_rim(v) == chosen.empty())
      chosen.insert(v);
  for(const Vertex_index v : chosen)
    is_corner[v] = true;

  features::Maps<Surface_mesh> maps(cube);
  const auto off = params::sharp_dihedral_angle(180.).corner_angle(180.).apex_angular_defect(180.);
  PMP::hermite_diffuse_classify_features(cube, maps.edge_classes, maps.vertex_classes);
  assert(number(edges(cube), maps.edge_classes, HDR::SHARP_EDGE) > number_of_edges);
  PMP::hermite_diffuse_classify_features(cube, maps.edge_classes, maps.vertex_classes,
                                         off.edge_is_constrained_map(is_constrained).vertex_is_constrained_map(is_corner));
  for(const auto e : edges(cube))
    assert(maps.edge_classes[e] == (is_constrained[e] ? HDR::CONSTRAINED_EDGE : HDR::INTERIOR_EDGE));
  for(const auto v : vertices(cube))
    assert(HDR::is_corner(maps.vertex_classes[v]) == (chosen.count(v) == 1));

  // a policy goes before the detection and before the other map
  for(const auto e : edges(cube))
    policies[e] = is_constrained[e] ? HDR::FREE_EDGE : HDR::DETECTED_EDGE;
  const Edge_index interior = *std::find_if(edges(cube).begin(), edges(cube).end(), [&](const Edge_index e)
    { return !is_at_top(cube.vertex(e, 0)) && !is_at_top(cube.vertex(e, 1)); });
  policies[interior] = HDR::RESAMPLED_EDGE;
  PMP::hermite_diffuse_classify_features(cube, maps.edge_classes, maps.vertex_classes,
    params::edge_policy_map(policies).edge_is_constrained_map(is_constrained));
  for(const auto e : edges(cube))
    if(is_constrained[e])
      assert(maps.edge_classes[e] == HDR::INTERIOR_EDGE);
  assert(maps.edge_classes[interior] == HDR::CONSTRAINED_EDGE);
  assert(number(edges(cube), maps.edge_classes, HDR::SHARP_EDGE) > 0);
}

typedef std::set<Point_3> Ends;

std::multiset<Ends> ends_of_edges(const Surface_mesh& mesh, const std::function<bool(Edge_index)>& is_selected)
{
  std::multiset<Ends> result;
  for(const auto e : edges(mesh))
    if(is_selected(e))
      result.insert({mesh.point(mesh.vertex(e, 0)), mesh.point(mesh.vertex(e, 1))});
  return result;
}

// Protected edges stay bit for bit, free ones vanish, and the sizes start from the protected ones: short edges in
// a coarse surrounding, and long ones in a fine one.
void test_policies()
{
  std::cout << "policies" << std::endl;
  for(const double length : {0.25, 0.02})
  {
    Surface_mesh mesh = square(20);
    auto policies = mesh.add_property_map<Edge_index, HDR::Edge_policy>("e:policy", HDR::DETECTED_EDGE).first;
    auto sizes = mesh.add_property_map<Vertex_index, double>("v:size", 0.).first;
    auto classes = mesh.add_property_map<Edge_index, HDR::Edge_class>("e:class").first;
    const auto is_on_line = [&](const Edge_index e)       // a part of the middle line
    {
      for(const int i : {0, 1})
      {
        const Point_3& p = mesh.point(mesh.vertex(e, i));
        if(std::abs(p.y() - 0.5) > 1e-9 || std::abs(p.x() - 0.5) > 0.2501)
          return false;
      }
      return true;
    };
    for(const auto e : edges(mesh))
      if(is_on_line(e))
        policies[e] = HDR::PROTECTED_EDGE;
    const std::multiset<Ends> expected = ends_of_edges(mesh, is_on_line);
    assert(expected.size() == 10);
    const auto report = PMP::hermite_diffuse_remesh(mesh, params::maximum_edge_length(length)
      .minimum_edge_length(length / 100.).edge_policy_map(policies).vertex_size_map(sizes).edge_class_map(classes));
    assert(ends_of_edges(mesh, [&](const Edge_index e) { return classes[e] == HDR::CONSTRAINED_EDGE; }) == expected);
    assert(report.smallest_quality > 0.4);
    for(const auto v : vertices(mesh))
    {
      const Point_3& p = mesh.point(v);
      const double distance = std::hypot((std::max)(0., std::abs(p.x() - 0.5) - 0.25), p.y() - 0.5);
      const double slope = HDR::internal::slope_of_gradation(length > 0.05 ? 1.3 : 2.);
      const double graded = length > 0.05 ? (std::min)(length, 0.05 + slope * distance)
                                          : (std::max)(length, 0.05 - slope * distance);
      // the map is linear in the cells, which the size of the input limits here
      assert(std::abs(sizes[v] - graded) < 0.4 * graded);
    }
  }
}

// Marks on a part of a line stay on that part, whatever the rest of the line is, and vanish where the policy makes it free.
void test_marks_on_a_part()
{
  std::cout << "marks on a part" << std::endl;
  struct Line { double y; HDR::Edge_policy policy; bool has_marks_after; };
  for(const Line line : {Line{0., HDR::DETECTED_EDGE, true}, Line{0.5, HDR::DETECTED_EDGE, true},
                         Line{0.5, HDR::RESAMPLED_EDGE, true}, Line{0.5, HDR::FREE_EDGE, false}})
    for(const double length : {0.3, 0.15, 0.03})
    {
      Surface_mesh mesh = square(20);
      auto policies = mesh.add_property_map<Edge_index, HDR::Edge_policy>("e:policy", HDR::DETECTED_EDGE).first;
      auto marks = mesh.add_property_map<Edge_index, bool>("e:mark", false).first;
      const auto is_on_line = [&](const Edge_index e)
      { return mesh.point(mesh.vertex(e, 0)).y() == line.y && mesh.point(mesh.vertex(e, 1)).y() == line.y; };
      const auto is_on_part = [](const Point_3& p) { return p.x() > 0.3999 && p.x() < 0.5001; };
      for(const auto e : edges(mesh))
        if(is_on_line(e))
        {
          policies[e] = line.policy;
          marks[e] = is_on_part(mesh.point(mesh.vertex(e, 0))) && is_on_part(mesh.point(mesh.vertex(e, 1)));
        }
      PMP::hermite_diffuse_remesh(mesh, params::approximation_error(0.).maximum_edge_length(length)
        .edge_policy_map(policies).edge_is_constrained_map(marks));
      double length_of_marks = 0.;
      for(const auto e : edges(mesh))
        if(marks[e])
        {
          assert(std::abs(mesh.point(mesh.vertex(e, 0)).y() - line.y) < 1e-9);
          assert(is_on_part(mesh.point(mesh.vertex(e, 0))) && is_on_part(mesh.point(mesh.vertex(e, 1))));
          length_of_marks += PMP::edge_length(e, mesh);
        }
      assert(std::abs(length_of_marks - (line.has_marks_after ? 0.1 : 0.)) < 1e-9);
    }
}

// without a sharp edge a free edge is as good as any: the crease of a roof disappears
void test_free_edges()
{
  std::cout << "free edges" << std::endl;
  Surface_mesh roof = square(8);
  for(const auto v : vertices(roof))
  {
    const Point_3 p = roof.point(v);
    roof.point(v) = Point_3(p.x(), p.y(), -std::abs(p.y() - 0.5));
  }
  for(const bool is_free : {false, true})
  {
    Surface_mesh mesh = roof;
    auto policies = mesh.add_property_map<Edge_index, HDR::Edge_policy>("e:policy", HDR::DETECTED_EDGE).first;
    auto classes = mesh.add_property_map<Edge_index, HDR::Edge_class>("e:class").first;
    for(const auto e : edges(mesh))
      policies[e] = is_free ? HDR::FREE_EDGE : HDR::DETECTED_EDGE;
    PMP::hermite_diffuse_remesh(mesh, params::maximum_edge_length(0.2).edge_policy_map(policies).edge_class_map(classes));
    assert((number(edges(mesh), classes, HDR::SHARP_EDGE) == 0) == is_free);
    // the border is kept in any case
    assert(number_of_border_loops(mesh) == 1 && number(edges(mesh), classes, HDR::BOUNDARY_EDGE) > 0);
  }
}

// corners bit for bit, and curves as close to those of the input as the error law says
void test_fidelity(const std::string& name, const Surface_mesh& input, const std::size_t number_of_corners,
                   const double error)
{
  Surface_mesh output;
  const features::Fidelity f = features::measure(input, output, error, params::sharp_dihedral_angle(40.));
  std::cout << name << ", error " << error << ": distance " << f.largest_distance / f.diagonal << ", excess "
            << f.largest_excess / f.diagonal << std::endl;
  check_result(input, output);
  assert(f.number_of_corners == number_of_corners && f.number_of_missing_corners == 0);
  assert(f.largest_excess <= 2e-4 * f.diagonal);
  assert(f.largest_distance <= 0.2 * error * f.diagonal);
}

// distances from the straight lines that the edges of a cube and of a plate lie on
void test_straight_edges()
{
  std::cout << "straight edges" << std::endl;
  const Surface_mesh input = read_data<Surface_mesh>("cube.off");
  for(const double length : {0.1, 1.5})
  {
    Surface_mesh mesh = input;
    auto classes = mesh.add_property_map<Edge_index, HDR::Edge_class>("e:class").first;
    PMP::hermite_diffuse_remesh(mesh, params::maximum_edge_length(length).edge_class_map(classes));
    for(const auto e : edges(mesh))
      if(HDR::is_feature(classes[e]))
        for(const int i : {0, 1})
        {
          const Point_3& p = mesh.point(mesh.vertex(e, i));
          const int number = int(std::abs(std::abs(p.x()) - 1.) < 1e-12) + int(std::abs(std::abs(p.y()) - 1.) < 1e-12)
                           + int(std::abs(std::abs(p.z()) - 1.) < 1e-12);
          assert(number >= 2);
        }
  }
}

// the rims of a cylinder of 48 sides are circles again when they have 96 and 24
void test_circles()
{
  std::cout << "circles" << std::endl;
  const Surface_mesh input = features::capped_cylinder<Surface_mesh>(48);
  for(const int number : {96, 24})
  {
    Surface_mesh mesh = input;
    auto classes = mesh.add_property_map<Edge_index, HDR::Edge_class>("e:class").first;
    const double length = 2. * analytic::pi / number;
    PMP::hermite_diffuse_remesh(mesh, params::approximation_error(0.).maximum_edge_length(length)
                                        .minimum_edge_length(length / 2.).edge_class_map(classes));
    std::size_t edges_on_rims = 0;
    double worst = 0.;
    for(const auto e : edges(mesh))
      if(HDR::is_feature(classes[e]))
      {
        ++edges_on_rims;
        for(const int i : {0, 1})
        {
          const Point_3& p = mesh.point(mesh.vertex(e, i));
          worst = (std::max)(worst, std::abs(std::hypot(p.x(), p.y()) - 1.));
          assert(std::abs(std::abs(p.z()) - 1.) < 1e-12);
        }
      }
    std::cout << "  " << edges_on_rims / 2. << " sides, " << worst << " from the circle" << std::endl;
    assert(worst < 1e-4);
    assert(edges_on_rims > 1.6 * number && edges_on_rims < 2.8 * number);
  }
}

// As long as the edges between their sides are smooth, cylinders of few sides are round, and their rims are.
void test_rims_of_few_sides()
{
  std::cout << "rims of few sides" << std::endl;
  for(const int number : {9, 10})
  {
    Surface_mesh mesh = features::capped_cylinder<Surface_mesh>(number);
    const auto report = PMP::hermite_diffuse_remesh(mesh, params::approximation_error(0.01).maximum_deviation(0.01));
    double worst = 0.;
    for(const auto v : vertices(mesh))
      if(std::abs(mesh.point(v).z()) < 1. - 1e-12)
        worst = (std::max)(worst, std::abs(std::hypot(mesh.point(v).x(), mesh.point(v).y()) - 1.));
    std::cout << "  " << number << " sides: " << report.number_of_faces << " faces, " << worst << " from the cylinder"
              << std::endl;
    // a fifth of what the sides are; the bound of the deviation is met by sizes, not by bisections of torn strips
    assert(worst < 0.2 * (1. - std::cos(analytic::pi / number)));
    assert(report.is_maximum_deviation_met && report.number_of_faces < 1.6 * report.predicted_number_of_faces);
  }
}

// What arcs enclose beyond few edges is meshed like the rest.
void test_discs_of_few_sides()
{
  std::cout << "discs of few sides" << std::endl;
  for(const int number : {9, 12})
  {
    Surface_mesh mesh = features::capped_cylinder<Surface_mesh>(number);
    constexpr double size = 0.06;
    const auto report = PMP::hermite_diffuse_remesh(mesh, params::approximation_error(0.5).gradation(2.)
                                                            .maximum_edge_length(size));
    std::cout << "  " << number << " sides: " << report.number_of_faces << " faces of "
              << report.predicted_number_of_faces << ", mean quality " << report.mean_quality << std::endl;
    assert(double(report.number_of_faces) > 0.95 * report.predicted_number_of_faces);
    assert(report.mean_quality > 0.9 && report.size_conformity > 0.995);
  }
}

struct Border
{
  double length = 0.;
  std::size_t number_of_loops = 0;

  explicit Border(const Surface_mesh& mesh) : number_of_loops(number_of_border_loops(mesh))
  {
    for(const auto h : halfedges(mesh))
      if(is_border(h, mesh))
        length += PMP::edge_length(h, mesh);
  }
};

void test_border(const std::string& name, const Surface_mesh& input, const double error)
{
  Surface_mesh mesh = input;
  PMP::hermite_diffuse_remesh(mesh, params::approximation_error(error));
  const Border before(input), after(mesh);
  std::cout << name << ": " << before.number_of_loops << " loops, border " << before.length << " -> " << after.length
            << " (" << 100. * (after.length / before.length - 1.) << " %)" << std::endl;
  assert(CGAL::is_valid_polygon_mesh(mesh) && euler_characteristic(mesh) == euler_characteristic(input));
  assert(has_all_points(mesh, corners(input)));
  assert(before.number_of_loops > 0 && after.number_of_loops == before.number_of_loops);
  assert(std::abs(after.length / before.length - 1.) < 0.005);
}

// a square plate with a round hole
Surface_mesh plate_with_hole()
{
  Surface_mesh mesh;
  const int n = 48, rows = 6;
  std::vector<std::vector<Vertex_index> > ring(rows + 1);
  for(int j = 0; j <= rows; ++j)
    for(int i = 0; i < n; ++i)
    {
      const double s = 2. * analytic::pi * i / n, c = std::cos(s), d = std::sin(s);
      const double square = 1. / (std::max)(std::abs(c), std::abs(d)), r = 0.4 + (square - 0.4) * j / rows;
      // the outer vertices exactly on the lines
      const auto snap = [&](const double x) { return j == rows && std::abs(std::abs(x) - 1.) < 1e-9 ? std::copysign(1., x) : x; };
      ring[j].push_back(mesh.add_vertex(Point_3(snap(r * c), snap(r * d), 0.)));
    }
  for(int j = 0; j < rows; ++j)
    for(int i = 0; i < n; ++i)
    {
      const int k = (i + 1) % n;
      mesh.add_face(ring[j][i], ring[j+1][i], ring[j+1][k]);
      mesh.add_face(ring[j][i], ring[j+1][k], ring[j][k]);
    }
  return mesh;
}

Surface_mesh half_sphere()
{
  Surface_mesh mesh;
  const int n = 48, rows = 12;
  const Vertex_index pole = mesh.add_vertex(Point_3(0, 0, 1));
  std::vector<std::vector<Vertex_index> > ring(rows + 1);
  for(int j = 1; j <= rows; ++j)
    for(int i = 0; i < n; ++i)
    {
      const double s = 2. * analytic::pi * i / n, t = analytic::pi / 2. * j / rows;
      ring[j].push_back(mesh.add_vertex(Point_3(std::sin(t) * std::cos(s), std::sin(t) * std::sin(s), std::cos(t))));
    }
  for(int i = 0; i < n; ++i)
  {
    const int k = (i + 1) % n;
    mesh.add_face(pole, ring[1][i], ring[1][k]);
    for(int j = 1; j < rows; ++j)
    {
      mesh.add_face(ring[j][i], ring[j+1][i], ring[j+1][k]);
      mesh.add_face(ring[j][i], ring[j+1][k], ring[j][k]);
    }
  }
  return mesh;
}

void test_borders()
{
  std::cout << "borders" << std::endl;
  for(const double error : {0.02, 0.01})
  {
    test_border("plate", plate_with_hole(), error);         // its corners are checked, too
    test_border("half sphere", half_sphere(), error);
    for(const char* name : {"blobby_3cc.off", "patch-01.off", "elephant-with-holes.off", "horizons.off"})
      test_border(name, read_data<Surface_mesh>(name), error);
  }
}

// Another run with the same parameters keeps a result, also where curves rule its sizes, with a small gradation, and
// where edges are so long against the radius of curvature that the result does not tell what it was before.
void test_second_run(const std::string& name, const double error, const double gradation)
{
  constexpr double largest_changed_part = 0.02;
  const auto parameters = params::approximation_error(error).gradation(gradation);
  Surface_mesh first = read_data<Surface_mesh>(name);
  PMP::hermite_diffuse_remesh(first, parameters);
  first.collect_garbage();
  Surface_mesh second = first;
  PMP::hermite_diffuse_remesh(second, parameters);
  // without a collection of garbage vertices keep their numbers
  const auto is_kept = [&](const Edge_index e)
  {
    const Vertex_index v = first.vertex(e, 0), w = first.vertex(e, 1);
    return !second.is_removed(v) && !second.is_removed(w) && second.halfedge(v, w) != Surface_mesh::null_halfedge();
  };
  const std::size_t kept = std::count_if(edges(first).begin(), edges(first).end(), is_kept);
  const double changed_part = 1. - double(kept) / double(first.number_of_edges());
  std::cout << name << ", second run: " << changed_part << " of the edges changed" << std::endl;
  assert(changed_part < largest_changed_part);
}

// a flat leaf, as long as 1, between two parabolas that leave each other; they meet at its tip at twice `half_angle`
Surface_mesh leaf(const double half_angle, const double bend)
{
  const int n = 40;
  Surface_mesh mesh;
  const Vertex_index tip = mesh.add_vertex(Point_3(0, 0, 0));
  std::vector<Vertex_index> row = {tip, tip, tip};
  for(int i = 1; i <= n; ++i)
  {
    const double x = double(i) / n, y = std::tan(half_angle) * x + bend * x * x;
    const std::vector<Vertex_index> next = {mesh.add_vertex(Point_3(x, -y, 0)), mesh.add_vertex(Point_3(x, 0, 0)),
                                            mesh.add_vertex(Point_3(x, y, 0))};
    for(int k = 0; k < 2; ++k)
    {
      mesh.add_face(row[k], next[k], next[k+1]);
      if(i > 1)
        mesh.add_face(row[k], next[k+1], row[k+1]);
    }
    row = next;
  }
  return mesh;
}

// Where two curves that bend away from each other meet, longer edges make a better triangle: 0.37 is the best between
// their tangents, and 0.50 to 0.52 are reached when only one of its vertices moves at a time, 0.49 on fandisk.
void test_sharp_corners()
{
  const double half_angle = 7. * analytic::pi / 180., bend = 0.6, least_quality = 0.53;
  for(const double length : {0.07, 0.1, 0.14})
  {
    Surface_mesh mesh = leaf(half_angle, bend);
    const auto report = PMP::hermite_diffuse_remesh(mesh, params::minimum_edge_length(length).maximum_edge_length(length));
    assert(report.smallest_quality > least_quality);
  }
  for(const double error : {0.0115, 0.0121, 0.0128})
  {
    Surface_mesh fandisk = read_data<Surface_mesh>("fandisk.off");
    const auto report = PMP::hermite_diffuse_remesh(fandisk, params::approximation_error(error).gradation(1.1));
    assert(report.smallest_quality > 0.5);
  }
}

// a flat plate, a regular polygon of radius 1 with each corner cut off by a part of its sides: its border has points at
// uneven distances
Surface_mesh plate_with_cut_corners(const int number_of_corners, const double part)
{
  const auto corner = [&](const int i)
  {
    const double angle = 2. * analytic::pi * i / number_of_corners;
    return Point_3(std::cos(angle), std::sin(angle), 0);
  };
  std::vector<Point_3> border;
  for(int i = 0; i < number_of_corners; ++i)
    for(const int neighbor : {i - 1, i + 1})
      border.push_back(corner(i) + part / 2. * (corner(neighbor) - corner(i)));
  Surface_mesh mesh;
  const Vertex_index center = mesh.add_vertex(Point_3(0, 0, 0));
  std::vector<Vertex_index> inside, outside;
  for(const Point_3& p : border)
  {
    inside.push_back(mesh.add_vertex(CGAL::midpoint(p, mesh.point(center))));
    outside.push_back(mesh.add_vertex(p));
  }
  for(std::size_t i = 0; i < border.size(); ++i)
  {
    const std::size_t j = (i + 1) % border.size();
    mesh.add_face(center, inside[i], inside[j]);
    mesh.add_face(inside[i], outside[i], outside[j]);
    mesh.add_face(inside[i], outside[j], inside[j]);
  }
  return mesh;
}

// The spline bends more beside such points than the circles through three of them, and its edges are shorter; the sizes
// of the faces follow, or their smallest quality is 0.44 to 0.55.
void test_uneven_points()
{
  for(const double part : {0.15, 0.25})
    for(const double error : {0.001, 0.0007})
    {
      Surface_mesh mesh = plate_with_cut_corners(20, part);
      const auto report = PMP::hermite_diffuse_remesh(mesh, params::approximation_error(error));
      std::cout << "cut corners, " << error << ": smallest quality " << report.smallest_quality << std::endl;
      assert(report.smallest_quality > 0.54);
    }
}

int main()
{
  test_fidelity("cube", read_data<Surface_mesh>("cube.off"), 8, 0.02);
  test_fidelity("fandisk", read_data<Surface_mesh>("fandisk.off"), 25, 0.02);
  test_fidelity("anchor_dense", read_data<Surface_mesh>("anchor_dense.off"), 16, 0.02);
  test_fidelity("joint", read_data<Surface_mesh>("joint.off"), 12, 0.005);
  test_fidelity("cylinder", features::capped_cylinder<Surface_mesh>(48), 0, 0.005);
  test_straight_edges();
  test_circles();
  test_rims_of_few_sides();
  test_discs_of_few_sides();
  test_borders();
  test_detection();
  test_user_features();
  test_policies();
  test_marks_on_a_part();
  test_free_edges();
  test_sharp_corners();
  test_uneven_points();
  test_second_run("anchor_dense.off", 0.0107, 1.1);
  test_second_run("anchor_dense.off", 0.007, 1.3);
  test_second_run("couplingdown.off", 0.3, 1.3);
  std::cout << "done" << std::endl;
  return EXIT_SUCCESS;
}
