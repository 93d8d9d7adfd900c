// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_CLASSIFICATION_NEEDLES_H
#define CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_CLASSIFICATION_NEEDLES_H

#include <CGAL/Hermite_diffuse_remeshing/Feature_classes.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Classification/Edge_table.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Hermite_diffuse_remeshing {
namespace internal {

// The normal of a needle is noise: that of a triangle with an angle of 5 degrees is turned by 40 when a vertex moves by
// a fourteenth of its length. If two features meet at such an angle with nothing but one face between them, no
// triangle there can be well shaped. Where the faces around the needle form one sheet, or two that meet at a single
// crease, it is taken to have the normal of one of them. Where it is the tip of a wedge, which goes on behind its
// short side, the wedge ends at this side if the faces around the tip form one sheet; otherwise its features stay.
class Needles
{
  const Indexed_triangles& m_surface;
  const Edge_table& m_edges;
  double m_sharp_angle;
  std::vector<Edge_class>& m_classes;
  const std::vector<char>& m_may_be_sharp;            // of the edges: the user says nothing of them
  std::vector<Vector> m_normals;        // of any length; those that needles are taken to have
  std::vector<char> m_is_needle;

  static constexpr double largest_angle = 0.0873;     // 5 degrees
  // angles closer than this, in radians, are the same: rounding does not choose between two sheets
  static constexpr double angle_tolerance = 1e-6;

public:
  Needles(const Indexed_triangles& surface, const Edge_table& edges, const double sharp_angle,
          std::vector<Edge_class>& classes, const std::vector<char>& may_be_sharp)
    : m_surface(surface), m_edges(edges), m_sharp_angle(sharp_angle), m_classes(classes), m_may_be_sharp(may_be_sharp)
    , m_is_needle(surface.number_of_faces(), false)
  {
    for(int f = 0; f < surface.number_of_faces(); ++f)
      m_normals.push_back(surface.area_vector(f));
  }

  // Needles beside needles wait until those have a normal. Longer chains of them are no accident. A needle that is taken
  // to face the other way stays turned over in the result: of two side by side the smaller is, and may do for both.
  void smooth()
  {
    constexpr int number_of_rounds = 3;
    for(int round = 0; round < number_of_rounds; ++round)
    {
      std::vector<int> needles;
      for(int f = 0; f < m_surface.number_of_faces(); ++f)
      {
        m_is_needle[f] = is_needle_between_features(f);
        if(m_is_needle[f])
          needles.push_back(f);
      }
      std::vector<std::pair<int, int> > lenders;
      for(const int f : needles)
      {
        const int k = side_to_join(f);
        if(k != -1)
          lenders.push_back(std::make_pair(f, neighbor(f, k)));
      }
      if(lenders.empty())
        return;
      let_larger_wait(lenders);
      for(const std::pair<int, int>& entry : lenders)
        m_normals[entry.first] = m_normals[entry.second];
      for(const std::pair<int, int>& entry : lenders)
        for(int k = 0; k < 3; ++k)
          classify_again(entry.first, k);
    }
  }

private:
  // `lenders`: needles and the faces the normals of which they are to have
  void let_larger_wait(std::vector<std::pair<int, int> >& lenders) const
  {
    // relative: areas closer than this are the same
    constexpr double area_tolerance = 1e-6;
    std::map<int, double> turned;         // areas of those that would be turned over
    for(const std::pair<int, int>& entry : lenders)
      if(m_normals[entry.first].dot(m_normals[entry.second]) < 0.)
        turned[entry.first] = m_surface.area_vector(entry.first).norm();
    const auto waits = [&](const std::pair<int, int>& entry)
    {
      const auto own = turned.find(entry.first);
      if(own == turned.end())
        return false;
      for(int k = 0; k < 3; ++k)
      {
        const auto other = m_edges.number_of_sides(m_edges.edge(entry.first, k)) == 2
                         ? turned.find(neighbor(entry.first, k)) : turned.end();
        if(other != turned.end() && own->second > (1. + area_tolerance) * other->second)
          return true;
      }
      return false;
    };
    lenders.erase(std::remove_if(lenders.begin(), lenders.end(), waits), lenders.end());
  }

  void classify_again(const int face, const int side)
  {
    const int e = m_edges.edge(face, side);
    if(m_classes[e] != SHARP_EDGE && !(m_classes[e] == INTERIOR_EDGE && m_may_be_sharp[e]))
      return;
    m_classes[e] = angle(face, side) > m_sharp_angle ? SHARP_EDGE : INTERIOR_EDGE;
  }

  Edge_class edge_class(const int face, const int side) const { return m_classes[m_edges.edge(face, side)]; }
  bool is_sharp(const int face, const int side) const { return edge_class(face, side) == SHARP_EDGE; }

  // of an edge with two sides
  int neighbor(const int face, const int side) const
  {
    const int e = m_edges.edge(face, side);
    return m_edges.side(e, m_edges.side(e, 0).face == face ? 1 : 0).face;
  }

  double angle(const int face, const int side) const
  { return angle_between(m_normals[face], m_normals[neighbor(face, side)]); }

  bool is_sharp_corner(const int f, const int corner) const
  {
    const Vector& p = m_surface.point(f, corner);
    return angle_between(m_surface.point(f, next(corner)) - p, m_surface.point(f, previous(corner)) - p)
         < largest_angle;
  }

  bool is_needle_between_features(const int f) const
  {
    for(int k = 0; k < 3; ++k)
      if(is_feature(edge_class(f, k)) && is_feature(edge_class(f, previous(k))) && is_sharp_corner(f, k))
        return is_sharp(f, 0) || is_sharp(f, 1) || is_sharp(f, 2);
    return false;
  }

  // With the normal of the face at side k no features meet at a small angle any more, and there is no new one but in
  // place of two, where a single sheet lies behind both.
  bool is_resolved(const int f, const int k) const
  {
    const Vector& normal = m_normals[neighbor(f, k)];
    std::array<bool, 3> is_left = {{false, false, false}};
    int new_side = -1;
    for(const int side : {next(k), previous(k)})
    {
      const Edge_class c = edge_class(f, side);
      is_left[side] = (c != INTERIOR_EDGE && c != SHARP_EDGE)
                   || angle_between(normal, m_normals[neighbor(f, side)]) > m_sharp_angle;
      if(is_left[side] && c == INTERIOR_EDGE)
        new_side = side;
    }
    const bool are_both_left = is_left[next(k)] && is_left[previous(k)];
    if(new_side == -1)
      return !(are_both_left && is_sharp_corner(f, previous(k)));
    const int third_side = 3 - k - new_side;
    return !are_both_left && is_sharp(f, third_side) && m_may_be_sharp[m_edges.edge(f, new_side)];
  }

  // The sharp side with the smallest angle of those that may become smooth; -1 if there is none, or if there are two
  // that lead to different sheets.
  int side_to_join(const int f) const
  {
    int best = -1;
    double least = 0.;
    bool is_unique = true;
    for(int k = 0; k < 3; ++k)
    {
      if(!is_sharp(f, k) || m_is_needle[neighbor(f, k)] || !is_resolved(f, k))
        continue;
      const double a = angle(f, k);
      if(best != -1 && std::abs(a - least) <= angle_tolerance)
        is_unique = is_unique
                 && angle_between(m_normals[neighbor(f, k)], m_normals[neighbor(f, best)]) <= m_sharp_angle;
      else if(best == -1 || a < least)
      {
        best = k;
        least = a;
        is_unique = true;
      }
    }
    return is_unique ? best : -1;
  }
};

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_CLASSIFICATION_NEEDLES_H
