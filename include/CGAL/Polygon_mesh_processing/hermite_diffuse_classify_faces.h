// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_POLYGON_MESH_PROCESSING_HERMITE_DIFFUSE_CLASSIFY_FACES_H
#define CGAL_POLYGON_MESH_PROCESSING_HERMITE_DIFFUSE_CLASSIFY_FACES_H

#include <CGAL/license/Hermite_diffuse_remeshing.h>

#include <CGAL/Hermite_diffuse_remeshing/Basic_surface.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Model/recognize_basic_shapes.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/read_model.h>
#include <CGAL/Hermite_diffuse_remeshing/named_parameters.h>

#include <CGAL/tags.h>

#include <limits>
#include <memory>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Polygon_mesh_processing {

/*!
 * \ingroup PkgHermiteDiffuseRemeshingRef
 *
 * splits a triangle mesh into connected regions that lie on planes, spheres, cylinders, cones and tori, and
 * the rest. Regions end at features and where the surface leaves the shape, even if it does so
 * tangentially, as between a face and its fillet. Planes are looked for first, then cylinders, cones, spheres and tori:
 * two rings of vertices, as a tessellated cylinder may have no others, lie on a sphere too.
 *
 * Meant for meshes whose vertices lie on the surfaces, such as tessellations of CAD models: a vertex
 * belongs to a curved surface if it is closer to it than a small part of the height of the
 * facets, 0.004 of the square of the shortest edge around it times the curvature, or than `maximum_distance`.
 *
 * Takes time proportional to the number of faces for each shape, but for a logarithmic factor, and time proportional to
 * the square of the number of faces around a vertex.
 *
 * @tparam ConcurrencyTag enables sequential versus parallel algorithm, for the surface that is fitted. Possible values
 *         are `Sequential_tag` (the default), `Parallel_tag` and `Parallel_if_available_tag`. The result is the same
 *         for any number of threads.
 * @tparam TriangleMesh a model of `FaceListGraph` and `VertexListGraph` that has dynamic properties
 * @tparam FaceLabelMap a model of `WritablePropertyMap` with key type
 *         `boost::graph_traits<TriangleMesh>::%face_descriptor` and value type `std::size_t`
 * @tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
 *
 * @param tmesh the mesh
 * @param face_label_map output: the rank of a face's region in the returned vector
 * @param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{maximum_distance}
 *     \cgalParamDescription{a vertex that is not farther from a surface than this belongs to it in any case: how far
 *       the coordinates are rounded}
 *     \cgalParamType{`double`, a length, at least 0}
 *     \cgalParamDefault{1e-6 of the diameter of the mesh, enough for coordinates in single precision}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{sharp_dihedral_angle, corner_angle, apex_angular_defect, edge_is_constrained_map,
 *     edge_policy_map, vertex_is_constrained_map, face_patch_map, normal_estimation, vertex_normal_map, hermite_weight,
 *     surface_model}
 *     \cgalParamDescription{as for `CGAL::Polygon_mesh_processing::hermite_diffuse_curvatures()`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{vertex_point_map}
 *     \cgalParamDescription{the points of the vertices}
 *     \cgalParamType{a model of `ReadablePropertyMap` with key type `vertex_descriptor` and value type `GT::Point_3`}
 *     \cgalParamDefault{`boost::get(CGAL::vertex_point, tmesh)`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{geom_traits}
 *     \cgalParamDescription{an instance of a geometric traits class}
 *     \cgalParamType{a model of `HermiteDiffuseRemeshingTraits`}
 *     \cgalParamDefault{a \cgal kernel deduced from the point type, using `CGAL::Kernel_traits`}
 *   \cgalParamNEnd
 * \cgalNamedParamsEnd
 *
 * @return a `std::vector` of `CGAL::Hermite_diffuse_remeshing::Basic_surface<GT>`, one per region
 *
 * \throw std::invalid_argument if the mesh has no face, a face that is not a triangle, a coordinate that is not
 *        finite or a diameter outside [1e-50, 1e50], or if a parameter is out of its range
 *
 * @sa `hermite_diffuse_curvatures()`
 */
template <typename ConcurrencyTag = Sequential_tag,
          typename TriangleMesh,
          typename FaceLabelMap,
          typename NamedParameters = parameters::Default_named_parameters>
auto hermite_diffuse_classify_faces(const TriangleMesh& tmesh, const FaceLabelMap face_label_map,
                                    const NamedParameters& np = parameters::default_values())
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  using namespace CGAL::Hermite_diffuse_remeshing::internal;
  const auto& pack = CGAL::Hermite_diffuse_remeshing::internal::pack(np);
  typedef std::decay_t<decltype(pack)> Pack;
  typedef Traits_of<TriangleMesh, Pack> GT;
  typedef typename GT::FT FT;

  const Input_mesh<TriangleMesh, GT> input = read_input<GT>(tmesh, pack);
  constexpr double rounding = 1e-6;
  const double tolerance = choose_parameter(get_parameter(pack, internal_np::maximum_distance),
                                            rounding * model_diameter(input.triangles));
  check_parameter("maximum_distance", tolerance, 0., (std::numeric_limits<double>::max)());
  const std::unique_ptr<Input_surface> model = read_model<ConcurrencyTag, Input_surface>(input, pack);

  Shape_recognizer recognize(model->surface, tolerance);
  recognize();
  const typename GT::Construct_point_3 point = input.traits.construct_point_3_object();
  const typename GT::Construct_vector_3 vector = input.traits.construct_vector_3_object();
  std::vector<Hermite_diffuse_remeshing::Basic_surface<GT> > result;
  for(const Basic_shape& shape : recognize.shapes())
  {
    // points of the traits need no default constructor
    result.push_back({shape.type, point(FT(shape.point[0]), FT(shape.point[1]), FT(shape.point[2])),
                      vector(FT(shape.direction[0]), FT(shape.direction[1]), FT(shape.direction[2])),
                      FT(shape.radius), FT(shape.tube_radius), FT(shape.half_angle), 0});
  }
  for(std::size_t f = 0; f < input.face_descriptors.size(); ++f)
  {
    const std::size_t label = std::size_t(recognize.regions()[f]);
    put(face_label_map, input.face_descriptors[f], label);
    ++result[label].number_of_faces;
  }
  return result;
}

} // namespace Polygon_mesh_processing
} // namespace CGAL

#endif // CGAL_POLYGON_MESH_PROCESSING_HERMITE_DIFFUSE_CLASSIFY_FACES_H
