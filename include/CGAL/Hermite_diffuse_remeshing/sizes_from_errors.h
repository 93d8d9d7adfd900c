// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_REMESHING_SIZES_FROM_ERRORS_H
#define CGAL_HERMITE_DIFFUSE_REMESHING_SIZES_FROM_ERRORS_H

#include <CGAL/license/Hermite_diffuse_remeshing.h>

#include <CGAL/Hermite_diffuse_remeshing/internal/read_input.h>

#include <CGAL/number_utils.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Hermite_diffuse_remeshing {

namespace internal {

// The number of new elements per unit of area, up to the factor that the target determines.
//
// An error that is integrated over an element goes with h^(p+1) if it goes with h^p at a point. The mesh
// with the fewest elements for an error has the same error e in each of them, so an element with the
// error E becomes (E/e)^(2/(p+1)) elements.
class Error_distribution
{
  const Indexed_triangles& m_triangles;
  std::vector<double> m_powers;                      // E^(2/(p+1)) of the faces
  double m_sum_of_powers = 0.;
  double m_order;

public:
  Error_distribution(const Indexed_triangles& triangles, const std::vector<double>& errors, const double order)
    : m_triangles(triangles), m_order(order)
  {
    check_finite_parameter("the order of the error", order);
    for(const double error : errors)
    {
      if(!(error >= 0.) || !std::isfinite(error))
        refuse("the error of face " + std::to_string(m_powers.size()), error, "it must be finite and not negative");
      m_powers.push_back(std::pow(error, 2. / (order + 1.)));
      m_sum_of_powers += m_powers.back();
    }
  }

  // e^(2/(p+1)) that gives n elements: the sum of (E/e)^(2/(p+1)) is n
  double power_for_number(const double number) const { return m_sum_of_powers / number; }

  // and that gives the error t: t^2 = n e^2
  double power_for_error(const double target) const
  {
    return std::pow(target / std::sqrt(m_sum_of_powers), 2. / m_order);
  }

  // Sizes at the vertices. An equilateral triangle of size h has the area sqrt(3)/4 h^2. At a vertex the elements
  // per area of its faces are averaged, so that their number is kept.
  std::vector<double> sizes(const double power) const
  {
    const std::size_t n = m_triangles.points.size();
    std::vector<double> area(n, 0.), number(n, 0.), result;
    for(int f = 0; f < m_triangles.number_of_faces(); ++f)
    {
      const double face_area = 0.5 * m_triangles.area_vector(f).norm();
      for(const int v : m_triangles.triangles[f])
      {
        area[v] += face_area;
        number[v] += m_powers[f] / power;
      }
    }
    for(std::size_t v = 0; v < n; ++v)
      result.push_back(number[v] > 0. ? std::sqrt(4. / std::sqrt(3.) * area[v] / number[v])
                                      : std::numeric_limits<double>::infinity());
    return result;
  }
};

// `power(distribution)`: the one that meets the user's target
template <typename TriangleMesh, typename FaceErrorMap, typename VertexSizeMap, typename NamedParameters,
          typename Power>
void write_sizes(const TriangleMesh& tmesh, const FaceErrorMap& error_map, const double order,
                 const VertexSizeMap& size_map, const NamedParameters& np, const Power& power)
{
  const auto& pack = internal::pack(np);
  const auto input = read_input<Traits_of<TriangleMesh, std::decay_t<decltype(pack)> > >(tmesh, pack);
  std::vector<double> errors;
  for(const auto f : input.face_descriptors)
    errors.push_back(CGAL::to_double(get(error_map, f)));
  const Error_distribution distribution(input.triangles, errors, order);
  const std::vector<double> sizes = distribution.sizes(power(distribution));
  for(std::size_t i = 0; i < sizes.size(); ++i)
    put(size_map, input.vertex_descriptors[i], sizes[i]);
}

} // namespace internal

/*!
 * \ingroup PkgHermiteDiffuseRemeshingRef
 *
 * computes sizes from the errors of the elements of a computation, such that a new mesh with these sizes
 * has about the given number of elements, and the smallest error that a mesh of this many elements can have.
 *
 * With \f$ E_T \f$ the error integrated over the element \f$ T \f$, that is the root of the integral of its
 * square, of area \f$ A_T \f$, and \f$ p \f$ its order, the new size in \f$ T \f$ is
 * \f[ h_T^2 = \frac{4}{\sqrt 3}\, A_T \left(\frac{e}{E_T}\right)^{2/(p+1)}, \f]
 * so that all new elements have the same error \f$ e \f$ (O. C. Zienkiewicz, J. Z. Zhu, <em>A simple error
 * estimator and adaptive procedure for practical engineering analysis</em>, 1987, and others). At a vertex
 * the elements per area of its faces are averaged. Where the error is zero, the size is infinite.
 *
 * Takes time proportional to the number of faces.
 *
 * @tparam TriangleMesh a model of `FaceListGraph` and `VertexListGraph` that has dynamic properties
 * @tparam FaceErrorMap a model of `ReadablePropertyMap` with key type `face_descriptor` and a value type
 *         convertible to `double`
 * @tparam VertexSizeMap a model of `WritablePropertyMap` with key type `vertex_descriptor` and value type
 *         `double`
 * @tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
 *
 * @param tmesh the mesh of the computation
 * @param errors errors of the elements, not negative, in any unit
 * @param order \f$ p \f$: the error at a point goes with this power of the size; 1 for the gradient of linear
 *        elements
 * @param number_of_elements larger than 0, finite
 * @param sizes output: lengths, to be used with `Vertex_size_field`, or with `Background_size_field` if another
 *        mesh of the surface is remeshed
 * @param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{vertex_point_map}
 *     \cgalParamDescription{a property map associating points to the vertices of `tmesh`}
 *     \cgalParamType{a class model of `ReadablePropertyMap` with `vertex_descriptor` as key type and `Point_3` of the
 *                    traits as value type}
 *     \cgalParamDefault{`boost::get(CGAL::vertex_point, tmesh)`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{geom_traits}
 *     \cgalParamDescription{an instance of a geometric traits class}
 *     \cgalParamType{a class model of `HermiteDiffuseRemeshingTraits`}
 *     \cgalParamDefault{the kernel of the points}
 *   \cgalParamNEnd
 * \cgalNamedParamsEnd
 *
 * \throw std::invalid_argument if an argument is out of its range, an error or a coordinate is not finite, or a face
 *        is no triangle
 */
template <typename TriangleMesh, typename FaceErrorMap, typename VertexSizeMap,
          typename NamedParameters = parameters::Default_named_parameters>
void sizes_for_number_of_elements(const TriangleMesh& tmesh, const FaceErrorMap& errors, const double order,
                                  const double number_of_elements, const VertexSizeMap& sizes,
                                  const NamedParameters& np = parameters::default_values())
{
  internal::check_finite_parameter("the number of elements", number_of_elements);
  internal::write_sizes(tmesh, errors, order, sizes, np, [=](const internal::Error_distribution& distribution)
                        { return distribution.power_for_number(number_of_elements); });
}

/*!
 * \ingroup PkgHermiteDiffuseRemeshingRef
 *
 * computes sizes from the errors of the elements of a computation, such that a new mesh with these sizes
 * has about the error `target_error`, the root of the sum of the squares of the errors of its elements, with
 * as few elements as possible. See `sizes_for_number_of_elements()`.
 *
 * Takes time proportional to the number of faces.
 *
 * @tparam TriangleMesh a model of `FaceListGraph` and `VertexListGraph` that has dynamic properties
 * @tparam FaceErrorMap a model of `ReadablePropertyMap` with key type `face_descriptor` and a value type
 *         convertible to `double`
 * @tparam VertexSizeMap a model of `WritablePropertyMap` with key type `vertex_descriptor` and value type
 *         `double`
 * @tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
 *
 * @param tmesh the mesh of the computation
 * @param errors errors of the elements, not negative, in any unit
 * @param order \f$ p \f$: the error at a point goes with this power of the size; 1 for the gradient of linear
 *        elements
 * @param target_error larger than 0, in the unit of `errors`
 * @param sizes output: lengths
 * @param np an optional sequence of \ref bgl_namedparameters "Named Parameters", those of
 *        `sizes_for_number_of_elements()`
 *
 * \throw std::invalid_argument if an argument is out of its range, an error or a coordinate is not finite, or a face
 *        is no triangle
 */
template <typename TriangleMesh, typename FaceErrorMap, typename VertexSizeMap,
          typename NamedParameters = parameters::Default_named_parameters>
void sizes_for_error(const TriangleMesh& tmesh, const FaceErrorMap& errors, const double order,
                     const double target_error, const VertexSizeMap& sizes,
                     const NamedParameters& np = parameters::default_values())
{
  internal::check_finite_parameter("the target error", target_error);
  internal::write_sizes(tmesh, errors, order, sizes, np, [=](const internal::Error_distribution& distribution)
                        { return distribution.power_for_error(target_error); });
}

} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_SIZES_FROM_ERRORS_H
