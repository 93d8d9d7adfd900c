// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_REPAIR_MESH_H
#define CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_REPAIR_MESH_H

#include <CGAL/Hermite_diffuse_remeshing/internal/Classification/classify_edges.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Indexed_triangles.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/edge_topology.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/assertions.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/use.h>

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace CGAL {
namespace Hermite_diffuse_remeshing {
namespace internal {

struct Repair
{
  enum Kind { COLLAPSE, FLIP };

  Kind kind;
  int source, target;                   // ends of the edge; a collapse removes the source
};

// Is the height over the longest edge within the resolution?
inline bool is_degenerate_triangle(const Vector& a, const Vector& b, const Vector& c, const double resolution)
{
  const double longest = (std::max)({(b - a).norm(), (c - b).norm(), (a - c).norm()});
  return !((b - a).cross(c - a).norm() > resolution * longest);
}

// The connectivity of the input, on which repairs are planned: it lets none happen that the user's features do not
// allow, and writes down the others. Faces and vertices have their numbers of the input.
class Repair_mesh
{
public:
  typedef CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3> Connectivity;
  typedef Connectivity::Vertex_index Vertex_index;
  typedef Connectivity::Halfedge_index Halfedge_index;
  typedef Connectivity::Face_index Face_index;

private:
  const Indexed_triangles& m_input;
  double m_resolution;
  Connectivity m_mesh;
  Connectivity::Property_map<Connectivity::Edge_index, Edge_mark> m_mark;
  Connectivity::Property_map<Vertex_index, bool> m_is_kept;
  std::vector<Repair> m_repairs;

public:
  // `is_free[face]`: may it be changed? `is_constrained[vertex]`: must it stay?
  Repair_mesh(const Indexed_triangles& input, const Side_marks& side_marks, const double resolution,
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

  const Connectivity& connectivity() const { return m_mesh; }
  const std::vector<Repair>& repairs() const { return m_repairs; }
  Edge_mark mark(const Halfedge_index h) const { return m_mark[m_mesh.edge(h)]; }

  // \name Geometry
  const Vector& point(const Vertex_index v) const { return m_input.points[v]; }

  double length(const Halfedge_index h) const
  {
    return (point(m_mesh.target(h)) - point(m_mesh.source(h))).norm();
  }

  // the corner of the face of h that h does not touch
  Vertex_index apex(const Halfedge_index h) const { return m_mesh.target(m_mesh.next(h)); }

  Vector area_vector(const Vertex_index a, const Vertex_index b, const Vertex_index c) const
  {
    return (point(b) - point(a)).cross(point(c) - point(a));
  }

  Vector area_vector(const Halfedge_index h) const
  {
    return area_vector(m_mesh.source(h), m_mesh.target(h), apex(h));
  }

  bool is_degenerate(const Vertex_index a, const Vertex_index b, const Vertex_index c) const
  {
    return is_degenerate_triangle(point(a), point(b), point(c), m_resolution);
  }

  bool is_degenerate(const Face_index f) const
  {
    const Halfedge_index h = m_mesh.halfedge(f);
    return is_degenerate(m_mesh.source(h), m_mesh.target(h), apex(h));
  }

  bool is_short(const Halfedge_index h) const { return !(length(h) > m_resolution); }

  std::pair<Halfedge_index, Halfedge_index> shortest_and_longest_side(const Face_index f) const
  {
    Halfedge_index shortest = m_mesh.halfedge(f), longest = shortest;
    for(const Halfedge_index h : CGAL::halfedges_around_face(m_mesh.halfedge(f), m_mesh))
    {
      if(length(h) < length(shortest))
        shortest = h;
      if(length(h) > length(longest))
        longest = h;
    }
    return std::make_pair(shortest, longest);
  }

  // \name Collapse
  // A vertex of a feature may only move along it: two features that touch are not merged.
  bool is_collapse_legal(const Halfedge_index h) const
  {
    const Vertex_index s = m_mesh.source(h);
    if(m_is_kept[s])
      return false;
    if(!is_feature(h))
      for(const Halfedge_index g : CGAL::halfedges_around_target(s, m_mesh))
        if(is_feature(g))
          return false;
    return is_collapse_manifold(h, m_mesh);
  }

  // removes the source
  void collapse(const Halfedge_index h)
  {
    CGAL_precondition(is_collapse_legal(h));
    m_repairs.push_back({Repair::COLLAPSE, int(m_mesh.source(h)), int(m_mesh.target(h))});
    std::vector<std::pair<Vertex_index, Edge_mark> > merged;
    for(const Halfedge_index g : {h, m_mesh.opposite(h)})
      if(!m_mesh.is_border(g))
        merged.push_back(std::make_pair(apex(g), (std::max)(mark(m_mesh.next(g)), mark(m_mesh.prev(g)))));
    const Vertex_index t = CGAL::Euler::collapse_edge(m_mesh.edge(h), m_mesh);
    for(const auto& edge : merged)
      m_mark[m_mesh.edge(m_mesh.halfedge(edge.first, t))] = edge.second;
  }

  // \name Flip
  bool is_flip_legal(const Halfedge_index h) const
  {
    if(is_feature(h))
      return false;
    const Vertex_index c = apex(h), d = apex(m_mesh.opposite(h));
    return c != d && !(m_is_kept[m_mesh.source(h)] && m_is_kept[m_mesh.target(h)])
        && m_mesh.halfedge(c, d) == Connectivity::null_halfedge();
  }

  void flip(const Halfedge_index h)
  {
    CGAL_precondition(is_flip_legal(h));
    m_repairs.push_back({Repair::FLIP, int(m_mesh.source(h)), int(m_mesh.target(h))});
    CGAL::Euler::flip_edge(h, m_mesh);
  }

private:
  bool is_feature(const Halfedge_index h) const
  {
    return mark(h) >= MARKED_PATCH_BORDER || m_mesh.is_border(m_mesh.edge(h));
  }
};

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_REPAIR_MESH_H
