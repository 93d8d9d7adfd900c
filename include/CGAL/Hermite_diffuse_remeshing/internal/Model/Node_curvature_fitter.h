// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_MODEL_NODE_CURVATURE_FITTER_H
#define CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_MODEL_NODE_CURVATURE_FITTER_H

#include <CGAL/Hermite_diffuse_remeshing/internal/Model/Reference_surface.h>

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace Hermite_diffuse_remeshing {
namespace internal {

// Curvature at nodes by a larger fit than that of `Reference_surface`: Hermite data of two rings,
// three at a border, in the frame of the node's own normal, through the node. Its error is about five
// times smaller on clean meshes. The degree is 4, but 3 where the normals are smoothed: noise asks
// for fewer coefficients.
class Node_curvature_fitter
{
  const Reference_surface& m_surface;
  Node_neighborhood m_neighborhood;

public:
  explicit Node_curvature_fitter(const Reference_surface& surface)
    : m_surface(surface), m_neighborhood(surface.cut_mesh(), surface.nodes())
  {}

  // A node without a normal has no curvature: its Monge form is flat, with the mean normal of its faces.
  Monge_form operator()(const int node)
  {
    const Node& center = m_surface.node(node);
    if(center.is_singular || !center.has_normal())
      return evaluated(node);
    const bool is_open = m_surface.cut_mesh().is_open(node);
    m_neighborhood.collect(node, is_open ? 3 : 2);
    const Node_frame frame = principal_frame(node);
    // in one-sided neighbourhoods terms of odd orders do not cancel, and are worse than those of even ones
    const double combined_share = is_open ? 0. : center.combined_share;
    Monge_form result;
    constexpr int least_number_for_quartic = 8;
    const bool is_smooth = m_surface.options().normals == SMOOTH_NORMALS;
    if(!is_smooth && m_neighborhood.size() >= least_number_for_quartic && fit<4>(frame, combined_share, result))
      return result;
    if(fit<3>(frame, combined_share, result))
      return result;
    return evaluated(node);
  }

private:
  // Turned to the directions in which the neighbours are spread most and least. What few of them leave undetermined, as along
  // a cylinder of one row, then is one coefficient, with a pivot that tells so, and not a mix of several; and nothing
  // depends on the order in which the faces are stored.
  Node_frame principal_frame(const int node) const
  {
    const Node& center = m_surface.node(node);
    const auto ring = m_surface.cut_mesh().ring(node);
    const auto distance2 = [&](const int j) { return (m_surface.node(j).position - center.position).squaredNorm(); };
    const int nearest = *std::min_element(ring.begin(), ring.end(),
                                          [&](const int i, const int j) { return distance2(i) < distance2(j); });
    const Node_frame frame(center.position, center.normal, m_surface.node(nearest).position, center.size);
    const double angle = Spread(frame, m_neighborhood, m_surface.nodes()).principal_angle();
    return Node_frame(center.position, center.normal,
                      center.position + center.size * (std::cos(angle) * frame.x_axis + std::sin(angle) * frame.y_axis),
                      center.size);
  }

  Monge_form evaluated(const int node) const
  {
    return m_surface.evaluate_unbounded(m_surface.location_of_node(node)).monge_form();
  }

  template <int Degree>
  bool fit(const Node_frame& frame, const double combined_share, Monge_form& result) const
  {
    // own normal: exactly the frame's; own position: there is no constant term
    constexpr double own_weight = 1e8, ridge = 1e-9;
    // what the ridge determines alone, whatever the directions of the axes
    constexpr double least_pivot = 10. * ridge;
    // in 1/(d^2 + floor), d relative to the node's size: where there is noise a near neighbour
    // deserves little more trust than a far one
    const double weight_floor = m_surface.options().normals == SMOOTH_NORMALS ? 3. : 1e-6;
    const double t = m_surface.options().hermite_weight;
    // Two rings of neighbours determine the fit even with little else than combined equations: measured on
    // smooth surfaces, this weight halves the largest errors, and the median ones.
    constexpr double combined_weight = 3.;
    Local_polynomial<Degree> polynomial;
    polynomial.add_slopes(0., 0., 0., 0., t * own_weight);
    double total_weight = 0.;
    for(const int j : m_neighborhood.neighbors())
    {
      const Node& node = m_surface.node(j);
      const Vector x = frame.local(node.position);
      // What is turned away is badly described by a polynomial, also on meshes that are merely coarse: the median
      // error on a torus of 2000 faces is less than half of that without.
      const double weight = (node.has_normal() ? agreement(frame.z_axis.dot(node.normal)) : 1.)
                          / (x.squaredNorm() + weight_floor);
      total_weight += weight;
      double p, q;
      if(frame.slopes_of_normal(node.normal, p, q))
        polynomial.add_position_and_slopes(x[0], x[1], x[2], (1. - t) * weight, p, q, t * weight,
                                           combined_share * combined_weight * weight);
      else
        polynomial.add_position(x[0], x[1], x[2], (1. - t) * weight);
    }
    for(int order = 2; order <= Degree; ++order)
      polynomial.add_ridge(order, ridge, total_weight);
    if(polynomial.template solve<1>() < least_pivot)
      return false;
    result = {frame.x_axis, frame.y_axis, frame.z_axis, polynomial[1], polynomial[2],
              2. * polynomial[3] / frame.size, polynomial[4] / frame.size, 2. * polynomial[5] / frame.size};
    return true;
  }
};

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_MODEL_NODE_CURVATURE_FITTER_H
