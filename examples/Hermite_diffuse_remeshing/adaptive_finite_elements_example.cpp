// Linear finite elements for u - laplace(u) = f on the unit sphere, where u has a sharp layer. The error is
// estimated after Zienkiewicz and Zhu, turned into sizes, and the sphere is remeshed with them, repeatedly.
// The exact solution is known: the error is printed against the number of unknowns, for uniform meshes
// and for adapted ones. Writes adapted_<step>.ply.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>
#include <CGAL/subdivision_method_3.h>
#include <CGAL/Hermite_diffuse_remeshing/Background_size_fields.h>
#include <CGAL/Hermite_diffuse_remeshing/Size_fields.h>
#include <CGAL/Hermite_diffuse_remeshing/sizes_from_errors.h>
#include <CGAL/Polygon_mesh_processing/hermite_diffuse_remesh.h>

#include <Eigen/Sparse>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <string>
#include <vector>

typedef CGAL::Exact_predicates_inexact_constructions_kernel   K;
typedef CGAL::Surface_mesh<K::Point_3>                        Mesh;
typedef boost::graph_traits<Mesh>::vertex_descriptor          vertex_descriptor;
typedef boost::graph_traits<Mesh>::face_descriptor            face_descriptor;
typedef Eigen::Vector3d                                       Vector;

namespace HDR = CGAL::Hermite_diffuse_remeshing;
namespace PMP = CGAL::Polygon_mesh_processing;

// ---- the problem: u = tanh(z/width), a layer along the equator ------------------------------------

const double width = 0.03;

double solution(const Vector& p) { return std::tanh(p.z() / width); }

// u' as a function of z
double slope(const Vector& p)
{
  const double t = solution(p);
  return (1. - t * t) / width;
}

Vector gradient(const Vector& p) { return slope(p) * (Vector::UnitZ() - p.z() * p); }

// on the sphere the Laplacian of u(z) is (1 - z^2) u'' - 2 z u'
double right_hand_side(const Vector& p)
{
  const double second = -2. * solution(p) * slope(p) / width;
  return solution(p) - (1. - p.z() * p.z()) * second + 2. * p.z() * slope(p);
}

// ---- finite elements ------------------------------------------------------------------------------

struct Element
{
  std::array<vertex_descriptor, 3> vertices;
  std::array<Vector, 3> points, gradients;             // of the shape functions
  double area;

  Element(const Mesh& mesh, const face_descriptor f)
  {
    int k = 0;
    for(const vertex_descriptor v : CGAL::vertices_around_face(mesh.halfedge(f), mesh))
    {
      vertices[k] = v;
      points[k++] = Vector(mesh.point(v).x(), mesh.point(v).y(), mesh.point(v).z());
    }
    const Vector n = (points[1] - points[0]).cross(points[2] - points[0]);
    area = n.norm() / 2.;
    for(k = 0; k < 3; ++k)
      gradients[k] = n.cross(points[(k + 2) % 3] - points[(k + 1) % 3]) / n.squaredNorm();
  }

  // a point by barycentric coordinates, moved to the sphere
  Vector on_sphere(const Vector& l) const { return (l[0] * points[0] + l[1] * points[1] + l[2] * points[2]).normalized(); }

  Vector gradient_of(const Eigen::VectorXd& u) const
  {
    return u[vertices[0]] * gradients[0] + u[vertices[1]] * gradients[1] + u[vertices[2]] * gradients[2];
  }
};

// exact for polynomials of degree four; the weights add up to one (D. A. Dunavant, 1985)
template <typename Visit>
void for_each_quadrature_point(const Visit& visit)
{
  const double a[2] = { 0.445948490915965, 0.091576213509771 }, w[2] = { 0.223381589678011, 0.109951743655322 };
  for(int i = 0; i < 2; ++i)
    for(int k = 0; k < 3; ++k)
    {
      Vector l(a[i], a[i], a[i]);
      l[k] = 1. - 2. * a[i];
      visit(l, w[i]);
    }
}

Eigen::VectorXd solve(const Mesh& mesh)
{
  const int n = static_cast<int>(mesh.number_of_vertices());
  std::vector<Eigen::Triplet<double> > entries;
  Eigen::VectorXd load = Eigen::VectorXd::Zero(n);
  for(const face_descriptor f : mesh.faces())
  {
    const Element e(mesh, f);
    for(int i = 0; i < 3; ++i)
      for(int j = 0; j < 3; ++j)
      {
        const double mass = e.area / (i == j ? 6. : 12.), stiffness = e.area * e.gradients[i].dot(e.gradients[j]);
        entries.emplace_back(int(e.vertices[i]), int(e.vertices[j]), mass + stiffness);
      }
    for_each_quadrature_point([&](const Vector& l, const double weight)
    {
      for(int i = 0; i < 3; ++i)
        load[e.vertices[i]] += weight * e.area * l[i] * right_hand_side(e.on_sphere(l));
    });
  }
  Eigen::SparseMatrix<double> matrix(n, n);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return Eigen::SimplicialLDLT<Eigen::SparseMatrix<double> >(matrix).solve(load);
}

// of the gradient, in the mean square
double exact_error(const Mesh& mesh, const Eigen::VectorXd& u)
{
  double sum = 0.;
  for(const face_descriptor f : mesh.faces())
  {
    const Element e(mesh, f);
    for_each_quadrature_point([&](const Vector& l, const double weight)
    { sum += weight * e.area * (gradient(e.on_sphere(l)) - e.gradient_of(u)).squaredNorm(); });
  }
  return std::sqrt(sum);
}

// The gradient at a vertex is the mean of the gradients in its elements. The error of an element is the
// difference between its own gradient and the one interpolated from its vertices.
Mesh::Property_map<face_descriptor, double> estimate_errors(Mesh& mesh, const Eigen::VectorXd& u)
{
  std::vector<Vector> recovered(mesh.number_of_vertices(), Vector::Zero());
  std::vector<double> area(mesh.number_of_vertices(), 0.);
  for(const face_descriptor f : mesh.faces())
  {
    const Element e(mesh, f);
    for(const vertex_descriptor v : e.vertices)
    {
      recovered[v] += e.area * e.gradient_of(u);
      area[v] += e.area;
    }
  }
  const auto errors = mesh.add_property_map<face_descriptor, double>("f:error").first;
  for(const face_descriptor f : mesh.faces())
  {
    const Element e(mesh, f);
    double sum = 0.;
    for_each_quadrature_point([&](const Vector& l, const double weight)
    {
      Vector g = Vector::Zero();
      for(int i = 0; i < 3; ++i)
        g += l[i] * recovered[e.vertices[i]] / area[e.vertices[i]];
      sum += weight * e.area * (g - e.gradient_of(u)).squaredNorm();
    });
    errors[f] = std::sqrt(sum);
  }
  return errors;
}

// ---- meshes ---------------------------------------------------------------------------------------

Mesh make_sphere()
{
  Mesh mesh;
  CGAL::make_icosahedron(mesh, K::Point_3(0., 0., 0.), 1.);
  CGAL::Subdivision_method_3::Loop_subdivision(mesh, CGAL::parameters::number_of_iterations(4));
  for(const vertex_descriptor v : mesh.vertices())
  {
    const double length = std::sqrt(CGAL::squared_distance(mesh.point(v), K::Point_3(0., 0., 0.)));
    mesh.point(v) = K::Point_3(mesh.point(v).x() / length, mesh.point(v).y() / length, mesh.point(v).z() / length);
  }
  return mesh;
}

// always of the first mesh, so that the surface stays the same however often it is remeshed
template <typename SizeField>
Mesh remeshed(const Mesh& input, const SizeField& field)
{
  Mesh mesh = input;
  PMP::hermite_diffuse_remesh(mesh, CGAL::parameters::approximation_error(0.).size_field(field).gradation(1.5)
                                      .maximum_edge_length(0.3));
  mesh.collect_garbage();
  return mesh;
}

// the solution as colours, from blue for -1 to red for 1
void write(Mesh& mesh, const Eigen::VectorXd& u, const std::string& filename)
{
  const auto color = mesh.add_property_map<vertex_descriptor, CGAL::IO::Color>("v:color").first;
  for(const vertex_descriptor v : mesh.vertices())
  {
    const double share = std::clamp((u[v] + 1.) / 2., 0., 1.);
    color[v] = CGAL::IO::Color(static_cast<unsigned char>(255. * share), 0,
                               static_cast<unsigned char>(255. * (1. - share)));
  }
  CGAL::IO::write_PLY(filename, mesh, CGAL::parameters::stream_precision(17));
}

// how fast the error falls with the number of unknowns; the best for linear elements is -1/2
double slope_between(const std::array<double, 2>& before, const std::array<double, 2>& after)
{
  return std::log(after[1] / before[1]) / std::log(after[0] / before[0]);
}

int main()
{
  const Mesh sphere = make_sphere();
  std::vector<std::array<double, 2> > uniform, adapted;        // unknowns, error

  std::cout << "mesh\tunknowns\terror\tslope\n";
  for(const double size : { 0.1, 0.05, 0.025 })
  {
    const Mesh mesh = remeshed(sphere, HDR::Constant_size_field(size));
    uniform.push_back({{ double(mesh.number_of_vertices()), exact_error(mesh, solve(mesh)) }});
    std::cout << "uniform\t" << uniform.back()[0] << "\t" << uniform.back()[1];
    if(uniform.size() > 1)
      std::cout << "\t" << slope_between(uniform[uniform.size() - 2], uniform.back());
    std::cout << std::endl;
  }

  Mesh mesh = remeshed(sphere, HDR::Constant_size_field(0.1));
  constexpr int number_of_steps = 5;
  for(int step = 0; step < number_of_steps; ++step)
  {
    const Eigen::VectorXd u = solve(mesh);
    const auto errors = estimate_errors(mesh, u);
    write(mesh, u, "adapted_" + std::to_string(step) + ".ply");
    adapted.push_back({{ double(mesh.number_of_vertices()), exact_error(mesh, u) }});
    std::cout << "adapted\t" << adapted.back()[0] << "\t" << adapted.back()[1];
    if(step > 0)
      std::cout << "\t" << slope_between(adapted[step - 1], adapted.back());
    std::cout << std::endl;
    if(step + 1 == number_of_steps)
      break;

    const auto sizes = mesh.add_property_map<vertex_descriptor, double>("v:size").first;
    const double number_of_elements = 2000. * std::pow(2., step);
    HDR::sizes_for_number_of_elements(mesh, errors, 1., number_of_elements, sizes);
    mesh = remeshed(sphere, HDR::Background_size_field<K>(mesh, sizes));
  }

  // with how many unknowns an adapted mesh is as accurate as the finest uniform one
  for(const auto& entry : adapted)
    if(entry[1] <= uniform.back()[1])
    {
      std::cout << "the accuracy of " << uniform.back()[0] << " uniform unknowns is reached with " << entry[0]
                << " adapted ones" << std::endl;
      return 4. * entry[0] <= uniform.back()[0] ? EXIT_SUCCESS : EXIT_FAILURE;
    }
  return EXIT_FAILURE;
}
