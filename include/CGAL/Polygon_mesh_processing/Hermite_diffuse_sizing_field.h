// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_POLYGON_MESH_PROCESSING_HERMITE_DIFFUSE_SIZING_FIELD_H
#define CGAL_POLYGON_MESH_PROCESSING_HERMITE_DIFFUSE_SIZING_FIELD_H

#include <CGAL/license/Hermite_diffuse_remeshing.h>

#include <CGAL/Hermite_diffuse_size_map.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Point_reader.h>

#include <CGAL/boost/graph/iterator.h>

#include <memory>
#include <optional>

namespace CGAL {
namespace Polygon_mesh_processing {

/*!
 * \ingroup PkgHermiteDiffuseRemeshingRef
 *
 * The class `Hermite_diffuse_sizing_field` hands the sizes of this package to the remeshing functions of
 * \cgal from version 6 on: the curvature of the Hermite diffuse surface, on faces and feature curves, the
 * fields of the user, the gradation and the budget of faces can drive `isotropic_remeshing()` and
 * `split_long_edges()`.
 *
 * The sizes are those of the mesh at the time of the construction; the mesh may change afterwards. An
 * edge is too long if it is longer than 4/3 of the mean of the sizes at its ends, and too short if it is
 * shorter than 4/5 of it: the factors are those of \cgal's own fields, which take the smaller of the two sizes. Every question takes time logarithmic in the number
 * of faces that the mesh had. Copies share the sizes.
 *
 * \cgalModels{PMPSizingField}
 *
 * \tparam TriangleMesh a model of `MutableFaceGraph`
 * \tparam GeomTraits a model of `HermiteDiffuseRemeshingTraits`; by default the kernel of the points of the mesh
 * \tparam VertexPointMap a model of `ReadablePropertyMap` with key type `vertex_descriptor` and the point type of the
 *         traits as value type; by default the internal map of the mesh
 * \tparam ConcurrencyTag enables the construction in parallel, as for `CGAL::Hermite_diffuse_size_map`
 *
 * @sa `CGAL::Hermite_diffuse_size_map`
 */
template <typename TriangleMesh,
          typename GeomTraits = typename GetGeomTraits<TriangleMesh>::type,
          typename VertexPointMap = typename boost::property_map<TriangleMesh, CGAL::vertex_point_t>::const_type,
          typename ConcurrencyTag = Sequential_tag>
class Hermite_diffuse_sizing_field
{
  typedef Hermite_diffuse_size_map<TriangleMesh, GeomTraits, ConcurrencyTag> Size_map;
  typedef Hermite_diffuse_remeshing::internal::Vector Vector;

public:
  /// \name Types
  /// @{

  /// the number type of the points
  typedef typename Size_map::FT FT;
  /// the type of the points
  typedef typename Size_map::Point_3 Point_3;
  /// a halfedge of the mesh
  typedef typename boost::graph_traits<TriangleMesh>::halfedge_descriptor halfedge_descriptor;
  /// a vertex of the mesh
  typedef typename boost::graph_traits<TriangleMesh>::vertex_descriptor vertex_descriptor;
  /// @}

private:
  std::shared_ptr<const Size_map> m_sizes;
  VertexPointMap m_points;
  GeomTraits m_traits;

public:
  /*!
   * computes the sizes.
   *
   * @param tmesh the mesh that will be remeshed
   * @param np an optional sequence of named parameters, as for `CGAL::Hermite_diffuse_size_map`; `geom_traits` and
   *        `vertex_point_map` are of the types of the template parameters
   *
   * \throw std::invalid_argument as `hermite_diffuse_remesh()` does
   */
  template <typename NamedParameters = parameters::Default_named_parameters>
  explicit Hermite_diffuse_sizing_field(const TriangleMesh& tmesh,
                                        const NamedParameters& np = parameters::default_values())
    : m_sizes(std::make_shared<const Size_map>(tmesh, np))
    , m_points(Hermite_diffuse_remeshing::internal::read_point_map(
        tmesh, Hermite_diffuse_remeshing::internal::pack(np)))
    , m_traits(parameters::choose_parameter<GeomTraits>(
        parameters::get_parameter(Hermite_diffuse_remeshing::internal::pack(np), internal_np::geom_traits)))
  {}

  /// returns the size at a vertex.
  FT at(const vertex_descriptor v, const TriangleMesh& /* tmesh */) const
  {
    return m_sizes->size(get(m_points, v));
  }

  /// returns how many times the square of the length between two vertices is larger than that of the
  /// longest edge, if it is.
  std::optional<FT> is_too_long(const vertex_descriptor v, const vertex_descriptor w, const TriangleMesh& tmesh) const
  {
    const FT ratio = squared_ratio(v, w, FT(4) / FT(3), tmesh);
    return ratio > FT(1) ? std::optional<FT>(ratio) : std::nullopt;
  }

  /// returns the part that the square of the length of an edge is of that of the shortest edge, if it is
  /// shorter.
  std::optional<FT> is_too_short(const halfedge_descriptor h, const TriangleMesh& tmesh) const
  {
    const FT ratio = squared_ratio(source(h, tmesh), target(h, tmesh), FT(4) / FT(5), tmesh);
    return ratio < FT(1) ? std::optional<FT>(ratio) : std::nullopt;
  }

  /// returns the middle of an edge.
  Point_3 split_placement(const halfedge_descriptor h, const TriangleMesh& tmesh) const
  {
    const Vector middle = (point(source(h, tmesh)) + point(target(h, tmesh))) / 2.;
    const typename GeomTraits::Construct_point_3 construct_point = m_traits.construct_point_3_object();
    return construct_point(FT(middle[0]), FT(middle[1]), FT(middle[2]));
  }

  /// does nothing: the sizes are known everywhere.
  void register_split_vertex(const vertex_descriptor, const TriangleMesh&) {}

private:
  Vector point(const vertex_descriptor v) const
  {
    return Hermite_diffuse_remeshing::internal::Point_reader<GeomTraits>(m_traits)(get(m_points, v));
  }

  FT squared_ratio(const vertex_descriptor v, const vertex_descriptor w, const FT factor,
                   const TriangleMesh& tmesh) const
  {
    const FT allowed = factor * (at(v, tmesh) + at(w, tmesh)) / FT(2);
    return FT((point(v) - point(w)).squaredNorm()) / (allowed * allowed);
  }
};

} // namespace Polygon_mesh_processing
} // namespace CGAL

#endif // CGAL_POLYGON_MESH_PROCESSING_HERMITE_DIFFUSE_SIZING_FIELD_H
