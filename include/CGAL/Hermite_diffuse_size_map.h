// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_SIZE_MAP_H
#define CGAL_HERMITE_DIFFUSE_SIZE_MAP_H

#include <CGAL/license/Hermite_diffuse_remeshing.h>

#include <CGAL/Hermite_diffuse_remeshing/internal/Point_reader.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/make_size_map.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/read_model.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/read_size_options.h>

#include <array>
#include <cstddef>
#include <memory>
#include <utility>

namespace CGAL {

/*!
 * \ingroup PkgHermiteDiffuseRemeshingRef
 *
 * The class `Hermite_diffuse_size_map` gives the sizes that
 * `CGAL::Polygon_mesh_processing::hermite_diffuse_remesh()` would use, without changing the mesh: the
 * smallest of the curvature's size, on faces and feature curves, of the user's `size_field` and of the
 * bounds, limited by the gradation and scaled to the budget of faces. They are continuous across the edges
 * of the mesh. It also predicts how many faces the result will have.
 *
 * The object is immutable, and refers to nothing: the mesh may change afterwards, for instance while
 * another remesher reads its sizes here. Queries from several threads are safe.
 *
 * \tparam TriangleMesh a model of `FaceListGraph` and `VertexListGraph` that has dynamic properties
 * \tparam GeomTraits_ a model of `HermiteDiffuseRemeshingTraits`; by default the kernel of the points
 *         of the mesh
 * \tparam ConcurrencyTag enables the construction in parallel. Possible values are `Sequential_tag`,
 *         `Parallel_tag` and `Parallel_if_available_tag`. The sizes are the same, to the last bit, for any
 *         number of threads. The user's fields and maps are read by the calling thread alone.
 *
 * @sa `CGAL::Polygon_mesh_processing::hermite_diffuse_remesh()`
 * @sa `CGAL::Hermite_diffuse_surface`
 */
template <typename TriangleMesh,
          typename GeomTraits_ = typename GetGeomTraits<TriangleMesh>::type,
          typename ConcurrencyTag = Sequential_tag>
class Hermite_diffuse_size_map
{
  typedef Hermite_diffuse_remeshing::internal::Input_model Input_model;
  typedef Hermite_diffuse_remeshing::internal::Location Location;
  typedef Hermite_diffuse_remeshing::internal::Size_map Size_map;
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
  /// rank of a face in `faces(tmesh)` at the time of the construction, as in the `vertex_location_map` of
  /// `CGAL::Polygon_mesh_processing::hermite_diffuse_remesh()`, and the barycentric coordinates in it. A descriptor,
  /// even one that is a number, is no rank: the two differ where faces have been removed.
  typedef std::pair<std::size_t, std::array<FT, 3> > Face_location;
  /// @}

private:
  Geom_traits m_traits;
  std::unique_ptr<Input_model> m_model;
  std::unique_ptr<Size_map> m_sizes;

public:
  /*!
   * computes the sizes on a mesh.
   *
   * @tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
   *
   * @param tmesh the mesh, which is not changed
   * @param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below
   *
   * \cgalNamedParamsBegin
   *   \cgalParamNBegin{approximation_error, sagitta, elements_per_circle, angle_per_element, sagitta_over_length,
   *     maximum_deviation, minimum_edge_length, maximum_edge_length, size_field, gradation, maximum_number_of_faces,
   *     sharp_dihedral_angle, corner_angle, apex_angular_defect, edge_is_constrained_map, edge_policy_map,
   *     vertex_is_constrained_map, protect_constraints, face_patch_map, maximum_displacement, polynomial_degree,
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
   * Degenerate and folded faces are taken as they are: the remeshing, which repairs them, may find other sizes near by.
   *
   * Takes time and memory proportional to the number of faces, but for a logarithmic factor and for vertices with very
   * many faces, which take the square of their number, and to the number of places where the sizes vary inside a face.
   *
   * \throw std::invalid_argument if the mesh has no face, a face that is not a triangle, a coordinate that is not
   *        finite or a diameter outside [1e-50, 1e50], or if a parameter of the model or of the sizes is out of its
   *        range
   */
  template <typename NamedParameters = parameters::Default_named_parameters>
  explicit Hermite_diffuse_size_map(const TriangleMesh& tmesh,
                                    const NamedParameters& np = parameters::default_values())
  {
    using namespace Hermite_diffuse_remeshing::internal;

    const auto& pack = Hermite_diffuse_remeshing::internal::pack(np);
    const Input_mesh<TriangleMesh, Geom_traits> input = read_input<Geom_traits>(tmesh, pack);
    m_traits = input.traits;
    Size_options options = read_size_options<Geom_traits>(pack, input.triangles);
    read_size_field(pack, m_traits, input.face_descriptors, options);
    m_model = read_model<ConcurrencyTag>(input, pack);
    m_model->locator.build_tree();
    m_sizes = make_size_map(*m_model, options, input.side_marks, read_face_budget(pack, input.face_descriptors.size()),
                            [](int) { return true; });
  }

  /// returns the size at the point of the mesh that is closest to `p`, a length; in time logarithmic in
  /// the number of faces.
  ///
  /// \throw std::invalid_argument if `p` is not finite, or so far away that the square of its distance overflows
  FT size(const Point_3& p) const
  {
    const Hermite_diffuse_remeshing::internal::Point_reader<Geom_traits> read_point(m_traits);
    return FT((*m_sizes)(m_model->locator.closest(read_point(p))));
  }

  /// returns the size at a location on the mesh, a length; in constant time.
  FT size(const Face_location& location) const
  {
    Location at;
    at.face = static_cast<int>(location.first);
    for(int k = 0; k < 3; ++k)
      at.coordinates[k] = CGAL::to_double(location.second[k]);
    return FT((*m_sizes)(at));
  }

  /// returns the number of faces to expect of a remeshing with these sizes: the integral of
  /// \f$ 4/(\sqrt{3}\,L^2) \f$ over the mesh, \f$ L \f$ being the size.
  double predicted_number_of_faces() const
  {
    return m_sizes->number_of_faces([](int) { return true; });
  }
};

} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_SIZE_MAP_H
