// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_CLASSIFICATION_CLASSIFY_EDGES_H
#define CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_CLASSIFICATION_CLASSIFY_EDGES_H

#include <CGAL/Hermite_diffuse_remeshing/internal/Classification/Edge_table.h>

#include <cmath>
#include <vector>

namespace CGAL {
namespace Hermite_diffuse_remeshing {
namespace internal {

enum Edge_class
{
  INTERIOR_EDGE,
  SHARP_EDGE,
  CONSTRAINED_EDGE,      // by the user, or between two patches
  BOUNDARY_EDGE,
  NON_MANIFOLD_EDGE      // more than two faces, or two that are not coherently oriented
};

inline bool is_feature(const Edge_class c) { return c != INTERIOR_EDGE; }

// The angle between the normals of the two faces of an edge, in radians. A degenerate face has
// no normal, so its edges have no angle: they never become sharp by themselves.
inline double dihedral_deviation(const Indexed_triangles& surface, const int face_1, const int face_2)
{
  const Vector n1 = surface.area_vector(face_1), n2 = surface.area_vector(face_2);
  return angle_between(n1, n2);
}

// `is_constrained(face, side)` tells the edges that the user wants to keep.
// `sharp_angle` is in radians; an edge is sharp if the normals of its faces differ by more.
template <typename IsConstrained>
std::vector<Edge_class> classify_edges(const Indexed_triangles& surface,
                                       const Edge_table& edges,
                                       const double sharp_angle,
                                       const IsConstrained& is_constrained)
{
  std::vector<Edge_class> classes(edges.number_of_edges(), INTERIOR_EDGE);
  for(int e = 0; e < edges.number_of_edges(); ++e)
  {
    const Face_side& s = edges.side(e, 0);
    if(edges.number_of_sides(e) == 1)
    {
      classes[e] = BOUNDARY_EDGE;
      continue;
    }
    const Face_side& t = edges.side(e, 1);
    const bool is_coherent = surface.triangles[s.face][s.side] == surface.triangles[t.face][next(t.side)];
    if(edges.number_of_sides(e) > 2 || !is_coherent)
      classes[e] = NON_MANIFOLD_EDGE;
    else if(is_constrained(s.face, s.side) || is_constrained(t.face, t.side))
      classes[e] = CONSTRAINED_EDGE;
    else if(dihedral_deviation(surface, s.face, t.face) > sharp_angle)
      classes[e] = SHARP_EDGE;
  }
  return classes;
}

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_CLASSIFICATION_CLASSIFY_EDGES_H
