// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_SLIDE_FROM_CORNER_H
#define CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_SLIDE_FROM_CORNER_H

#include <CGAL/Hermite_diffuse_remeshing/internal/Transformation/curve_fidelity.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Transformation/is_free.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Transformation/quality.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Transformation/relocate_vertices.h>

#include <array>
#include <utility>

namespace CGAL {
namespace Hermite_diffuse_remeshing {
namespace internal {

// Moves both ends of the side that faces a corner, from which the other two sides of its face go along feature curves.
// The best face there has two sides of the same length. So neither end gains by a move of its own, though the angle
// between the chords of curves that bend changes with their length.
template <typename UserMesh>
class Slide_from_corner
{
  typedef Working_mesh<UserMesh> Mesh;
  typedef typename Mesh::vertex_descriptor vertex_descriptor;
  typedef typename Mesh::halfedge_descriptor halfedge_descriptor;

  std::array<vertex_descriptor, 2> m_ends;
  std::array<Site, 2> m_sites;

public:
  // `h`: of a face with two other sides on curves, opposite to the corner; `before`: of all faces around its ends. A score
  // of -1 where these may not move. No side of the face becomes longer than `longest_length` times its size.
  Worth plan(const Mesh& mesh, const halfedge_descriptor h, const Worth& before, const double longest_length)
  {
    const auto& tm = mesh.tmesh();
    const Worth none{-1., 0.};
    // the angle does not help a triangle that is turned over
    if(before.score <= 0.)
      return none;
    m_ends = {{source(h, tm), target(h, tm)}};
    const vertex_descriptor corner = target(next(h, tm), tm);
    const std::array<int, 2> curves = {{mesh.curve(prev(h, tm)), mesh.curve(next(h, tm))}};
    std::array<double, 2> parameters, origins;
    for(int i = 0; i < 2; ++i)
    {
      if(mesh.is_fixed(m_ends[i]) || mesh.site(m_ends[i]).curve != curves[i])
        return none;
      parameters[i] = mesh.parameter(m_ends[i], curves[i]);
      origins[i] = mesh.parameter(corner, curves[i]);
    }

    // of the distance to the corner; as for a single vertex of a curve, steps are halved
    constexpr double first_step = 0.1, last_step = 0.005;
    // of the score: a longer triangle that is hardly better is not worth two moves
    constexpr double least_gain = 0.01;
    Worth result = before;
    search_by_halving(1., first_step, [&](const double step, double) { return step < last_step; }, [&](const double factor)
    {
      std::array<Site, 2> sites;
      const auto is_allowed = [&](const int i)
      {
        const double parameter = origins[i] + factor * (parameters[i] - origins[i]);
        const std::pair<double, double> bounds = neighbor_parameters(mesh, m_ends[i]);
        if(parameter <= bounds.first || parameter >= bounds.second
           || !is_curve_move_faithful(mesh, m_ends[i], parameter))
          return false;
        sites[i] = mesh.reference().curve_site(curves[i], parameter);
        return factor < 1. || (sites[i].point - mesh.point(corner)).norm()
                                <= longest_length * (sites[i].size + mesh.size(corner)) / 2.;
      };
      if(!is_allowed(0) || !is_allowed(1))
        return false;
      const Worth worth = worth_at(mesh, sites);
      if(!is_better(worth, result))
        return false;
      result = worth;
      m_sites = sites;
      return true;
    });
    return result.score < (1. + least_gain) * before.score ? none : result;
  }

  bool is_free(Mesh& mesh) const
  {
    if(!mesh.is_guarded())
      return true;
    const Numbered_triangles replaced = triangles_around(mesh, {m_ends[0], m_ends[1]});
    Numbered_triangles made = replaced;
    for(int i = 0; i < 2; ++i)
      made = with_moved(mesh, made, m_ends[i], m_sites[i]);
    return mesh.is_free(Mesh::Graph_traits::null_vertex(), made, replaced);
  }

  void execute(Mesh& mesh) const
  {
    for(int i = 0; i < 2; ++i)
      mesh.relocate(m_ends[i], m_sites[i]);
  }

private:
  // of the faces around both ends, if these were at other sites
  Worth worth_at(const Mesh& mesh, const std::array<Site, 2>& sites) const
  {
    const auto& tm = mesh.tmesh();
    const auto site = [&](const vertex_descriptor v) -> const Site&
    {
      return mesh.index(v) == mesh.index(m_ends[0]) ? sites[0]
           : mesh.index(v) == mesh.index(m_ends[1]) ? sites[1] : mesh.site(v);
    };
    Worth result;
    for(const vertex_descriptor end : m_ends)
      mesh.visit_copies(end, [&](const vertex_descriptor copy)
      {
        for(const halfedge_descriptor h : CGAL::halfedges_around_target(copy, tm))
          if(!mesh.is_border_or_outside(h))
            result.add(worth(mesh.reference(), site(source(h, tm)), site(copy), site(target(next(h, tm), tm)),
                             mesh.hint(h)));
      });
    return result;
  }
};

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_SLIDE_FROM_CORNER_H
