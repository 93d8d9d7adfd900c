// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_MODEL_REFERENCE_SURFACE_H
#define CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_MODEL_REFERENCE_SURFACE_H

#include <CGAL/Hermite_diffuse_remeshing/Model_choices.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Model/Interpolation_weights.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Model/Local_quadric.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Model/find_flat_nodes.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Model/node_normals.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Progress.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Hermite_diffuse_remeshing {

namespace internal {

struct Model_options
{
  int degree = 3;                                     // 2, 3 or 4
  int exponent = 2;                                   // of w/(1-w): 1 or 2
  double hermite_weight = 0.3;                        // t: slopes against positions
  Normal_estimation normals = FITTED_NORMALS;
  double combined_weight = 1.;                        // of the combined equations of `Local_polynomial`
  bool has_soft_degree = true;                        // terms of order three are damped where they are
                                                      // not determined, see `soft_degree()`
  bool is_solved_at_centroids = false;                // the paper's: one polynomial of degree 2 per face,
                                                      // which jumps across edges
  double maximum_displacement = std::numeric_limits<double>::infinity();   // of points over the facets
  bool is_parallel = false;                           // with threads of TBB, where it is linked
};

// The frozen copy of the input with its nodes: the Hermite diffuse interpolation, evaluated anew at
// every query in a frame that is blended from the corners' normals. The evaluated surface is
// continuous across edges to rounding and interpolates the nodes and their normals. Its heights over the facets may
// be bounded.
class Reference_surface
{
  Indexed_triangles m_triangles;
  Cut_mesh m_cut_mesh;
  std::vector<Node> m_nodes;
  Interpolation_weights m_weights;
  std::vector<char> m_is_flat;                        // of the nodes
  Model_options m_options;
  std::vector<Local_quadric> m_quadrics;              // of the faces, if they are solved at centroids

  // Slopes of a normal that lies nearly in the plane of the frame carry no information. The frame turns with
  // the query, so they fade: a node that came in or went out at once would break the surface.
  static constexpr double least_cosine = 0.2, trusted_cosine = 0.5;
  static constexpr double ridge = 1e-9;
  // An ill-conditioned fit over a folded ring is no more than amplified rounding and noise. Fits on stretched
  // meshes, six to one, have pivots of 5e-5 and more.
  static constexpr double incredible_pivot = 1e-7, credible_pivot = 1e-5;
  // Pivots depend on the directions of x and y: over faces that are stretched obliquely to them they are smaller than
  // along the principal axes, by less than this is above credible ones.
  static constexpr double doubtful_pivot = 1e-4;

public:
  Reference_surface(Indexed_triangles triangles, Cut_mesh cut_mesh,
                    const std::vector<Vertex_class>& vertex_classes, const Model_options& options,
                    const Known_normals& known_normals = Known_normals(),
                    const Progress& progress = Progress())
    : m_triangles(std::move(triangles)), m_cut_mesh(std::move(cut_mesh)),
      m_nodes(make_nodes(m_triangles, m_cut_mesh, vertex_classes)), m_options(options)
  {
    Neighbors_on_lines on_lines = estimate_node_normals(m_triangles, m_cut_mesh, options.normals, known_normals,
                                                        options.is_parallel, progress, m_nodes);
    m_is_flat = find_flat_nodes(m_cut_mesh, m_nodes);
    m_weights = Interpolation_weights(m_cut_mesh, m_nodes, m_is_flat, m_triangles.number_of_faces(), std::move(on_lines),
                                      options.is_parallel, progress.part(0., 0.));
    if(!options.is_solved_at_centroids)
      return;
    m_options.combined_weight = 0.;     // the paper has none
    std::vector<Local_quadric> quadrics(m_triangles.triangles.size());
    for_each_index(m_triangles.number_of_faces(), options.is_parallel, [&]
    {
      return [&](const int f) { quadrics[f] = solve({f, {{1. / 3., 1. / 3., 1. / 3.}}}); };
    }, progress.part(1., 1.));
    m_quadrics.swap(quadrics);
  }

  const Indexed_triangles& triangles() const { return m_triangles; }
  const Cut_mesh& cut_mesh() const { return m_cut_mesh; }
  const std::vector<Node>& nodes() const { return m_nodes; }
  const Node& node(const int i) const { return m_nodes[i]; }
  const Node& node(const int face, const int corner) const { return m_nodes[m_cut_mesh.node(face, corner)]; }
  const Model_options& options() const { return m_options; }

  // the first of its corners
  Location location_of_node(const int i) const
  {
    return location_of_corner(*m_cut_mesh.corners(i).begin());
  }

  // Normal blended from the corners' normals, not a fit: one or two degrees from the fitted one,
  // at a tenth of the price.
  Vector blended_normal(const Location& location) const
  {
    return blended_normal(location, sum_of_normals(location));
  }

  // for the price of longer evaluations
  void save_memory() { m_weights.forget(); }

  // calls `visit(node, weight)` for the nodes that influence a point
  template <typename Visit>
  void visit_weights(const Location& location, const Visit& visit) const
  {
    m_weights.for_each(m_cut_mesh, m_nodes, location, visit);
  }

  Local_quadric evaluate(const Location& location) const
  {
    Local_quadric result = evaluate_unbounded(location);
    if(saturation().is_bounded())
      result = result.saturated(m_triangles.point(location), m_triangles.area_vector(location.face), saturation());
    return result;
  }

  // Whatever the bound of the heights: this is what the facets stand for, of which curvatures are asked.
  Local_quadric evaluate_unbounded(const Location& location) const
  {
    return m_quadrics.empty() ? solve(location)
                              : m_quadrics[location.face].expanded_at(m_triangles.point(location));
  }

  Saturation saturation() const { return Saturation(m_options.maximum_displacement); }

private:
  // from 0 to 1
  static double fade(const double x, const double first, const double last)
  {
    const double u = last > first ? (std::max)(0., (std::min)(1., (x - first) / (last - first))) : 1.;
    return u * u * (3. - 2. * u);
  }
  static double trust(const double cosine)
  {
    return cosine >= trusted_cosine ? 1. : fade(cosine, least_cosine, trusted_cosine);
  }

  Vector sum_of_normals(const Location& location) const
  {
    Vector sum = Vector::Zero();
    for(int k = 0; k < 3; ++k)
      sum += location.coordinates[k] * node(location.face, k).normal;
    return sum;
  }

  // Is what would be fitted at a location on a plane, and so the plane? On an edge this depends on its ends only, so that
  // both faces say the same.
  bool is_flat(const Location& location) const
  {
    for(int k = 0; k < 3; ++k)
      if(location.coordinates[k] > 0. && !m_is_flat[m_cut_mesh.node(location.face, k)])
        return false;
    return true;
  }

  // of the corners that count, by number: on an edge the same for both faces
  int first_node(const Location& location) const
  {
    int result = m_cut_mesh.number_of_nodes();
    for(int k = 0; k < 3; ++k)
      if(location.coordinates[k] > 0.)
        result = (std::min)(result, m_cut_mesh.node(location.face, k));
    return result;
  }

  // what the corners that have a normal add to its sum: less than one near an apex
  double weight_of_normals(const Location& location) const
  {
    double weight = 0.;
    for(int k = 0; k < 3; ++k)
      if(node(location.face, k).has_normal())
        weight += location.coordinates[k];
    return weight;
  }

  Vector blended_normal(const Location& location, const Vector& sum) const
  {
    // where the normals cancel
    constexpr double least_norm = 1e-3;
    // at an apex, whose own coordinates are known to rounding only, or where all corners are singular
    constexpr double least_weight = 1e-8;
    const double norm = sum.norm(), weight = weight_of_normals(location);
    return weight > least_weight && norm > least_norm * weight
             ? Vector(sum / norm)
             : Vector(m_triangles.area_vector(location.face).stableNormalized());
  }

  // Where the normals of the corners nearly cancel, as on a face that is folded over, the frame turns by half a circle
  // and the fit with it: no height over the facet means anything there, and heights of ten edges occur. Between
  // two corners the norm of the blended normal is the cosine of half the angle between theirs at least: fits fade from
  // an angle of 110 degrees on. Apices have no normal, and take no part.
  double credibility(const Location& location, const Vector& sum) const
  {
    constexpr double incredible_norm = 0.45, credible_norm = 0.57;
    const double norm = sum.norm();
    if(norm >= credible_norm)
      return 1.;
    const double weight = weight_of_normals(location);
    return fade(norm, incredible_norm * weight, credible_norm * weight);
  }

  Local_quadric solve(const Location& location) const
  {
    Local_quadric result;
    const Vector sum = sum_of_normals(location);
    result.origin = m_triangles.point(location);
    result.z_axis = blended_normal(location, sum);
    result.x_axis = any_normal(result.z_axis);
    result.y_axis = result.z_axis.cross(result.x_axis);

    double weight = 0., size = 0., between_singular = 0.;
    Blended blended;
    for(int k = 0; k < 3; ++k)
    {
      if(node(location.face, k).is_singular && node(location.face, next(k)).is_singular)
        between_singular += location.coordinates[k] * location.coordinates[next(k)];
      const Node& corner = node(location.face, k);
      blended.cubic_ridge += location.coordinates[k] * corner.cubic_ridge();
      blended.combined_weight += location.coordinates[k] * corner.combined_share * m_options.combined_weight;
      blended.apex_share += location.coordinates[k] * corner.is_near_apex;
      if(corner.is_singular)
        continue;
      weight += location.coordinates[k];
      size += location.coordinates[k] * corner.size;
    }
    if(!(weight > 0.))
      return result;                    // at an apex: the vertex itself
    result.size = size / weight;
    if(is_flat(location))
    {
      // what rounding of the coordinates moved off the plane returns to it
      const Vector& on_plane = m_nodes[first_node(location)].position;
      result.a[0] = (on_plane - result.origin).dot(result.z_axis) / result.size;
      return result;
    }

    double pivot = fit(location, blended, result);
    if(pivot < doubtful_pivot)
    {
      turn_to_principal_axes(location, result);
      pivot = fit(location, blended, result);
    }
    // An edge between two apices is straight, as no normal is known there. The fit beside it is led to it: this
    // factor is zero on that edge and one on the two others.
    const double straightness = between_singular > 0. ? weight / (weight + between_singular) : 1.;
    const double part = straightness * credibility(location, sum) * fade(pivot, incredible_pivot, credible_pivot);
    if(part < 1.)
      for(double& a : result.a)
        a *= part;
    return result;
  }

  // what the corners of a face say of the fit, blended by the barycentric coordinates
  struct Blended
  {
    double cubic_ridge = 0., combined_weight = 0.;
    double apex_share = 0.;               // in [0,1]: of the `agreement()` in the weights of nodes
  };

  // Solves for the coefficients, in the frame that is there, and returns the smallest pivot.
  double fit(const Location& location, const Blended& blended, Local_quadric& result) const
  {
    switch(m_options.degree)
    {
      case 2:  return fit_of_degree<2>(location, blended, result);
      case 4:  return fit_of_degree<4>(location, blended, result);
      default: return fit_of_degree<3>(location, blended, result);
    }
  }

  template <int Degree>
  double fit_of_degree(const Location& location, const Blended& blended, Local_quadric& result) const;

  // of the nodes that are fitted
  void turn_to_principal_axes(const Location& location, Local_quadric& frame) const
  {
    double xx = 0., xy = 0., yy = 0.;
    visit_weights(location, [&](const int i, const double weight)
    {
      const Vector d = m_nodes[i].position - frame.origin;
      const double x = d.dot(frame.x_axis), y = d.dot(frame.y_axis);
      xx += weight * x * x;
      xy += weight * x * y;
      yy += weight * y * y;
    });
    const double angle = angle_of_larger_axis(xx, xy, yy);
    frame.x_axis = std::cos(angle) * frame.x_axis + std::sin(angle) * frame.y_axis;
    frame.y_axis = frame.z_axis.cross(frame.x_axis);
  }
};

template <int Degree>
double Reference_surface::fit_of_degree(const Location& location, const Blended& blended, Local_quadric& result) const
{
  typedef typename Local_polynomial<Degree>::Pair Pair;
  const double t = m_options.hermite_weight;
  const double inverse_size = 1. / result.size;
  Local_polynomial<Degree> polynomial;
  double total_weight = 0.;
  const auto add_two_nodes = [&](const Node& a, const Node& b, const double weight_of_a, const double weight_of_b)
  {
    // in steps, which compilers inline in larger programs, too
    const auto along = [](const std::array<Pair, 3>& v, const Vector& axis)
    {
      Pair sum = axis[0] * v[0];
      sum += axis[1] * v[1];
      sum += axis[2] * v[2];
      return sum;
    };
    std::array<Pair, 3> d, n;
    for(int i = 0; i < 3; ++i)
    {
      d[i] = inverse_size * (Pair(a.position[i], b.position[i]) - result.origin[i]);
      n[i] = Pair(a.normal[i], b.normal[i]);
    }
    const Pair x = along(d, result.x_axis), y = along(d, result.y_axis), z = along(d, result.z_axis);
    const Pair nz = along(n, result.z_axis);
    Pair omega = interpolating_weights(Pair(weight_of_a, weight_of_b), m_options.exponent);
    if(blended.apex_share > 0.)
      omega *= 1. - blended.apex_share * (1. - Pair(a.has_normal() ? agreement(nz[0]) : 1., b.has_normal() ? agreement(nz[1]) : 1.));
    total_weight += (std::min)(1., omega[0]);
    total_weight += (std::min)(1., omega[1]);
    const Pair trusted = omega * Pair(trust(nz[0]), trust(nz[1]));
    const Pair minus_inverse_nz = -1. / nz.max(least_cosine);
    // The combined equation multiplies errors of slopes by the distance, those of positions by the
    // order: on stretched faces, where some nodes are several sizes away, its weight must fall.
    const Pair r2 = x * x + y * y;
    polynomial.add_two(x, y, z, (1. - t) * omega, along(n, result.x_axis) * minus_inverse_nz,
                       along(n, result.y_axis) * minus_inverse_nz, t * trusted,
                       blended.combined_weight * trusted / (1. + r2 * r2));
  };
  const Node* waiting = nullptr;        // for a second one
  double weight_of_waiting = 0.;
  visit_weights(location, [&](const int i, const double weight)
  {
    const Node& node = m_nodes[i];
    if(waiting == nullptr)
    {
      waiting = &node;
      weight_of_waiting = weight;
      return;
    }
    add_two_nodes(*waiting, node, weight_of_waiting, weight);
    waiting = nullptr;
  });
  if(waiting != nullptr)
    add_two_nodes(*waiting, *waiting, weight_of_waiting, 0.);
  // the ridge is relative to the weight of the data, which changes continuously with the query
  polynomial.add_ridge(2, ridge, total_weight);
  for(int order = 3; order <= Degree; ++order)
    polynomial.add_ridge(order, m_options.has_soft_degree ? blended.cubic_ridge : ridge, total_weight);
  const double pivot = polynomial.solve();
  for(int i = 0; i < 6; ++i)
    result.a[i] = pivot > 0. ? polynomial[i] : 0.;
  return pivot;
}

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_MODEL_REFERENCE_SURFACE_H
