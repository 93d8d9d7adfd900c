// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_POLYGON_MESH_PROCESSING_HERMITE_DIFFUSE_CLASSIFY_FEATURES_H
#define CGAL_POLYGON_MESH_PROCESSING_HERMITE_DIFFUSE_CLASSIFY_FEATURES_H

#include <CGAL/license/Hermite_diffuse_remeshing.h>

#include <CGAL/Hermite_diffuse_remeshing/Feature_classes.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/read_input.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/read_parameters.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/validate_input.h>
#include <CGAL/Hermite_diffuse_remeshing/named_parameters.h>

#include <type_traits>
#include <vector>

namespace CGAL {
namespace Polygon_mesh_processing {

/*!
 * \ingroup PkgHermiteDiffuseRemeshingRef
 *
 * finds the feature edges and the corners of a triangle mesh, as `hermite_diffuse_remesh()` does before
 * anything else. Section \ref HDR_features of the manual gives the rules.
 *
 * An edge is sharp if the normals of its two faces differ by more than `sharp_dihedral_angle`, or if it leads from one
 * crease to another between long facets, as in the seam of mitred tubes. On scans and
 * coarse meshes single edges pass this limit by noise, so a connected set of feature edges is not taken if
 * it has only sharp edges and fewer than six of them, has an end at which no other feature edge begins,
 * and all of its angles are less than 1.5 times the limit.
 *
 * Takes time proportional to the number of faces, but for a logarithmic factor.
 *
 * @tparam TriangleMesh a model of `FaceListGraph` and `VertexListGraph` that has dynamic properties
 * @tparam EdgeClassMap a model of `WritablePropertyMap` with key type
 *         `boost::graph_traits<TriangleMesh>::%edge_descriptor` and value type
 *         `CGAL::Hermite_diffuse_remeshing::Edge_class`
 * @tparam VertexClassMap a model of `WritablePropertyMap` with key type
 *         `boost::graph_traits<TriangleMesh>::%vertex_descriptor` and value type
 *         `CGAL::Hermite_diffuse_remeshing::Vertex_class`
 * @tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
 *
 * @param tmesh the mesh
 * @param edge_class_map output: the classes of the edges
 * @param vertex_class_map output: the classes of the vertices
 * @param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{sharp_dihedral_angle}
 *     \cgalParamDescription{an edge is sharp if the normals of its two faces differ by more than this}
 *     \cgalParamType{`double`, degrees in [0, 180]; 180 turns the detection off}
 *     \cgalParamDefault{`40`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{corner_angle}
 *     \cgalParamDescription{a vertex between two feature edges is a corner if these turn by more than this}
 *     \cgalParamType{`double`, degrees in [0, 180]; 180 turns the detection off}
 *     \cgalParamDefault{`60`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{apex_angular_defect}
 *     \cgalParamDescription{a vertex without feature edges is an apex, which is kept like a corner, if the
 *       sum of the angles of its faces differs from 360 degrees by more than this}
 *     \cgalParamType{`double`, degrees in [0, 180]; 180 turns the detection off}
 *     \cgalParamDefault{`30`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{edge_is_constrained_map}
 *     \cgalParamDescription{edges that are features whatever their angle}
 *     \cgalParamType{a model of `ReadablePropertyMap` with key type `edge_descriptor` and value type `bool`}
 *     \cgalParamDefault{no edge}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{edge_policy_map}
 *     \cgalParamDescription{a decision on each edge, which goes before the rules}
 *     \cgalParamType{a model of `ReadablePropertyMap` with key type `edge_descriptor` and value type
 *       `CGAL::Hermite_diffuse_remeshing::Edge_policy`}
 *     \cgalParamDefault{`CGAL::Hermite_diffuse_remeshing::DETECTED_EDGE` for all edges}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{vertex_is_constrained_map}
 *     \cgalParamDescription{vertices that are corners}
 *     \cgalParamType{a model of `ReadablePropertyMap` with key type `vertex_descriptor` and value type `bool`}
 *     \cgalParamDefault{no vertex}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{face_patch_map}
 *     \cgalParamDescription{labels; edges between faces of different labels are features}
 *     \cgalParamType{a model of `ReadablePropertyMap` with key type `face_descriptor` and a value type that
 *       can be compared}
 *     \cgalParamDefault{one label}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{vertex_point_map}
 *     \cgalParamDescription{the points of the vertices}
 *     \cgalParamType{a model of `ReadablePropertyMap` with key type `vertex_descriptor` and value type
 *       `GeomTraits::Point_3`}
 *     \cgalParamDefault{`boost::get(CGAL::vertex_point, tmesh)`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{geom_traits}
 *     \cgalParamDescription{an instance of a geometric traits class}
 *     \cgalParamType{a model of `HermiteDiffuseRemeshingTraits`}
 *     \cgalParamDefault{a \cgal kernel deduced from the point type, using `CGAL::Kernel_traits`}
 *   \cgalParamNEnd
 * \cgalNamedParamsEnd
 *
 * \throw std::invalid_argument if the mesh has no face, a face that is not a triangle, a coordinate that is not
 *        finite or a diameter outside [1e-50, 1e50], or if a parameter is out of its range
 *
 * @sa `hermite_diffuse_remesh()`
 */
template <typename TriangleMesh, typename EdgeClassMap, typename VertexClassMap,
          typename NamedParameters = parameters::Default_named_parameters>
void hermite_diffuse_classify_features(const TriangleMesh& tmesh, const EdgeClassMap edge_class_map,
                                       const VertexClassMap vertex_class_map,
                                       const NamedParameters& np = parameters::default_values())
{
  using namespace CGAL::Hermite_diffuse_remeshing::internal;
  using CGAL::Hermite_diffuse_remeshing::Edge_class;
  using CGAL::Hermite_diffuse_remeshing::Vertex_class;
  const auto& pack = CGAL::Hermite_diffuse_remeshing::internal::pack(np);
  typedef Traits_of<TriangleMesh, std::decay_t<decltype(pack)> > GT;
  const Feature_options options = read_feature_options(pack);
  const Input_mesh<TriangleMesh, GT> input = read_input<GT>(tmesh, pack);
  const Indexed_triangles& triangles = input.triangles;
  checked_diameter(triangles);
  const auto vertex_is_constrained = parameters::choose_parameter(
    parameters::get_parameter(pack, internal_np::vertex_is_constrained),
    Static_boolean_property_map<typename boost::graph_traits<TriangleMesh>::vertex_descriptor, false>());

  const Edge_table edge_table(triangles);
  const auto edge_mark = [&](const int f, const int side) { return input.side_marks[f][side]; };
  const std::vector<Edge_class> edge_classes = classify_edges(triangles, edge_table, options.sharp_angle, edge_mark);
  const Cut_mesh cut_mesh(triangles, edge_table, edge_classes);
  const std::vector<Vertex_class> vertex_classes =
    classify_vertices(triangles, edge_table, edge_classes, cut_mesh, options.corner_angle, options.apex_defect,
                      edge_mark, [&](const int v) -> bool { return get(vertex_is_constrained, input.vertex_descriptors[v]); });

  for(int f = 0; f < triangles.number_of_faces(); ++f)
  {
    auto h = halfedge(input.face_descriptors[f], tmesh);
    for(int k = 0; k < 3; ++k, h = next(h, tmesh))
      put(edge_class_map, edge(h, tmesh), edge_classes[edge_table.edge(f, k)]);
  }
  for(int v = 0; v < triangles.number_of_vertices(); ++v)
    put(vertex_class_map, input.vertex_descriptors[v], vertex_classes[v]);
}

} // namespace Polygon_mesh_processing
} // namespace CGAL

#endif // CGAL_POLYGON_MESH_PROCESSING_HERMITE_DIFFUSE_CLASSIFY_FEATURES_H
