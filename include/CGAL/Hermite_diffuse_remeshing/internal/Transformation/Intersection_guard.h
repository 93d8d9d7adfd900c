// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_INTERSECTION_GUARD_H
#define CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_INTERSECTION_GUARD_H

#include <CGAL/Hermite_diffuse_remeshing/internal/Transformation/do_triangles_meet.h>

#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/property_map.h>

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <cstddef>
#include <limits>

namespace CGAL {
namespace Hermite_diffuse_remeshing {
namespace internal {

typedef boost::container::small_vector<Numbered_triangle, 16> Numbered_triangles;

// Knows where the faces of the mesh are, and whether triangles that are to replace some of them would meet
// others.
template <typename TriangleMesh>
class Intersection_guard
{
  typedef typename boost::graph_traits<TriangleMesh>::face_descriptor face_descriptor;
  typedef Face_grid<face_descriptor> Grid;
  typedef typename Grid::Cell Cell;
  typedef typename boost::property_map<TriangleMesh, CGAL::dynamic_face_property_t<Cell*> >::type Cell_map;

  Grid m_grid;
  Cell_map m_cells;                     // null: the face is not known

public:
  // `extent`: of the whole mesh
  Intersection_guard(TriangleMesh& tmesh, const double extent)
    : m_grid(extent), m_cells(get(CGAL::dynamic_face_property_t<Cell*>(), tmesh))
  {
    for(const face_descriptor f : faces(tmesh))
      put(m_cells, f, nullptr);
  }

  // The face is new, or has moved; it is inside the box, and may move there.
  void note(const face_descriptor f, const Bounding_box& box)
  {
    Cell* const cell = get(m_cells, f);
    if(cell != nullptr && Grid::holds(*cell, box))
    {
      Grid::set_box(f, box, *cell);
      return;
    }
    if(cell != nullptr)
      m_grid.erase(f, cell);
    put(m_cells, f, m_grid.insert(f, box));
  }

  // the face will be removed
  void forget(const face_descriptor f)
  {
    Cell* const cell = get(m_cells, f);
    if(cell != nullptr)
      m_grid.erase(f, cell);
    put(m_cells, f, nullptr);
  }

  // that the face is inside the box, and perhaps no more
  bool knows(const face_descriptor f, const Bounding_box& box) const
  {
    const Cell* const cell = get(m_cells, f);
    return cell != nullptr && Grid::box(f, *cell).holds(box);
  }

  // calls `visit(face, its box)` for the faces whose boxes meet the box until it returns false
  template <typename Visit>
  bool visit_near(const Bounding_box& box, const Visit& visit) const { return m_grid.visit_near(box, visit); }

  // Whether `made` may take the place of `replaced`: nothing meets then, or no more pairs of faces do than now. A face
  // may get rid of one that it meets and meet another instead: where two sheets pass through each other there would be
  // no operation at all otherwise. `triangle(f)` gives a face with its numbers.
  template <typename Triangle>
  bool allows(const Numbered_triangles& made, const Numbered_triangles& replaced, const Triangle& triangle) const
  {
    if(number_of_meetings(made, replaced, triangle, 1) == 0)
      return true;
    const std::size_t now = number_of_meetings(replaced, replaced, triangle, (std::numeric_limits<std::size_t>::max)());
    return now > 0 && number_of_meetings(made, replaced, triangle, now + 1) <= now;
  }

private:
  // The pairs that meet among some triangles, or of them and the faces other than `replaced`. Counts no farther than
  // to `limit`.
  template <typename Triangle>
  std::size_t number_of_meetings(const Numbered_triangles& triangles, const Numbered_triangles& replaced,
                                 const Triangle& triangle, const std::size_t limit) const
  {
    std::size_t number = 0;
    if(triangles.empty())
      return number;
    boost::container::small_vector<Bounding_box, 16> boxes;
    for(const Numbered_triangle& t : triangles)
      boxes.push_back(Bounding_box(t.points));
    Bounding_box box = boxes.front();
    for(std::size_t i = 1; i < triangles.size(); ++i)
    {
      box.add(boxes[i]);
      for(std::size_t j = 0; j < i; ++j)
        number += boxes[i].meets(boxes[j]) && do_triangles_meet(triangles[i], triangles[j]);
    }
    if(number < limit)
      visit_near(box, [&](const face_descriptor f, const Bounding_box& box_of_face)
      {
        const auto is_near = [&](const Bounding_box& b) { return b.meets(box_of_face); };
        const auto first = std::find_if(boxes.begin(), boxes.end(), is_near);
        if(first == boxes.end())
          return true;
        const Numbered_triangle other = triangle(f);
        if(!is_among(other, replaced))
          for(std::size_t i = first - boxes.begin(); i < boxes.size(); ++i)
            number += is_near(boxes[i]) && do_triangles_meet(triangles[i], other);
        return number < limit;
      });
    return number;
  }

  static bool is_among(const Numbered_triangle& t, const Numbered_triangles& others)
  {
    return std::any_of(others.begin(), others.end(), [&](const Numbered_triangle& other)
                       { return other.vertices == t.vertices; });
  }
};

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_INTERSECTION_GUARD_H
