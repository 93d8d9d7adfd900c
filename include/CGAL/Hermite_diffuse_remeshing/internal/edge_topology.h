// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_EDGE_TOPOLOGY_H
#define CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_EDGE_TOPOLOGY_H

#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/helpers.h>

#include <boost/graph/graph_traits.hpp>

namespace CGAL {
namespace Hermite_diffuse_remeshing {
namespace internal {

// Is the target of h, a border halfedge, the tip of an ear, a face with two sides on the border, with other faces
// that only touch the ear there?
template <typename TriangleMesh>
bool is_tip_of_touching_ear(const typename boost::graph_traits<TriangleMesh>::halfedge_descriptor h,
                            const TriangleMesh& tm)
{
  return is_border(opposite(prev(opposite(h, tm), tm), tm), tm) && degree(target(h, tm), tm) > 2;
}

// Have the two faces of an edge the same corners?
template <typename TriangleMesh>
bool is_between_coincident_faces(const typename boost::graph_traits<TriangleMesh>::halfedge_descriptor h,
                                 const TriangleMesh& tm)
{
  return target(next(h, tm), tm) == target(next(opposite(h, tm), tm), tm)
      && !is_border(h, tm) && !is_border(opposite(h, tm), tm);
}

// the halfedge of a face that leads to a vertex; null if there is none
template <typename TriangleMesh>
typename boost::graph_traits<TriangleMesh>::halfedge_descriptor
halfedge_to(const typename boost::graph_traits<TriangleMesh>::vertex_descriptor v,
            const typename boost::graph_traits<TriangleMesh>::face_descriptor f, const TriangleMesh& tm)
{
  for(const auto h : CGAL::halfedges_around_face(halfedge(f, tm), tm))
    if(target(h, tm) == v)
      return h;
  return boost::graph_traits<TriangleMesh>::null_halfedge();
}

// May Euler::collapse_edge() collapse the edge of h? Besides the link condition there are cases that it does not
// handle: it takes the tip of an ear for removed together with the ear; and of faces with the same corners it would make
// an edge from a vertex to itself, while the link condition sees no more than a common neighbor on each side.
template <typename TriangleMesh>
bool is_collapse_manifold(const typename boost::graph_traits<TriangleMesh>::halfedge_descriptor h,
                          const TriangleMesh& tm)
{
  for(const auto side : {h, opposite(h, tm)})
    if(is_border(side, tm) && is_tip_of_touching_ear(side, tm))
      return false;
  return !is_between_coincident_faces(h, tm) && CGAL::Euler::does_satisfy_link_condition(edge(h, tm), tm);
}

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_EDGE_TOPOLOGY_H
