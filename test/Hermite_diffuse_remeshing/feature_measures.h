#ifndef FEATURE_MEASURES_H
#define FEATURE_MEASURES_H

// Feature curves of a mesh and of what it was remeshed to: the edges of the one against the edges of the other, and
// against the splines through the vertices of the input, to which the error law refers.

#include "mesh_measures.h"

#include <CGAL/Hermite_diffuse_remeshing/Feature_classes.h>
#include <CGAL/Polygon_mesh_processing/hermite_diffuse_classify_features.h>
#include <CGAL/Polygon_mesh_processing/hermite_diffuse_remesh.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Curves/chain_feature_edges.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <vector>

namespace features {

namespace HDR = CGAL::Hermite_diffuse_remeshing;

template <typename Mesh>
struct Maps
{
  typedef typename Mesh::template Property_map<typename Mesh::Edge_index, HDR::Edge_class> Edge_classes;
  typedef typename Mesh::template Property_map<typename Mesh::Vertex_index, HDR::Vertex_class> Vertex_classes;
  typedef typename Mesh::template Property_map<typename Mesh::Vertex_index, double> Sizes;

  Edge_classes edge_classes;
  Vertex_classes vertex_classes;
  Sizes sizes;

  explicit Maps(Mesh& mesh)
    : edge_classes(mesh.template add_property_map<typename Mesh::Edge_index, HDR::Edge_class>("e:class").first)
    , vertex_classes(mesh.template add_property_map<typename Mesh::Vertex_index, HDR::Vertex_class>("v:class").first)
    , sizes(mesh.template add_property_map<typename Mesh::Vertex_index, double>("v:size").first)
  {}
};

template <typename Point>
struct Edge
{
  Point source, target;
  double size;                          // that was asked for, the mean at the ends

  Point at(const double u) const { return source + u * (target - source); }
};

template <typename Mesh>
std::vector<Edge<typename Mesh::Point> > feature_edges(const Mesh& mesh, const Maps<Mesh>& maps)
{
  std::vector<Edge<typename Mesh::Point> > result;
  for(const auto e : edges(mesh))
    if(HDR::is_feature(maps.edge_classes[e]))
      result.push_back({mesh.point(mesh.vertex(e, 0)), mesh.point(mesh.vertex(e, 1)),
                        (maps.sizes[mesh.vertex(e, 0)] + maps.sizes[mesh.vertex(e, 1)]) / 2.});
  return result;
}

// index of the closest edge, and the distance to it
template <typename Point>
std::pair<std::size_t, double> closest(const std::vector<Edge<Point> >& edges, const Point& p)
{
  std::pair<std::size_t, double> best(0, std::numeric_limits<double>::infinity());
  for(std::size_t i = 0; i < edges.size(); ++i)
  {
    const auto d = edges[i].target - edges[i].source;
    const double length2 = d.squared_length();
    const double u = length2 > 0. ? (std::max)(0., (std::min)(1., (p - edges[i].source) * d / length2)) : 0.;
    const double distance2 = CGAL::squared_distance(p, edges[i].at(u));
    if(distance2 < best.second)
      best = std::make_pair(i, distance2);
  }
  best.second = std::sqrt(best.second);
  return best;
}

// The distance between an arc and its chord if the chord has the length that the error law asks for.
inline double sagitta(const double size, const double error)
{
  const double length_over_radius = HDR::internal::length_of_error(error);
  const double half = length_over_radius / 2.;
  return size / length_over_radius * (1. - std::sqrt(1. - half * half));
}

// the splines as fine polylines
template <typename Mesh>
std::vector<Edge<typename Mesh::Point> > feature_splines(const Mesh& mesh, const Maps<Mesh>& maps)
{
  using namespace HDR::internal;
  typedef typename Mesh::Point Point;
  typedef typename CGAL::Kernel_traits<Point>::Kernel Kernel;
  std::vector<typename Mesh::Face_index> faces;
  const Indexed_triangles triangles = read_triangles(mesh, mesh.points(), Kernel(), faces);
  const Edge_table table(triangles);
  std::vector<HDR::Edge_class> edge_classes(table.number_of_edges());
  for(int f = 0; f < triangles.number_of_faces(); ++f)
  {
    auto h = mesh.halfedge(faces[f]);
    for(int k = 0; k < 3; ++k, h = mesh.next(h))
      edge_classes[table.edge(f, k)] = maps.edge_classes[mesh.edge(h)];
  }
  std::vector<HDR::Vertex_class> vertex_classes;
  for(const auto v : vertices(mesh))
    vertex_classes.push_back(maps.vertex_classes[v]);
  std::vector<Edge<Point> > result;
  const int n = 8;
  for(const Feature_curve& curve : chain_feature_edges(triangles, table, edge_classes, vertex_classes).curves)
    for(int i = 0; i < curve.spline.number_of_segments(); ++i)
    {
      const double s = curve.spline.parameter(i), length = curve.spline.parameter(i + 1) - s;
      for(int k = 0; k < n; ++k)
      {
        const Vector p = curve.spline.point(s + length * k / n), q = curve.spline.point(s + length * (k + 1) / n);
        result.push_back({Point(p[0], p[1], p[2]), Point(q[0], q[1], q[2]), 0.});
      }
    }
  return result;
}

struct Fidelity
{
  std::size_t number_of_corners = 0, number_of_missing_corners = 0;
  std::size_t number_of_edges = 0;
  double diagonal = 0.;
  double largest_distance = 0.;         // two-sided, between the feature edges of input and result
  double largest_excess = 0.;           // of the two-sided distance to the splines over the sagitta there
};

// remeshes, and compares the feature edges
template <typename Mesh, typename NamedParameters>
Fidelity measure(const Mesh& input, Mesh& output, const double error, const NamedParameters& np)
{
  typedef typename Mesh::Point Point;
  namespace PMP = CGAL::Polygon_mesh_processing;
  output = input;
  Mesh classified = input;
  const Maps<Mesh> before(classified), after(output);
  PMP::hermite_diffuse_classify_features(classified, before.edge_classes, before.vertex_classes, np);
  PMP::hermite_diffuse_remesh(output, np.approximation_error(error).edge_class_map(after.edge_classes)
                                        .vertex_size_map(after.sizes));

  Fidelity result;
  result.diagonal = diagonal_of_box(input);
  std::set<Point> points;
  for(const auto v : vertices(output))
    points.insert(output.point(v));
  for(const auto v : vertices(classified))
    if(HDR::is_corner(before.vertex_classes[v]))
    {
      ++result.number_of_corners;
      result.number_of_missing_corners += points.count(classified.point(v)) == 0;
    }

  const std::vector<Edge<Point> > old_edges = feature_edges(classified, before), new_edges = feature_edges(output, after);
  result.number_of_edges = new_edges.size();
  const std::vector<Edge<Point> > splines = feature_splines(classified, before);
  const int n = 8;
  for(const Edge<Point>& edge : new_edges)
    for(int i = 0; i < n; ++i)
    {
      const Point p = edge.at(double(i) / n);
      result.largest_distance = (std::max)(result.largest_distance, closest(old_edges, p).second);
      result.largest_excess = (std::max)(result.largest_excess, closest(splines, p).second - sagitta(edge.size, error));
    }
  for(const Edge<Point>& edge : old_edges)
    for(int i = 0; i < n; ++i)
      result.largest_distance = (std::max)(result.largest_distance, closest(new_edges, edge.at(double(i) / n)).second);
  for(const Edge<Point>& piece : splines)
  {
    const std::pair<std::size_t, double> nearest = closest(new_edges, piece.source);
    result.largest_excess = (std::max)(result.largest_excess, nearest.second - sagitta(new_edges[nearest.first].size, error));
  }
  return result;
}

// a cylinder of radius 1 from z = -1 to z = 1 with flat caps, its axis at the centre of these
template <typename Mesh>
Mesh capped_cylinder(const int number_of_sides)
{
  typedef typename Mesh::Point Point;
  Mesh mesh;
  const int rows = (std::max)(1, static_cast<int>(number_of_sides / 3.14159));
  std::vector<std::vector<typename Mesh::Vertex_index> > ring(rows + 1);
  for(int j = 0; j <= rows; ++j)
    for(int i = 0; i < number_of_sides; ++i)
    {
      const double angle = 2. * 3.14159265358979323846 * i / number_of_sides;
      ring[j].push_back(mesh.add_vertex(Point(std::cos(angle), std::sin(angle), 2. * j / rows - 1.)));
    }
  const auto bottom = mesh.add_vertex(Point(0, 0, -1)), top = mesh.add_vertex(Point(0, 0, 1));
  for(int i = 0; i < number_of_sides; ++i)
  {
    const int k = (i + 1) % number_of_sides;
    for(int j = 0; j < rows; ++j)
    {
      mesh.add_face(ring[j][i], ring[j][k], ring[j+1][k]);
      mesh.add_face(ring[j][i], ring[j+1][k], ring[j+1][i]);
    }
    mesh.add_face(bottom, ring[0][k], ring[0][i]);
    mesh.add_face(top, ring[rows][i], ring[rows][k]);
  }
  return mesh;
}

} // namespace features

#endif // FEATURE_MEASURES_H
