// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_REMESHING_DEFAULT_REMESHING_VISITOR_H
#define CGAL_HERMITE_DIFFUSE_REMESHING_DEFAULT_REMESHING_VISITOR_H

#include <CGAL/license/Hermite_diffuse_remeshing.h>

#include <boost/graph/graph_traits.hpp>

namespace CGAL {
namespace Hermite_diffuse_remeshing {

/*!
 * \ingroup PkgHermiteDiffuseRemeshingRef
 *
 * is a visitor whose functions do nothing: derive from it and write the ones of interest.
 * Pass the visitor with `visitor(std::ref(v))` to keep what it has collected.
 *
 * \cgalModels{HermiteDiffuseRemeshingVisitor}
 *
 * \tparam TriangleMesh the type of the mesh that is remeshed
 */
template <typename TriangleMesh>
struct Default_remeshing_visitor
{
  /// \name Types
  /// @{

  /// a vertex of the mesh
  typedef typename boost::graph_traits<TriangleMesh>::vertex_descriptor vertex_descriptor;
  /// a halfedge of the mesh
  typedef typename boost::graph_traits<TriangleMesh>::halfedge_descriptor halfedge_descriptor;
  /// an edge of the mesh
  typedef typename boost::graph_traits<TriangleMesh>::edge_descriptor edge_descriptor;
  /// a face of the mesh
  typedef typename boost::graph_traits<TriangleMesh>::face_descriptor face_descriptor;
  /// @}

  /// \name Stages
  /// @{

  /// a stage with this name begins
  void stage_begins(const char* /* name */) {}
  /// `fraction` of the current stage that is done, from 0 to 1 and never falling
  void progress(double /* fraction */) {}
  /// the stage with this name ends
  void stage_ends(const char* /* name */) {}
  /// asked all the time; once `true` is returned the mesh is left as it is, valid
  bool is_stop_requested() { return false; }
  /// @}

  /// \name Operations
  /// @{

  /// the edge will be split
  void before_edge_split(edge_descriptor) {}
  /// an edge was split at this new vertex
  void after_edge_split(vertex_descriptor) {}
  /// the second face is new, and has taken a part of the place of the first
  void after_face_split(face_descriptor, face_descriptor) {}
  /// the halfedge will be collapsed: its source is removed, its target stays
  void before_edge_collapse(halfedge_descriptor) {}
  /// an edge was collapsed to this vertex
  void after_edge_collapse(vertex_descriptor) {}
  /// the edge will be flipped
  void before_edge_flip(edge_descriptor) {}
  /// the edge was flipped
  void after_edge_flip(edge_descriptor) {}
  /// the vertex will be removed, and the polygon around it filled with other edges
  void before_vertex_removal(vertex_descriptor) {}
  /// a vertex was removed
  void after_vertex_removal() {}
  /// the vertex will be given another point
  void before_vertex_relocation(vertex_descriptor) {}
  /// the vertex was given another point
  void after_vertex_relocation(vertex_descriptor) {}
  /// @}
};

} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_DEFAULT_REMESHING_VISITOR_H
