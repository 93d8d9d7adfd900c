// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_PLAN_REPAIRS_H
#define CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_PLAN_REPAIRS_H

#include <CGAL/Hermite_diffuse_remeshing/internal/Classification/classify_edges.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Indexed_triangles.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Repair_mesh.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/unfold_faces.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <vector>

namespace CGAL {
namespace Hermite_diffuse_remeshing {
namespace internal {

// Points that are closer than this may differ by the rounding of their coordinates alone. Coordinates that
// all fit into single precision come from there, as those of an STL file do.
inline double resolution_of_coordinates(const Indexed_triangles& triangles)
{
  double largest = 0.;
  bool is_single = true;
  for(const std::array<int, 3>& t : triangles.triangles)
    for(const int v : t)
    {
      const Vector& p = triangles.points[v];
      largest = (std::max)(largest, p.cwiseAbs().maxCoeff());
      is_single = is_single && p.cwiseAbs().maxCoeff() < double((std::numeric_limits<float>::max)())
                            && p.cast<float>().cast<double>() == p;
    }
  // two points in three coordinates, each rounded by half a unit in the last place: below 2 sqrt(3) halves
  constexpr double halves = 4.;
  return halves / 2. * largest * (is_single ? double(std::numeric_limits<float>::epsilon())
                                            : std::numeric_limits<double>::epsilon());
}

inline std::size_t count_degenerate_faces(const Indexed_triangles& triangles, const double resolution)
{
  std::size_t number = 0;
  for(int f = 0; f < triangles.number_of_faces(); ++f)
    number += is_degenerate_triangle(triangles.point(f, 0), triangles.point(f, 1), triangles.point(f, 2), resolution);
  return number;
}

inline void check_has_area(const Indexed_triangles& triangles, const std::size_t number_of_degenerate_faces)
{
  if(number_of_degenerate_faces == triangles.triangles.size())
    throw std::invalid_argument("all faces are degenerate, from face 0 on: a surface without area has no shape");
}

inline std::size_t count_isolated_vertices(const Indexed_triangles& triangles)
{
  std::vector<char> is_used(triangles.points.size(), false);
  for(const std::array<int, 3>& t : triangles.triangles)
    for(const int v : t)
      is_used[v] = true;
  return std::count(is_used.begin(), is_used.end(), char(false));
}

// the points that equal another, which is not counted
inline std::size_t count_coincident_points(const std::vector<Vector>& points)
{
  std::vector<std::array<double, 3> > sorted;
  for(const Vector& p : points)
    sorted.push_back({{p[0], p[1], p[2]}});
  std::sort(sorted.begin(), sorted.end());
  return sorted.end() - std::unique(sorted.begin(), sorted.end());
}

// Triangles after some repairs. Vertices keep their numbers, `faces[i]` is the former number of face i.
struct Repaired_triangles
{
  std::vector<Repair> repairs;
  std::vector<int> faces;
  std::vector<std::array<int, 3> > triangles;
  Side_marks side_marks;
  std::size_t number_of_degenerate_faces = 0, number_of_degenerate_faces_left = 0;
  std::size_t number_of_folded_faces = 0, number_of_folded_faces_left = 0;
  double highest_rise = 0.;             // how far the unfolding has moved the surface at most
};

// Finds the degenerate faces, whose height is within the resolution, and gets rid of them without a guess:
// of a face with two vertices at one place by the collapse of the edge between them, of a face with
// a vertex inside its longest edge by the flip of that edge. User's features stay, and what has no such
// way out. Then it unfolds what is folded over.
class Repair_planner
{
  typedef Repair_mesh::Vertex_index Vertex_index;
  typedef Repair_mesh::Halfedge_index Halfedge_index;
  typedef Repair_mesh::Face_index Face_index;

  const Indexed_triangles& m_input;
  Repair_mesh m_mesh;
  double m_largest_rise;

  // A repair can make the next one possible; chains of more than these are left to the remeshing.
  static constexpr int maximum_number_of_passes = 16;

public:
  // `largest_rise`: how far the unfolding may move the surface; for the others see `Repair_mesh`
  Repair_planner(const Indexed_triangles& input, const Side_marks& side_marks, const double resolution,
                 const double largest_rise, const std::vector<char>& is_free, const std::vector<char>& is_constrained)
    : m_input(input), m_mesh(input, side_marks, resolution, is_free, is_constrained), m_largest_rise(largest_rise)
  {}

  Repaired_triangles operator()()
  {
    Repaired_triangles result;
    result.number_of_degenerate_faces = degenerate_faces().size();
    for(int pass = 0; pass < maximum_number_of_passes; ++pass)
    {
      const std::size_t before = m_mesh.repairs().size();
      for(const Face_index f : degenerate_faces())
        if(!m_mesh.connectivity().is_removed(f) && m_mesh.is_degenerate(f))
          repair(f);
      if(m_mesh.repairs().size() == before)
        break;
    }
    result.number_of_degenerate_faces_left = degenerate_faces().size();
    Face_unfolding unfold(m_mesh, m_largest_rise);
    result.number_of_folded_faces = unfold.folded_faces().size();
    unfold();
    result.number_of_folded_faces_left = unfold.folded_faces().size();
    result.highest_rise = unfold.highest_rise();
    result.repairs = m_mesh.repairs();
    for(const Face_index f : m_mesh.connectivity().faces())
      add_face(f, result);
    return result;
  }

private:
  // from its former first corner on, if it still has it
  void add_face(const Face_index f, Repaired_triangles& result) const
  {
    const auto& mesh = m_mesh.connectivity();
    Halfedge_index h = mesh.halfedge(f);
    for(int k = 0; k < 2 && int(mesh.source(h)) != m_input.triangles[f][0]; ++k)
      h = mesh.next(h);
    std::array<int, 3> triangle;
    std::array<Edge_mark, 3> marks;
    for(int k = 0; k < 3; ++k, h = mesh.next(h))
    {
      triangle[k] = int(mesh.source(h));
      marks[k] = m_mesh.mark(h);
    }
    result.faces.push_back(int(f));
    result.triangles.push_back(triangle);
    result.side_marks.push_back(marks);
  }

  std::vector<Face_index> degenerate_faces() const
  {
    std::vector<Face_index> result;
    for(const Face_index f : m_mesh.connectivity().faces())
      if(m_mesh.is_degenerate(f))
        result.push_back(f);
    return result;
  }

  void repair(const Face_index f)
  {
    const auto sides = m_mesh.shortest_and_longest_side(f);
    const Halfedge_index shortest = sides.first, longest = sides.second;
    if(m_mesh.is_short(shortest))
    {
      for(const Halfedge_index h : {shortest, m_mesh.connectivity().opposite(shortest)})
        if(m_mesh.is_collapse_legal(h))
          return m_mesh.collapse(h);
    }
    else if(m_mesh.is_flip_legal(longest) && is_flip_of_use(longest))
      m_mesh.flip(longest);
  }

  // of the longest side of a degenerate face
  bool is_flip_of_use(const Halfedge_index h) const
  {
    const auto& mesh = m_mesh.connectivity();
    const Halfedge_index o = mesh.opposite(h);
    const Vertex_index a = mesh.source(h), b = mesh.target(h), c = m_mesh.apex(h), d = m_mesh.apex(o);
    if(m_mesh.is_degenerate(mesh.face(o)))
    {
      // four points on a line: the edges become shorter
      constexpr double noticeable = 1. - 1e-9;
      return (m_mesh.point(d) - m_mesh.point(c)).norm() < noticeable * m_mesh.length(h);
    }
    const Vector normal = m_mesh.area_vector(o);
    return !m_mesh.is_degenerate(a, d, c) && !m_mesh.is_degenerate(d, b, c)
        && normal.dot(m_mesh.area_vector(a, d, c)) > 0. && normal.dot(m_mesh.area_vector(d, b, c)) > 0.;
  }
};

// `Planner` is `Repair_planner`: a template for the same reason as `make_model()`.
template <typename Planner>
Repaired_triangles repair_triangles(const Indexed_triangles& input, const Side_marks& side_marks, const double resolution,
                                    const double largest_rise, const std::vector<char>& is_free,
                                    const std::vector<char>& is_constrained)
{
  return Planner(input, side_marks, resolution, largest_rise, is_free, is_constrained)();
}

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_PLAN_REPAIRS_H
