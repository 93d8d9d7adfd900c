// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_SIZING_BISECTION_TREE_H
#define CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_SIZING_BISECTION_TREE_H

#include <CGAL/Hermite_diffuse_remeshing/internal/Indexed_triangles.h>

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Hermite_diffuse_remeshing {
namespace internal {

// The faces of the reference, bisected where the size map needs it. The corners of the cells are samples,
// known by number; the first cells are the faces.
class Bisection_tree
{
public:
  struct Cell
  {
    std::array<int, 3> samples;
    int face;
    int split_side = -1;                  // -1: leaf
    int first_child = -1;                 // the children keep the start and the end of the split side
    bool is_probed = false;               // the user's field hides nothing inside
  };

private:
  std::vector<Cell> m_cells;

public:
  explicit Bisection_tree(const Indexed_triangles& triangles)
    : m_cells(triangles.number_of_faces())
  {
    for(int f = 0; f < triangles.number_of_faces(); ++f)
    {
      m_cells[f].samples = triangles.triangles[f];
      m_cells[f].face = f;
    }
  }

  int number_of_cells() const { return static_cast<int>(m_cells.size()); }
  const Cell& operator[](const int c) const { return m_cells[c]; }
  bool is_leaf(const int c) const { return m_cells[c].split_side == -1; }
  void set_probed(const int c) { m_cells[c].is_probed = true; }

  std::vector<std::array<int, 3> > samples_of_leaves() const
  {
    std::vector<std::array<int, 3> > result;
    for(const Cell& cell : m_cells)
      if(cell.split_side == -1)
        result.push_back(cell.samples);
    return result;
  }

  // the leaf at a location, and the coordinates in it
  std::pair<int, Barycentric> leaf(const Location& location) const
  {
    // Points between two children are usual on regular meshes, and what is asked for there is asked of one of them:
    // rounding must not choose.
    constexpr double margin = 1e-9;
    int c = location.face;
    Barycentric l = location.coordinates;
    while(m_cells[c].split_side != -1)
    {
      const int k = m_cells[c].split_side, j = next(k);
      const int child = l[k] + margin >= l[j] ? 0 : 1;
      const int kept = child == 0 ? k : j, replaced = child == 0 ? j : k;
      l[kept] -= l[replaced];
      l[replaced] *= 2.;
      c = m_cells[c].first_child + child;
    }
    return std::make_pair(c, l);
  }

  // splits a leaf at the sample in the middle of side k
  void bisect(const int c, const int k, const int middle)
  {
    Cell first = m_cells[c], second = m_cells[c];
    first.samples[next(k)] = middle;
    second.samples[k] = middle;
    m_cells[c].split_side = k;
    m_cells[c].first_child = number_of_cells();
    m_cells.push_back(first);
    m_cells.push_back(second);
  }
};

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_SIZING_BISECTION_TREE_H
