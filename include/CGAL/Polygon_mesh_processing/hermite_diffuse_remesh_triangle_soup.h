// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_POLYGON_MESH_PROCESSING_HERMITE_DIFFUSE_REMESH_TRIANGLE_SOUP_H
#define CGAL_POLYGON_MESH_PROCESSING_HERMITE_DIFFUSE_REMESH_TRIANGLE_SOUP_H

#include <CGAL/license/Hermite_diffuse_remeshing.h>

#include <CGAL/Hermite_diffuse_remeshing/Default_remeshing_visitor.h>
#include <CGAL/Hermite_diffuse_remeshing/Remeshing_report.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/remesh_soup.h>
#include <CGAL/Hermite_diffuse_remeshing/named_parameters.h>

#include <CGAL/Surface_mesh.h>

namespace CGAL {
namespace Polygon_mesh_processing {

/*!
 * \ingroup PkgHermiteDiffuseRemeshingRef
 *
 * remeshes a soup of triangles, which may be non-manifold: edges with any number of triangles, vertices where sheets
 * touch, open and closed parts, triangles that are not coherently oriented, sheets that cannot be oriented. Apart
 * from that it does the same as `hermite_diffuse_remesh()`, but for degenerate and folded triangles, which it does not
 * repair: `CGAL::Polygon_mesh_processing::repair_polygon_soup()` removes some of them. The report's counts of these,
 * and of isolated and coincident points, stay 0. Of a map of labels, entries beyond the triangles of the result are
 * left as they are.
 *
 * The soup is cut into sheets along its non-manifold edges. These edges, the junctions, are feature edges: they form
 * curves between corners, each with one spline and one sampling, which all its sheets share. They are split,
 * collapsed and moved like the edges and vertices of other curves, in all the sheets at once, so that the result
 * conforms: along a junction as many triangles meet at every edge as in the input, and nowhere else do more than two.
 * The size is one function on the whole surface, and its gradation runs across the junctions.
 *
 * Triangles are joined by the indices of their vertices, not by their coordinates.
 * `CGAL::Polygon_mesh_processing::repair_polygon_soup()` merges points that coincide. Those that no triangle uses
 * are not in the result. In each sheet the orientation of most of its triangles is given to all.
 *
 * @tparam ConcurrencyTag enables sequential versus parallel algorithm, as for `hermite_diffuse_remesh()`
 * @tparam PointRange a model of `RandomAccessContainer` and `BackInsertionSequence` whose value type is the point type
 * @tparam TriangleRange a model of `BackInsertionSequence` whose value type is a model of
 *         `RandomAccessContainer` of `std::size_t` that can be constructed from a list of three indices:
 *         `std::vector<std::size_t>` or `std::array<std::size_t, 3>`
 * @tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
 *
 * @param points the points, which are replaced
 * @param triangles the triangles as indices into `points`, which are replaced
 * @param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{approximation_error, sagitta, elements_per_circle, angle_per_element, sagitta_over_length,
 *     maximum_deviation, maximum_displacement, minimum_edge_length, maximum_edge_length, size_field, gradation,
 *     sharp_dihedral_angle, corner_angle, apex_angular_defect, polynomial_degree, hermite_weight, normal_estimation,
 *     surface_model,
 *     number_of_iterations, maximum_number_of_faces, maximum_running_time, protect_constraints,
 *     do_self_intersection_tests}
 *     \cgalParamDescription{as for `hermite_diffuse_remesh()`; a size field that asks for a face gets the index of a
 *       triangle}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{face_patch_map}
 *     \cgalParamDescription{labels of the triangles, for instance the two materials at its sides. Edges between two
 *       triangles of different labels are features. It is read for the triangles of the input and written for those of
 *       the result, which may be more.}
 *     \cgalParamType{a model of `ReadWritePropertyMap` with key type `std::size_t`, for instance
 *       `boost::associative_property_map<std::map<std::size_t, int> >`, and a value type that can be compared}
 *     \cgalParamDefault{one label}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{edge_is_constrained_map}
 *     \cgalParamDescription{edges that are features whatever their angle; not kept up to date}
 *     \cgalParamType{a model of `ReadablePropertyMap` with key type `std::pair<std::size_t, std::size_t>`, the indices
 *       of the ends with the smaller one first, and value type `bool`}
 *     \cgalParamDefault{no edge}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{edge_policy_map}
 *     \cgalParamDescription{a decision on each edge, which goes before the rules of the detection; not kept up to
 *       date. A junction cannot be free.}
 *     \cgalParamType{a model of `ReadablePropertyMap` with the same key type and value type
 *       `CGAL::Hermite_diffuse_remeshing::Edge_policy`}
 *     \cgalParamDefault{`CGAL::Hermite_diffuse_remeshing::DETECTED_EDGE` for all edges}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{vertex_is_constrained_map}
 *     \cgalParamDescription{points that are corners}
 *     \cgalParamType{a model of `ReadablePropertyMap` with key type `std::size_t` and value type `bool`}
 *     \cgalParamDefault{no point}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{vertex_normal_map}
 *     \cgalParamDescription{normals that the user knows; they replace the estimated ones. A zero vector means unknown,
 *       and so does one that is more than 60 degrees away from that of the triangles around the point, or 30 where
 *       several sheets meet.}
 *     \cgalParamType{a model of `ReadablePropertyMap` with key type `std::size_t` and value type
 *       `GeomTraits::Vector_3`}
 *     \cgalParamDefault{none}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{visitor}
 *     \cgalParamDescription{is told about stages and operations and may stop the remeshing. The elements that it
 *       is given are those of the mesh of the sheets; an operation at a junction is reported once per sheet.}
 *     \cgalParamType{a model of `HermiteDiffuseRemeshingVisitor` for `CGAL::Surface_mesh<Point>`, by value or
 *       by `std::ref`}
 *     \cgalParamDefault{`CGAL::Hermite_diffuse_remeshing::Default_remeshing_visitor<CGAL::Surface_mesh<Point> >`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{vertex_location_map, vertex_size_map, face_origin_map, face_deviation_map}
 *     \cgalParamDescription{output: as for `hermite_diffuse_remesh()`, with indices into the new points and triangles
 *       as keys. A location is the index of a triangle of the input and the coordinates with respect to its corners. A
 *       point without a triangle has none before the first change.}
 *     \cgalParamType{models of `WritablePropertyMap` with key type `std::size_t`}
 *     \cgalParamDefault{none}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{edge_class_map}
 *     \cgalParamDescription{output: what an edge of the result is a piece of; the junctions are the edges of class
 *       `CGAL::Hermite_diffuse_remeshing::NON_MANIFOLD_EDGE`}
 *     \cgalParamType{a model of `WritablePropertyMap` with key type `std::pair<std::size_t, std::size_t>`, the indices
 *       of the ends with the smaller one first, and value type `CGAL::Hermite_diffuse_remeshing::Edge_class`}
 *     \cgalParamDefault{none}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{geom_traits}
 *     \cgalParamDescription{an instance of a geometric traits class}
 *     \cgalParamType{a model of `HermiteDiffuseRemeshingTraits`}
 *     \cgalParamDefault{a \cgal kernel deduced from the point type, using `CGAL::Kernel_traits`}
 *   \cgalParamNEnd
 * \cgalNamedParamsEnd
 *
 * @return what was done, and which promises were kept. `CGAL::SM_Face_index(i)` in it stands for triangle `i` of the
 *         result.
 *
 * \throw std::invalid_argument if there is no triangle, if a polygon is not a triangle or names a vertex twice or one
 *        that is not there, if all triangles are degenerate, if a coordinate or a known normal is not finite, if the
 *        diameter is outside [1e-50, 1e50], or if a parameter is out of its range. The message names it, and the soup is
 *        unchanged.
 *
 * @sa `hermite_diffuse_remesh()`
 */
template <typename ConcurrencyTag = Sequential_tag, typename PointRange, typename TriangleRange,
          typename NamedParameters = parameters::Default_named_parameters>
Hermite_diffuse_remeshing::Remeshing_report<Surface_mesh<typename PointRange::value_type> >
hermite_diffuse_remesh_triangle_soup(PointRange& points, TriangleRange& triangles,
                                     const NamedParameters& np = parameters::default_values())
{
  return CGAL::Hermite_diffuse_remeshing::internal::remesh_soup<ConcurrencyTag>(
    points, triangles, CGAL::Hermite_diffuse_remeshing::internal::pack(np));
}

} // namespace Polygon_mesh_processing
} // namespace CGAL

#endif // CGAL_POLYGON_MESH_PROCESSING_HERMITE_DIFFUSE_REMESH_TRIANGLE_SOUP_H
