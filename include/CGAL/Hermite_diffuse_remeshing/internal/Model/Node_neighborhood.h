// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_MODEL_NODE_NEIGHBORHOOD_H
#define CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_MODEL_NODE_NEIGHBORHOOD_H

#include <CGAL/Hermite_diffuse_remeshing/internal/Model/Monge_form.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Model/Node_data.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace CGAL {
namespace Hermite_diffuse_remeshing {
namespace internal {

// Frame at a node with lengths divided by the node's size. The x axis points to the first
// neighbour, so that it turns with the surface and the pivots of a fit do not depend on how the
// input lies in space.
struct Node_frame
{
  Vector origin, x_axis, y_axis, z_axis;
  double size;

  Node_frame(const Vector& origin, const Vector& z_axis, const Vector& towards, const double size)
    : origin(origin), z_axis(z_axis), size(size)
  {
    const Vector d = towards - origin;
    x_axis = d - d.dot(z_axis) * z_axis;
    const double norm = x_axis.norm();
    // relative to the neighbour's distance: a neighbour straight above gives no direction
    constexpr double least_slope = 1e-6;
    x_axis = norm > least_slope * d.norm() ? Vector(x_axis / norm) : any_normal(z_axis);
    y_axis = z_axis.cross(x_axis);
  }

  Vector local(const Vector& p) const
  {
    const Vector d = (p - origin) / size;
    return Vector(d.dot(x_axis), d.dot(y_axis), d.dot(z_axis));
  }

  // slopes of the surface with this normal; false if it is nearly in the plane of the frame, where
  // its slopes carry no information
  bool slopes_of_normal(const Vector& normal, double& p, double& q) const
  {
    constexpr double least_cosine = 0.2;
    const double nz = normal.dot(z_axis);
    if(!(nz > least_cosine))
      return false;
    p = -normal.dot(x_axis) / nz;
    q = -normal.dot(y_axis) / nz;
    return true;
  }

  Vector normal_of_slopes(const double p, const double q) const
  {
    return (z_axis - p * x_axis - q * y_axis).normalized();
  }
};

// The nodes around a node, ring after ring. Singular ones are positions like others, but are not crossed:
// what is on the other side of an apex tells nothing of this side. Nor are tangent nodes. One object serves many nodes.
class Node_neighborhood
{
  const Cut_mesh& m_cut_mesh;
  const std::vector<Node>& m_nodes;
  std::vector<int> m_neighbors;
  std::size_t m_first_of_last_ring = 0;
  bool m_has_apex = false;
  std::vector<int> m_mark;              // the query that has seen a node last
  int m_query = 0;

public:
  Node_neighborhood(const Cut_mesh& cut_mesh, const std::vector<Node>& nodes)
    : m_cut_mesh(cut_mesh), m_nodes(nodes), m_mark(nodes.size(), 0)
  {}

  // starts again with the first rings of a node
  void collect(const int node, const int number_of_rings)
  {
    m_neighbors.clear();
    m_first_of_last_ring = 0;
    m_has_apex = false;
    m_mark[node] = ++m_query;
    add_ring_of(node);
    for(int ring = 1; ring < number_of_rings; ++ring)
      add_ring();
  }

  // the ring around the last one
  void add_ring()
  {
    const std::size_t end = m_neighbors.size();
    for(std::size_t i = m_first_of_last_ring; i < end; ++i)
      if(!m_nodes[m_neighbors[i]].is_tangent)
        add_ring_of(m_neighbors[i]);
    m_first_of_last_ring = end;
  }

  const std::vector<int>& neighbors() const { return m_neighbors; }
  int size() const { return static_cast<int>(m_neighbors.size()); }

  // a neighbour is singular
  bool has_apex() const { return m_has_apex; }

private:
  void add_ring_of(const int node)
  {
    if(m_nodes[node].is_singular)
      return;
    for(const int j : m_cut_mesh.ring(node))
      if(m_mark[j] != m_query)
      {
        m_mark[j] = m_query;
        m_neighbors.push_back(j);
        m_has_apex = m_has_apex || m_nodes[j].is_singular;
      }
  }
};

// Coordinates of the plane of a frame in which the neighbours are spread equally in all directions: without
// them a quartic over stretched triangles looks as if it were not determined. They are L^-1 (x,y), where
// L L^T is the mean of (x,y) (x,y)^T.
class Spread
{
  double m_xx = 0., m_yx = 0., m_yy = 0.;             // of L

public:
  Spread(const Node_frame& frame, const Node_neighborhood& neighborhood, const std::vector<Node>& nodes)
  {
    double xx = 0., xy = 0., yy = 0.;
    for(const int j : neighborhood.neighbors())
    {
      const Vector x = frame.local(nodes[j].position) / std::sqrt(double(neighborhood.size()));
      xx += x[0] * x[0];
      xy += x[0] * x[1];
      yy += x[1] * x[1];
    }
    m_xx = std::sqrt(xx);
    m_yx = xx > 0. ? xy / m_xx : 0.;
    m_yy = std::sqrt((std::max)(0., yy - m_yx * m_yx));
  }

  // not all on one line
  bool is_regular() const
  {
    constexpr double least_ratio = 1e-6;
    return m_yy > least_ratio * m_xx && m_xx > least_ratio * m_yy;
  }

  // from the x axis to the direction in which they are spread most; 0 where that is the same in all, but for rounding
  double principal_angle() const
  {
    constexpr double noticeable_part = 1e-6;
    const double xx = m_xx * m_xx, twice_xy = 2. * m_xx * m_yx, yy = m_yx * m_yx + m_yy * m_yy;
    return std::hypot(twice_xy, xx - yy) > noticeable_part * (xx + yy) ? std::atan2(twice_xy, xx - yy) / 2. : 0.;
  }

  Eigen::Vector2d equalized(const Vector& x) const
  {
    const double u = x[0] / m_xx;
    return Eigen::Vector2d(u, (x[1] - m_yx * u) / m_yy);
  }

  // with the slopes in these coordinates
  Vector normal_of_slopes(const Node_frame& frame, const double p, const double q) const
  {
    const double slope_y = q / m_yy;
    return frame.normal_of_slopes((p - m_yx * slope_y) / m_xx, slope_y);
  }
};

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_MODEL_NODE_NEIGHBORHOOD_H
