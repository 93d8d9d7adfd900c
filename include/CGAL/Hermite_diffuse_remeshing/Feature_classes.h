// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_REMESHING_FEATURE_CLASSES_H
#define CGAL_HERMITE_DIFFUSE_REMESHING_FEATURE_CLASSES_H

#include <CGAL/license/Hermite_diffuse_remeshing.h>

namespace CGAL {
namespace Hermite_diffuse_remeshing {

/*!
 * \ingroup PkgHermiteDiffuseRemeshingRef
 *
 * what an edge is to the model of the surface. All but `INTERIOR_EDGE` are features; where several
 * reasons hold, the last one in this list is given.
 */
enum Edge_class
{
  INTERIOR_EDGE,       ///< the surface is smooth across it
  SHARP_EDGE,          ///< the normals of its faces differ by more than `sharp_dihedral_angle`, or it joins two creases
  PATCH_BORDER_EDGE,   ///< the labels of its faces in `face_patch_map` differ
  CONSTRAINED_EDGE,    ///< the user says so, by `edge_is_constrained_map` or `edge_policy_map`
  BOUNDARY_EDGE,       ///< it has one face
  NON_MANIFOLD_EDGE    ///< it has more than two faces, or two that no orientation makes coherent
};

/*!
 * \ingroup PkgHermiteDiffuseRemeshingRef
 *
 * what a vertex is to the model of the surface. `SURFACE_VERTEX` and `CURVE_VERTEX` may move, on the
 * surface and along their feature curve; the others are corners, which keep their exact place. Where several reasons
 * hold an apex goes before what the user says, and that before junctions and kinks; sheets that touch count where nothing
 * else does.
 */
enum Vertex_class
{
  SURFACE_VERTEX,      ///< no feature edge
  CURVE_VERTEX,        ///< two feature edges that go on smoothly
  JUNCTION_VERTEX,     ///< other than two feature edges, or two of different classes or numbers of faces, or of which
                       ///< one only is in `edge_is_constrained_map`
  KINK_VERTEX,         ///< two feature edges that turn by more than `corner_angle`
  APEX_VERTEX,         ///< no feature edge, but the angles of the faces of a sheet miss 360 degrees by more than
                       ///< `apex_angular_defect`
  TOUCHING_VERTEX,     ///< sheets of the surface touch there that share no edge
  CONSTRAINED_VERTEX   ///< the user says so, by `vertex_is_constrained_map`
};

/*!
 * \ingroup PkgHermiteDiffuseRemeshingRef
 *
 * what the user decides on an edge, the value type of the parameter `edge_policy_map`.
 */
enum Edge_policy
{
  DETECTED_EDGE = 0,   ///< nothing: the rules of the detection hold
  FREE_EDGE,           ///< no feature, whatever its angle and the labels of its faces; an edge of the border stays one.
                       ///< A crease that is declared smooth is a very small radius: bound the sizes there by
                       ///< `minimum_edge_length`, or very small ones are asked for.
  RESAMPLED_EDGE,      ///< a feature: its vertices move along its curve, and are as many as the sizes ask for
  PROTECTED_EDGE       ///< a feature that stays exactly as it is: neither split, collapsed nor moved
};

/*!
 * \ingroup PkgHermiteDiffuseRemeshingRef
 *
 * returns whether a vertex of this class keeps its exact place.
 */
inline bool is_corner(const Vertex_class c)
{
  return c != SURFACE_VERTEX && c != CURVE_VERTEX;
}

/*!
 * \ingroup PkgHermiteDiffuseRemeshingRef
 *
 * returns whether an edge of this class is a feature.
 */
inline bool is_feature(const Edge_class c)
{
  return c != INTERIOR_EDGE;
}

} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_FEATURE_CLASSES_H
