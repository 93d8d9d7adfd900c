// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_CLASSIFICATION_FADING_CREASES_H
#define CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_CLASSIFICATION_FADING_CREASES_H

#include <CGAL/Hermite_diffuse_remeshing/Feature_classes.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Classification/Edge_table.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Indexed_triangles.h>

#include <CGAL/number_type_basic.h>

#include <algorithm>
#include <vector>

namespace CGAL {
namespace Hermite_diffuse_remeshing {
namespace internal {

// The seam of two tubes that meet in a mitre is a crease outside and inside of the bend, and fades between: there the
// facets of both turn by less than any bound. Where they are as long as the tubes, the surface must not be taken for
// smooth there: the normals at one end of a facet would swell all of it, by a tenth of its length times the angle.
class Fading_creases
{
  const Indexed_triangles& m_surface;
  const Edge_table& m_edges;
  const std::vector<char>& m_may_be_sharp;            // of the edges: the user says nothing of them
  std::vector<Edge_class>& m_classes;
  std::vector<int> m_number_of_features;              // of the vertices
  std::vector<char> m_is_in_seam;                     // of the edges: has been gone along

  // Of facets, in lengths of their edges in the seam: of shorter ones the swelling is no more than a few sagittas of
  // well-shaped triangles.
  static constexpr double least_length = 3.;
  // The seam goes on by less than 60 degrees: around a tube of eight sides it turns by 44.
  static constexpr double least_cosine = 0.5;

public:
  Fading_creases(const Indexed_triangles& surface, const Edge_table& edges, const std::vector<char>& may_be_sharp,
                 std::vector<Edge_class>& classes)
    : m_surface(surface), m_edges(edges), m_may_be_sharp(may_be_sharp), m_classes(classes)
    , m_number_of_features(surface.number_of_vertices(), 0)
  {
    for(int e = 0; e < edges.number_of_edges(); ++e)
      if(is_feature(classes[e]))
        for(const int v : edges.vertices(e))
          ++m_number_of_features[v];
  }

  // Makes the edges sharp that lead from one free end of a crease to another, if all of it is between long facets.
  void close()
  {
    std::vector<int> ends;              // edges that are the last of a crease
    for(int e = 0; e < m_edges.number_of_edges(); ++e)
      if(is_at_free_end(e) && is_between_long_facets(e))
        ends.push_back(e);
    if(ends.empty())
      return;
    const std::vector<std::vector<int> > edges_of_vertex = edges_between_long_facets();
    m_is_in_seam.assign(m_edges.number_of_edges(), false);
    for(const int e : ends)
      for(const int v : m_edges.vertices(e))
        if(m_number_of_features[v] == 1)
          close_from(e, v, edges_of_vertex);
  }

private:
  bool is_at_free_end(const int e) const
  {
    return m_classes[e] == SHARP_EDGE && (m_number_of_features[m_edges.vertices(e)[0]] == 1
                                          || m_number_of_features[m_edges.vertices(e)[1]] == 1);
  }

  bool is_between_long_facets(const int e) const
  {
    const Vector& p = m_surface.points[m_edges.vertices(e)[0]];
    const Vector& q = m_surface.points[m_edges.vertices(e)[1]];
    const double least_square = CGAL::square(least_length) * (q - p).squaredNorm();
    for(int i = 0; i < m_edges.number_of_sides(e); ++i)
    {
      const Face_side& side = m_edges.side(e, i);
      const Vector& tip = m_surface.point(side.face, previous(side.side));
      if((std::max)((tip - p).squaredNorm(), (tip - q).squaredNorm()) < least_square)
        return false;
    }
    return true;
  }

  std::vector<std::vector<int> > edges_between_long_facets() const
  {
    std::vector<std::vector<int> > result(m_surface.number_of_vertices());
    for(int e = 0; e < m_edges.number_of_edges(); ++e)
      if(m_may_be_sharp[e] && (!is_feature(m_classes[e]) || is_at_free_end(e)) && is_between_long_facets(e))
        for(const int v : m_edges.vertices(e))
          result[v].push_back(e);
    return result;
  }

  // of the edge e, which ends or begins at the vertex
  Vector direction_from(const int v, const int e) const
  {
    return (m_surface.points[m_edges.opposite_vertex(e, v)] - m_surface.points[v]).stableNormalized();
  }

  void close_from(const int crease, const int end, const std::vector<std::vector<int> >& edges_of_vertex)
  {
    std::vector<int> seam;
    int v = end, last = crease;
    do
    {
      seam.push_back(last);
      m_is_in_seam[last] = true;
      last = straightest(v, -direction_from(v, last), edges_of_vertex[v]);
      if(last != -1)
        v = m_edges.opposite_vertex(last, v);
    }
    while(last != -1 && !m_is_in_seam[last] && !is_feature(m_classes[last]));
    const bool is_closed = last != -1 && !m_is_in_seam[last];
    for(const int e : seam)
    {
      m_is_in_seam[e] = false;
      if(!is_closed || is_feature(m_classes[e]))
        continue;
      m_classes[e] = SHARP_EDGE;
      for(const int w : m_edges.vertices(e))
        ++m_number_of_features[w];
    }
  }

  // of some edges of a vertex, the one that goes on in a direction; -1 if none does
  int straightest(const int v, const Vector& ahead, const std::vector<int>& edges) const
  {
    int result = -1;
    double cosine = least_cosine;
    for(const int e : edges)
      if(ahead.dot(direction_from(v, e)) > cosine)
      {
        cosine = ahead.dot(direction_from(v, e));
        result = e;
      }
    return result;
  }
};

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_CLASSIFICATION_FADING_CREASES_H
