// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_SURFACE_H
#define CGAL_HERMITE_DIFFUSE_SURFACE_H

#include <CGAL/license/Hermite_diffuse_remeshing.h>

#include <CGAL/Hermite_diffuse_remeshing/Principal_curvatures_and_directions.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Point_reader.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/order_for_locality.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/read_model.h>
#include <CGAL/Hermite_diffuse_remeshing/named_parameters.h>

#include <array>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL {

/*!
 * \ingroup PkgHermiteDiffuseRemeshingRef
 *
 * The class `Hermite_diffuse_surface` is the smooth surface that a triangle mesh stands for. It is
 * fitted to the vertices and to normals estimated there, interpolates both, is continuous across
 * edges, and stops at features: at a sharp edge each side has its own point, normal and curvature. The points of
 * the two differ by about the sagitta of a curved edge.
 *
 * A point of the surface is named by a face of the mesh and barycentric coordinates in it, as in
 * `CGAL::Polygon_mesh_processing`'s location functions: the coordinates belong to
 * `source(halfedge(f))`, `target(halfedge(f))` and the third vertex of the face. For a mesh whose
 * vertices lie on a smooth surface with edges of length \f$ h \f$, the distance to it is of order
 * \f$ h^4 \f$, the angle between the normals of order \f$ h^3 \f$, and the error of the curvatures
 * of order \f$ h^2 \f$, with the default parameters.
 *
 * `hermite_diffuse_remesh()` bends this surface to the splines of its feature curves, near which the two differ:
 * distances that it reports are to the bent one.
 *
 * The object is immutable and refers to the mesh for its descriptors only: the geometry is copied.
 * Queries from several threads are safe. An evaluation takes time proportional to the number of vertices around the
 * corners of its face, a projection without a hint time logarithmic in the number of faces.
 *
 * \tparam TriangleMesh a model of `FaceListGraph` and `VertexListGraph` that has dynamic properties
 * \tparam GeomTraits_ a model of `HermiteDiffuseRemeshingTraits`; by default the kernel of the points
 *         of the mesh
 * \tparam ConcurrencyTag enables the construction in parallel. Possible values are `Sequential_tag`,
 *         `Parallel_tag` and `Parallel_if_available_tag`. The surface is the same, to the last bit, for any
 *         number of threads.
 *
 * @sa `CGAL::Polygon_mesh_processing::hermite_diffuse_remesh()`
 */
template <typename TriangleMesh,
          typename GeomTraits_ = typename GetGeomTraits<TriangleMesh>::type,
          typename ConcurrencyTag = Sequential_tag>
class Hermite_diffuse_surface
{
  typedef Hermite_diffuse_remeshing::internal::Input_model Input_model;
  typedef Hermite_diffuse_remeshing::internal::Location Location;
  typedef Hermite_diffuse_remeshing::internal::Vector Vector;

public:
  /// \name Types
  /// @{

  /// the geometry traits
  typedef GeomTraits_ Geom_traits;
  /// the number type of the traits
  typedef typename Geom_traits::FT FT;
  /// the point type of the traits
  typedef typename Geom_traits::Point_3 Point_3;
  /// the vector type of the traits
  typedef typename Geom_traits::Vector_3 Vector_3;
  /// a face of the mesh
  typedef typename boost::graph_traits<TriangleMesh>::face_descriptor face_descriptor;
  /// a halfedge of the mesh
  typedef typename boost::graph_traits<TriangleMesh>::halfedge_descriptor halfedge_descriptor;
  /// a vertex of the mesh
  typedef typename boost::graph_traits<TriangleMesh>::vertex_descriptor vertex_descriptor;
  /// a face and the barycentric coordinates in it, which are not negative and add up to one
  typedef std::pair<face_descriptor, std::array<FT, 3> > Face_location;

  /// principal curvatures and their directions, unit vectors of the tangent plane
  typedef Hermite_diffuse_remeshing::Principal_curvatures_and_directions<Geom_traits>
    Principal_curvatures_and_directions;
  /// @}

private:
  Geom_traits m_traits;
  std::vector<face_descriptor> m_faces;
  typename boost::property_map<TriangleMesh, CGAL::dynamic_face_property_t<int> >::const_type m_rank;
  std::unique_ptr<Input_model> m_model;

public:
  /*!
   * fits the surface to a mesh.
   *
   * @tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
   *
   * @param tmesh the mesh; it must outlive the surface, without changes of its faces
   * @param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below
   *
   * \cgalNamedParamsBegin
   *   \cgalParamNBegin{sharp_dihedral_angle, corner_angle, apex_angular_defect, edge_is_constrained_map,
   *     edge_policy_map, vertex_is_constrained_map, face_patch_map, maximum_displacement, polynomial_degree,
   *     hermite_weight, normal_estimation, surface_model, vertex_normal_map}
   *     \cgalParamDescription{as for `CGAL::Polygon_mesh_processing::hermite_diffuse_remesh()`, but maps are only read}
   *   \cgalParamNEnd
   *   \cgalParamNBegin{vertex_point_map}
   *     \cgalParamDescription{the points of the vertices}
   *     \cgalParamType{a model of `ReadablePropertyMap` with key type `vertex_descriptor` and value type `Point_3`}
   *     \cgalParamDefault{`boost::get(CGAL::vertex_point, tmesh)`}
   *   \cgalParamNEnd
   *   \cgalParamNBegin{geom_traits}
   *     \cgalParamDescription{an instance of the geometric traits class}
   *     \cgalParamType{`Geom_traits`}
   *     \cgalParamDefault{`Geom_traits()`}
   *   \cgalParamNEnd
   * \cgalNamedParamsEnd
   *
   * Takes time proportional to the number of faces, but for the sorting of the edges and the search tree,
   * which add a logarithmic factor, and for vertices with very many faces, which take the square of their number. The
   * surface takes less than 150 bytes per face, beyond the mesh, if few
   * vertices are on features.
   *
   * \throw std::invalid_argument if the mesh has no face, a face that is not a triangle, a coordinate that is not
   *        finite or a diameter outside [1e-50, 1e50], or if a parameter is out of its range
   */
  template <typename NamedParameters = parameters::Default_named_parameters>
  explicit Hermite_diffuse_surface(const TriangleMesh& tmesh,
                                   const NamedParameters& np = parameters::default_values())
    : m_rank(get(CGAL::dynamic_face_property_t<int>(), tmesh))
  {
    using namespace Hermite_diffuse_remeshing::internal;

    const auto& pack = Hermite_diffuse_remeshing::internal::pack(np);
    Input_mesh<TriangleMesh, Geom_traits> input = read_input<Geom_traits>(tmesh, pack);
    order_for_locality(m_rank, input);
    m_traits = input.traits;
    m_model = read_model<ConcurrencyTag>(input, pack);
    m_faces = std::move(input.face_descriptors);
    m_model->keep_surface_only();
    m_model->locator.build_tree();
  }

  /// \name Evaluation
  /// @{

  /// returns the point of the surface at a location.
  Point_3 point(const Face_location& location) const
  {
    return to_point(evaluate(location).point());
  }

  /// returns the unit normal at a location, on the side of the face.
  Vector_3 normal(const Face_location& location) const
  {
    return to_vector(evaluate(location).normal());
  }

  /// returns the principal curvatures at a location, larger first, in one over the unit of length, positive where the
  /// surface bends away from its normal, whatever `maximum_displacement` is.
  std::pair<FT, FT> principal_curvatures(const Face_location& location) const
  {
    // with the signs of the class for curvatures and directions
    const std::pair<double, double> k = evaluate_unbounded(location).monge_form().curvatures();
    return std::make_pair(FT(0. - k.second), FT(0. - k.first));
  }

  /// returns the principal curvatures and their directions at a location, whatever `maximum_displacement` is.
  Principal_curvatures_and_directions
  principal_curvatures_and_directions(const Face_location& location) const
  {
    return Hermite_diffuse_remeshing::internal::to_public(
      evaluate_unbounded(location).monge_form().principal_curvatures(), m_traits);
  }
  /// @}

  /// \name Location
  /// @{

  /// returns the location of the target of a halfedge, on the side of its face: the two sides of a sharp
  /// edge have different normals and curvatures there.
  ///
  /// \pre `h` is not a border halfedge.
  Face_location vertex_location(const halfedge_descriptor h, const TriangleMesh& tmesh) const
  {
    CGAL_precondition(!is_border(h, tmesh));
    const halfedge_descriptor first = halfedge(face(h, tmesh), tmesh);
    Face_location result(face(h, tmesh), {{FT(0), FT(0), FT(0)}});
    const int corner = h == first ? 1 : h == next(first, tmesh) ? 2 : 0;
    result.second[corner] = FT(1);
    return result;
  }

  /// returns the location of the point of the facets of the mesh that is closest to `query`.
  ///
  /// \throw std::invalid_argument if `query` is not finite, or so far away that the square of its distance overflows
  Face_location locate(const Point_3& query) const
  {
    return to_face_location(m_model->locator.closest(from_point(query)));
  }

  /// returns the location of the point of the surface that is closest to `query`, near the closest
  /// facet: Newton's method on the local fits, from facet to facet.
  ///
  /// \throw std::invalid_argument as `locate()`
  Face_location project(const Point_3& query) const
  {
    const Vector p = from_point(query);
    return to_face_location(m_model->locator.project(p, m_model->locator.closest(p).face).location);
  }

  /// same, from a location that is known to be near, without a search; stays on the hint's side of
  /// every feature. The query is not checked.
  ///
  /// \pre the coordinates of the query are finite
  Face_location project(const Point_3& query, const Face_location& hint) const
  {
    return to_face_location(m_model->locator.project(from_point(query), get(m_rank, hint.first)).location);
  }
  /// @}

private:
  Hermite_diffuse_remeshing::internal::Local_quadric evaluate(const Face_location& location) const
  {
    return m_model->surface.evaluate(from_face_location(location));
  }
  Hermite_diffuse_remeshing::internal::Local_quadric evaluate_unbounded(const Face_location& location) const
  {
    return m_model->surface.evaluate_unbounded(from_face_location(location));
  }

  Location from_face_location(const Face_location& location) const
  {
    Location result;
    result.face = get(m_rank, location.first);
    for(int k = 0; k < 3; ++k)
      result.coordinates[k] = location.second[k];
    return result;
  }

  Face_location to_face_location(const Location& location) const
  {
    Face_location result;
    result.first = m_faces[location.face];
    for(int k = 0; k < 3; ++k)
      result.second[k] = FT(location.coordinates[k]);
    return result;
  }

  Vector from_point(const Point_3& p) const
  {
    return Hermite_diffuse_remeshing::internal::Point_reader<Geom_traits>(m_traits)(p);
  }
  Point_3 to_point(const Vector& v) const
  {
    const typename Geom_traits::Construct_point_3 point = m_traits.construct_point_3_object();
    return point(FT(v[0]), FT(v[1]), FT(v[2]));
  }
  Vector_3 to_vector(const Vector& v) const
  {
    const typename Geom_traits::Construct_vector_3 vector = m_traits.construct_vector_3_object();
    return vector(FT(v[0]), FT(v[1]), FT(v[2]));
  }
};

} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_SURFACE_H
