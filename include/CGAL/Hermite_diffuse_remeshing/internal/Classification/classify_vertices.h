// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_CLASSIFICATION_CLASSIFY_VERTICES_H
#define CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_CLASSIFICATION_CLASSIFY_VERTICES_H

#include <CGAL/Hermite_diffuse_remeshing/internal/Classification/Cut_mesh.h>

#include <boost/math/constants/constants.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

namespace CGAL {
namespace Hermite_diffuse_remeshing {
namespace internal {

// Angles are in radians. A vertex is a corner if the user says so, if the number of its feature
// edges is neither zero nor two, if its two feature edges have different classes or numbers of faces, if one of them only is
// in the user's map of constraints, if they turn by more than `corner_angle`, if several sheets touch there, or if its
// angular defect, the absolute value of 2 pi minus the sum of the angles of its faces, exceeds `apex_defect` (paper,
// section 2.2).
template <typename EdgeMark, typename IsConstrained>
std::vector<Vertex_class> classify_vertices(const Indexed_triangles& surface,
                                            const Edge_table& edges,
                                            const std::vector<Edge_class>& edge_classes,
                                            const Cut_mesh& cut_mesh,
                                            const double corner_angle,
                                            const double apex_defect,
                                            const EdgeMark& edge_mark,
                                            const IsConstrained& is_constrained)
{
  const int nv = surface.number_of_vertices();
  struct Feature_star { int number = 0; int edge[2] = {-1, -1}; };
  std::vector<Feature_star> stars(nv);
  for(int e = 0; e < edges.number_of_edges(); ++e)
    if(is_feature(edge_classes[e]))
      for(const int v : edges.vertices(e))
      {
        Feature_star& star = stars[v];
        if(star.number < 2)
          star.edge[star.number] = e;
        ++star.number;
      }

  std::vector<int> number_of_nodes(nv, 0), number_of_closed_nodes(nv, 0);
  std::vector<double> largest_defect(nv, 0.);          // of the closed nodes
  for(int i = 0; i < cut_mesh.number_of_nodes(); ++i)
  {
    const int v = cut_mesh.vertex(i);
    ++number_of_nodes[v];
    double angle_sum = 0.;
    for(const int c : cut_mesh.corners(i))
    {
      const Vector& p = surface.points[v];
      angle_sum += angle_between(surface.point(c / 3, next(c % 3)) - p, surface.point(c / 3, previous(c % 3)) - p);
    }
    if(cut_mesh.is_open(i))
      continue;
    ++number_of_closed_nodes[v];
    largest_defect[v] = (std::max)(largest_defect[v],
                                   std::abs(2. * boost::math::constants::pi<double>() - angle_sum));
  }

  const auto is_marked = [&](const int e) { return strongest_mark(edges, e, edge_mark) == MARKED_CONSTRAINED; };
  std::vector<Vertex_class> classes(nv, SURFACE_VERTEX);
  for(int v = 0; v < nv; ++v)
  {
    const Feature_star& star = stars[v];
    if(star.number == 0 && largest_defect[v] > apex_defect)
      classes[v] = APEX_VERTEX;
    else if(is_constrained(v))
      classes[v] = CONSTRAINED_VERTEX;
    else if(star.number == 0)
      classes[v] = number_of_nodes[v] > 1 ? TOUCHING_VERTEX : SURFACE_VERTEX;
    else if(star.number != 2 || edge_classes[star.edge[0]] != edge_classes[star.edge[1]]
            || edges.number_of_sides(star.edge[0]) != edges.number_of_sides(star.edge[1])
            || is_marked(star.edge[0]) != is_marked(star.edge[1]))
      classes[v] = JUNCTION_VERTEX;
    else
    {
      const Vector& p = surface.points[v];
      const double kink = angle_between(p - surface.points[edges.opposite_vertex(star.edge[0], v)],
                                        surface.points[edges.opposite_vertex(star.edge[1], v)] - p);
      classes[v] = kink > corner_angle ? KINK_VERTEX : number_of_closed_nodes[v] > 0 ? TOUCHING_VERTEX : CURVE_VERTEX;
    }
  }
  return classes;
}

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_CLASSIFICATION_CLASSIFY_VERTICES_H
