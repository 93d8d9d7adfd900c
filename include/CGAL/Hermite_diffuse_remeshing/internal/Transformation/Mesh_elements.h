// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_MESH_ELEMENTS_H
#define CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_MESH_ELEMENTS_H

#include <CGAL/Hermite_diffuse_remeshing/internal/Transformation/Change_record.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Transformation/Junctions.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Transformation/User_mesh.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Transformation/do_triangles_meet.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Transformation/quality.h>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/property_map.h>

#include <boost/container/small_vector.hpp>

#include <utility>
#include <vector>

namespace CGAL {
namespace Hermite_diffuse_remeshing {
namespace internal {

// What is known of the elements of the user's mesh while it is remeshed. Vertices carry numbers that do
// not depend on descriptors, so that an order by them is the same for every type of mesh. Copies of a vertex,
// where sheets of a non-manifold surface meet, have one number, and with it all data.
template <typename UserMesh>
class Mesh_elements
{
public:
  typedef typename UserMesh::TriangleMesh TriangleMesh;
  typedef boost::graph_traits<TriangleMesh> Graph_traits;
  typedef typename Graph_traits::vertex_descriptor vertex_descriptor;
  typedef typename Graph_traits::halfedge_descriptor halfedge_descriptor;
  typedef typename Graph_traits::edge_descriptor edge_descriptor;
  typedef typename Graph_traits::face_descriptor face_descriptor;
  typedef typename Junctions<vertex_descriptor>::Copies Copies;
  typedef boost::container::small_vector<halfedge_descriptor, 2> Siblings;

  struct alignas(64) Vertex             // a line of the cache
  {
    Site site;                          // begins with what is asked most
    Vertex_class type = SURFACE_VERTEX;
    int reference_vertex = -1;          // that it began as; where it is now if it is fixed
    bool is_frozen = false;
    vertex_descriptor descriptor = Graph_traits::null_vertex();   // one of the copies; null: the number is free
  };

protected:
  struct Edge
  {
    int curve = -1;                     // -1: interior
    Edge_class type = INTERIOR_EDGE;
    bool is_protected = false;
    bool is_constrained = false;        // in the user's map
  };

  typedef typename boost::property_map<TriangleMesh, CGAL::dynamic_vertex_property_t<int> >::type Vertex_index_map;
  typedef typename boost::property_map<TriangleMesh, CGAL::dynamic_edge_property_t<Edge> >::type Edge_map;
  typedef typename boost::property_map<TriangleMesh, CGAL::dynamic_face_property_t<int> >::type Face_hint_map;

  const UserMesh& m_user;
  const Reference& m_reference;
  Vertex_index_map m_vertex_index;
  Edge_map m_edge;
  Face_hint_map m_hint;                 // a face of the reference near the face; -1: not to be remeshed
  std::vector<Vertex> m_vertices;
  // of every vertex, what is asked most: dense, so that it stays in the cache, and none across two of its lines
  struct alignas(32) Place { Vector point; double size; };
  std::vector<Place> m_places;          // as in its site
  std::vector<int> m_free_vertices;
  Junctions<vertex_descriptor> m_junctions;
  std::vector<char> m_is_reference_face_remeshed;
  std::size_t m_number_of_faces = 0;    // that are remeshed
  Change_record<TriangleMesh> m_changes;

public:
  // `faces_of_reference[i]` is the face of the mesh that became face i of the reference;
  // `is_remeshed[i]` selects the part to work on; `is_edge_frozen(face of the reference, side)`: may the edge not
  // be changed?
  template <typename IsFrozen>
  Mesh_elements(const UserMesh& user, const Reference& reference,
                const std::vector<face_descriptor>& faces_of_reference,
                const std::vector<char>& is_remeshed,
                const IsFrozen& is_edge_frozen)
    : m_user(user), m_reference(reference)
    , m_vertex_index(get(CGAL::dynamic_vertex_property_t<int>(), user.tmesh))
    , m_edge(get(CGAL::dynamic_edge_property_t<Edge>(), user.tmesh))
    , m_hint(get(CGAL::dynamic_face_property_t<int>(), user.tmesh))
    , m_is_reference_face_remeshed(is_remeshed)
    , m_changes(user.tmesh)
  {
    for(const vertex_descriptor v : vertices(user.tmesh))
      put(m_vertex_index, v, -1);
    for(const edge_descriptor e : edges(user.tmesh))
      put(m_edge, e, Edge());

    m_changes.begin();
    const Indexed_triangles& triangles = reference.surface.triangles();
    std::vector<int> index_of_vertex(triangles.number_of_vertices(), -1);
    std::vector<Copies> copies_of_vertex(triangles.number_of_vertices());
    for(int f = 0; f < triangles.number_of_faces(); ++f)
    {
      put(m_hint, faces_of_reference[f], is_remeshed[f] ? f : -1);
      m_changes.set_of_face(faces_of_reference[f]);
      m_number_of_faces += is_remeshed[f];
      halfedge_descriptor h = halfedge(faces_of_reference[f], user.tmesh);
      for(int k = 0; k < 3; ++k, h = next(h, user.tmesh))
      {
        const int v = triangles.triangles[f][k];
        const vertex_descriptor copy = source(h, user.tmesh);
        if(index_of_vertex[v] == -1)
          index_of_vertex[v] = make_initial_vertex(copy, f, k);
        if(copies_of_vertex[v].empty() || get(m_vertex_index, copy) == -1)
          copies_of_vertex[v].push_back(copy);
        put(m_vertex_index, copy, index_of_vertex[v]);
        make_initial_edge(edge(h, user.tmesh), reference.edges.edge(f, k), is_edge_frozen(f, k));
      }
    }
    for(std::size_t c = 0; c < reference.curves.curves.size(); ++c)
    {
      const Feature_curve& curve = reference.curves.curves[c];
      for(std::size_t i = 1; i + 1 < curve.vertices.size(); ++i)
        set_site(index_of_vertex[curve.vertices[i]],
                 reference.curve_site(static_cast<int>(c), curve.spline.parameter(static_cast<int>(i))));
    }
    for(int v = 0; v < triangles.number_of_vertices(); ++v)
      m_junctions.set(index_of_vertex[v], copies_of_vertex[v]);
    freeze_seam_and_protected_edges();
  }

  const Reference& reference() const { return m_reference; }
  const TriangleMesh& tmesh() const { return m_user.tmesh; }
  std::size_t number_of_faces() const { return m_number_of_faces; }
  // Are queries made by several threads? Changes, and calls of the visitor, are made by the calling one alone.
  bool is_parallel() const { return m_reference.surface.options().is_parallel; }

  bool is_stopped() const { return m_user.visitor.is_stop_requested(); }
  // in loops with steps that are shorter than the question
  bool is_stopped_at(const std::size_t step) const
  {
    constexpr std::size_t steps_per_question = 64;
    return step % steps_per_question == 0 && is_stopped();
  }

  // \name Data of the elements
  int index(const vertex_descriptor v) const { return get(m_vertex_index, v); }
  const Vertex& data(const vertex_descriptor v) const { return m_vertices[index(v)]; }
  const Site& site(const vertex_descriptor v) const { return data(v).site; }
  const Vector& point(const vertex_descriptor v) const { return m_places[index(v)].point; }
  double size(const vertex_descriptor v) const { return m_places[index(v)].size; }
  bool is_frozen(const vertex_descriptor v) const { return data(v).is_frozen; }
  bool is_fixed(const vertex_descriptor v) const { return data(v).is_frozen || is_corner(data(v).type); }

  int curve(const halfedge_descriptor h) const { return get(m_edge, edge(h, tmesh())).curve; }
  bool is_on_curve(const halfedge_descriptor h) const { return curve(h) != -1; }
  Edge_class edge_class(const halfedge_descriptor h) const { return get(m_edge, edge(h, tmesh())).type; }
  bool is_protected(const halfedge_descriptor h) const { return get(m_edge, edge(h, tmesh())).is_protected; }

  bool is_border_or_outside(const halfedge_descriptor h) const
  {
    return CGAL::is_border(h, tmesh()) || get(m_hint, face(h, tmesh())) == -1;
  }
  bool is_remeshed(const face_descriptor f) const { return get(m_hint, f) != -1; }
  int hint(const halfedge_descriptor h) const { return get(m_hint, face(h, tmesh())); }
  int hint(const face_descriptor f) const { return get(m_hint, f); }

  bool is_inside(const edge_descriptor e) const
  {
    const halfedge_descriptor h = halfedge(e, tmesh());
    return !is_border_or_outside(h) || !is_border_or_outside(opposite(h, tmesh()));
  }

  double length(const halfedge_descriptor h) const
  {
    return (point(target(h, tmesh())) - point(source(h, tmesh()))).norm();
  }
  // length over the size asked for, which is linear along an edge: its mean is taken
  double relative_length(const halfedge_descriptor h) const
  {
    return 2. * length(h) / (size(source(h, tmesh())) + size(target(h, tmesh())));
  }

  Numbered_triangle triangle(const face_descriptor f) const
  {
    const halfedge_descriptor h = halfedge(f, tmesh());
    const vertex_descriptor a = source(h, tmesh()), b = target(h, tmesh()), c = target(next(h, tmesh()), tmesh());
    return {{{index(a), index(b), index(c)}}, {{point(a), point(b), point(c)}}};
  }

  // numbers of the ends, smaller first: an order of the edges that is the same for every mesh type
  std::pair<int, int> edge_key(const halfedge_descriptor h) const
  {
    const int s = index(source(h, tmesh())), t = index(target(h, tmesh()));
    return s < t ? std::make_pair(s, t) : std::make_pair(t, s);
  }

  // the numbers go from 0 to this; those of removed vertices are free, their vertex is null
  std::size_t number_of_vertex_slots() const { return m_vertices.size(); }
  vertex_descriptor vertex(const int i) const { return m_vertices[i].descriptor; }

  bool is_reference_face_remeshed(const int f) const { return m_is_reference_face_remeshed[f]; }

  // parameter of a vertex on a curve that it lies on
  double parameter(const vertex_descriptor v, const int curve) const
  {
    return site(v).curve == curve ? site(v).parameter : m_reference.end_parameter(curve, data(v).reference_vertex);
  }

  // \name Junctions
  template <typename Visit>
  void visit_copies(const vertex_descriptor v, const Visit& visit) const { m_junctions.visit_copies(index(v), v, visit); }
  Copies copies(const vertex_descriptor v) const
  {
    Copies result;
    visit_copies(v, [&result](const vertex_descriptor copy) { result.push_back(copy); });
    return result;
  }
  bool has_copies(const vertex_descriptor v) const { return m_junctions.has(index(v)); }

  // the copies of an edge of a curve, in the direction of h; any other edge is its only copy
  Siblings siblings(const halfedge_descriptor h) const
  {
    const vertex_descriptor s = source(h, tmesh()), t = target(h, tmesh());
    Siblings result;
    if(!is_on_curve(h) || (!has_copies(s) && !has_copies(t)))
      result.push_back(h);
    else
      for(const vertex_descriptor a : copies(s))
        visit_copies(t, [&](const vertex_descriptor b)
        {
          const std::pair<halfedge_descriptor, bool> found = halfedge(a, b, tmesh());
          if(found.second && curve(found.first) == curve(h))
            result.push_back(found.first);
        });
    return result;
  }

  // Are two vertices copies of one, or are any of their copies joined by an edge? Another edge between them would
  // be a new junction.
  bool are_joined(const vertex_descriptor v, const vertex_descriptor w) const
  {
    bool result = index(v) == index(w);
    visit_copies(v, [&](const vertex_descriptor a)
    { visit_copies(w, [&](const vertex_descriptor b) { result = result || halfedge(a, b, tmesh()).second; }); });
    return result;
  }

  // \name Changes
  std::size_t number_of_changes() const { return m_changes.number(); }
  // the vertex with the number, which may be gone
  bool has_changed(const int i, const std::size_t since) const { return m_changes.is_since_at_vertex(i, since); }
  bool has_changed(const vertex_descriptor v, const std::size_t since) const { return has_changed(index(v), since); }
  bool has_changed(const halfedge_descriptor h, const std::size_t since) const
  {
    return has_changed(source(h, tmesh()), since) || has_changed(target(h, tmesh()), since);
  }
  bool has_changed(const face_descriptor f, const std::size_t since) const
  {
    const halfedge_descriptor h = halfedge(f, tmesh());
    return has_changed(h, since) || has_changed(target(next(h, tmesh()), tmesh()), since);
  }
  // Is the triangle another one? A face that has changed may only lie beside such, or at a size that has changed.
  bool has_new_shape(const face_descriptor f, const std::size_t since) const { return m_changes.is_since_of_face(f, since); }
  void start_log() { m_changes.start_log(); }
  void stop_log() { m_changes.stop_log(); }
  const std::vector<int>& log() const { return m_changes.log(); }

protected:
  // the caller tells which vertices have the number
  int add_vertex(const Vertex& data)
  {
    int i = static_cast<int>(m_vertices.size());
    if(m_free_vertices.empty())
    {
      m_vertices.emplace_back();
      m_places.emplace_back();
    }
    else
    {
      i = m_free_vertices.back();
      m_free_vertices.pop_back();
    }
    m_vertices[i] = data;
    m_changes.set_at_vertex(i);
    set_site(i, data.site);
    return i;
  }

  void set_site(const int i, const Site& site)
  {
    m_vertices[i].site = site;
    m_places[i] = {site.point, site.size};
  }

  void free_vertex(const int i)
  {
    m_vertices[i].descriptor = Graph_traits::null_vertex();
    m_junctions.erase(i);
    m_free_vertices.push_back(i);
  }

  void set_edge(const edge_descriptor e, const Edge& data)
  {
    put(m_edge, e, data);
    m_user.set_constrained(e, data.is_constrained);
  }

  void touch(const vertex_descriptor v) { m_changes.set_at_vertex(index(v)); }

  void touch_shape(const halfedge_descriptor h)
  {
    if(!CGAL::is_border(h, tmesh()))
      m_changes.set_of_face(face(h, tmesh()));
  }

  void touch_around(const vertex_descriptor v)
  {
    m_changes.begin();
    touch(v);
    visit_copies(v, [&](const vertex_descriptor copy)
    {
      for(const halfedge_descriptor h : CGAL::halfedges_around_target(copy, tmesh()))
      {
        touch(source(h, tmesh()));
        touch_shape(h);
      }
    });
  }

  // the two faces of an edge
  void touch_quadrangle(const halfedge_descriptor h)
  {
    m_changes.begin();
    for(const halfedge_descriptor side : {h, opposite(h, tmesh())})
    {
      touch(target(side, tmesh()));
      touch(target(next(side, tmesh()), tmesh()));
      touch_shape(side);
    }
  }

private:
  int make_initial_vertex(const vertex_descriptor descriptor, const int face, const int corner)
  {
    const int v = m_reference.surface.triangles().triangles[face][corner];
    Vertex vertex;
    vertex.site = m_reference.vertex_site(face, corner);
    vertex.type = m_reference.vertex_classes[v];
    if(vertex.type == SURFACE_VERTEX)
      vertex.site.normal = m_reference.surface.blended_normal(vertex.site.location);
    vertex.reference_vertex = v;
    vertex.descriptor = descriptor;
    return add_vertex(vertex);
  }

  void make_initial_edge(const edge_descriptor e, const int reference_edge, const bool is_frozen)
  {
    Edge data;
    data.curve = m_reference.curves.curve_of_edge[reference_edge];
    data.type = m_reference.edge_classes[reference_edge];
    data.is_constrained = m_user.is_constrained(e) && is_feature(data.type);
    data.is_protected = is_frozen;
    put(m_edge, e, data);
  }

  // the edges between the part that is remeshed and the rest, and those that the user protects
  void freeze_seam_and_protected_edges()
  {
    for(const edge_descriptor e : edges(tmesh()))
    {
      const halfedge_descriptor h = halfedge(e, tmesh()), o = opposite(h, tmesh());
      Edge data = get(m_edge, e);
      const bool is_seam = is_border_or_outside(h) != is_border_or_outside(o)
                        && !CGAL::is_border(h, tmesh()) && !CGAL::is_border(o, tmesh());
      // marks on edges that are free would go astray with the first flips
      if(!is_seam && is_inside(e))
        m_user.set_constrained(e, data.is_constrained);
      if(!is_seam && !data.is_protected)
        continue;
      data.is_protected = true;
      put(m_edge, e, data);
      m_vertices[index(source(h, tmesh()))].is_frozen = m_vertices[index(target(h, tmesh()))].is_frozen = true;
    }
  }
};

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_MESH_ELEMENTS_H
