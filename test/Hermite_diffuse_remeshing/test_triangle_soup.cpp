#include "soups.h"
#include "test_helpers.h"

#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/Polygon_mesh_processing/hermite_diffuse_remesh_triangle_soup.h>

#include <map>

using namespace HDR;
using namespace HDR::internal;

typedef std::array<std::size_t, 3> Triangle;

struct Soup
{
  std::vector<Point_3> points;
  std::vector<Triangle> triangles;
  std::map<std::size_t, int> labels;
};

Soup make_soup(const soups::Soup& given)
{
  Soup soup;
  for(const soups::Point& p : given.points)
    soup.points.push_back(Point_3(p[0], p[1], p[2]));
  soup.triangles = given.triangles;
  for(std::size_t i = 0; i < given.labels.size(); ++i)
    soup.labels[i] = given.labels[i];
  return soup;
}

Indexed_triangles indexed(const Soup& soup)
{
  return read_soup(soup.points, soup.triangles, Kernel());
}

// the edges with other than two faces
struct Special_edges
{
  std::map<int, std::vector<std::array<Vector, 2> > > of_valence;

  explicit Special_edges(const Indexed_triangles& surface)
  {
    const Edge_table edges(surface);
    for(int e = 0; e < edges.number_of_edges(); ++e)
      if(edges.number_of_sides(e) != 2)
        of_valence[edges.number_of_sides(e)].push_back(
          {{surface.points[edges.vertices(e)[0]], surface.points[edges.vertices(e)[1]]}});
  }

  double distance(const int valence, const Vector& p) const
  {
    double best = std::numeric_limits<double>::infinity();
    for(const std::array<Vector, 2>& edge : of_valence.at(valence))
    {
      const Vector d = edge[1] - edge[0];
      const double u = (std::max)(0., (std::min)(1., (p - edge[0]).dot(d) / d.squaredNorm()));
      best = (std::min)(best, (p - edge[0] - u * d).norm());
    }
    return best;
  }

  double length(const int valence) const
  {
    double sum = 0.;
    for(const std::array<Vector, 2>& edge : of_valence.at(valence))
      sum += (edge[1] - edge[0]).norm();
    return sum;
  }
};

long euler_characteristic(const Indexed_triangles& surface)
{
  return long(surface.number_of_vertices()) - Edge_table(surface).number_of_edges() + surface.number_of_faces();
}

double mean_edge_length(const Indexed_triangles& surface)
{
  const Edge_table edges(surface);
  double sum = 0.;
  for(int e = 0; e < edges.number_of_edges(); ++e)
    sum += (surface.points[edges.vertices(e)[1]] - surface.points[edges.vertices(e)[0]]).norm();
  return sum / edges.number_of_edges();
}

// area by label
std::map<int, double> areas(const Indexed_triangles& surface, const std::map<std::size_t, int>& labels)
{
  std::map<int, double> result;
  for(int f = 0; f < surface.number_of_faces(); ++f)
    result[labels.at(std::size_t(f))] += surface.area_vector(f).norm() / 2.;
  return result;
}

// conforming, along the same junctions and borders, with the labels where they were
void check(const Soup& input, const Soup& output, const double distance, const std::map<std::size_t, double>& sizes)
{
  const Indexed_triangles before = indexed(input), after = indexed(output);
  assert(euler_characteristic(before) == euler_characteristic(after));

  std::set<std::array<int, 3> > seen;
  std::vector<char> is_used(after.number_of_vertices(), false);
  for(std::array<int, 3> triangle : after.triangles)
  {
    for(const int v : triangle)
      is_used[v] = true;
    std::sort(triangle.begin(), triangle.end());
    assert(seen.insert(triangle).second);
  }
  assert(std::count(is_used.begin(), is_used.end(), false) == 0);
  assert(std::set<Point_3>(output.points.begin(), output.points.end()).size() == output.points.size());

  const Special_edges old_edges(before), new_edges(after);
  assert(old_edges.of_valence.size() == new_edges.of_valence.size());
  for(const auto& entry : old_edges.of_valence)
  {
    assert(new_edges.of_valence.count(entry.first) == 1);
    for(const auto& edge : entry.second)
      assert(new_edges.distance(entry.first, (edge[0] + edge[1]) / 2.) < distance);
    for(const auto& edge : new_edges.of_valence.at(entry.first))
      assert(old_edges.distance(entry.first, (edge[0] + edge[1]) / 2.) < distance);
  }

  const Edge_table edges(after);
  for(int e = 0; e < edges.number_of_edges(); ++e)
    if(edges.number_of_sides(e) > 2)
    {
      const std::array<int, 2>& ends = edges.vertices(e);
      const double relative = 2. * (after.points[ends[1]] - after.points[ends[0]]).norm()
                            / (sizes.at(std::size_t(ends[0])) + sizes.at(std::size_t(ends[1])));
      assert(relative > 0.5 && relative < 2.);
    }

  // coherently oriented but for what cannot be
  const auto incoherent = [](const Indexed_triangles& surface)
  {
    const Edge_table edges(surface);
    const std::vector<Edge_class> classes =
      classify_edges(surface, edges, 4., [](int, int) { return MARKED_FREE; });
    int number = 0;
    for(int e = 0; e < edges.number_of_edges(); ++e)
      number += edges.number_of_sides(e) == 2 && classes[e] == NON_MANIFOLD_EDGE;
    return number;
  };
  Indexed_triangles oriented = before;
  orient_sheets(oriented);
  assert((incoherent(oriented) == 0) == (incoherent(after) == 0));
}

void test(const std::string& name, const Soup& input, const std::set<int>& valences)
{
  const Indexed_triangles before = indexed(input);
  for(const auto& entry : Special_edges(before).of_valence)
    assert(valences.count(entry.first) == 1);
  assert(Special_edges(before).of_valence.size() == valences.size());
  const double length = mean_edge_length(before);
  for(const double factor : {0.25, 4.})
  {
    Soup output = input;
    std::map<std::size_t, double> sizes;
    const auto report = PMP::hermite_diffuse_remesh_triangle_soup(output.points, output.triangles,
      params::approximation_error(0.).maximum_edge_length(factor * length).minimum_edge_length(factor * length / 100.)
        .face_patch_map(boost::make_assoc_property_map(output.labels))
        .vertex_size_map(boost::make_assoc_property_map(sizes)));
    std::cout << name << " x " << factor << ": " << input.triangles.size() << " -> " << output.triangles.size()
              << " triangles, quality " << report.smallest_quality << ", " << report.mean_quality << ", "
              << report.seconds << " s" << std::endl;
    assert(report.number_of_faces == output.triangles.size() && report.number_of_vertices == output.points.size());
    assert(report.smallest_quality >= 0.35);
    assert((output.triangles.size() > input.triangles.size()) == (factor < 1.));
    check(input, output, factor < 1. ? 0.1 * length : 1.5 * length, sizes);
    for(std::size_t i = output.triangles.size(); i < input.triangles.size(); ++i)
      output.labels.erase(i);
    const std::map<int, double> old_areas = areas(before, input.labels), new_areas = areas(indexed(output), output.labels);
    assert(old_areas.size() == new_areas.size());
    for(const auto& entry : old_areas)
      assert(std::abs(new_areas.at(entry.first) / entry.second - 1.) < (factor < 1. ? 0.02 : 0.25));
  }
}

// one soup of several files, each with a label of its own; points that are equal are joined
Soup read_soups(char** first, char** last)
{
  soups::Soup soup;
  for(char** file = first; file != last; ++file)
  {
    std::vector<Point_3> points;
    std::vector<std::vector<std::size_t> > triangles;
    const bool is_read = CGAL::IO::read_polygon_soup(*file, points, triangles);
    assert(is_read);
    std::vector<std::size_t> index;
    for(const Point_3& p : points)
      index.push_back(soup.point({{p.x(), p.y(), p.z()}}));
    for(const std::vector<std::size_t>& t : triangles)
      soup.triangle(index[t[0]], index[t[1]], index[t[2]], int(file - first));
  }
  return make_soup(soup);
}

// a size larger than the model: the coarsest soup that conforms
void test_extreme_coarsening(const std::string& name, const Soup& input)
{
  Soup output = input;
  PMP::hermite_diffuse_remesh_triangle_soup(output.points, output.triangles,
    params::approximation_error(0.).maximum_edge_length(100.).minimum_edge_length(50.)
      .face_patch_map(boost::make_assoc_property_map(output.labels)));
  std::cout << name << ", as coarse as possible: " << output.triangles.size() << " triangles" << std::endl;
  const Indexed_triangles before = indexed(input), after = indexed(output);
  assert(output.triangles.size() < input.triangles.size() / 8);
  assert(euler_characteristic(before) == euler_characteristic(after));
  const Special_edges old_edges(before), new_edges(after);
  assert(old_edges.of_valence.size() == new_edges.of_valence.size());
  for(const auto& entry : old_edges.of_valence)
    assert(new_edges.of_valence.count(entry.first) == 1);
}

// The true normals of a bent sheet, the triangles of which are turned at random, make a better model: the vertices of the
// result are closer to it. A normal has no side, as a soup has none.
void test_normals()
{
  soups::Soup bent;
  const auto height = [](const double u, const double v) { return 0.2 * std::sin(3. * u) * std::cos(2. * v); };
  bent.sheet(12, 12, 0, [&](const double u, const double v) { return soups::Point{{u, v, height(u, v)}}; });
  Soup input = make_soup(bent);
  std::map<std::size_t, Kernel::Vector_3> normals;
  for(std::size_t i = 0; i < input.points.size(); ++i)
  {
    const double u = input.points[i].x(), v = input.points[i].y();
    normals[i] = (i % 2 == 0 ? 1. : -3.) * Kernel::Vector_3(-0.6 * std::cos(3. * u) * std::cos(2. * v),
                                                           0.4 * std::sin(3. * u) * std::sin(2. * v), 1.);
  }
  for(std::size_t i = 0; i < input.triangles.size(); i += 3)
    std::swap(input.triangles[i][1], input.triangles[i][2]);
  const auto error = [&](const Soup& soup)
  {
    double largest = 0.;
    for(const Point_3& p : soup.points)
      if((std::min)({p.x(), p.y(), 1. - p.x(), 1. - p.y()}) > 0.1)
        largest = (std::max)(largest, std::abs(p.z() - height(p.x(), p.y())));
    return largest;
  };
  Soup plain = input, known = input;
  PMP::hermite_diffuse_remesh_triangle_soup(plain.points, plain.triangles,
    params::maximum_edge_length(0.04).normal_estimation(AREA_NORMALS));
  PMP::hermite_diffuse_remesh_triangle_soup(known.points, known.triangles,
    params::maximum_edge_length(0.04).normal_estimation(AREA_NORMALS)
                                     .vertex_normal_map(boost::make_assoc_property_map(normals)));
  std::cout << "known normals: error " << error(known) << " instead of " << error(plain) << std::endl;
  assert(error(known) < error(plain) / 3.);
}

// A split at the spine of a book adds a face to each leaf: the last one that there would be room for if it added two
// is not made.
void test_budget_at_junction()
{
  std::cout << "budget at a junction" << std::endl;
  for(const int number_of_leaves : {3, 12})
    for(std::size_t budget = 50; budget < 54; ++budget)
    {
      Soup book;
      book.points = {Point_3(0., 0., 0.), Point_3(0., 0., 1.)};
      for(int i = 0; i < number_of_leaves; ++i)
      {
        const double angle = 2. * analytic::pi * i / number_of_leaves;
        const std::size_t first = book.points.size();
        for(const double z : {0., 1.})
          book.points.push_back(Point_3(std::cos(angle), std::sin(angle), z));
        book.triangles.push_back({{0, first, first + 1}});
        book.triangles.push_back({{0, first + 1, 1}});
      }
      const auto size = [](const Point_3& p) { return p.x() * p.x() + p.y() * p.y() < 0.1 ? 0.01 : 0.5; };
      PMP::hermite_diffuse_remesh_triangle_soup(book.points, book.triangles,
        params::approximation_error(0.).size_field(size).maximum_number_of_faces(budget));
      assert(book.triangles.size() <= budget && int(book.triangles.size()) > 2 * number_of_leaves);
    }
}

// maps of the user with indices as keys, and what is refused
void test_parameters()
{
  std::cout << "parameters" << std::endl;
  const Soup input = make_soup(soups::t_of_plates(4));
  const Indexed_triangles before = indexed(input);

  // the junction is protected: its edges stay, and the size starts from them
  typedef std::pair<std::size_t, std::size_t> Edge;
  std::map<Edge, Edge_policy> policies;
  const Edge_table edges(before);
  std::set<std::set<Point_3> > junction;
  for(int e = 0; e < edges.number_of_edges(); ++e)
    if(edges.number_of_sides(e) == 3)
    {
      policies[Edge(edges.vertices(e)[0], edges.vertices(e)[1])] = PROTECTED_EDGE;
      junction.insert({input.points[edges.vertices(e)[0]], input.points[edges.vertices(e)[1]]});
    }
  Soup output = input;
  std::map<std::size_t, std::pair<std::size_t, std::array<double, 3> > > locations;
  std::map<std::size_t, std::size_t> origins;
  PMP::hermite_diffuse_remesh_triangle_soup(output.points, output.triangles,
    params::maximum_edge_length(0.08).edge_policy_map(boost::make_assoc_property_map(policies))
      .vertex_location_map(boost::make_assoc_property_map(locations))
      .face_origin_map(boost::make_assoc_property_map(origins)));
  const Indexed_triangles after = indexed(output);
  const Edge_table new_edges(after);
  std::set<std::set<Point_3> > new_junction;
  for(int e = 0; e < new_edges.number_of_edges(); ++e)
    if(new_edges.number_of_sides(e) == 3)
      new_junction.insert({output.points[new_edges.vertices(e)[0]], output.points[new_edges.vertices(e)[1]]});
  assert(new_junction == junction);

  assert(locations.size() == output.points.size() && origins.size() == output.triangles.size());
  for(const auto& entry : locations)
  {
    const std::array<std::size_t, 3>& t = input.triangles[entry.second.first];
    const std::array<double, 3>& l = entry.second.second;
    const Point_3 p = CGAL::barycenter(input.points[t[0]], l[0], input.points[t[1]], l[1], input.points[t[2]], l[2]);
    assert(CGAL::squared_distance(p, output.points[entry.first]) < 1e-12);
  }

  // the classes of the edges: the junction is protected, the rest of the plates is smooth but for its border
  std::map<Edge, Edge_class> classes;
  Soup classified = input;
  PMP::hermite_diffuse_remesh_triangle_soup(classified.points, classified.triangles,
    params::maximum_edge_length(0.08).edge_class_map(boost::make_assoc_property_map(classes)));
  const Edge_table classified_edges(indexed(classified));
  assert(classes.size() == std::size_t(classified_edges.number_of_edges()));
  for(int e = 0; e < classified_edges.number_of_edges(); ++e)
  {
    const Edge_class expected[] = {INTERIOR_EDGE, BOUNDARY_EDGE, INTERIOR_EDGE, NON_MANIFOLD_EDGE};
    assert(classes.at(Edge(classified_edges.vertices(e)[0], classified_edges.vertices(e)[1]))
           == expected[classified_edges.number_of_sides(e)]);
  }

  // a stop before the first change
  locations.clear();
  origins.clear();
  output = input;
  PMP::hermite_diffuse_remesh_triangle_soup(output.points, output.triangles,
    params::maximum_edge_length(0.08).maximum_running_time(1e-9).vertex_location_map(boost::make_assoc_property_map(locations))
      .face_origin_map(boost::make_assoc_property_map(origins)));
  assert(output.triangles == input.triangles && origins.size() == input.triangles.size());
  for(const auto& entry : origins)
    assert(entry.first == entry.second);
  for(const auto& entry : locations)
    for(int k = 0; k < 3; ++k)
      assert(entry.second.second[k] == (input.triangles[entry.second.first][k] == entry.first ? 1. : 0.));

  // the size field is asked at places of the triangles as they are given, whatever their orientation
  Soup turned = input;
  for(std::size_t i = 0; i < turned.triangles.size(); i += 3)
    std::swap(turned.triangles[i][1], turned.triangles[i][2]);
  const std::vector<Point_3> points = turned.points;
  const std::vector<Triangle> triangles = turned.triangles;
  int number_of_questions = 0;
  const auto field = [&](const Point_3& p, const std::size_t f, const std::array<double, 3>& l)
  {
    const Triangle& t = triangles[f];
    const Point_3 q = CGAL::barycenter(points[t[0]], l[0], points[t[1]], l[1], points[t[2]], l[2]);
    assert(CGAL::squared_distance(p, q) < 1e-20);
    ++number_of_questions;
    return 0.1;
  };
  PMP::hermite_diffuse_remesh_triangle_soup(turned.points, turned.triangles, params::size_field(field));
  assert(number_of_questions > 100);

  std::map<std::size_t, Kernel::Vector_3> normals;           // none is known
  for(std::size_t i = 0; i < input.points.size(); ++i)
    normals[i] = CGAL::NULL_VECTOR;
  const auto is_refused = [&](Soup soup)
  {
    const Soup copy = soup;
    const auto known = params::maximum_edge_length(0.5).vertex_normal_map(boost::make_assoc_property_map(normals));
    try { PMP::hermite_diffuse_remesh_triangle_soup(soup.points, soup.triangles, known); }
    catch(const std::invalid_argument&) { return soup.points.size() == copy.points.size() && soup.triangles == copy.triangles; }
    return false;
  };
  Soup bad = input;
  bad.triangles.clear();
  assert(is_refused(bad));
  bad = input;
  bad.triangles[3][1] = bad.points.size();
  assert(is_refused(bad));
  bad = input;
  bad.triangles[3][1] = bad.triangles[3][0];
  assert(is_refused(bad));
  bad = input;
  bad.points[2] = Point_3(0., std::numeric_limits<double>::quiet_NaN(), 0.);
  assert(is_refused(bad));
  bad = input;
  for(Point_3& p : bad.points)
    p = CGAL::ORIGIN + 1e60 * (p - CGAL::ORIGIN);
  assert(is_refused(bad));
  bad = input;
  for(Point_3& p : bad.points)
    p = Point_3(p.x(), 0., 0.);
  assert(is_refused(bad));
  assert(!is_refused(input));
  normals[2] = Kernel::Vector_3(0., 0., std::numeric_limits<double>::infinity());
  assert(is_refused(input));
}

int main(int argc, char** argv)
{
  // a complex may be given by its files, as CGAL's polyhedral_complex_of_spheres: three sheets meet at a junction
  if(argc > 1)
  {
    test("files", read_soups(argv + 1, argv + argc), {3});
    return EXIT_SUCCESS;
  }
  test("three sheets", make_soup(soups::three_sheets(12)), {1, 3});
  test("T of plates", make_soup(soups::t_of_plates(8)), {1, 3});
  test("two cubes", make_soup(soups::two_cubes(8)), {3});
  test("two cones", make_soup(soups::two_cones(7)), {});
  test("Moebius strip", make_soup(soups::moebius_strip(6)), {1});
  test("three balls", make_soup(soups::three_balls(5)), {3});
  test_extreme_coarsening("three sheets", make_soup(soups::three_sheets(12)));
  test_extreme_coarsening("two cubes", make_soup(soups::two_cubes(6)));
  test_extreme_coarsening("three balls", make_soup(soups::three_balls(5)));
  test_parameters();
  test_budget_at_junction();
  test_normals();
  std::cout << "done" << std::endl;
  return EXIT_SUCCESS;
}
