// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_REMESHING_SIZE_FIELDS_H
#define CGAL_HERMITE_DIFFUSE_REMESHING_SIZE_FIELDS_H

#include <CGAL/license/Hermite_diffuse_remeshing.h>

#include <CGAL/boost/graph/iterator.h>
#include <CGAL/use.h>

#include <boost/graph/graph_traits.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <tuple>
#include <type_traits>

namespace CGAL {
namespace Hermite_diffuse_remeshing {

namespace internal {

// A field may depend on the point alone, or also on where it lies on the mesh.
template <typename Field, typename Point, typename Face, typename Coordinates>
double size_of_field(const Field& field, const Point& p, const Face f, const Coordinates& coordinates)
{
  if constexpr(std::is_invocable<const Field&, const Point&, Face, const Coordinates&>::value)
    return field(p, f, coordinates);
  else
    return field(p);
}

} // namespace internal

/*!
 * \ingroup PkgHermiteDiffuseRemeshingRef
 *
 * The class `Constant_size_field` asks for the same size everywhere.
 *
 * \cgalModels{HermiteDiffuseSizeField}
 */
class Constant_size_field
{
  double m_size;

public:
  /// @param size a length, larger than 0
  explicit Constant_size_field(const double size) : m_size(size) {}

  /// returns the size.
  template <typename Point>
  double operator()(const Point&) const { return m_size; }
};

/*!
 * \ingroup PkgHermiteDiffuseRemeshingRef
 *
 * The class `Vertex_size_field` asks for sizes that are given at the vertices of the mesh that is
 * remeshed, and interpolates them linearly on its faces. A size that is infinite means that there is
 * none.
 *
 * \cgalModels{HermiteDiffuseSizeField}
 *
 * \tparam TriangleMesh a model of `FaceListGraph`
 * \tparam VertexSizeMap a model of `ReadablePropertyMap` with key type `vertex_descriptor` and a value
 *         type convertible to `double`
 */
template <typename TriangleMesh, typename VertexSizeMap>
class Vertex_size_field
{
  typedef typename boost::graph_traits<TriangleMesh>::face_descriptor face_descriptor;

  const TriangleMesh* m_tmesh;
  VertexSizeMap m_sizes;

public:
  /// @param tmesh the mesh that will be remeshed, which is referred to
  /// @param sizes the sizes of its vertices, lengths larger than 0
  Vertex_size_field(const TriangleMesh& tmesh, const VertexSizeMap& sizes) : m_tmesh(&tmesh), m_sizes(sizes) {}

  /// returns the interpolated size, in constant time.
  template <typename Point, typename FT>
  double operator()(const Point&, const face_descriptor f, const std::array<FT, 3>& coordinates) const
  {
    double size = 0.;
    auto h = halfedge(f, *m_tmesh);
    for(std::size_t k = 0; k < 3; ++k, h = next(h, *m_tmesh))
      // an infinite size at another vertex must not spoil the result
      if(coordinates[k] > FT(0))
        size += double(coordinates[k]) * double(get(m_sizes, source(h, *m_tmesh)));
    return size;
  }
};

/*!
 * \ingroup PkgHermiteDiffuseRemeshingRef
 *
 * The class `Face_size_field` asks for sizes that are given for the faces of the mesh that is
 * remeshed: for example by material or by element of a computation. At an edge the smaller size of its
 * faces counts, from which sizes grow with the gradation into the other face. A size that is infinite
 * means that there is none.
 *
 * \cgalModels{HermiteDiffuseSizeField}
 *
 * \tparam TriangleMesh a model of `FaceListGraph`
 * \tparam FaceSizeMap a model of `ReadablePropertyMap` with key type `face_descriptor` and a value type
 *         convertible to `double`
 */
template <typename TriangleMesh, typename FaceSizeMap>
class Face_size_field
{
  typedef typename boost::graph_traits<TriangleMesh>::face_descriptor face_descriptor;

  FaceSizeMap m_sizes;

public:
  /// @param tmesh the mesh that will be remeshed
  /// @param sizes the sizes of its faces, lengths larger than 0
  Face_size_field(const TriangleMesh& tmesh, const FaceSizeMap& sizes) : m_sizes(sizes) { CGAL_USE(tmesh); }

  /// returns the size of the face, in constant time.
  template <typename Point, typename FT>
  double operator()(const Point&, const face_descriptor f, const std::array<FT, 3>&) const
  {
    return double(get(m_sizes, f));
  }
};

/*!
 * \ingroup PkgHermiteDiffuseRemeshingRef
 *
 * The class `Minimum_size_field` asks for the smallest of the sizes of several fields.
 *
 * \cgalModels{HermiteDiffuseSizeField}
 *
 * \tparam SizeFields models of `HermiteDiffuseSizeField`
 *
 * @sa `minimum_size_field()`
 */
template <typename... SizeFields>
class Minimum_size_field
{
  std::tuple<SizeFields...> m_fields;

public:
  /// @param fields the fields, which are copied
  explicit Minimum_size_field(const SizeFields&... fields) : m_fields(fields...) {}

  /// returns the smallest of the sizes.
  template <typename Point, typename Face, typename Coordinates>
  double operator()(const Point& p, const Face f, const Coordinates& coordinates) const
  {
    double smallest = std::numeric_limits<double>::infinity();
    // what is no number is not dropped, but refused by the remeshing
    const auto lower = [&smallest](const double size)
    { smallest = std::isnan(smallest) || size >= smallest ? smallest : size; };
    std::apply([&](const SizeFields&... fields) { (lower(internal::size_of_field(fields, p, f, coordinates)), ...); },
               m_fields);
    return smallest;
  }
};

/*!
 * \ingroup PkgHermiteDiffuseRemeshingRef
 *
 * returns a field whose size is the smallest of the sizes of several fields.
 *
 * @tparam SizeFields models of `HermiteDiffuseSizeField`
 *
 * @param fields the fields, which are copied
 */
template <typename... SizeFields>
Minimum_size_field<SizeFields...> minimum_size_field(const SizeFields&... fields)
{
  return Minimum_size_field<SizeFields...>(fields...);
}

} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_SIZE_FIELDS_H
