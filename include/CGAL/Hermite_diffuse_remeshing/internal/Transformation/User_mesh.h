// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_USER_MESH_H
#define CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_USER_MESH_H

#include <CGAL/Hermite_diffuse_remeshing/internal/Indexed_triangles.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Supervisor.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>

namespace CGAL {
namespace Hermite_diffuse_remeshing {
namespace internal {

// What the user handed in. The types of the property maps stay behind virtual functions: the operators are compiled
// once for all of them, and cost far more than such a call.
template <typename TriangleMesh_>
class User_mesh
{
public:
  typedef TriangleMesh_ TriangleMesh;

protected:
  typedef boost::graph_traits<TriangleMesh> Graph_traits;
  typedef typename Graph_traits::vertex_descriptor vertex_descriptor;
  typedef typename Graph_traits::edge_descriptor edge_descriptor;
  typedef typename Graph_traits::face_descriptor face_descriptor;

public:
  TriangleMesh& tmesh;
  Supervisor<TriangleMesh>& visitor;

  User_mesh(TriangleMesh& tmesh, Supervisor<TriangleMesh>& visitor) : tmesh(tmesh), visitor(visitor) {}
  User_mesh(const User_mesh&) = delete;
  User_mesh& operator=(const User_mesh&) = delete;
  virtual ~User_mesh() = default;

  virtual void set_point(vertex_descriptor v, const Vector& p) const = 0;
  virtual bool is_constrained(edge_descriptor e) const = 0;
  virtual void set_constrained(edge_descriptor e, bool is_constrained) const = 0;
  virtual void copy_patch(face_descriptor from, face_descriptor to) const = 0;
};

template <typename TriangleMesh, typename VertexPointMap, typename EdgeIsConstrainedMap, typename FacePatchMap,
          typename GeomTraits>
class User_mesh_with_maps : public User_mesh<TriangleMesh>
{
  typedef User_mesh<TriangleMesh> Base;
  using typename Base::vertex_descriptor;
  using typename Base::edge_descriptor;
  using typename Base::face_descriptor;

  // some maps, such as CGAL::Boolean_property_map of CGAL 5, are not written to as constants
  mutable VertexPointMap m_points;
  mutable EdgeIsConstrainedMap m_edge_is_constrained;
  mutable FacePatchMap m_face_patch;
  GeomTraits m_traits;

public:
  User_mesh_with_maps(TriangleMesh& tmesh, Supervisor<TriangleMesh>& visitor, const VertexPointMap& points,
                      const EdgeIsConstrainedMap& edge_is_constrained, const FacePatchMap& face_patch,
                      const GeomTraits& traits)
    : Base(tmesh, visitor), m_points(points), m_edge_is_constrained(edge_is_constrained), m_face_patch(face_patch)
    , m_traits(traits)
  {}

  void set_point(const vertex_descriptor v, const Vector& p) const override
  {
    const typename GeomTraits::Construct_point_3 construct_point = m_traits.construct_point_3_object();
    put(m_points, v, construct_point(p[0], p[1], p[2]));
  }

  bool is_constrained(const edge_descriptor e) const override { return get(m_edge_is_constrained, e); }

  // a map that is asked and not told may be for reading only
  void set_constrained(const edge_descriptor e, const bool is_constrained) const override
  {
    if(get(m_edge_is_constrained, e) != is_constrained)
      put(m_edge_is_constrained, e, is_constrained);
  }

  void copy_patch(const face_descriptor from, const face_descriptor to) const override
  {
    put(m_face_patch, to, get(m_face_patch, from));
  }
};

struct Operation_counts
{
  std::size_t splits = 0, collapses = 0, flips = 0, vertex_removals = 0, relocations = 0;
};

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_USER_MESH_H
