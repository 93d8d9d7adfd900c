// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_POLYGON_MESH_PROCESSING_HERMITE_DIFFUSE_CURVATURES_H
#define CGAL_POLYGON_MESH_PROCESSING_HERMITE_DIFFUSE_CURVATURES_H

#include <CGAL/license/Hermite_diffuse_remeshing.h>

#include <CGAL/Hermite_diffuse_remeshing/Principal_curvatures_and_directions.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Model/Node_curvature_fitter.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/read_model.h>
#include <CGAL/Hermite_diffuse_remeshing/named_parameters.h>

#include <functional>
#include <memory>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Hermite_diffuse_remeshing {
namespace internal {

// Of a vertex with several sides the side that bends most counts; the first of those that are equal but
// for rounding.
inline void keep_larger(Principal_curvatures& of_vertex, const Principal_curvatures& of_node)
{
  constexpr double rounding = 1e-9;
  if(of_vertex.maximum_direction == Vector::Zero()
     || of_node.largest_absolute() > (1. + rounding) * of_vertex.largest_absolute())
    of_vertex = of_node;
}

// The class of this package and that of CGAL 6, which users may have in their maps, have the same members.
template <typename Result, typename GeomTraits>
Result convert(const Principal_curvatures_and_directions<GeomTraits>& k)
{
  return Result{k.min_curvature, k.max_curvature, k.min_direction, k.max_direction};
}

// to the variable that the user refers to, if he does
template <typename Variable, typename FT>
void assign(const std::reference_wrapper<Variable> variable, const FT value) { variable.get() = value; }
template <typename Variable, typename GeomTraits>
void assign(const std::reference_wrapper<Variable> variable, const Principal_curvatures_and_directions<GeomTraits>& k)
{
  variable.get() = convert<Variable>(k);
}
template <typename Value>
void assign(const internal_np::Param_not_found&, const Value&) {}

} // namespace internal
} // namespace Hermite_diffuse_remeshing

namespace Polygon_mesh_processing {

/*!
 * \ingroup PkgHermiteDiffuseRemeshingRef
 *
 * computes curvatures at all vertices of a triangle mesh: by a polynomial of degree 4 that is fitted, at
 * each vertex, to the positions and estimated normals of two rings of neighbors, three at a border.
 * The fit stays on its side of every sharp edge, border and user feature; at a vertex with
 * several sides the curvature of the side that bends most is written. A curvature is positive where the
 * surface bends away from its normal: both are on a sphere with outward normals. At the tip of a
 * cone, which has none, and at isolated vertices the curvatures are zero.
 *
 * The maps, and the sign of what is written to them, are those of `interpolated_corrected_curvatures()` of \cgal 6: one
 * function may take the place of the other.
 *
 * On irregular meshes whose vertices lie on a smooth surface the error decreases at least with the square of the
 * edge length. With vertices that do not, `normal_estimation(SMOOTH_NORMALS)` averages normals over
 * several rings and fits polynomials of degree 3.
 *
 * Takes time and memory proportional to the number of faces, but for a logarithmic factor, and time proportional to the
 * square of the number of faces around a vertex.
 *
 * A chain of parameters that begins with one of this package's own takes these and those of \cgal in any order; one
 * that begins with one of \cgal's takes only those of \cgal. The parameters for curvatures are \cgal's from version 6 on:
 * in a program for all versions, a chain with others of this package begins with one of these.
 *
 * @tparam ConcurrencyTag enables sequential versus parallel algorithm. Possible values are `Sequential_tag`
 *         (the default), `Parallel_tag` and `Parallel_if_available_tag`. The values are the same, to the last
 *         bit, for any number of threads.
 * @tparam TriangleMesh a model of `FaceListGraph` and `VertexListGraph` that has dynamic properties
 * @tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
 *
 * @param tmesh the mesh
 * @param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below.
 *        `GT` stands for the type of the object given by `geom_traits`.
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{vertex_mean_curvature_map}
 *     \cgalParamDescription{output: mean curvatures, half the sum of the principal ones, in one over the unit
 *       of length}
 *     \cgalParamType{a model of `WritablePropertyMap` with key type `vertex_descriptor` and value type `GT::FT`}
 *     \cgalParamDefault{none}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{vertex_Gaussian_curvature_map}
 *     \cgalParamDescription{output: Gaussian curvatures, the product of the principal ones}
 *     \cgalParamType{a model of `WritablePropertyMap` with key type `vertex_descriptor` and value type `GT::FT`}
 *     \cgalParamDefault{none}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{vertex_principal_curvatures_and_directions_map}
 *     \cgalParamDescription{output: principal curvatures and directions}
 *     \cgalParamType{a model of `WritablePropertyMap` with key type `vertex_descriptor` and value type
 *       `CGAL::Hermite_diffuse_remeshing::Principal_curvatures_and_directions<GT>`, or the class of the same name in
 *       `CGAL::Polygon_mesh_processing` of \cgal 6}
 *     \cgalParamDefault{none}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{normal_estimation}
 *     \cgalParamDescription{how the normals at the vertices are estimated}
 *     \cgalParamType{`CGAL::Hermite_diffuse_remeshing::Normal_estimation`}
 *     \cgalParamDefault{`FITTED_NORMALS`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{vertex_normal_map}
 *     \cgalParamDescription{normals that are known, zero where they are not; used as by
 *       `CGAL::Polygon_mesh_processing::hermite_diffuse_remesh()`}
 *     \cgalParamType{a model of `ReadablePropertyMap` with key type `vertex_descriptor` and value type `GT::Vector_3`}
 *     \cgalParamDefault{none}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{sharp_dihedral_angle, corner_angle, apex_angular_defect, edge_is_constrained_map,
 *     edge_policy_map, vertex_is_constrained_map, face_patch_map, hermite_weight, surface_model}
 *     \cgalParamDescription{as for `CGAL::Polygon_mesh_processing::hermite_diffuse_remesh()`, but maps are only read,
 *       and `PAPER_MODEL` changes the defaults of `normal_estimation` and `hermite_weight`;
 *       `maximum_displacement` is checked and has no effect, and the degree and the form of the model count only where
 *       too few neighbors leave the curvature to the surface}
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
 * \throw std::invalid_argument if the mesh has no face, a face that is not a triangle or a coordinate
 *        that is not finite, if its diameter is outside [1e-50, 1e50], or if a parameter is out of its range
 *
 * @sa `CGAL::Hermite_diffuse_surface`
 */
template <typename ConcurrencyTag = Sequential_tag,
          typename TriangleMesh, typename NamedParameters = parameters::Default_named_parameters>
void hermite_diffuse_curvatures(const TriangleMesh& tmesh,
                                const NamedParameters& np = parameters::default_values())
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  using namespace CGAL::Hermite_diffuse_remeshing;
  using namespace CGAL::Hermite_diffuse_remeshing::internal;
  const auto& pack = CGAL::Hermite_diffuse_remeshing::internal::pack(np);
  typedef std::decay_t<decltype(pack)> Pack;
  typedef typename boost::graph_traits<TriangleMesh>::vertex_descriptor vertex_descriptor;
  typedef Traits_of<TriangleMesh, Pack> GT;
  typedef typename GT::FT FT;

  const Input_mesh<TriangleMesh, GT> input = read_input<GT>(tmesh, pack);
  const std::unique_ptr<Input_surface> model = read_model<ConcurrencyTag, Input_surface>(input, pack);

  const auto mean = choose_parameter(get_parameter(pack, internal_np::vertex_mean_curvature_map),
                                     Constant_property_map<vertex_descriptor, FT>());
  const auto gaussian = choose_parameter(get_parameter(pack, internal_np::vertex_Gaussian_curvature_map),
                                         Constant_property_map<vertex_descriptor, FT>());
  typedef Hermite_diffuse_remeshing::Principal_curvatures_and_directions<GT> Principal;
  const auto principal =
    choose_parameter(get_parameter(pack, internal_np::vertex_principal_curvatures_and_directions_map),
                     Constant_property_map<vertex_descriptor, Principal>());
  typedef typename boost::property_traits<std::decay_t<decltype(principal)> >::value_type User_principal;
  const Cut_mesh& cut_mesh = model->surface.cut_mesh();
  std::vector<Principal_curvatures> of_nodes(cut_mesh.number_of_nodes());
  for_each_index(cut_mesh.number_of_nodes(), is_parallel<ConcurrencyTag>(), [&]
  {
    return [&, fitter = Node_curvature_fitter(model->surface)](const int i) mutable
           { of_nodes[i] = fitter(i).principal_curvatures(); };
  });
  std::vector<Principal_curvatures> curvatures(input.vertex_descriptors.size());
  for(int i = 0; i < cut_mesh.number_of_nodes(); ++i)
    keep_larger(curvatures[cut_mesh.vertex(i)], of_nodes[i]);
  for(std::size_t i = 0; i < curvatures.size(); ++i)
  {
    const vertex_descriptor v = input.vertex_descriptors[i];
    const Principal k = to_public(curvatures[i], input.traits);
    put(mean, v, k.mean_curvature());
    put(gaussian, v, k.Gaussian_curvature());
    put(principal, v, convert<User_principal>(k));
  }
}

/*!
 * \ingroup PkgHermiteDiffuseRemeshingRef
 *
 * computes curvatures at one vertex of a triangle mesh, from the faces around it alone: the same values as
 * the function for all vertices, but for rounding, unless a crease or a flat side on which they depend is cut off.
 *
 * Takes time proportional to the number of faces within ten edges of the vertex.
 *
 * @tparam TriangleMesh a model of `FaceListGraph` and `VertexListGraph` that has dynamic properties
 * @tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
 *
 * @param v the vertex
 * @param tmesh the mesh
 * @param np a sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below. `GT` stands for the
 *        type of the object given by `geom_traits`.
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{vertex_mean_curvature}
 *     \cgalParamDescription{the variable for the mean curvature\, given by `std::ref`}
 *     \cgalParamType{`GT::FT`}
 *     \cgalParamDefault{the result is not wanted}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{vertex_Gaussian_curvature}
 *     \cgalParamDescription{the variable for the Gaussian curvature\, given by `std::ref`}
 *     \cgalParamType{`GT::FT`}
 *     \cgalParamDefault{the result is not wanted}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{vertex_principal_curvatures_and_directions}
 *     \cgalParamDescription{the variable for the principal curvatures and their directions\, given by `std::ref`}
 *     \cgalParamType{`CGAL::Hermite_diffuse_remeshing::Principal_curvatures_and_directions<GT>`, or the class of the
 *       same name in `CGAL::Polygon_mesh_processing` of \cgal 6}
 *     \cgalParamDefault{the result is not wanted}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{sharp_dihedral_angle, corner_angle, apex_angular_defect, edge_is_constrained_map,
 *     edge_policy_map, vertex_is_constrained_map, face_patch_map, normal_estimation, vertex_normal_map, hermite_weight,
 *     surface_model, vertex_point_map, geom_traits}
 *     \cgalParamDescription{as for all vertices}
 *   \cgalParamNEnd
 * \cgalNamedParamsEnd
 *
 * \throw std::invalid_argument if a face around the vertex is not a triangle or has a coordinate that is
 *        not finite, or if a parameter is out of its range
 *
 * @sa `CGAL::Hermite_diffuse_surface`
 */
template <typename TriangleMesh, typename NamedParameters>
void hermite_diffuse_curvatures(const typename boost::graph_traits<TriangleMesh>::vertex_descriptor v,
                                const TriangleMesh& tmesh, const NamedParameters& np)
{
  using parameters::get_parameter;
  using namespace CGAL::Hermite_diffuse_remeshing::internal;
  const auto& pack = CGAL::Hermite_diffuse_remeshing::internal::pack(np);
  typedef Traits_of<TriangleMesh, std::decay_t<decltype(pack)> > GT;

  // three rings for the fit, four for the normal of the outermost, three for flat sides around it
  constexpr int number_of_rings = 10;
  const Input_mesh<TriangleMesh, GT> input = read_neighborhood<GT>(v, tmesh, number_of_rings, pack);
  Principal_curvatures k;
  if(!input.face_descriptors.empty())
  {
    const std::unique_ptr<Input_surface> model = read_model<Sequential_tag, Input_surface>(input, pack);
    Node_curvature_fitter fitter(model->surface);
    const Cut_mesh& cut_mesh = model->surface.cut_mesh();
    for(int i = 0; i < cut_mesh.number_of_nodes(); ++i)
      if(input.vertex_descriptors[cut_mesh.vertex(i)] == v)
        keep_larger(k, fitter(i).principal_curvatures());
  }
  const auto result = to_public(k, input.traits);
  assign(get_parameter(pack, internal_np::vertex_mean_curvature), result.mean_curvature());
  assign(get_parameter(pack, internal_np::vertex_Gaussian_curvature), result.Gaussian_curvature());
  assign(get_parameter(pack, internal_np::vertex_principal_curvatures_and_directions), result);
}

} // namespace Polygon_mesh_processing
} // namespace CGAL

#endif // CGAL_POLYGON_MESH_PROCESSING_HERMITE_DIFFUSE_CURVATURES_H
