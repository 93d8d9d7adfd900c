#ifndef MODEL_MEASURES_H
#define MODEL_MEASURES_H

// Errors of the model on a mesh of a known surface.

#include "irregular_meshes.h"

#include <CGAL/Hermite_diffuse_remeshing/internal/Model/Input_model.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Model/Node_curvature_fitter.h>

#include <limits>
#include <memory>

namespace measures {

using namespace CGAL::Hermite_diffuse_remeshing::internal;
using CGAL::Hermite_diffuse_remeshing::AREA_NORMALS;

const double infinite = std::numeric_limits<double>::infinity();

inline Vector vector(const analytic::Point& p) { return Vector(p[0], p[1], p[2]); }
inline analytic::Point point(const Vector& v) { return {{v[0], v[1], v[2]}}; }

inline Indexed_triangles indexed(const analytic::Triangles& mesh)
{
  Indexed_triangles result;
  for(const analytic::Point& p : mesh.points)
    result.points.push_back(vector(p));
  for(const std::array<std::size_t, 3>& f : mesh.faces)
    result.triangles.push_back({{int(f[0]), int(f[1]), int(f[2])}});
  return result;
}

// `Model` is `Input_model` or `Input_surface`
template <typename Model = Input_model>
std::unique_ptr<Model> make_model(const Indexed_triangles& triangles,
                                  const Model_options& options = Model_options(),
                                  const double sharp_angle_in_degrees = 180.,
                                  const std::vector<Vector>& vertex_normals = std::vector<Vector>())
{
  const double sharp = sharp_angle_in_degrees < 180. ? sharp_angle_in_degrees * analytic::pi / 180. : infinite;
  const Feature_options features = {sharp, analytic::pi / 3., infinite};
  return std::unique_ptr<Model>(
    new Model(triangles, features, options, [](int, int) { return UNMARKED_EDGE; }, [](int) { return false; },
              vertex_normals));
}

inline double quantile(std::vector<double> values, const double q)
{
  if(values.empty())
    return 0.;
  const std::size_t i = (std::min)(values.size() - 1, std::size_t(q * values.size()));
  std::nth_element(values.begin(), values.begin() + i, values.end());
  return values[i];
}

struct Root_mean_square
{
  double sum = 0., largest = 0.;
  int number = 0;

  void add(const double x)
  {
    sum += x * x;
    ++number;
    largest = (std::max)(largest, std::abs(x));
  }
  double operator()() const { return number > 0 ? std::sqrt(sum / number) : 0.; }
};

inline double mean_edge_length(const Indexed_triangles& triangles)
{
  double sum = 0.;
  for(int f = 0; f < triangles.number_of_faces(); ++f)
    for(int k = 0; k < 3; ++k)
      sum += (triangles.point(f, k) - triangles.point(f, next(k))).norm();
  return sum / (3. * triangles.number_of_faces());
}

// 0: on the border, 1: has a neighbour there, 2: neither
inline std::vector<int> distance_to_border(const Cut_mesh& cut_mesh)
{
  std::vector<int> distance(cut_mesh.number_of_nodes(), 2);
  for(int i = 0; i < cut_mesh.number_of_nodes(); ++i)
    if(cut_mesh.is_open(i))
    {
      distance[i] = 0;
      for(const int j : cut_mesh.ring(i))
        distance[j] = (std::min)(distance[j], 1);
    }
  return distance;
}

inline double curvature_error(const std::pair<double, double>& k, const analytic::Truth& truth,
                              const double largest_curvature)
{
  const double scale = (std::max)({std::abs(truth.maximum), std::abs(truth.minimum), 0.1 * largest_curvature});
  return (std::max)(std::abs(k.first - truth.maximum), std::abs(k.second - truth.minimum)) / scale;
}

// The cubic triangle of A. Vlachos et al., Curved PN triangles, I3D 2001.
inline Vector pn_point(const std::array<Vector, 3>& p, const std::array<Vector, 3>& n, const Barycentric& l)
{
  Vector result = Vector::Zero(), sum_of_sides = Vector::Zero();
  for(int i = 0; i < 3; ++i)
  {
    result += l[i] * l[i] * l[i] * p[i];
    for(const int j : {next(i), previous(i)})
    {
      const Vector b = (2. * p[i] + p[j] - (p[j] - p[i]).dot(n[i]) * n[i]) / 3.;
      result += 3. * l[i] * l[i] * l[j] * b;
      sum_of_sides += b;
    }
  }
  const Vector e = sum_of_sides / 6., v = (p[0] + p[1] + p[2]) / 3.;
  return result + 6. * l[0] * l[1] * l[2] * (e + (e - v) / 2.);
}

struct Accuracy
{
  double h = 0.;                                                    // mean length of the edges
  double curvature_median = 0., curvature_p95 = 0., curvature_max = 0.;
  double border_curvature_median = 0., border_curvature_p95 = 0.;   // of vertices on the border
  double centroid_median = 0., centroid_p95 = 0.;
  double position = 0., flat = 0., pn_area = 0., border_position = 0.;  // rms, relative to h
  double normal = 0.;                                               // rms in degrees
};

// curvature at node i by `curvature(i)`, a pair
template <typename Curvature>
void measure_curvature(const Input_model& model, const analytic::Test_surface& truth, const Curvature& curvature,
                       Accuracy& result)
{
  const Cut_mesh& cut_mesh = model.surface.cut_mesh();
  const std::vector<int> border = distance_to_border(cut_mesh);
  std::vector<double> inside, on_border;
  for(int i = 0; i < cut_mesh.number_of_nodes(); ++i)
  {
    const double error = curvature_error(curvature(i), truth.truth(point(model.surface.node(i).position)),
                                         truth.largest_curvature);
    if(border[i] == 2)
      inside.push_back(error);
    else if(border[i] == 0)
      on_border.push_back(error);
  }
  result.curvature_median = quantile(inside, 0.5);
  result.curvature_p95 = quantile(inside, 0.95);
  result.curvature_max = quantile(inside, 1.);
  result.border_curvature_median = quantile(on_border, 0.5);
  result.border_curvature_p95 = quantile(on_border, 0.95);
}

inline Accuracy measure(const Input_model& model, const analytic::Test_surface& truth,
                        const int number_of_points = 10000)
{
  Accuracy result;
  const Indexed_triangles& triangles = model.surface.triangles();
  const Cut_mesh& cut_mesh = model.surface.cut_mesh();
  result.h = mean_edge_length(triangles);
  measure_curvature(model, truth, [&](const int i)
                    { return model.surface.evaluate(model.surface.location_of_node(i)).monge_form().curvatures(); },
                    result);

  std::vector<Vector> area_normals;
  for(int i = 0; i < cut_mesh.number_of_nodes(); ++i)
    area_normals.push_back(fan_normal(triangles, cut_mesh, i, true));
  const std::vector<int> border = distance_to_border(cut_mesh);

  analytic::Random random(number_of_points);
  Root_mean_square position, flat, pn_area, normal, border_position;
  std::vector<double> centroid_curvature;
  for(int n = 0; n < number_of_points; ++n)
  {
    const int f = int(random(0., triangles.number_of_faces()));
    const double r = std::sqrt(random(0., 1.)), s = random(0., 1.);
    const Location location = {f, {{1. - r, r * (1. - s), r * s}}};
    const std::array<int, 3>& nodes = cut_mesh.nodes(f);
    const int to_border = (std::min)({border[nodes[0]], border[nodes[1]], border[nodes[2]]});
    if(to_border == 1)
      continue;
    const Local_quadric quadric = model.surface.evaluate(location);
    const analytic::Truth t = truth.truth(point(quadric.point()));
    const double error = (quadric.point() - vector(t.point)).norm() / result.h;
    if(to_border == 0)
    {
      border_position.add(error);
      continue;
    }
    position.add(error);
    normal.add(angle_between(quadric.normal(), vector(t.normal)) * 180. / analytic::pi);
    const auto distance = [&](const Vector& p) { return (p - vector(truth.truth(point(p)).point)).norm() / result.h; };
    flat.add(distance(quadric.origin));
    std::array<Vector, 3> p, m;
    for(int k = 0; k < 3; ++k)
    {
      p[k] = triangles.point(f, k);
      m[k] = area_normals[nodes[k]];
    }
    pn_area.add(distance(pn_point(p, m, location.coordinates)));
    const Local_quadric center = model.surface.evaluate({f, {{1. / 3., 1. / 3., 1. / 3.}}});
    centroid_curvature.push_back(curvature_error(center.monge_form().curvatures(), truth.truth(point(center.point())),
                                                 truth.largest_curvature));
  }
  result.position = position();
  result.flat = flat();
  result.pn_area = pn_area();
  result.normal = normal();
  result.border_position = border_position();
  result.centroid_median = quantile(centroid_curvature, 0.5);
  result.centroid_p95 = quantile(centroid_curvature, 0.95);
  return result;
}

} // namespace measures

#endif // MODEL_MEASURES_H
