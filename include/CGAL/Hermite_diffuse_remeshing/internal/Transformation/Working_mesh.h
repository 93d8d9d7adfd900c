// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_WORKING_MESH_H
#define CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_WORKING_MESH_H

#include <CGAL/Hermite_diffuse_remeshing/internal/Progress.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Transformation/Guarded_mesh.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Transformation/sort_free_elements.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/edge_topology.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/for_each_index.h>

#include <CGAL/assertions.h>
#include <CGAL/boost/graph/Euler_operations.h>

#include <boost/container/static_vector.hpp>
#include <boost/property_map/function_property_map.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Hermite_diffuse_remeshing {
namespace internal {

// The one gate to the user's mesh: every Euler operation, every change of a point, of a constraint or of
// a patch label, and every call of the visitor is made here. An operation on a vertex or an edge of a
// junction is carried out on all its copies.
template <typename UserMesh>
class Working_mesh : public Guarded_mesh<UserMesh>
{
  typedef Guarded_mesh<UserMesh> Base;
  typedef typename Base::Edge Edge;

public:
  typedef typename Base::TriangleMesh TriangleMesh;
  typedef typename Base::Graph_traits Graph_traits;
  typedef typename Base::Vertex Vertex;
  typedef typename Base::vertex_descriptor vertex_descriptor;
  typedef typename Base::halfedge_descriptor halfedge_descriptor;
  typedef typename Base::edge_descriptor edge_descriptor;
  typedef typename Base::face_descriptor face_descriptor;
  typedef typename Base::Copies Copies;
  typedef std::vector<std::pair<vertex_descriptor, vertex_descriptor> > Diagonals;

private:
  using Base::m_user;
  using Base::m_reference;
  using Base::m_vertex_index;
  using Base::m_edge;
  using Base::m_hint;
  using Base::m_vertices;
  using Base::m_places;
  using Base::m_free_vertices;
  using Base::m_junctions;
  using Base::m_number_of_faces;
  using Base::m_changes;

  std::size_t m_maximum_number_of_faces;
  Operation_counts m_counts;

public:
  using Base::tmesh;
  using Base::index;
  using Base::point;
  using Base::hint;
  using Base::triangle;
  using Base::is_remeshed;
  using Base::is_on_curve;
  using Base::siblings;
  using Base::visit_copies;
  using Base::has_new_shape;
  using Base::is_stopped;
  using Base::touch_around;
  using Base::touch_quadrangle;
  using Base::add_vertex;
  using Base::free_vertex;
  using Base::set_edge;
  using Base::set_site;
  using Base::note;
  using Base::note_around;
  using Base::forget_around;
  using Base::forget_ball;
  using Base::move_ball;

  template <typename IsFrozen>
  Working_mesh(const UserMesh& user, const Reference& reference,
               const std::vector<face_descriptor>& faces_of_reference, const std::vector<char>& is_remeshed,
               const IsFrozen& is_edge_frozen, const std::size_t maximum_number_of_faces, const bool is_guarded)
    : Base(user, reference, faces_of_reference, is_remeshed, is_edge_frozen, is_guarded)
    , m_maximum_number_of_faces(maximum_number_of_faces)
  {}

  const Operation_counts& counts() const { return m_counts; }

  // \name Control
  // for what only reads the mesh
  Progress progress() const { return Progress([this](double) { return !Base::is_stopped(); }); }
  void give_up_if_stopped() const
  {
    if(is_stopped())
      throw Interrupted();
  }
  std::size_t maximum_number_of_faces() const { return m_maximum_number_of_faces; }
  bool has_room_for(const std::size_t number) const { return m_number_of_faces + number <= m_maximum_number_of_faces; }
  bool is_full() const { return !has_room_for(2); }
  void report_progress(const double fraction) { m_user.visitor.progress(fraction); }

  // Room for a number of faces that are remeshed: a mesh that grows face by face is copied again and again. What is made
  // takes free places in their order.
  void make_room(const std::size_t number_of_faces)
  {
    if(number_of_faces <= m_number_of_faces)
      return;
    TriangleMesh& tm = m_user.tmesh;
    const std::size_t more_faces = number_of_faces - m_number_of_faces, more_vertices = more_faces / 2 + 1,
                      more_edges = more_vertices + more_faces;                          // as Euler has it
    reserve(tm, num_vertices(tm) + more_vertices, num_edges(tm) + more_edges, num_faces(tm) + more_faces);
    m_vertices.reserve(m_vertices.size() + more_vertices);
    m_places.reserve(m_places.size() + more_vertices);
    Base::make_room_for_vertices(m_vertices.size() + more_vertices);
    std::sort(m_free_vertices.begin(), m_free_vertices.end(), std::greater<int>());
    sort_free_elements(tm);
  }

  // \name Operations
  // The caller has made sure that they are legal.
  // inserts a vertex at a site in the edge of h and joins it to the opposite vertices
  vertex_descriptor split_edge(const halfedge_descriptor h, const Site& site)
  {
    Vertex vertex;
    vertex.site = site;
    vertex.type = is_on_curve(h) ? CURVE_VERTEX : SURFACE_VERTEX;
    const int number = add_vertex(vertex);
    forget_ball(number);
    vertex_descriptor first = Graph_traits::null_vertex();
    Copies copies;
    for(const halfedge_descriptor sibling : siblings(h))
    {
      const vertex_descriptor copy = split_sibling(sibling, number);
      first = copies.empty() ? copy : first;
      copies.push_back(copy);
    }
    m_vertices[number].descriptor = first;
    m_junctions.set(number, copies);
    note_around(first);
    touch_around(first);
    ++m_counts.splits;
    return first;
  }

  // removes the source of h; its target moves to a site
  vertex_descriptor collapse_edge(const halfedge_descriptor h, const Site& site)
  {
    const int kept = index(target(h, tmesh())), removed = index(source(h, tmesh()));
    move_ball(kept, (site.point - m_vertices[kept].site.point).norm());
    set_site(kept, site);
    vertex_descriptor v = target(h, tmesh());
    for(const halfedge_descriptor sibling : siblings(h))
    {
      const vertex_descriptor stayed = collapse_sibling(sibling, kept);
      if(sibling == h)
        v = stayed;
    }
    free_vertex(removed);
    m_vertices[kept].descriptor = v;
    visit_copies(v, [&](const vertex_descriptor copy) { m_user.set_point(copy, site.point); });
    note_around(v);
    touch_around(v);
    ++m_counts.collapses;
    return v;
  }

  void flip_edge(const halfedge_descriptor h)
  {
    TriangleMesh& tm = m_user.tmesh;
    m_user.visitor.before_edge_flip(edge(h, tm));
    touch_quadrangle(h);
    CGAL::Euler::flip_edge(h, tm);
    note_around(target(h, tm));
    ++m_counts.flips;
    m_user.visitor.after_edge_flip(edge(h, tm));
  }

  void relocate(const vertex_descriptor v, const Site& site)
  {
    visit_copies(v, [&](const vertex_descriptor copy) { m_user.visitor.before_vertex_relocation(copy); });
    move_ball(index(v), (site.point - point(v)).norm());
    set_site(index(v), site);
    visit_copies(v, [&](const vertex_descriptor copy)
    {
      m_user.set_point(copy, site.point);
      m_user.visitor.after_vertex_relocation(copy);
    });
    Base::note_relocated(v);
    touch_around(v);
    ++m_counts.relocations;
  }

  // removes a vertex inside the surface and fills the polygon around it with diagonals
  void remove_vertex(const vertex_descriptor v, const Diagonals& diagonals)
  {
    TriangleMesh& tm = m_user.tmesh;
    m_user.visitor.before_vertex_removal(v);
    for(const halfedge_descriptor h : CGAL::halfedges_around_target(v, tm))
      m_user.set_constrained(edge(h, tm), false);
    touch_around(v);
    forget_around(v);
    free_vertex(index(v));
    m_number_of_faces -= degree(v, tm) - 1;
    const auto parts = fill_polygon(CGAL::Euler::remove_center_vertex(halfedge(v, tm), tm), diagonals);
    ++m_counts.vertex_removals;
    m_user.visitor.after_vertex_removal();
    tell_of_parts(parts);
    for(const face_descriptor f : parts)
      note(f);
  }

  // Replaces edges at the target of h by other diagonals of the same polygon: those between the face of h
  // and the faces that follow by opposite(next(h)).
  void retriangulate_fan(const halfedge_descriptor h, const std::size_t number_of_edges, const Diagonals& diagonals)
  {
    TriangleMesh& tm = m_user.tmesh;
    // the visitor, which may throw, sees the mesh before the first change and after the last
    halfedge_descriptor g = h;
    for(std::size_t i = 0; i < number_of_edges; ++i, g = opposite(next(g, tm), tm))
      m_user.visitor.before_edge_flip(edge(next(g, tm), tm));
    touch_around(target(h, tm));
    forget_around(target(h, tm));
    for(std::size_t i = 0; i < number_of_edges; ++i)
    {
      m_user.set_constrained(edge(next(h, tm), tm), false);
      CGAL::Euler::join_face(next(h, tm), tm);
      --m_number_of_faces;
      ++m_counts.flips;
    }
    const std::vector<face_descriptor> parts = fill_polygon(h, diagonals);
    for(const std::pair<vertex_descriptor, vertex_descriptor>& ends : diagonals)
      m_user.visitor.after_edge_flip(edge(ends.first, ends.second, tm).first);
    tell_of_parts(parts);
    for(const face_descriptor f : parts)
      note(f);
    note_around(target(h, tm));
  }

  // the size map has changed
  void update_sizes()
  {
    // the far end of a slope of the sizes, which no operator would notice, is no change
    constexpr double least_change = 0.01;
    m_changes.begin();
    for(std::size_t i = 0; i < m_vertices.size(); ++i)
    {
      Site& site = m_vertices[i].site;
      const double size = m_reference.sizes(site.location);
      if(std::abs(size - site.size) > least_change * site.size)
        m_changes.set_at_vertex(static_cast<int>(i));
      m_places[i].size = site.size = size;
    }
  }

  // the face on which the centroid of a face lies
  int face_of_reference(const face_descriptor f) const
  {
    const std::array<Vector, 3> corners = triangle(f).points;
    return m_reference.locator.walk((corners[0] + corners[1] + corners[2]) / 3., hint(f)).face;
  }

  // remembers where on the reference the faces lie that have changed, so that the next walk is short
  void update_hints(const std::size_t since)
  {
    std::vector<std::pair<face_descriptor, int> > hints;
    std::size_t step = 0;
    for(const face_descriptor f : faces(tmesh()))
    {
      if(Base::is_stopped_at(step++))
        return;
      if(is_remeshed(f) && has_new_shape(f, since))
        hints.push_back(std::make_pair(f, -1));
    }
    for_each_index(static_cast<int>(hints.size()), Base::is_parallel(), [&]
    {
      return [&](const int i) { hints[i].second = face_of_reference(hints[i].first); };
    }, progress());
    for(const std::pair<face_descriptor, int>& entry : hints)
      put(m_hint, entry.first, entry.second);
  }

private:
  vertex_descriptor split_sibling(const halfedge_descriptor h, const int number)
  {
    TriangleMesh& tm = m_user.tmesh;
    m_user.visitor.before_edge_split(edge(h, tm));
    const Edge edge_data = get(m_edge, edge(h, tm));
    const halfedge_descriptor o = opposite(h, tm);
    const halfedge_descriptor h_new = CGAL::Euler::split_edge(h, tm);
    const vertex_descriptor v = target(h_new, tm);
    set_edge(edge(h_new, tm), edge_data);
    boost::container::static_vector<std::pair<face_descriptor, face_descriptor>, 2> parts;
    if(!CGAL::is_border(h, tm))
      parts.push_back(split_face(h_new, next(h, tm)));
    if(!CGAL::is_border(o, tm))
      parts.push_back(split_face(o, next(opposite(h_new, tm), tm)));
    put(m_vertex_index, v, number);
    m_user.set_point(v, m_vertices[number].site.point);
    m_user.visitor.after_edge_split(v);
    for(const std::pair<face_descriptor, face_descriptor>& part : parts)
      m_user.visitor.after_face_split(part.first, part.second);
    return v;
  }

  vertex_descriptor collapse_sibling(const halfedge_descriptor h, const int number)
  {
    TriangleMesh& tm = m_user.tmesh;
    m_user.visitor.before_edge_collapse(h);
    const halfedge_descriptor o = opposite(h, tm);
    const vertex_descriptor target_before = target(h, tm);
    // Euler::collapse_edge() keeps one edge of each of the two triangles, which one depends on the direction of the edge;
    // ours are the ones at the target. Protected edges stay themselves; others must not be constrained when they are gone.
    m_user.set_constrained(edge(h, tm), false);
    boost::container::static_vector<std::pair<vertex_descriptor, Edge>, 2> kept_edges;
    for(const halfedge_descriptor side : {h, o})
      if(!CGAL::is_border(side, tm))
      {
        --m_number_of_faces;
        Base::forget(face(side, tm));
        const edge_descriptor kept = edge(side == h ? next(h, tm) : prev(o, tm), tm);
        kept_edges.push_back(std::make_pair(target(next(side, tm), tm), get(m_edge, kept)));
        for(const halfedge_descriptor g : {next(side, tm), prev(side, tm)})
          if(!get(m_edge, edge(g, tm)).is_protected)
            m_user.set_constrained(edge(g, tm), false);
      }
    const auto is_protected_edge = boost::make_function_property_map<typename Graph_traits::edge_descriptor>(
      [this](const auto e) { return get(m_edge, e).is_protected; });
    const vertex_descriptor v = CGAL::Euler::collapse_edge(edge(h, tm), tm, is_protected_edge);
    for(const std::pair<vertex_descriptor, Edge>& kept : kept_edges)
      set_edge(edge(v, kept.first, tm).first, kept.second);
    put(m_vertex_index, v, number);
    m_junctions.replace(number, target_before, v);
    m_user.set_point(v, m_vertices[number].site.point);
    m_user.visitor.after_edge_collapse(v);
    return v;
  }

  // Joins the targets of two halfedges of one face; the new one inherits what the face knew. Returns both.
  std::pair<face_descriptor, face_descriptor> split_face(const halfedge_descriptor h, const halfedge_descriptor g)
  {
    TriangleMesh& tm = m_user.tmesh;
    const face_descriptor f = face(h, tm);
    const halfedge_descriptor diagonal = CGAL::Euler::split_face(h, g, tm);
    const face_descriptor part = face(face(diagonal, tm) == f ? opposite(diagonal, tm) : diagonal, tm);
    set_edge(edge(diagonal, tm), Edge());
    put(m_hint, part, hint(f));
    m_user.copy_patch(f, part);
    m_changes.set_of_face(f);
    m_changes.set_of_face(part);
    ++m_number_of_faces;
    return std::make_pair(f, part);
  }

  // splits the face of h into triangles, the first of which keeps its descriptor
  std::vector<face_descriptor> fill_polygon(const halfedge_descriptor h, const Diagonals& diagonals)
  {
    const TriangleMesh& tm = tmesh();
    m_changes.set_of_face(face(h, tm));
    std::vector<face_descriptor> parts(1, face(h, tm));
    for(const std::pair<vertex_descriptor, vertex_descriptor>& ends : diagonals)
      for(const face_descriptor part : parts)
      {
        const halfedge_descriptor to_first = halfedge_to(ends.first, part, tm);
        const halfedge_descriptor to_second = halfedge_to(ends.second, part, tm);
        if(to_first == Graph_traits::null_halfedge() || to_second == Graph_traits::null_halfedge())
          continue;
        parts.push_back(split_face(to_first, to_second).second);
        break;
      }
    return parts;
  }

  void tell_of_parts(const std::vector<face_descriptor>& parts)
  {
    for(std::size_t i = 1; i < parts.size(); ++i)
      m_user.visitor.after_face_split(parts.front(), parts[i]);
  }
};

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_WORKING_MESH_H
