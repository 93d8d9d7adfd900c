// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_CLASSIFICATION_CLASSIFY_EDGES_H
#define CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_CLASSIFICATION_CLASSIFY_EDGES_H

#include <CGAL/Hermite_diffuse_remeshing/Feature_classes.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Classification/Edge_table.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Classification/Fading_creases.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Classification/Needles.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace CGAL {
namespace Hermite_diffuse_remeshing {
namespace internal {

// What the user says of an edge of the input, the weakest word first.
enum Edge_mark : unsigned char
{
  UNMARKED_EDGE,         // nothing
  MARKED_FREE,           // no feature
  MARKED_PATCH_BORDER,   // a feature, because its faces have different labels
  MARKED_FEATURE,
  MARKED_CONSTRAINED,    // a feature, because it is in the user's map, which is to stay where it is
  MARKED_PROTECTED       // a feature that cannot be changed
};

// The stronger word of the two sides of an edge counts.
template <typename EdgeMark>
Edge_mark strongest_mark(const Edge_table& edges, const int e, const EdgeMark& edge_mark)
{
  Edge_mark result = UNMARKED_EDGE;
  for(int i = 0; i < edges.number_of_sides(e); ++i)
    result = (std::max)(result, edge_mark(edges.side(e, i).face, edges.side(e, i).side));
  return result;
}

// of the three sides of every face
typedef std::vector<std::array<Edge_mark, 3> > Side_marks;

// The angle between the normals of the two faces of an edge, in radians. A degenerate face has
// no normal, so its edges have no angle: they never become sharp by themselves.
inline double dihedral_deviation(const Indexed_triangles& surface, const int face_1, const int face_2)
{
  const Vector n1 = surface.area_vector(face_1), n2 = surface.area_vector(face_2);
  return angle_between(n1, n2);
}

// On scans and coarse meshes single edges pass the limit by noise. A connected set of feature edges is
// taken for noise if all of these hold: it has only sharp edges, and fewer than six; it has a free
// end, a vertex with no second feature edge; none of its angles is 1.5 times the limit or more. A
// crease is longer, sharper, closed, or ends at other features.
inline void discard_isolated_sharp_edges(const Indexed_triangles& surface, const Edge_table& edges,
                                         const double sharp_angle, std::vector<Edge_class>& classes)
{
  constexpr int least_number_of_edges = 6;
  constexpr double clearly_sharp = 1.5;

  std::vector<std::vector<int> > edges_of_vertex(surface.number_of_vertices());
  for(int e = 0; e < edges.number_of_edges(); ++e)
    if(is_feature(classes[e]))
      for(const int v : edges.vertices(e))
        edges_of_vertex[v].push_back(e);

  std::vector<char> is_seen(edges.number_of_edges(), false);
  std::vector<int> component;
  for(int seed = 0; seed < edges.number_of_edges(); ++seed)
  {
    if(is_seen[seed] || !is_feature(classes[seed]))
      continue;
    component.assign(1, seed);
    is_seen[seed] = true;
    bool is_noise = true, has_free_end = false;
    for(std::size_t i = 0; i < component.size(); ++i)
    {
      const int e = component[i];
      is_noise = is_noise && classes[e] == SHARP_EDGE
              && dihedral_deviation(surface, edges.side(e, 0).face, edges.side(e, 1).face)
                 < clearly_sharp * sharp_angle;
      for(const int v : edges.vertices(e))
      {
        has_free_end = has_free_end || edges_of_vertex[v].size() == 1;
        for(const int other : edges_of_vertex[v])
          if(!is_seen[other])
          {
            is_seen[other] = true;
            component.push_back(other);
          }
      }
    }
    if(is_noise && has_free_end && component.size() < least_number_of_edges)
      for(const int e : component)
        classes[e] = INTERIOR_EDGE;
  }
}

// `edge_mark(face, side)` is what the user says of an edge.
// `angle_bound` is in radians; an edge is sharp if the normals of its faces differ by more.
template <typename EdgeMark>
std::vector<Edge_class> classify_edges(const Indexed_triangles& surface,
                                       const Edge_table& edges,
                                       const double angle_bound,
                                       const EdgeMark& edge_mark)
{
  // In radians: what roundings of the coordinates, also to single precision, make of an angle. Whether the edges of a
  // regular prism are sharp, which all have the angle that was asked for, is not for them to decide.
  constexpr double rounding = 1e-5;
  const double sharp_angle = angle_bound + rounding;
  std::vector<Edge_class> classes(edges.number_of_edges(), INTERIOR_EDGE);
  std::vector<char> may_be_sharp(edges.number_of_edges(), false);
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
    {
      classes[e] = NON_MANIFOLD_EDGE;
      continue;
    }
    const Edge_mark mark = strongest_mark(edges, e, edge_mark);
    if(mark >= MARKED_FEATURE)
      classes[e] = CONSTRAINED_EDGE;
    else if(mark == MARKED_PATCH_BORDER)
      classes[e] = PATCH_BORDER_EDGE;
    else if(mark == UNMARKED_EDGE)
    {
      may_be_sharp[e] = true;
      if(dihedral_deviation(surface, s.face, t.face) > sharp_angle)
        classes[e] = SHARP_EDGE;
    }
  }
  Needles(surface, edges, sharp_angle, classes, may_be_sharp).smooth();
  Fading_creases(surface, edges, may_be_sharp, classes).close();
  discard_isolated_sharp_edges(surface, edges, sharp_angle, classes);
  return classes;
}

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_CLASSIFICATION_CLASSIFY_EDGES_H
