// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_MODEL_NODE_NORMALS_H
#define CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_MODEL_NODE_NORMALS_H

#include <CGAL/Hermite_diffuse_remeshing/Model_choices.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Model/Local_polynomial.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Model/Normal_fitter.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Model/Tangent_nodes.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Model/end_tangents.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/for_each_index.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace CGAL {
namespace Hermite_diffuse_remeshing {

namespace internal {

// Normal of the fan of faces of a node, weighted by area or by Max's weights. These are large for
// thin faces: one that is turned against the others, as a needle may be that is folded over, takes no part.
inline Vector fan_normal(const Indexed_triangles& surface, const Cut_mesh& cut_mesh,
                         const int node, const bool use_area)
{
  const auto sum_up = [&](const auto& weigh)
  {
    Vector sum = Vector::Zero();
    visit_fan(surface, cut_mesh, node, [&](const int, const Vector& u, const Vector& v)
              { sum += weigh(u, v, u.cross(v)) * u.cross(v); });
    return sum;
  };
  const Vector sum_of_area = sum_up([](const Vector&, const Vector&, const Vector&) { return 1.; });
  Vector sum = Vector::Zero();
  if(!use_area)
    sum = sum_up([&](const Vector& u, const Vector& v, const Vector& n)
    { return n.dot(sum_of_area) >= 0. ? max_weight(u, v) : 0.; });
  if(!(sum.norm() > 0.))
    sum = sum_of_area;
  const double norm = sum.norm();
  return norm > 0. ? Vector(sum / norm) : Vector(Vector::Zero());
}

// The normal of a node from a Hermite fit over its ring that leaves its own normal out
template <int Degree>
Vector smoothed_normal(const Cut_mesh& cut_mesh, const std::vector<Node>& nodes, const std::vector<Vector>& normals,
                       const int i)
{
  constexpr double slope_weight = 0.5, relative_ridge = 1e-9;
  const Index_range ring = cut_mesh.ring(i);
  const Node_frame frame(nodes[i].position, normals[i], nodes[*ring.begin()].position, nodes[i].size);
  Local_polynomial<Degree> polynomial;
  polynomial.add_position(0., 0., 0., 1. - slope_weight);
  for(const int j : ring)
  {
    const Vector x = frame.local(nodes[j].position);
    polynomial.add_position(x[0], x[1], x[2], 1. - slope_weight);
    double p, q;
    if(frame.slopes_of_normal(normals[j], p, q))
      polynomial.add_slopes(x[0], x[1], p, q, slope_weight);
  }
  polynomial.add_ridge(2, relative_ridge, double(ring.size() + 1));
  return polynomial.solve() > 0. ? frame.normal_of_slopes(polynomial[1], polynomial[2]) : normals[i];
}

// One sweep of Jacobi: every normal from those around, so that noise is averaged
inline std::vector<Vector> smoothed_normals(const Cut_mesh& cut_mesh, const std::vector<Node>& nodes,
                                            const std::vector<Vector>& normals, const bool is_parallel,
                                            const Progress& progress)
{
  std::vector<Vector> result(normals);
  for_each_index(cut_mesh.number_of_nodes(), is_parallel, [&]
  {
    return [&](const int i)
    {
      if(normals[i] != Vector::Zero())
        result[i] = smoothed_normal<2>(cut_mesh, nodes, normals, i);
    };
  }, progress);
  return result;
}

// The normal that the user gives for a vertex, on the side of a node and whichever of the faces' sides it is on. A vertex on
// a feature has several nodes and one normal: it belongs to those whose faces it is nearly normal to. Elsewhere facets may
// be as coarse as they like, but a normal that lies nearly in them tells nothing.
inline Vector given_normal(const std::vector<Vector>& vertex_normals, const Cut_mesh& cut_mesh, const int node,
                           const bool is_only_node, const Vector& fan_normal)
{
  constexpr double least_cosine_at_feature = 0.86602540378443865, least_cosine = 0.5;      // of 30 and 60 degrees
  if(vertex_normals.empty())
    return Vector::Zero();
  const Vector& normal = vertex_normals[cut_mesh.vertex(node)];
  const double cosine = normal.dot(fan_normal);
  if(std::abs(cosine) < (is_only_node ? least_cosine : least_cosine_at_feature))
    return Vector::Zero();
  return cosine > 0. ? normal : Vector(-normal);
}

// Sets the normals of tangent nodes, and fits those of the nodes near them anew, on their side of the lines alone.
inline Neighbors_on_lines mend_normals_at_tangent_lines(const Indexed_triangles& surface, const Cut_mesh& cut_mesh,
                                                        const std::vector<Vector>& max_normals,
                                                        const std::vector<bool>& is_given, const bool is_parallel,
                                                        const Progress& progress, std::vector<Node>& nodes,
                                                        std::vector<double>& signal_over_noise)
{
  const Tangent_nodes tangent_nodes(surface, cut_mesh, nodes, max_normals, is_given, is_parallel, progress);
  std::vector<bool> is_near(nodes.size(), false);
  for(const int i : tangent_nodes.nodes())
  {
    nodes[i].is_tangent = true;
    for(const int j : cut_mesh.ring(i))
    {
      is_near[j] = true;
      for(const int k : cut_mesh.ring(j))
        is_near[k] = true;
    }
  }
  // An angle in radians. Beside a line the neighbours are on one side, and of few rows; where that turns a fit away
  // from the Max normal, this is better.
  constexpr double trusted_turn = 0.06, distrusted_turn = 0.12;
  Normal_fitter fitter(cut_mesh, nodes, max_normals);
  for(int i = 0; i < cut_mesh.number_of_nodes(); ++i)
    if(nodes[i].has_normal() && !is_given[i])
    {
      const bool leans = tangent_nodes.has_turned(i);
      nodes[i].normal = tangent_nodes.normal(i);
      if(!is_near[i] || nodes[i].is_tangent || leans)
        continue;
      const Fitted_normal fitted = fitter(i);
      signal_over_noise[i] = fitted.signal_over_noise;
      const double share = ramp((fitted.normal - max_normals[i]).norm(), distrusted_turn, trusted_turn);
      nodes[i].normal = (share * fitted.normal + (1. - share) * max_normals[i]).normalized();
    }
  return tangent_nodes.neighbors_on_lines();
}

// What is known before the normals are estimated
struct Known_normals
{
  std::vector<Vector> of_vertices;            // unit, or zero where the user gives none; or no vector at all
  std::vector<End_tangents> end_tangents;
};

// Sets the normals of all nodes: those that the user gives, and estimates of the others. These are
// always computed from the Max normals of all nodes, never from normals that were just updated: the
// result does not depend on the order of the nodes. Returns the neighbours that tangent nodes have on their lines.
inline Neighbors_on_lines estimate_node_normals(const Indexed_triangles& surface, const Cut_mesh& cut_mesh,
                                                const Normal_estimation estimation,
                                                const Known_normals& known_normals, const bool is_parallel,
                                                const Progress& progress, std::vector<Node>& nodes)
{
  const int n = cut_mesh.number_of_nodes();
  std::vector<Vector> normals(n, Vector::Zero());
  for_each_index(n, is_parallel, [&]
  {
    return [&](const int i)
    {
      if(!nodes[i].is_singular)
        normals[i] = fan_normal(surface, cut_mesh, i, estimation == AREA_NORMALS);
    };
  }, progress.part(0., 0.));

  std::vector<int> number_of_nodes(known_normals.of_vertices.size(), 0);     // of the vertices
  if(!number_of_nodes.empty())
    for(int i = 0; i < n; ++i)
      ++number_of_nodes[cut_mesh.vertex(i)];
  std::vector<bool> is_given(n);
  for(int i = 0; i < n; ++i)
  {
    nodes[i].normal = given_normal(known_normals.of_vertices, cut_mesh, i,
                                   !number_of_nodes.empty() && number_of_nodes[cut_mesh.vertex(i)] == 1, normals[i]);
    is_given[i] = nodes[i].has_normal();
  }

  if(estimation == SMOOTH_NORMALS)
  {
    constexpr int number_of_sweeps = 3;
    for(int sweep = 0; sweep < number_of_sweeps; ++sweep)
      normals = smoothed_normals(cut_mesh, nodes, normals, is_parallel,
                                 progress.part(double(sweep) / number_of_sweeps, (sweep + 1.) / number_of_sweeps));
  }
  if(estimation == FITTED_NORMALS)
    correct_normals_at_ends(known_normals.end_tangents, normals);
  std::vector<double> signal_over_noise(n, 0.);
  const auto make_worker = [&]
  {
    return [&, fitter = Normal_fitter(cut_mesh, nodes, normals)](const int i) mutable
    {
      Node& node = nodes[i];
      if(normals[i] == Vector::Zero())
        return;
      const Fitted_normal fitted = estimation == FITTED_NORMALS ? fitter(i) : Fitted_normal{normals[i], 0.};
      signal_over_noise[i] = fitted.signal_over_noise;
      if(!node.has_normal())
        node.normal = fitted.normal;
    };
  };
  for_each_index(n, is_parallel, make_worker, progress);
  Neighbors_on_lines on_lines;
  if(estimation == FITTED_NORMALS)
    on_lines = mend_normals_at_tangent_lines(surface, cut_mesh, normals, is_given, is_parallel, progress.part(1., 1.), nodes,
                                             signal_over_noise);

  // Combined equations remove the influence of terms of order four and amplify noise. A single ratio is
  // uncertain: the mean over the ring tells noise, 1.3, from meshes without, 4 on the coarsest.
  constexpr double none = 3.3, all = 4.3;
  for(int i = 0; i < n; ++i)
  {
    double sum = signal_over_noise[i];
    for(const int j : cut_mesh.ring(i))
      sum += signal_over_noise[j];
    nodes[i].combined_share = static_cast<float>(ramp(sum / (1 + cut_mesh.ring(i).size()), none, all));
  }
  return on_lines;
}

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_MODEL_NODE_NORMALS_H
