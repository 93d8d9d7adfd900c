// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_MODEL_NORMAL_FITTER_H
#define CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_MODEL_NORMAL_FITTER_H

#include <CGAL/Hermite_diffuse_remeshing/internal/Model/Local_polynomial.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Model/Node_neighborhood.h>

#include <CGAL/number_type_basic.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace CGAL {
namespace Hermite_diffuse_remeshing {
namespace internal {

struct Fitted_normal
{
  Vector normal;
  double signal_over_noise;      // of the positions around, see `Normal_fitter::signal_over_noise()`
};

class Normal_fitter
{
  const Cut_mesh& m_cut_mesh;
  const std::vector<Node>& m_nodes;
  const std::vector<Vector>& m_max_normals;
  Node_neighborhood m_neighborhood;
  bool m_is_open = false;               // the node whose neighbourhood it is

  // spare neighbours beyond the number of unknowns
  static constexpr int surplus = 3;
  // keeps the weight 1/d^2 finite; relative to the node's size, squared
  static constexpr double weight_floor = 1e-6;

public:
  Normal_fitter(const Cut_mesh& cut_mesh, const std::vector<Node>& nodes,
                const std::vector<Vector>& max_normals)
    : m_cut_mesh(cut_mesh), m_nodes(nodes), m_max_normals(max_normals), m_neighborhood(cut_mesh, nodes)
  {}

  // A fit of degree 4; where it is not determined, or turns the normal too far, lower ones take over
  // gradually, and in the end the Max normal.
  Fitted_normal operator()(const int node)
  {
    // a border node sees one side only, and a node of few neighbours few points: they look further
    m_neighborhood.collect(node, m_cut_mesh.is_open(node) ? 3 : 2);
    if(!has_enough<4>())
      m_neighborhood.add_ring();
    // whatever would be fitted, it is the plane
    if(is_in_plane(node))
      return {m_max_normals[node], 0.};
    const Node_frame frame(m_nodes[node].position, m_max_normals[node],
                           m_nodes[*m_cut_mesh.ring(node).begin()].position, m_nodes[node].size);
    const double turn = mean_turn(frame.z_axis);
    // A mesh can be too coarse for a polynomial over the neighbourhood. Where the normals there differ
    // from the node's by 38 degrees (rms), a fit is as wrong as the Max normal on average, beyond it
    // gets worse fast. From 32 to 45 degrees the fit gives way gradually, so that no rounding decides.
    constexpr double largest_turn_of_all = 0.152, largest_turn_of_any = 0.293;        // 1 - cosine
    const double share = is_between_rims(node) ? 0. : ramp(turn, largest_turn_of_any, largest_turn_of_all);
    Fitted_normal result = {(1. - share) * frame.z_axis, 0.};
    m_is_open = m_cut_mesh.is_open(node);
    const double rest = add_fit<2>(frame, add_fit<3>(frame, add_fit<4>(frame, share, result), result), result);
    result.normal = (result.normal + rest * frame.z_axis).normalized();
    // terms of order four say nothing of a surface that the mesh hardly resolves
    constexpr double largest_turn_of_signal = 0.14;
    result.signal_over_noise *= ramp(turn, largest_turn_of_all, largest_turn_of_signal);
    return result;
  }

private:
  // with its neighbourhood
  bool is_in_plane(const int node) const
  {
    const std::vector<int>& neighbors = m_neighborhood.neighbors();
    return std::all_of(neighbors.begin(), neighbors.end(), [&](const int j)
                       { return m_nodes[node].sees_in_plane(m_nodes[j].position, m_max_normals[node]); });
  }

  // mean of 1 - cosine of the angles between the Max normals around and the node's
  double mean_turn(const Vector& normal) const
  {
    double turn = 0., weights = 0.;
    for(const int j : m_neighborhood.neighbors())
    {
      if(m_nodes[j].is_singular)
        continue;
      const double cosine = normal.dot(m_max_normals[j]);
      const double weight = m_neighborhood.has_apex() ? agreement(cosine) : 1.;
      turn += weight * (1. - cosine);
      weights += weight;
    }
    return weights > 0. ? turn / weights : 0.;
  }

  // of the position of neighbour j, which is x in the frame
  double weight(const Node_frame& frame, const int j, const Vector& x) const
  {
    const double weight = 1. / (x.squaredNorm() + weight_floor);
    return m_neighborhood.has_apex() && !m_nodes[j].is_singular
         ? weight * agreement(frame.z_axis.dot(m_max_normals[j])) : weight;
  }

  // Where all positions lie on the two rims of a strip, one row of facets wide, they say nothing of what is between the
  // rims, whatever the pivots: on a strip of a helicoid fits came out wrong by 9 degrees, and Max normals by half a degree.
  bool is_between_rims(const int node) const
  {
    const std::vector<int>& neighbors = m_neighborhood.neighbors();
    return m_cut_mesh.is_open(node)
        && std::all_of(neighbors.begin(), neighbors.end(), [this](const int j) { return m_cut_mesh.is_open(j); });
  }

  template <int Degree>
  bool has_enough() const { return m_neighborhood.size() >= Local_polynomial<Degree>::size - 1 + surplus; }

  template <int Degree>
  double add_fit(const Node_frame& frame, double share, Fitted_normal& result) const;

  // calls `visit(x, y, z, weight)` for the neighbours
  template <typename Visit>
  void visit_positions(const Node_frame& frame, const Spread& spread, const Visit& visit) const
  {
    for(const int j : m_neighborhood.neighbors())
    {
      const Vector x = frame.local(m_nodes[j].position);
      const Eigen::Vector2d u = spread.equalized(x);
      visit(u[0], u[1], x[2], weight(frame, j, x));
    }
  }

  // x, y, z, weight
  Eigen::Matrix<double, Eigen::Dynamic, 4> positions(const Node_frame& frame, const Spread& spread) const
  {
    Eigen::Matrix<double, Eigen::Dynamic, 4> result(m_neighborhood.size(), 4);
    int row = 0;
    visit_positions(frame, spread, [&](const double x, const double y, const double z, const double weight)
                    { result.row(row++) << x, y, z, weight; });
    return result;
  }

  struct Residuals
  {
    double sum = 0., weights = 0.;        // the weighted squares that a fit makes small
  };

  template <int Degree>
  Residuals residuals(const Node_frame& frame, const Spread& spread, const Local_polynomial<Degree>& polynomial) const
  {
    Residuals result;
    visit_positions(frame, spread, [&](const double x, const double y, const double z, const double weight)
    {
      result.sum += weight * CGAL::square(polynomial(x, y) - z);
      result.weights += weight;
    });
    return result;
  }

  template <int Degree>
  Local_polynomial<Degree> polynomial_of_positions(const Node_frame& frame, const Spread& spread) const
  {
    Local_polynomial<Degree> result;
    visit_positions(frame, spread, [&](const double x, const double y, const double z, const double weight)
                    { result.add_position(x, y, z, weight); });
    return result;
  }

  // From 0 to 1: do the terms of the highest order bring the fit closer to the positions than as many others would do that
  // mean nothing? From one side, what they make of noise is a slope at the border. The ratio of variances is Fisher's: 1 in
  // median if there is nothing but noise, and 2.5 to 4 in one case of twenty.
  template <int Degree>
  double significance(const Node_frame& frame, const Spread& spread, const Local_polynomial<Degree>& polynomial) const
  {
    constexpr double least_ratio = 1.5, sure_ratio = 4.;
    Local_polynomial<Degree - 1> lower = polynomial_of_positions<Degree - 1>(frame, spread);
    if(!std::isfinite(lower.solve_through_origin()))
      return 1.;
    constexpr int unknowns = Local_polynomial<Degree>::size - 1, terms_of_highest_order = Degree + 1;
    const double rest = residuals(frame, spread, polynomial).sum / (m_neighborhood.size() - unknowns);
    const double gain = residuals(frame, spread, lower).sum / terms_of_highest_order
                      - rest * (m_neighborhood.size() - unknowns) / terms_of_highest_order;
    return gain < sure_ratio * rest ? ramp(gain / rest, least_ratio, sure_ratio) : gain > 0. ? 1. : 0.;
  }

  // How far the terms of order four stand out from the residuals, at most 10. Measured on irregular meshes of
  // smooth surfaces, the ratio is 1.1 in median if there is nothing but noise; without it, from 8 on coarse
  // meshes to several hundred.
  template <int Degree>
  double signal_over_noise(const Node_frame& frame, const Spread& spread,
                           const Local_polynomial<Degree>& polynomial) const
  {
    constexpr double largest = 10.;
    // In a plane there is neither, and what rounding leaves of both must not decide: of the coordinates, which lose a few
    // units in the last place when they are turned, and terms of order four are some hundred times what they are made of.
    constexpr double part_that_rounding_makes = 1e4 * std::numeric_limits<double>::epsilon();
    const Residuals rest = residuals(frame, spread, polynomial);
    const int unknowns = Local_polynomial<Degree>::size - 1;
    const double variance = rest.sum / rest.weights * m_neighborhood.size() / (m_neighborhood.size() - unknowns)
                          + CGAL::square(part_that_rounding_makes * (1. + frame.origin.norm() / frame.size));
    const double signal = polynomial.squared_norm(Degree);
    return signal < largest * largest * variance ? std::sqrt(signal / variance) : largest;
  }
};

// Adds the normal of a fit with the part of `share` that it deserves, and returns the rest.
template <int Degree>
double Normal_fitter::add_fit(const Node_frame& frame, const double share, Fitted_normal& result) const
{
  if(!(share > 0.) || !has_enough<Degree>())
    return share;
  const Spread spread(frame, m_neighborhood, m_nodes);
  if(!spread.is_regular())
    return share;
  Local_polynomial<Degree> polynomial = polynomial_of_positions<Degree>(frame, spread);
  // Where the positions lie on few lines, such as the rows of a structured mesh, terms are not determined; from the one
  // side of a border they have variances of 1e3 to 1e5. The confidence changes with the order of magnitude. Rounding must
  // not decide: large variances do not come out well enough of the normal equations.
  double variance = polynomial.solve_through_origin();
  constexpr double largest_known_variance = 1e3;
  if(variance > largest_known_variance)
    variance = polynomial.solve_through_origin_by_orthogonalization(positions(frame, spread));
  constexpr double largest_logarithm = 5.5, largest_certain_logarithm = 4.5;           // to base 10
  const double is_determined = ramp(std::log10(variance), largest_logarithm, largest_certain_logarithm);
  if(!(is_determined > 0.))
    return share;
  const Vector normal = spread.normal_of_slopes(frame, polynomial[1], polynomial[2]);
  // a fit that turns the normal by more than 20 degrees has left the neighbourhood it can describe
  constexpr double cosine_of_15_degrees = 0.96592582628906831, cosine_of_20_degrees = 0.93969262078590838;
  double part = share * is_determined * ramp(normal.dot(frame.z_axis), cosine_of_20_degrees, cosine_of_15_degrees);
  if constexpr(Degree > 2)
    if(m_is_open && part > 0.)
      part *= significance(frame, spread, polynomial);
  result.normal += part * normal;
  if(Degree == 4)
    result.signal_over_noise = part * signal_over_noise(frame, spread, polynomial);
  return share - part;
}

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_MODEL_NORMAL_FITTER_H
