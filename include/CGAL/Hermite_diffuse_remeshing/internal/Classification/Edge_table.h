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
#include <utility>
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
    int source, target;                           // source < target
    Face_side side;
  };

public:
  explicit Edge_table(const Indexed_triangles& surface)
    : m_edge_of_side(surface.triangles.size())
  {
    std::vector<Record> records;
    records.reserve(3 * surface.triangles.size());
    for(int f = 0; f < surface.number_of_faces(); ++f)
      for(int k = 0; k < 3; ++k)
      {
        const std::pair<const int&, const int&> ends =
          std::minmax(surface.triangles[f][k], surface.triangles[f][next(k)]);
        records.push_back({ends.first, ends.second, {f, k}});
      }
    // stable: the sides of an edge stay in the order of the faces
    std::stable_sort(records.begin(), records.end(), [](const Record& a, const Record& b)
                     { return a.source != b.source ? a.source < b.source : a.target < b.target; });

    m_sides.reserve(records.size());
    for(std::size_t i = 0; i < records.size(); ++i)
    {
      const Record& record = records[i];
      if(i == 0 || record.source != records[i-1].source || record.target != records[i-1].target)
      {
        m_vertices.push_back({{record.source, record.target}});
        m_first_side.push_back(static_cast<int>(i));
      }
      m_edge_of_side[record.side.face][record.side.side] = static_cast<int>(m_vertices.size()) - 1;
      m_sides.push_back(record.side);
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
