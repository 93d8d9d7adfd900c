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
#include <CGAL/Hermite_diffuse_remeshing/internal/edge_topology.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/assertions.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/iterator.h>

#include <algorithm>
#include <array>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Hermite_diffuse_remeshing {
namespace internal {

// Points that are closer than this may differ by the rounding of their coordinates alone. Coordinates that
// all fit into single precision come from there, as those of an STL file do.
inline double resolution_of_coordinates(const std::vector<Vector>& points)
{
  double largest = 0.;
  bool is_single = true;
  for(const Vector& p : points)
  {
    largest = (std::max)(largest, p.cwiseAbs().maxCoeff());
    is_single = is_single && p.cwiseAbs().maxCoeff() < double((std::numeric_limits<float>::max)())
                          && p.cast<float>().cast<double>() == p;
  }
  // two points in three coordinates, each rounded by half a unit in the last place: below 2 sqrt(3) halves
  constexpr double halves = 4.;
  return halves / 2. * largest * (is_single ? double(std::numeric_limits<float>::epsilon())
                                            : std::numeric_limits<double>::epsilon());
}

// Is the height over the longest edge within the resolution?
inline bool is_degenerate_triangle(const Vector& a, const Vector& b, const Vector& c, const double resolution)
{
  const double longest = (std::max)({(b - a).norm(), (c - b).norm(), (a - c).norm()});
  return !((b - a).cross(c - a).norm() > resolution * longest);
}

inline std::size_t count_degenerate_faces(const Indexed_triangles& triangles, const double resolution)
{
  std::size_t number = 0;
  for(int f = 0; f < triangles.number_of_faces(); ++f)
    number += is_degenerate_triangle(triangles.point(f, 0), triangles.point(f, 1), triangles.point(f, 2), resolution);
  return number;
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

// A change of the triangles that moves no point of the surface by more than the resolution.
struct Repair
{
  enum Kind { COLLAPSE, FLIP };

  Kind kind;
  int source, target;                   // ends of the edge; a collapse removes the source
};

// Triangles after some repairs. Vertices keep their numbers, `faces[i]` is the former number of face i.
struct Repaired_triangles
{
  std::vector<Repair> repairs;
  std::vector<int> faces;
  std::vector<std::array<int, 3> > triangles;
  Side_marks side_marks;
  std::size_t number_of_degenerate_faces = 0, number_of_degenerate_faces_left = 0;
};

// Finds the degenerate faces, whose height is within the resolution, and gets rid of them without a guess:
// of a face with two vertices at one place by the collapse of the edge between them, of a face with
// a vertex inside its longest edge by the flip of that edge. User's features stay, and what has no such
// way out.
class Repair_planner
{
  typedef CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3> Connectivity;
  typedef Connectivity::Vertex_index Vertex_index;
  typedef Connectivity::Halfedge_index Halfedge_index;
  typedef Connectivity::Face_index Face_index;

  const Indexed_triangles& m_input;
  double m_resolution;
  Connectivity m_mesh;
  Connectivity::Property_map<Connectivity::Edge_index, Edge_mark> m_mark;
  Connectivity::Property_map<Vertex_index, bool> m_is_kept;
  std::vector<Repair> m_repairs;

  // A repair can make the next one possible; chains of more than these are left to the remeshing.
  static constexpr int maximum_number_of_passes = 16;

public:
  // `is_free[face]`: may it be changed? `is_constrained[vertex]`: must it stay?
  Repair_planner(const Indexed_triangles& input, const Side_marks& side_marks, const double resolution,
                 const std::vector<char>& is_free, const std::vector<char>& is_constrained)
    : m_input(input), m_resolution(resolution)
  {
    m_mark = m_mesh.add_property_map<Connectivity::Edge_index, Edge_mark>("e:mark", UNMARKED_EDGE).first;
    m_is_kept = m_mesh.add_property_map<Vertex_index, bool>("v:kept", false).first;
    for(int v = 0; v < input.number_of_vertices(); ++v)
      m_is_kept[m_mesh.add_vertex()] = is_constrained[v] != 0;
    for(int f = 0; f < input.number_of_faces(); ++f)
    {
      const std::array<int, 3>& t = input.triangles[f];
      const Face_index added = m_mesh.add_face(Vertex_index(t[0]), Vertex_index(t[1]), Vertex_index(t[2]));
      CGAL_assertion(added == Face_index(f));
      CGAL_USE(added);
      for(int k = 0; k < 3; ++k)
      {
        const Vertex_index source(t[k]), target(t[next(k)]);
        m_mark[m_mesh.edge(m_mesh.halfedge(source, target))] = side_marks[f][k];
        if(!is_free[f])
          m_is_kept[source] = true;
      }
    }
  }

  Repaired_triangles operator()()
  {
    Repaired_triangles result;
    result.number_of_degenerate_faces = degenerate_faces().size();
    for(int pass = 0; pass < maximum_number_of_passes; ++pass)
    {
      const std::size_t before = m_repairs.size();
      for(const Face_index f : degenerate_faces())
        if(!m_mesh.is_removed(f) && is_degenerate(f))
          repair(f);
      if(m_repairs.size() == before)
        break;
    }
    result.number_of_degenerate_faces_left = degenerate_faces().size();
    result.repairs = m_repairs;
    for(const Face_index f : m_mesh.faces())
      add_face(f, result);
    return result;
  }

private:
  const Vector& point(const Vertex_index v) const { return m_input.points[v]; }

  // from its former first corner on, if it still has it
  void add_face(const Face_index f, Repaired_triangles& result) const
  {
    Halfedge_index h = m_mesh.halfedge(f);
    for(int k = 0; k < 2 && int(m_mesh.source(h)) != m_input.triangles[f][0]; ++k)
      h = m_mesh.next(h);
    std::array<int, 3> triangle;
    std::array<Edge_mark, 3> marks;
    for(int k = 0; k < 3; ++k, h = m_mesh.next(h))
    {
      triangle[k] = int(m_mesh.source(h));
      marks[k] = m_mark[m_mesh.edge(h)];
    }
    result.faces.push_back(int(f));
    result.triangles.push_back(triangle);
    result.side_marks.push_back(marks);
  }

  double length(const Halfedge_index h) const
  {
    return (point(m_mesh.target(h)) - point(m_mesh.source(h))).norm();
  }

  Vector area_vector(const Vertex_index a, const Vertex_index b, const Vertex_index c) const
  {
    return (point(b) - point(a)).cross(point(c) - point(a));
  }

  bool is_degenerate(const Vertex_index a, const Vertex_index b, const Vertex_index c) const
  {
    return is_degenerate_triangle(point(a), point(b), point(c), m_resolution);
  }

  Vertex_index apex(const Halfedge_index h) const { return m_mesh.target(m_mesh.next(h)); }

  bool is_degenerate(const Face_index f) const
  {
    const Halfedge_index h = m_mesh.halfedge(f);
    return is_degenerate(m_mesh.source(h), m_mesh.target(h), apex(h));
  }

  std::vector<Face_index> degenerate_faces() const
  {
    std::vector<Face_index> result;
    for(const Face_index f : m_mesh.faces())
      if(is_degenerate(f))
        result.push_back(f);
    return result;
  }

  void repair(const Face_index f)
  {
    Halfedge_index shortest = m_mesh.halfedge(f), longest = shortest;
    for(const Halfedge_index h : CGAL::halfedges_around_face(m_mesh.halfedge(f), m_mesh))
    {
      if(length(h) < length(shortest))
        shortest = h;
      if(length(h) > length(longest))
        longest = h;
    }
    if(length(shortest) > m_resolution)
      flip(longest);
    else if(!collapse(shortest))
      collapse(m_mesh.opposite(shortest));
  }

  bool is_feature(const Halfedge_index h) const
  {
    return m_mark[m_mesh.edge(h)] >= MARKED_PATCH_BORDER || m_mesh.is_border(m_mesh.edge(h));
  }

  // A vertex of a feature may only move along it: two features that touch are not merged.
  bool collapse(const Halfedge_index h)
  {
    const Vertex_index s = m_mesh.source(h);
    if(m_is_kept[s])
      return false;
    if(!is_feature(h))
      for(const Halfedge_index g : CGAL::halfedges_around_target(s, m_mesh))
        if(is_feature(g))
          return false;
    if(!is_collapse_manifold(h, m_mesh))
      return false;
    m_repairs.push_back({Repair::COLLAPSE, int(s), int(m_mesh.target(h))});

    std::vector<std::pair<Vertex_index, Edge_mark> > merged;
    for(const Halfedge_index g : {h, m_mesh.opposite(h)})
      if(!m_mesh.is_border(g))
        merged.push_back(std::make_pair(apex(g), (std::max)(m_mark[m_mesh.edge(m_mesh.next(g))],
                                                             m_mark[m_mesh.edge(m_mesh.prev(g))])));
    const Vertex_index t = CGAL::Euler::collapse_edge(m_mesh.edge(h), m_mesh);
    for(const auto& edge : merged)
      m_mark[m_mesh.edge(m_mesh.halfedge(edge.first, t))] = edge.second;
    return true;
  }

  bool flip(const Halfedge_index h)
  {
    const Halfedge_index o = m_mesh.opposite(h);
    if(is_feature(h))
      return false;
    const Vertex_index a = m_mesh.source(h), b = m_mesh.target(h), c = apex(h), d = apex(o);
    if(c == d || (m_is_kept[a] && m_is_kept[b]) || m_mesh.halfedge(c, d) != Connectivity::null_halfedge())
      return false;
    if(is_degenerate(m_mesh.face(o)))
    {
      // four points on a line: the edges become shorter
      constexpr double noticeable = 1. - 1e-9;
      if(!((point(d) - point(c)).norm() < noticeable * length(h)))
        return false;
    }
    else
    {
      const Vector normal = area_vector(b, a, d);
      if(is_degenerate(a, d, c) || is_degenerate(d, b, c)
         || !(normal.dot(area_vector(a, d, c)) > 0. && normal.dot(area_vector(d, b, c)) > 0.))
        return false;
    }
    m_repairs.push_back({Repair::FLIP, int(a), int(b)});
    CGAL::Euler::flip_edge(h, m_mesh);
    return true;
  }
};

// `Planner` is `Repair_planner`: a template for the same reason as `make_model()`.
template <typename Planner>
Repaired_triangles repair_triangles(const Indexed_triangles& input, const Side_marks& side_marks, const double resolution,
                                    const std::vector<char>& is_free, const std::vector<char>& is_constrained)
{
  return Planner(input, side_marks, resolution, is_free, is_constrained)();
}

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_PLAN_REPAIRS_H
