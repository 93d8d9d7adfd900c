// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_MODEL_TANGENT_NODES_H
#define CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_MODEL_TANGENT_NODES_H

#include <CGAL/Hermite_diffuse_remeshing/internal/Model/Flat_regions.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Model/Node_data.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Model/Rises.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Model/Scatter_of_normals.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/selected_elements.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Hermite_diffuse_remeshing {
namespace internal {

// Where a plane or a cylinder ends tangentially in a fillet, tessellations have large facets on one side and small ones
// on the other. Normals that are estimated from both are turned by a part of the angle between small facets, and the
// smooth surface bulges over the large ones by this angle times their length. Here the nodes on such lines are found.
// Their normals are those of the large facets, and neither side tells anything of the other: of a
// tangent node's neighbours those have an influence that are on the line.
//
// Lines are told from places where a smooth surface is merely meshed with different sizes: there the large facets
// turn, too, and so do the normals at their other ends.
class Tangent_nodes
{
  const Indexed_triangles& m_surface;
  const Cut_mesh& m_cut_mesh;
  const std::vector<Node>& m_nodes;                   // with estimates of the normals
  const std::vector<Vector>& m_max_normals;
  Flat_regions m_regions;
  std::vector<Vector> m_normals;
  std::vector<int> m_tangent;
  Neighbors_on_lines m_on_lines;

  // between edges of a node, or between rises of the surface over them: below the first one bulges over large facets
  // are about those over small ones
  static constexpr double least_ratio = 3.3, sure_ratio = 6.;
  // of the area of the node's largest facet: from here on facets are large; those of one flat region are as large as it
  static constexpr double large_part = 0.3;
  // Of a turn: the large facets agree with each other if their normals differ by less than the first along it, and do
  // not from the second on.
  static constexpr double agreeing = 0.4, disagreeing = 0.8;
  // in radians: what rounding turns in a plane is less
  static constexpr double least_turn = 1e-6;

  // What the large facets of a node say. Along the first of two directions of their plane they agree best.
  struct Large_facets
  {
    int node;
    Vector normal;
    std::array<Vector, 2> directions;
    std::vector<Vector> normals;
    std::vector<int> neighbors, other_neighbors;      // of them, and of the small ones; both sorted
    bool is_flat;                                     // they agree in all directions
  };

  struct Candidate
  {
    Large_facets facets;
    double suspicion;
  };

public:
  // given normals stay
  Tangent_nodes(const Indexed_triangles& surface, const Cut_mesh& cut_mesh, const std::vector<Node>& nodes,
                const std::vector<Vector>& max_normals, const std::vector<bool>& is_given, const bool is_parallel,
                const Progress& progress)
    : m_surface(surface), m_cut_mesh(cut_mesh), m_nodes(nodes), m_max_normals(max_normals)
    , m_regions(surface, cut_mesh, is_parallel, progress)
  {
    for(const Node& node : nodes)
      m_normals.push_back(node.normal);
    std::vector<int> all(cut_mesh.number_of_nodes());
    std::iota(all.begin(), all.end(), 0);
    const std::vector<int> suspicious = selected_elements(all, is_parallel, [&](const int i)
    { return nodes[i].has_normal() && !is_given[i] && excess_of_rise(i) > 0.; }, progress);
    lean_on_large_facets(suspicious);
    std::vector<Vector> settled = m_normals;
    m_tangent = selected_elements(all, is_parallel, [&](const int i)
    { return nodes[i].has_normal() && has_edges_of_different_lengths(i) && is_tangent(large_facets(i), settled[i]); }, progress);
    for(const int i : m_tangent)
    {
      const Large_facets facets = large_facets(i);
      std::vector<int> on_lines;
      std::set_intersection(facets.neighbors.begin(), facets.neighbors.end(), facets.other_neighbors.begin(),
                            facets.other_neighbors.end(), std::back_inserter(on_lines));
      if(!is_corner_of_lines(i, on_lines))
        for(const int j : on_lines)
          m_on_lines.emplace_back(i, j);
    }
    for(const int i : m_tangent)
      if(!is_given[i])
        m_normals[i] = settled[i];
  }

  const Vector& normal(const int node) const { return m_normals[node]; }
  // does it differ from the estimate?
  bool has_turned(const int node) const { return (m_normals[node] - m_nodes[node].normal).norm() > least_turn; }
  const std::vector<int>& nodes() const { return m_tangent; }
  // those that belong to large facets and to small ones
  const Neighbors_on_lines& neighbors_on_lines() const { return m_on_lines; }

private:
  const Vector& position(const int node) const { return m_nodes[node].position; }
  // twice, of the facet of a corner
  double area(const int corner, const int node) const { return m_regions.area(corner / 3, m_nodes[node].size); }

  // Fits look far, and err on both sides of a line; Max's normals are good where facets are regular.
  const Vector& neighbor_normal(const int node) const
  {
    return (has_turned(node) ? m_normals : m_max_normals)[node];
  }

  // Jacobi's sweeps: the nodes at both ends of a facet wait for each other
  void lean_on_large_facets(const std::vector<int>& suspicious)
  {
    std::vector<Candidate> candidates;
    for(const int i : suspicious)
    {
      Candidate candidate = {large_facets(i), excess_of_rise(i)};
      if(!candidate.facets.other_neighbors.empty())
        candidates.push_back(std::move(candidate));
    }
    std::vector<Vector> normals;
    for(const Candidate& candidate : candidates)
      normals.push_back(blended(candidate, true));
    const auto assign = [&]
    {
      for(std::size_t k = 0; k < candidates.size(); ++k)
        m_normals[candidates[k].facets.node] = normals[k];
    };
    constexpr int number_of_sweeps = 3;
    for(int sweep = 0; sweep < number_of_sweeps; ++sweep)
    {
      assign();
      for(std::size_t k = 0; k < candidates.size(); ++k)
        normals[k] = blended(candidates[k], false);
    }
    assign();
  }

  Rises rises(const int i) const { return find_rises(m_surface, m_cut_mesh, m_nodes, m_regions, i); }

  // From 0 to 1: does the surface rise over the long edges of the node by more than over its short ones?
  double excess_of_rise(const int i) const
  {
    const Rises r = rises(i);
    return r.usual > 0. ? ramp(r.largest / r.usual, least_ratio, sure_ratio) : 0.;
  }

  bool has_edges_of_different_lengths(const int i) const
  {
    double shortest = std::numeric_limits<double>::infinity(), longest = 0.;
    for(const int j : m_cut_mesh.ring(i))
    {
      const double length = (position(j) - position(i)).norm();
      shortest = (std::min)(shortest, length);
      longest = (std::max)(longest, length);
    }
    return longest > least_ratio * shortest;
  }

  Large_facets large_facets(const int i) const
  {
    Large_facets result = {i, m_nodes[i].normal, {}, {}, {}, {}, false};
    double largest = 0.;
    for(const int c : m_cut_mesh.corners(i))
      largest = (std::max)(largest, area(c, i));
    // Max's weights times the third power of the area: those of long facets of a cylinder balance, and strips along the
    // sides of a plane count little
    Vector sum = Vector::Zero();
    visit_fan(m_surface, m_cut_mesh, i, [&](const int c, const Vector& u, const Vector& v)
    {
      const double part = area(c, i) / largest;
      sum += part * part * part * max_weight(u, v) * u.cross(v);
      const bool is_large = part >= large_part;
      if(is_large)
        result.normals.push_back(u.cross(v).normalized());
      for(const int k : {next(c % 3), previous(c % 3)})
        (is_large ? result.neighbors : result.other_neighbors).push_back(m_cut_mesh.node(c / 3, k));
    });
    if(sum.norm() > 0.)
      result.normal = sum.normalized();
    for(std::vector<int>* const neighbors : {&result.neighbors, &result.other_neighbors})
    {
      std::sort(neighbors->begin(), neighbors->end());
      neighbors->erase(std::unique(neighbors->begin(), neighbors->end()), neighbors->end());
    }
    find_directions(result);
    return result;
  }

  void find_directions(Large_facets& facets) const
  {
    const Vector& normal = facets.normal;
    Scatter_of_normals of_large(normal), of_small(normal);
    for(const Vector& n : facets.normals)
      of_large.add(n);
    // squares of angles in radians: below it facets agree in all directions, and rounding must not choose
    constexpr double equal = 1e-12;
    facets.is_flat = of_large.difference() <= equal;
    Vector along = normal.cross(of_large.widest());
    if(facets.is_flat)
    {
      // then, the one in which the small facets turn away
      Vector sum = Vector::Zero();
      double length = 0.;
      for(const int j : facets.other_neighbors)
        if(m_nodes[j].has_normal())
        {
          const Vector& n = neighbor_normal(j);
          of_small.add(n);
          sum += n - n.dot(normal) * normal;
          length += (n - n.dot(normal) * normal).norm();
        }
      constexpr double balanced = 1e-3;
      if(sum.norm() > balanced * length)
        along = sum.normalized();
      else if(of_small.difference() > equal)
        along = of_small.widest();
    }
    facets.directions = {{along, normal.cross(along)}};
  }

  // along one of the two directions, between a normal at the node and those of the large facets
  static double spread(const Large_facets& facets, const Vector& normal, const Vector& direction)
  {
    double result = 0.;
    for(const Vector& n : facets.normals)
      result = (std::max)(result, std::abs(direction.dot(n - normal)));
    return result;
  }

  // At the other end of a large facet: on a line its estimate or Max's normal may be right where the other one errs, on
  // a smooth surface both turn with it. So the one counts that is closer along the direction, unless the node leans on
  // its large facets already.
  const Vector& normal_at_end(const int j, const Vector& normal, const Vector& direction) const
  {
    const double now = std::abs(direction.dot(m_normals[j] - normal));
    return has_turned(j) || now <= std::abs(direction.dot(m_max_normals[j] - normal)) + least_turn ? m_normals[j]
                                                                                                   : m_max_normals[j];
  }

  // and those at their other ends
  double spread_at_ends(const Large_facets& facets, const Vector& normal, const Vector& direction) const
  {
    double result = 0.;
    for(const int j : facets.neighbors)
      if(m_nodes[j].has_normal())
        result = (std::max)(result, std::abs(direction.dot(normal_at_end(j, normal, direction) - normal)));
    return result;
  }

  Vector blended(const Candidate& candidate, const bool is_first) const
  {
    const Large_facets& facets = candidate.facets;
    const Vector estimate = m_nodes[facets.node].normal, turn = facets.normal - estimate;
    std::array<Vector, 2> directions = facets.directions;
    if(facets.is_flat)
    {
      // one turn: of a small part of it, across the rest, the errors of the neighbours would say nothing
      const Vector across = turn - turn.dot(facets.normal) * facets.normal;
      directions = {{across.norm() > least_turn ? Vector(across.normalized()) : Vector(Vector::Zero()), Vector::Zero()}};
    }
    Vector result = estimate;
    for(const Vector& direction : directions)
    {
      const Vector part = turn.dot(direction) * direction;
      const double length = part.norm();
      if(!(length > 0.))
        continue;
      double share = candidate.suspicion * ramp(spread(facets, facets.normal, direction) / length, disagreeing, agreeing);
      if(!is_first)
        share *= fitting_share(facets, part)
               * ramp(spread_at_ends(facets, facets.normal, direction) / length, disagreeing, agreeing);
      result += share * part;
    }
    return result.normalized();
  }

  // The chord of an arc makes the same angle with the normals at both ends. By how much of `turn` must the normal be
  // turned to fit all chords to the neighbours best, least squares of the angles? Long chords lead to other lines,
  // whether they belong to large facets or to long ones beside them.
  double fitting_share(const Large_facets& facets, const Vector& turn) const
  {
    constexpr double part_of_long_chord = 0.5;
    double longest = 0.;
    for(const int j : m_cut_mesh.ring(facets.node))
      longest = (std::max)(longest, (position(j) - position(facets.node)).norm());
    double product = 0., square = 0.;
    const Vector direction = turn.normalized();
    for(const int j : m_cut_mesh.ring(facets.node))
      if(m_nodes[j].has_normal())
      {
        const Vector chord = position(j) - position(facets.node), d = chord.normalized();
        const bool is_at_end = chord.norm() > part_of_long_chord * longest
                            || std::binary_search(facets.neighbors.begin(), facets.neighbors.end(), j);
        const Vector& other = is_at_end ? normal_at_end(j, facets.normal, direction) : neighbor_normal(j);
        product -= turn.dot(d) * (m_nodes[facets.node].normal.dot(d) + other.dot(d));
        square += turn.dot(d) * turn.dot(d);
      }
    // on tangent lines about 1, but for the errors of the neighbours' normals; on smooth surfaces about 0
    constexpr double least_share = 0.4, sure_share = 0.7;
    return square > 0. ? ramp(product / square, least_share, sure_share) : 0.;
  }

  // Two lines meet where fillets do: what is far along one of them is no part of the fillet along the other.
  bool is_corner_of_lines(const int i, const std::vector<int>& on_lines) const
  {
    constexpr double cosine_of_corner = 0.6;          // of lines with a turn between those of hexagons and octagons
    std::vector<Vector> directions;
    for(const int j : on_lines)
      directions.push_back((position(j) - position(i)).normalized());
    for(const Vector& u : directions)
      for(const Vector& v : directions)
        if(std::abs(u.dot(v)) < cosine_of_corner)
          return true;
    return false;
  }

  // of the normals of the small facets' nodes, along one of the two directions
  double turn_of_small(const Large_facets& facets, const Vector& normal, const Vector& direction) const
  {
    double result = 0.;
    for(const int j : facets.other_neighbors)
      if(m_nodes[j].has_normal())
        result = (std::max)(result, std::abs(direction.dot(neighbor_normal(j) - normal)));
    return result;
  }

  // Do the large facets agree along a direction in which the small ones turn away, along arcs that begin here? Then
  // `settled` is the normal that is theirs along it, unless what is missing is what irregular facets of a cylinder turn.
  // In the other direction, that of a cylinder's arcs, the fit has looked beyond the line: where that turns it from the
  // Max normal, this is better.
  bool is_tangent(const Large_facets& facets, Vector& settled) const
  {
    // of what the small facets turn in the other direction, and of the rise over their edges
    constexpr double least_turn_of_small = 0.4, least_bulge = 0.3;
    // in radians: Max normals of irregular facets of a cylinder are turned by as much
    constexpr double trusted_turn = 0.02, distrusted_turn = 0.05;
    const Vector& normal = m_normals[facets.node];
    std::array<bool, 2> is_along = {{false, false}};
    for(int k = 0; k < 2; ++k)
    {
      const Vector& direction = facets.directions[k];
      const double turn = turn_of_small(facets, normal, direction);
      // at the other ends from the facets, not from here: nodes that lean in opposite ways would wait for each other
      if(!(turn > least_turn)
         || !((std::max)(spread(facets, normal, direction), spread_at_ends(facets, facets.normal, direction)) < agreeing * turn))
        continue;
      is_along[k] = true;
      const Vector missing = (facets.normal - normal).dot(direction) * direction;
      double bulge = 0.;
      for(const int j : facets.neighbors)
        bulge = (std::max)(bulge, std::abs(missing.dot(position(j) - position(facets.node))));
      if(turn > least_turn_of_small * turn_of_small(facets, normal, facets.directions[1 - k])
         && bulge > least_bulge * rises(facets.node).usual)
        settled += missing;
    }
    if(is_along[0] != is_along[1])
    {
      const Vector& direction = facets.directions[is_along[0] ? 1 : 0];
      const double turn = direction.dot(m_max_normals[facets.node] - settled);
      settled += ramp(std::abs(turn), trusted_turn, distrusted_turn) * turn * direction;
    }
    settled.normalize();
    return is_along[0] || is_along[1];
  }
};

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_MODEL_TANGENT_NODES_H
