// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_CURVES_CHAIN_FEATURE_EDGES_H
#define CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_CURVES_CHAIN_FEATURE_EDGES_H

#include <CGAL/Hermite_diffuse_remeshing/internal/Classification/classify_vertices.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Curves/Feature_spline.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Hermite_diffuse_remeshing {
namespace internal {

// A feature curve between two corners: its vertices and edges in the reference, and its spline.
struct Feature_curve
{
  std::vector<int> vertices;
  std::vector<int> edges;
  Feature_spline spline;

  // a point of the curve as a location on the first face of its edge
  Location location(const double s, const Indexed_triangles& surface, const Edge_table& edge_table) const
  {
    const std::pair<int, double> at = spline.segment(s);
    const Face_side& side = edge_table.side(edges[at.first], 0);
    return location_on_side(side, along(at.first, at.second, side, surface));
  }

  // the parameter of the point above the place that is the part u of a side on the segment
  double parameter(const int segment, const Face_side& side, const double u, const Indexed_triangles& surface) const
  {
    const double v = along(segment, u, side, surface);
    return (1. - v) * spline.parameter(segment) + v * spline.parameter(segment + 1);
  }

  // from a part of the segment to that of a side on it, or back
  double along(const int segment, const double u, const Face_side& side, const Indexed_triangles& surface) const
  {
    return surface.triangles[side.face][side.side] == vertices[segment] ? u : 1. - u;
  }
};

// All feature curves; for every edge of the reference its curve (-1: not a feature edge) and its place
// in the curve.
struct Feature_curves
{
  std::vector<Feature_curve> curves;
  std::vector<int> curve_of_edge;
  std::vector<int> segment_of_edge;
};

namespace chaining {

inline double chain_length(const std::vector<int>& vertices, const Indexed_triangles& surface, const std::size_t last)
{
  double sum = 0.;
  for(std::size_t i = 0; i < last; ++i)
    sum += (surface.points[vertices[i+1]] - surface.points[vertices[i]]).norm();
  return sum;
}

// index of the inner vertex of a chain that comes closest to halving its length
inline int middle_vertex(const std::vector<int>& vertices, const Indexed_triangles& surface)
{
  const double total = chain_length(vertices, surface, vertices.size() - 1);
  double length = 0., best = total;
  int middle = 1;
  // ties, usual on regular polygons, must not be decided by rounding
  const double least_gain = 1e-9 * total;
  for(std::size_t i = 1; i + 1 < vertices.size(); ++i)
  {
    length += (surface.points[vertices[i]] - surface.points[vertices[i-1]]).norm();
    const double gap = std::abs(length - total / 2.);
    if(gap < best - least_gain)
    {
      best = gap;
      middle = static_cast<int>(i);
    }
  }
  return middle;
}

// By which angle the smooth surface turns most at one of the edges of every vertex of a curve; 0 at the others
inline std::vector<double> bends_beside_curves(const Indexed_triangles& surface, const Edge_table& edges,
                                               const std::vector<Edge_class>& edge_classes,
                                               const std::vector<Vertex_class>& vertex_classes)
{
  std::vector<double> result(surface.number_of_vertices(), 0.);
  for(int e = 0; e < edges.number_of_edges(); ++e)
  {
    if(edge_classes[e] != INTERIOR_EDGE)
      continue;
    for(const int v : edges.vertices(e))
      if(vertex_classes[v] == CURVE_VERTEX)
        result[v] = (std::max)(result[v],
                               dihedral_deviation(surface, edges.side(e, 0).face, edges.side(e, 1).face));
  }
  return result;
}

} // namespace chaining

// Chains the feature edges between corners. A closed chain becomes two curves of about equal length;
// the vertices where it is cut become corners (paper, section 4.2). `saturation`: of the distance of the splines
// to the edges.
inline Feature_curves chain_feature_edges(const Indexed_triangles& surface, const Edge_table& edges,
                                          const std::vector<Edge_class>& edge_classes,
                                          std::vector<Vertex_class>& vertex_classes,
                                          const Saturation& saturation = Saturation())
{
  Feature_curves result;
  result.curve_of_edge.assign(edges.number_of_edges(), -1);
  result.segment_of_edge.assign(edges.number_of_edges(), -1);

  // the two feature edges at every vertex of class CURVE_VERTEX
  std::vector<std::array<int, 2> > feature_edges(surface.number_of_vertices(), {{-1, -1}});
  for(int e = 0; e < edges.number_of_edges(); ++e)
    if(is_feature(edge_classes[e]))
      for(const int v : edges.vertices(e))
        feature_edges[v][feature_edges[v][0] == -1 ? 0 : 1] = e;

  std::vector<std::vector<int> > edges_of_corner(surface.number_of_vertices());
  for(int e = 0; e < edges.number_of_edges(); ++e)
    if(is_feature(edge_classes[e]))
      for(const int v : edges.vertices(e))
        if(is_corner(vertex_classes[v]))
          edges_of_corner[v].push_back(e);

  const auto store = [&](const std::vector<int>& vs, const std::vector<int>& es, const Feature_spline& spline,
                         const int first, const int last)
  {
    for(int i = first; i < last; ++i)
    {
      result.curve_of_edge[es[i]] = static_cast<int>(result.curves.size());
      result.segment_of_edge[es[i]] = i - first;
    }
    result.curves.push_back({std::vector<int>(vs.begin() + first, vs.begin() + last + 1),
                             std::vector<int>(es.begin() + first, es.begin() + last),
                             Feature_spline(spline, first, last)});
  };

  const std::vector<double> bends = chaining::bends_beside_curves(surface, edges, edge_classes, vertex_classes);

  // By how much a curve may turn in its first edge e behind the corner v: by this part of the angle to the closest other
  // one. Its tangent leaves the edge by half of it, so that curves that leave the corner side by side stay apart by two
  // fifths of the angle if both do. A cylinder of nine sides needs 0.571 where it is cut; no regular polygon has 0.58.
  const auto largest_turn = [&](const int v, const int e)
  {
    constexpr double part_of_angle = 0.58;
    const Vector& p = surface.points[v];
    double result = std::numeric_limits<double>::infinity();
    for(const int other : edges_of_corner[v])
      if(other != e)
        result = (std::min)(result, angle_between(surface.points[edges.opposite_vertex(e, v)] - p,
                                                  surface.points[edges.opposite_vertex(other, v)] - p));
    return part_of_angle * result;
  };

  // follows curve vertices from `start` along e until a corner or the start is met
  const auto follow = [&](const int start, int e)
  {
    std::vector<int> vs(1, start), es;
    int v = start;
    for(;;)
    {
      es.push_back(e);
      v = edges.opposite_vertex(e, v);
      vs.push_back(v);
      if(v == start || is_corner(vertex_classes[v]))
        break;
      e = feature_edges[v][0] == e ? feature_edges[v][1] : feature_edges[v][0];
    }
    const int last = static_cast<int>(es.size());
    const bool is_loop = v == start;
    const bool is_smooth_loop = is_loop && !is_corner(vertex_classes[start]);
    std::vector<Vector> points;
    std::vector<double> bends_at_points;
    for(std::size_t i = 0; i < vs.size() - (is_smooth_loop ? 1 : 0); ++i)
    {
      points.push_back(surface.points[vs[i]]);
      bends_at_points.push_back(bends[vs[i]]);
    }
    const std::array<double, 2> turns_of_ends = {{largest_turn(vs.front(), es.front()),
                                                  largest_turn(vs.back(), es.back())}};
    const Feature_spline spline(points, is_smooth_loop, turns_of_ends, saturation, bends_at_points);
    if(!is_loop)
      return store(vs, es, spline, 0, last);
    const int middle = chaining::middle_vertex(vs, surface);
    vertex_classes[start] = vertex_classes[vs[middle]] = JUNCTION_VERTEX;
    store(vs, es, spline, 0, middle);
    store(vs, es, spline, middle, last);
  };

  // first the chains that start at a corner, then the loops
  for(const bool from_corners : {true, false})
    for(int e = 0; e < edges.number_of_edges(); ++e)
    {
      if(!is_feature(edge_classes[e]))
        continue;
      for(const int v : edges.vertices(e))
        if(result.curve_of_edge[e] == -1 && (!from_corners || is_corner(vertex_classes[v])))
          follow(v, e);
    }
  return result;
}

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_CURVES_CHAIN_FEATURE_EDGES_H
