// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_CLASSIFICATION_EDGE_TABLE_H
#define CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_CLASSIFICATION_EDGE_TABLE_H

#include <CGAL/Hermite_diffuse_remeshing/internal/Indexed_triangles.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <tuple>
#include <vector>

namespace CGAL {
namespace Hermite_diffuse_remeshing {
namespace internal {

// A face and one of its sides.
struct Face_side
{
  int face = -1;
  int side = -1;
};

// the place that is the part u of the side
inline Location location_on_side(const Face_side& side, const double u)
{
  Location result;
  result.face = side.face;
  result.coordinates.fill(0.);
  result.coordinates[side.side] = 1. - u;
  result.coordinates[next(side.side)] = u;
  return result;
}

// The undirected edges of a set of triangles, with any number of faces at each.
class Edge_table
{
  std::vector<std::array<int, 2> > m_vertices;    // of an edge, smaller index first
  std::vector<Face_side> m_sides;                 // grouped by edge
  std::vector<int> m_first_side;                  // number of edges + 1
  std::vector<std::array<int, 3> > m_edge_of_side;

  struct Record
  {
    int target;                                   // of the two ends the larger index
    Face_side side;

    // as in the order of the faces where the ends are the same
    bool operator<(const Record& other) const
    {
      return std::tie(target, side.face, side.side) < std::tie(other.target, other.side.face, other.side.side);
    }
  };

public:
  explicit Edge_table(const Indexed_triangles& surface)
    : m_edge_of_side(surface.triangles.size())
  {
    // the sides by the smaller index of their ends
    const auto source = [&surface](const int f, const int k)
    {
      return (std::min)(surface.triangles[f][k], surface.triangles[f][next(k)]);
    };
    std::vector<std::size_t> first(surface.number_of_vertices() + 1, 0);
    for(int f = 0; f < surface.number_of_faces(); ++f)
      for(int k = 0; k < 3; ++k)
        ++first[source(f, k) + 1];
    std::partial_sum(first.begin(), first.end(), first.begin());
    std::vector<Record> records(first.back());
    std::vector<std::size_t> next_free(first.begin(), first.end() - 1);
    for(int f = 0; f < surface.number_of_faces(); ++f)
      for(int k = 0; k < 3; ++k)
        records[next_free[source(f, k)]++] = {(std::max)(surface.triangles[f][k], surface.triangles[f][next(k)]), {f, k}};

    m_sides.reserve(records.size());
    for(int v = 0; v < surface.number_of_vertices(); ++v)
    {
      std::sort(records.begin() + first[v], records.begin() + first[v+1]);
      for(std::size_t i = first[v]; i < first[v+1]; ++i)
      {
        const Record& record = records[i];
        if(i == first[v] || record.target != records[i-1].target)
        {
          m_vertices.push_back({{v, record.target}});
          m_first_side.push_back(static_cast<int>(i));
        }
        m_edge_of_side[record.side.face][record.side.side] = static_cast<int>(m_vertices.size()) - 1;
        m_sides.push_back(record.side);
      }
    }
    m_first_side.push_back(static_cast<int>(records.size()));
  }

  int number_of_edges() const { return static_cast<int>(m_vertices.size()); }
  const std::array<int, 2>& vertices(const int e) const { return m_vertices[e]; }
  int edge(const int face, const int side) const { return m_edge_of_side[face][side]; }

  int number_of_sides(const int e) const { return m_first_side[e+1] - m_first_side[e]; }
  const Face_side& side(const int e, const int i) const { return m_sides[m_first_side[e] + i]; }

  int opposite_vertex(const int e, const int v) const
  {
    return m_vertices[e][0] == v ? m_vertices[e][1] : m_vertices[e][0];
  }
};

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_CLASSIFICATION_EDGE_TABLE_H
