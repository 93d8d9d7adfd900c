// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_SIZING_FEATURE_GAPS_H
#define CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_SIZING_FEATURE_GAPS_H

#include <CGAL/Hermite_diffuse_remeshing/internal/Classification/Cut_mesh.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Curves/chain_feature_edges.h>

#include <CGAL/number_utils.h>

#include <boost/geometry/algorithms/expand.hpp>
#include <boost/geometry/algorithms/intersects.hpp>
#include <boost/geometry/geometries/box.hpp>
#include <boost/geometry/geometries/point.hpp>
#include <boost/geometry/index/rtree.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Hermite_diffuse_remeshing {
namespace internal {

// The width of the strips of the surface between two feature curves, such as chamfers, measured from one
// of them. Triangles in a strip can only be well shaped if they are not much longer than it is wide.
class Feature_gaps
{
  typedef boost::geometry::model::point<double, 3, boost::geometry::cs::cartesian> Box_corner;
  typedef boost::geometry::model::box<Box_corner> Box;
  // Consecutive edges of a curve. A search meets mostly those of the curve that it begins at, and is done with all of a
  // run at once.
  struct Run { int curve; std::size_t first, last; };
  static constexpr std::size_t length_of_run = 32;
  typedef std::pair<Box, Run> Entry;

  const Indexed_triangles& m_triangles;
  const Cut_mesh& m_cut_mesh;
  const Edge_table& m_edges;
  const Feature_curves& m_curves;
  boost::geometry::index::rtree<Entry, boost::geometry::index::rstar<16> > m_tree;
  double m_reach = 0.;                            // no two points of the surface are farther apart

  // The shortest way to the other curve leaves a curve at a right angle, along the surface; less than this
  // cosine is near enough. The middle of the side of a thin plate, the other side of which is close
  // too, is none.
  static constexpr double largest_cosine = 0.5037;
  // of the diameter: the search of a gap begins with this where the edge has no length
  static constexpr double least_radius = 1e-4;

public:
  Feature_gaps(const Indexed_triangles& triangles, const Cut_mesh& cut_mesh, const Edge_table& edges,
               const Feature_curves& curves)
    : m_triangles(triangles), m_cut_mesh(cut_mesh), m_edges(edges), m_curves(curves)
  {
    std::vector<Entry> entries;
    for(std::size_t c = 0; c < curves.curves.size(); ++c)
    {
      const std::vector<int>& curve = curves.curves[c].edges;
      for(std::size_t first = 0; first < curve.size(); first += length_of_run)
      {
        const Run run = {static_cast<int>(c), first, (std::min)(first + length_of_run, curve.size())};
        Box box = box_of_edge(curve[first]);
        for(std::size_t i = first + 1; i < run.last; ++i)
          boost::geometry::expand(box, box_of_edge(curve[i]));
        entries.push_back(Entry(box, run));
      }
    }
    m_tree = decltype(m_tree)(entries);
    m_reach = model_diameter(triangles);
  }

  // from a point of an edge of a curve to the closest other curve that bounds the same patch and has no
  // corner in common; infinite if there is none closer than `limit`
  double gap(const Vector& p, const int edge, const double limit) const
  {
    const Vector along = m_triangles.points[m_edges.vertices(edge)[1]] - m_triangles.points[m_edges.vertices(edge)[0]];
    const Vector tangent = along.stableNormalized();
    double best = limit;
    // Boxes that grow from the length of the edge. The incremental search for nearest neighbours sorts all it has met
    // again and again, and most of them are other edges of the same curve.
    for(double radius = (std::max)(along.norm(), least_radius * m_reach); ; radius *= 2.)
    {
      const Vector reach = Vector::Constant(radius);
      const Box box(corner(p - reach), corner(p + reach));
      for(auto it = m_tree.qbegin(boost::geometry::index::intersects(box)); it != m_tree.qend(); ++it)
      {
        const Run& run = it->second;
        if(!are_apart(m_curves.curve_of_edge[edge], run.curve))
          continue;
        for(std::size_t i = run.first; i < run.last; ++i)
        {
          const int other = m_curves.curves[run.curve].edges[i];
          const Vector way = closest_point(other, p) - p;
          const double distance = way.norm();
          if(distance < best && distance > 0. && std::abs(way.dot(tangent)) < largest_cosine * distance
             && boost::geometry::intersects(box, box_of_edge(other)) && is_on_common_patch(edge, other, way / distance))
            best = distance;
        }
      }
      if(best <= radius || limit <= radius || m_reach <= radius)
        break;
    }
    return best < limit ? best : std::numeric_limits<double>::infinity();
  }

private:
  Box box_of_edge(const int e) const
  {
    const Vector& p = m_triangles.points[m_edges.vertices(e)[0]];
    const Vector& q = m_triangles.points[m_edges.vertices(e)[1]];
    return Box(corner(p.cwiseMin(q)), corner(p.cwiseMax(q)));
  }

  static Box_corner corner(const Vector& p) { return Box_corner(p[0], p[1], p[2]); }

  bool are_apart(const int c, const int d) const
  {
    if(c == d)
      return false;
    const std::vector<int>& v = m_curves.curves[c].vertices;
    const std::vector<int>& w = m_curves.curves[d].vertices;
    return v.front() != w.front() && v.front() != w.back() && v.back() != w.front() && v.back() != w.back();
  }

  Vector closest_point(const int edge, const Vector& p) const
  {
    const Vector& a = m_triangles.points[m_edges.vertices(edge)[0]];
    const Vector d = m_triangles.points[m_edges.vertices(edge)[1]] - a;
    const double length2 = d.squaredNorm();
    return length2 > 0. ? Vector(a + (std::min)(1., (std::max)(0., (p - a).dot(d) / length2)) * d) : a;
  }

  bool is_on_common_patch(const int edge, const int other, const Vector& direction) const
  {
    for(int i = 0; i < m_edges.number_of_sides(edge); ++i)
      for(int j = 0; j < m_edges.number_of_sides(other); ++j)
      {
        const int f = m_edges.side(edge, i).face;
        if(m_cut_mesh.patch(f) == m_cut_mesh.patch(m_edges.side(other, j).face)
           && std::abs(direction.dot(m_triangles.area_vector(f).stableNormalized())) < largest_cosine)
          return true;
      }
    return false;
  }
};

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_SIZING_FEATURE_GAPS_H
