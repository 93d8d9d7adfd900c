// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_MOVED_VERTICES_H
#define CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_MOVED_VERTICES_H

#include <CGAL/Hermite_diffuse_remeshing/internal/Transformation/Face_grid.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Hermite_diffuse_remeshing {
namespace internal {

// Numbers of vertices that have moved, by the ball that holds the faces around them: most searches need to know of few
// of them.
class Moved_vertices
{
  struct Moves_in_ball
  {
    std::vector<int> vertices;
    Face_grid<int>::Cell* cell = nullptr;         // of the ball; meaningless without vertices
  };

  std::vector<int> m_anywhere;
  std::vector<Moves_in_ball> m_in_balls;
  Face_grid<int> m_grid;                          // of the balls in which vertices have moved
  std::vector<int> m_near;                        // balls

public:
  // `extent`: of the largest ball that will be
  explicit Moved_vertices(const double extent) : m_grid(extent) {}

  // the faces around the vertex may be anywhere
  void add_anywhere(const int vertex) { m_anywhere.push_back(vertex); }

  // they are in the ball, which has a number and a box
  void add(const int vertex, const int ball, const Bounding_box& box)
  {
    if(m_in_balls.size() <= std::size_t(ball))
      m_in_balls.resize(ball + 1);
    Moves_in_ball& moves = m_in_balls[ball];
    if(moves.vertices.empty())
      moves.cell = m_grid.insert(ball, box);
    moves.vertices.push_back(vertex);
  }

  // Calls `visit(vertex)` for the vertices around which faces may be in a box, and forgets them, until it returns false.
  template <typename Visit>
  void take(const Bounding_box& box, const Visit& visit)
  {
    if(!std::all_of(m_anywhere.begin(), m_anywhere.end(), visit))
      return;
    m_anywhere.clear();
    m_near.clear();
    m_grid.visit_near(box, [this](const int ball, const Bounding_box&) { m_near.push_back(ball); return true; });
    for(const int ball : m_near)
    {
      Moves_in_ball& moves = m_in_balls[ball];
      if(!std::all_of(moves.vertices.begin(), moves.vertices.end(), visit))
        return;
      moves.vertices.clear();
      m_grid.erase(ball, moves.cell);
    }
  }
};

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_MOVED_VERTICES_H
