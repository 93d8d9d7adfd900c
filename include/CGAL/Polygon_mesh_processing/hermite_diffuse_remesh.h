// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_POLYGON_MESH_PROCESSING_HERMITE_DIFFUSE_REMESH_H
#define CGAL_POLYGON_MESH_PROCESSING_HERMITE_DIFFUSE_REMESH_H

#include <CGAL/license/Hermite_diffuse_remeshing.h>

#include <CGAL/Hermite_diffuse_remeshing/Default_remeshing_visitor.h>
#include <CGAL/Hermite_diffuse_remeshing/Remeshing_report.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/remesh.h>
#include <CGAL/Hermite_diffuse_remeshing/named_parameters.h>

#include <type_traits>
#include <vector>

namespace CGAL {
namespace Polygon_mesh_processing {

/*!
 * \ingroup PkgHermiteDiffuseRemeshingRef
 *
 * remeshes a triangulated region of a polygon mesh: the sizes of the new faces follow the curvature of
 * a smooth surface that is fitted to the vertices of the mesh and to normals estimated there, the
 * new vertices lie on that surface, and sharp edges, corners and borders are kept.
 *
 * The surface is a Hermite diffuse interpolation: A. Rassineux, P. Villon, J.-M. Savignat, O. Stab,
 * <em>Surface remeshing by local Hermite diffuse interpolation</em>, International Journal for
 * Numerical Methods in Engineering 49, 2000. Feature edges become cubic splines, and the vertices on
 * them lie on these. The mesh is changed in place by splits, collapses and flips of edges and by
 * relocations of vertices. No garbage is collected: where the mesh only marks removed elements, as `CGAL::Surface_mesh`
 * does, new ones may take their places.
 *
 * Time is proportional to the number of faces of the input and of the result, but for a factor
 * logarithmic in the former; a vertex with very many faces, such as the center of a fan, takes at least the square of
 * their number. The result depends on the input and the parameters only, and scaling, rotating or translating the input does
 * the same to it.
 *
 * A chain of parameters that begins with one of this package's own (`approximation_error` and the others that \cgal
 * does not have) takes these and those of \cgal in any order; one that begins with one of \cgal's takes only those of
 * \cgal, which are `maximum_number_of_faces`, `maximum_running_time`, `do_self_intersection_tests`,
 * `number_of_iterations`, `vertex_normal_map`, `visitor`, `protect_constraints`, `vertex_point_map`, `geom_traits` and
 * the maps of constraints and patches.
 *
 * @tparam ConcurrencyTag enables sequential versus parallel algorithm. Possible values are `Sequential_tag`
 *         (the default), `Parallel_tag` and `Parallel_if_available_tag`. The result is the same, to the last bit,
 *         for any number of threads. Only the calling thread changes the mesh and its property maps, and calls
 *         visitors, property maps and size fields of the user; the mesh is read by several threads at the same time.
 * @tparam FaceRange a model of `Range` with value type `boost::graph_traits<TriangleMesh>::%face_descriptor`
 * @tparam TriangleMesh a model of `MutableFaceGraph`, `FaceListGraph`, `EdgeListGraph` and `VertexListGraph` that has
 *         dynamic properties of vertices, edges and faces
 * @tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
 *
 * @param faces the faces of `tmesh` to be remeshed; the others are left exactly as they are, and so are the
 *        edges between the two. The surface is fitted to the whole mesh. Without any, nothing changes; one
 *        that has been removed is refused, until its garbage is collected: then the descriptor names nothing.
 * @param tmesh the mesh
 * @param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{approximation_error}
 *     \cgalParamDescription{relative error \f$ \varepsilon \f$ of an edge against an arc with the smallest
 *       radius of curvature \f$ R \f$; the edge length follows from
 *       \f$ \varepsilon = \frac{\xi^2}{8} \sqrt{1 + (1 - \xi^2/4)^{-2}},\ \xi = L/R \f$.
 *       0.01 means 26 edges on a circle. With 0 the curvature is not looked at, unless there is a `maximum_deviation`:
 *       `approximation_error(0).maximum_edge_length(l)` makes edges of one length.}
 *     \cgalParamType{`double`, a pure number, at least 0}
 *     \cgalParamDefault{`0.01`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{sagitta}
 *     \cgalParamDescription{largest distance between an edge and its arc. This and the next three say the same
 *       as `approximation_error` in other words, see \ref PkgHermiteDiffuseRemeshingSizeLaws. Each replaces the
 *       default of `approximation_error`; of several that are given the smallest size counts.}
 *     \cgalParamType{`double`, a length, larger than 0}
 *     \cgalParamDefault{none}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{elements_per_circle}
 *     \cgalParamDescription{number of edges on a full circle with the radius of curvature}
 *     \cgalParamType{`double`, at least 2}
 *     \cgalParamDefault{none}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{angle_per_element}
 *     \cgalParamDescription{angle that an edge spans at the centre of curvature}
 *     \cgalParamType{`double`, degrees in (0, 180]}
 *     \cgalParamDefault{none}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{sagitta_over_length}
 *     \cgalParamDescription{distance between an edge and its arc divided by the length of the edge}
 *     \cgalParamType{`double`, a ratio in (0, 0.5]}
 *     \cgalParamDefault{none}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{maximum_deviation}
 *     \cgalParamDescription{largest distance between the result and the fitted surface, measured at vertices,
 *       middles of edges and centroids of faces of the result, and from points of the fitted surface and of its
 *       feature curves to the result. Sizes are chosen for it from the curvature, as by another error law. Where it is
 *       exceeded even so, they are lowered and the mesh is adapted again there, in at most 20 rounds. Where
 *       `maximum_number_of_faces` does not do for it, the faces are shared out so that the largest deviation is as
 *       small as they allow. The report says whether it was met, and where it was not; and how far the fitted
 *       surface is from the facets of the input.}
 *     \cgalParamType{`double`, a length, larger than 0}
 *     \cgalParamDefault{infinity}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{maximum_displacement}
 *     \cgalParamDescription{largest distance of the points of the fitted surface from the facets of the input, and of
 *       its feature curves from the edges: what the fit says of the distance \f$ h \f$ becomes
 *       \f$ h / (1 + (h/b)^4)^{1/4} \f$ with this bound \f$ b \f$. The sizes are still those of the surface
 *       without the bound. With 0 all vertices of the result lie on the facets. The distance of the result from the
 *       input is at most the sum of this and of the deviation.}
 *     \cgalParamType{`double`, a length, at least 0}
 *     \cgalParamDefault{infinity}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{minimum_edge_length}
 *     \cgalParamDescription{lower bound of the sizes}
 *     \cgalParamType{`double`, a length, at least 0; 0 means the default}
 *     \cgalParamDefault{1e-4 of the diameter of the mesh, twice the largest distance of a vertex to the centroid of the
 *       surface; or `maximum_edge_length` if that is smaller}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{maximum_edge_length}
 *     \cgalParamDescription{upper bound of the sizes, reached where the surface is flat}
 *     \cgalParamType{`double`, a length, at least 0; 0 means the default}
 *     \cgalParamDefault{0.1 of the diameter of the mesh, or `minimum_edge_length` if that is larger}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{size_field}
 *     \cgalParamDescription{the user's own size; the smallest of it, the curvature's size and the upper bound is
 *       used, or the lower bound if that is larger; alone with `approximation_error(0)`. It is read before
 *       anything is changed: at the vertices of the mesh, and between them at places half a size apart or closer.
 *       A finer part of the field that is smaller than the elements around it may be overlooked if the field
 *       does not lead there gradually.}
 *     \cgalParamType{a model of `HermiteDiffuseSizeField`, for instance a function from `GeomTraits::Point_3`
 *       to `double`: a length larger than 0, infinite where there is no size}
 *     \cgalParamDefault{none}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{gradation}
 *     \cgalParamDescription{largest ratio \f$ g \f$ of the sizes of two adjacent faces. It is applied to the
 *       sizes before anything is remeshed, as the slope \f$ \sqrt{3} \ln g \f$ of the size with the
 *       distance, which does not depend on the faces of the input.}
 *     \cgalParamType{`double`, a ratio in [1, 2]}
 *     \cgalParamDefault{`1.3`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{sharp_dihedral_angle}
 *     \cgalParamDescription{an edge is sharp if the normals of its two faces differ by more than this, and 1e-5
 *       radians for what roundings may make}
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
 *     \cgalParamDescription{edges that are features whatever their angle; kept up to date. Where the marks of a border begin
 *       and end there are corners. Marks on edges that `edge_policy_map` makes free are removed.}
 *     \cgalParamType{a model of `ReadWritePropertyMap` with key type `edge_descriptor` and value type `bool`}
 *     \cgalParamDefault{no edge}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{vertex_is_constrained_map}
 *     \cgalParamDescription{vertices that are corners}
 *     \cgalParamType{a model of `ReadablePropertyMap` with key type `vertex_descriptor` and value type `bool`}
 *     \cgalParamDefault{no vertex}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{protect_constraints}
 *     \cgalParamDescription{if `true`, the edges of `edge_is_constrained_map` stay exactly as they are:
 *       neither split, collapsed nor moved. Without that map it has no effect: border edges, which \cgal's isotropic
 *       remeshing protects then, are sampled anew unless they are marked there. The sizes around start from their
 *       lengths: smaller ones grow from them with the gradation, larger ones fall to what was asked for with a
 *       gradation of 2.}
 *     \cgalParamType{`bool`}
 *     \cgalParamDefault{`false`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{face_patch_map}
 *     \cgalParamDescription{labels; edges between faces of different labels are features. Kept up to date.}
 *     \cgalParamType{a model of `ReadWritePropertyMap` with key type `face_descriptor` and a value type that
 *       can be compared}
 *     \cgalParamDefault{one label}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{edge_policy_map}
 *     \cgalParamDescription{a decision on each edge, which goes before the rules of the detection and before
 *       `protect_constraints`: free, sampled anew along its curve, or protected exactly. It is read before
 *       anything is changed, and not kept up to date.}
 *     \cgalParamType{a model of `ReadablePropertyMap` with key type `edge_descriptor` and value type
 *       `CGAL::Hermite_diffuse_remeshing::Edge_policy`}
 *     \cgalParamDefault{`CGAL::Hermite_diffuse_remeshing::DETECTED_EDGE` for all edges}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{polynomial_degree}
 *     \cgalParamDescription{degree of the local polynomial; the paper's is 2}
 *     \cgalParamType{`int`, 2, 3 or 4}
 *     \cgalParamDefault{`3`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{hermite_weight}
 *     \cgalParamDescription{weight \f$ t \f$ of the normals, \f$ 1-t \f$ being that of the positions}
 *     \cgalParamType{`double`, in [0.001, 0.999]}
 *     \cgalParamDefault{`0.3`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{normal_estimation}
 *     \cgalParamDescription{how the normals at the vertices are estimated. With `SMOOTH_NORMALS`\, for noisy meshes\, the
 *       sizes follow the mean curvature over about six elements\, too}
 *     \cgalParamType{`CGAL::Hermite_diffuse_remeshing::Normal_estimation`}
 *     \cgalParamDefault{`FITTED_NORMALS`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{surface_model}
 *     \cgalParamDescription{the preset of the model: the one described above, or the paper's own form, the defaults of
 *       which are a weight of 0.5 and `AREA_NORMALS`, and which has no degree but 2}
 *     \cgalParamType{`CGAL::Hermite_diffuse_remeshing::Surface_model`}
 *     \cgalParamDefault{`CGAL::Hermite_diffuse_remeshing::CONTINUOUS_MODEL`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{vertex_normal_map}
 *     \cgalParamDescription{normals that the user knows; they replace the estimated ones. A zero vector means
 *       unknown, and so does one that is more than 60 degrees away from that of the faces around the vertex. At a vertex
 *       on a feature, a normal is used for the sides of the feature from the faces of which it is at most 30 degrees
 *       away. An apex has none. Length and orientation do not matter.}
 *     \cgalParamType{a model of `ReadablePropertyMap` with key type `vertex_descriptor` and value type
 *       `GeomTraits::Vector_3`}
 *     \cgalParamDefault{none}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{number_of_iterations}
 *     \cgalParamDescription{upper bound of the passes of the adaptation, which ends by itself when nothing is
 *       left to do; it holds for each of the levels of sizes, from coarse to fine, that a mesh with many
 *       faces is made by}
 *     \cgalParamType{`unsigned int`, at least 1}
 *     \cgalParamDefault{`10`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{maximum_number_of_faces}
 *     \cgalParamDescription{budget of remeshed faces. The sizes, their bounds included, are scaled up until
 *       nine tenths of it are predicted, and no edge is split beyond it. Where features make more faces of a larger input
 *       than predicted, the sizes are scaled up further, until the budget is met or only the corners and what they keep are
 *       left. 0 means the default.}
 *     \cgalParamType{`std::size_t`}
 *     \cgalParamDefault{1000000, or ten times the faces of the input if that is more: a cap, so that an absurdly
 *       small size does not eat the memory}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{maximum_running_time}
 *     \cgalParamDescription{after this time the remeshing stops as if the visitor had asked for it. The clock
 *       is read for nothing else; a result that it has stopped depends on the machine and on its load.}
 *     \cgalParamType{`double`, seconds, larger than 0}
 *     \cgalParamDefault{infinity}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{do_self_intersection_tests}
 *     \cgalParamDescription{if `true`, an operation whose triangles would meet other triangles of the mesh is
 *       refused: a mesh without self-intersections gets none, and the number of pairs of faces that meet
 *       does not grow.}
 *     \cgalParamType{`bool`}
 *     \cgalParamDefault{`true`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{visitor}
 *     \cgalParamDescription{is told about stages and operations and may stop the remeshing}
 *     \cgalParamType{a model of `HermiteDiffuseRemeshingVisitor`, by value or by `std::ref`; a value is copied, and
 *       what the copy has collected goes with it}
 *     \cgalParamDefault{`CGAL::Hermite_diffuse_remeshing::Default_remeshing_visitor<TriangleMesh>`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{vertex_location_map}
 *     \cgalParamDescription{output: where a vertex lies on the input, as the rank of a face in `faces(tmesh)`
 *       before the call and barycentric coordinates with respect to `source(halfedge(f))`,
 *       `target(halfedge(f))` and the third vertex. This and `face_origin_map` are also written if a stop came before
 *       the mesh was changed, the other output maps are not then.}
 *     \cgalParamType{a model of `WritablePropertyMap` with key type `vertex_descriptor` and value type
 *       `std::pair<std::size_t, std::array<double, 3> >`}
 *     \cgalParamDefault{none}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{edge_class_map}
 *     \cgalParamDescription{output: what an edge of the result is a piece of}
 *     \cgalParamType{a model of `WritablePropertyMap` with key type `edge_descriptor` and value type
 *       `CGAL::Hermite_diffuse_remeshing::Edge_class`}
 *     \cgalParamDefault{none}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{face_origin_map}
 *     \cgalParamDescription{output: rank in `faces(tmesh)` before the call of the face that the centroid of a face lies
 *       on; a face that is not remeshed has its own}
 *     \cgalParamType{a model of `WritablePropertyMap` with key type `face_descriptor` and value type `std::size_t`}
 *     \cgalParamDefault{none}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{vertex_size_map}
 *     \cgalParamDescription{output: the edge length that was asked for at a vertex}
 *     \cgalParamType{a model of `WritablePropertyMap` with key type `vertex_descriptor` and value type `double`}
 *     \cgalParamDefault{none}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{face_deviation_map}
 *     \cgalParamDescription{output: the largest distance to the fitted surface that was measured at a face; not written
 *       for faces that are not remeshed, nor after a stop}
 *     \cgalParamType{a model of `WritablePropertyMap` with key type `face_descriptor` and value type `double`}
 *     \cgalParamDefault{none}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{vertex_point_map}
 *     \cgalParamDescription{the points of the vertices}
 *     \cgalParamType{a model of `ReadWritePropertyMap` with key type `vertex_descriptor` and value type
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
 * @return what was done, and which promises were kept
 *
 * \throw std::invalid_argument if the mesh cannot be remeshed, see \ref HDR_input, or if a parameter is out of
 *        its range. The message names the element or the parameter, and the mesh is unchanged.
 * \throw std::bad_alloc if there is too little memory. The mesh is valid then, and before the adaptation begins
 *        unchanged, but for repaired faces.
 *
 * @sa `CGAL::Hermite_diffuse_surface`
 * @sa `CGAL::Hermite_diffuse_remeshing::Attribute_transfer`
 */
template <typename ConcurrencyTag = Sequential_tag, typename FaceRange, typename TriangleMesh,
          typename NamedParameters = parameters::Default_named_parameters
#ifndef DOXYGEN_RUNNING
          // a variable of named parameters, which is no mesh, belongs to the other overload
          , typename = std::enable_if_t<
              !Hermite_diffuse_remeshing::internal::is_named_parameters<TriangleMesh>::value>
#endif
          >
Hermite_diffuse_remeshing::Remeshing_report<TriangleMesh>
hermite_diffuse_remesh(const FaceRange& faces, TriangleMesh& tmesh,
                       const NamedParameters& np = parameters::default_values())
{
  return CGAL::Hermite_diffuse_remeshing::internal::remesh<ConcurrencyTag>(
    faces, tmesh, CGAL::Hermite_diffuse_remeshing::internal::pack(np));
}

/*!
 * \ingroup PkgHermiteDiffuseRemeshingRef
 *
 * remeshes all faces of a triangle mesh: the same as the function for a range of faces, with `faces(tmesh)`.
 *
 * @tparam ConcurrencyTag as for a range of faces
 * @tparam TriangleMesh as for a range of faces
 * @tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
 *
 * @param tmesh the mesh
 * @param np an optional sequence of \ref bgl_namedparameters "Named Parameters", those of the function for a range of
 *        faces
 *
 * @return what was done, and which promises were kept
 *
 * \throw std::invalid_argument as for a range of faces
 * \throw std::bad_alloc as for a range of faces
 */
template <typename ConcurrencyTag = Sequential_tag, typename TriangleMesh,
          typename NamedParameters = parameters::Default_named_parameters
#ifndef DOXYGEN_RUNNING
          // a variable of a range of faces belongs to the other overload, with the mesh behind it
          , typename = std::enable_if_t<
              Hermite_diffuse_remeshing::internal::is_named_parameters<NamedParameters>::value>
#endif
          >
Hermite_diffuse_remeshing::Remeshing_report<TriangleMesh>
hermite_diffuse_remesh(TriangleMesh& tmesh, const NamedParameters& np = parameters::default_values())
{
  typedef typename boost::graph_traits<TriangleMesh>::face_descriptor face_descriptor;
  const std::vector<face_descriptor> all_faces(faces(tmesh).begin(), faces(tmesh).end());
  return hermite_diffuse_remesh<ConcurrencyTag>(all_faces, tmesh, np);
}

} // namespace Polygon_mesh_processing
} // namespace CGAL

#endif // CGAL_POLYGON_MESH_PROCESSING_HERMITE_DIFFUSE_REMESH_H
