// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_REMESHING_SIZES_FROM_ERRORS_H
#define CGAL_HERMITE_DIFFUSE_REMESHING_SIZES_FROM_ERRORS_H

#include <CGAL/Hermite_diffuse_remeshing/internal/validate_input.h>

#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/number_utils.h>
#include <CGAL/property_map.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace CGAL {
namespace Hermite_diffuse_remeshing {

namespace internal {

// The number of new elements per unit of area, up to the factor that the target determines.
//
// An error that is integrated over an element goes with h^(p+1) if it goes with h^p at a point. The mesh
// with the fewest elements for an error has the same error e in each of them, so an element with the
// error E becomes (E/e)^(2/(p+1)) elements.
template <typename TriangleMesh, typename FaceErrorMap, typename VertexSizeMap>
class Error_distribution
{
  const TriangleMesh& m_tmesh;
  std::vector<double> m_areas, m_powers;             // of the faces: area, E^(2/(p+1))
  double m_sum_of_powers = 0.;
  double m_order;

public:
  Error_distribution(const TriangleMesh& tmesh, const FaceErrorMap& errors, const double order)
    : m_tmesh(tmesh), m_order(order)
  {
    typedef typename GetGeomTraits<TriangleMesh>::type GT;
    check_positive_parameter("the order of the error", order);
    const GT traits = GT();
    const auto points = get_const_property_map(CGAL::vertex_point, tmesh);
    const auto squared_area = traits.compute_squared_area_3_object();
    for(const auto f : faces(tmesh))
    {
      const double error = CGAL::to_double(get(errors, f));
      if(!(error >= 0.) || !std::isfinite(error))
        refuse("the error of face " + std::to_string(m_areas.size()), error, "it must be finite and not negative");
      const auto h = halfedge(f, tmesh);
      m_areas.push_back(std::sqrt(CGAL::to_double(squared_area(get(points, source(h, tmesh)), get(points, target(h, tmesh)),
                                                               get(points, target(next(h, tmesh), tmesh))))));
      m_powers.push_back(std::pow(error, 2. / (order + 1.)));
      m_sum_of_powers += m_powers.back();
    }
  }

  // e^(2/(p+1)) that gives n elements: the sum of (E/e)^(2/(p+1)) is n
  double power_for_number(const double number) const { return m_sum_of_powers / number; }

  // and that gives the error t: t^2 = n e^2
  double power_for_error(const double target) const
  {
    return std::pow(target * target / m_sum_of_powers, 1. / m_order);
  }

  // An equilateral triangle of size h has the area sqrt(3)/4 h^2. At a vertex the elements per area of its
  // faces are averaged, so that their number is kept.
  void write(const double power, const VertexSizeMap& sizes) const
  {
    auto rank = get(CGAL::dynamic_vertex_property_t<std::size_t>(), m_tmesh);
    std::size_t n = 0;
    for(const auto v : vertices(m_tmesh))
      put(rank, v, n++);
    std::vector<double> area(n, 0.), number(n, 0.);
    std::size_t i = 0;
    for(const auto f : faces(m_tmesh))
    {
      for(const auto v : CGAL::vertices_around_face(halfedge(f, m_tmesh), m_tmesh))
      {
        area[get(rank, v)] += m_areas[i];
        number[get(rank, v)] += m_powers[i] / power;
      }
      ++i;
    }
    for(const auto v : vertices(m_tmesh))
    {
      const double elements = number[get(rank, v)];
      put(sizes, v, elements > 0. ? std::sqrt(4. / std::sqrt(3.) * area[get(rank, v)] / elements)
                                  : std::numeric_limits<double>::infinity());
    }
  }
};

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
 * @tparam TriangleMesh a model of `FaceListGraph` with an internal property map of points
 * @tparam FaceErrorMap a model of `ReadablePropertyMap` with key type `face_descriptor` and a value type
 *         convertible to `double`
 * @tparam VertexSizeMap a model of `WritablePropertyMap` with key type `vertex_descriptor` and value type
 *         `double`
 *
 * @param tmesh the mesh of the computation
 * @param errors errors of the elements, not negative, in any unit
 * @param order \f$ p \f$: the error at a point goes with this power of the size; 1 for the gradient of linear
 *        elements
 * @param number_of_elements larger than 0
 * @param sizes output: lengths, to be used with `Vertex_size_field`, or with `Background_size_field` if another
 *        mesh of the surface is remeshed
 *
 * \throw std::invalid_argument if an argument is out of its range or an error is not finite
 */
template <typename TriangleMesh, typename FaceErrorMap, typename VertexSizeMap>
void sizes_for_number_of_elements(const TriangleMesh& tmesh, const FaceErrorMap& errors, const double order,
                                  const double number_of_elements, const VertexSizeMap& sizes)
{
  internal::check_positive_parameter("the number of elements", number_of_elements);
  const internal::Error_distribution<TriangleMesh, FaceErrorMap, VertexSizeMap> distribution(tmesh, errors, order);
  distribution.write(distribution.power_for_number(number_of_elements), sizes);
}

/*!
 * \ingroup PkgHermiteDiffuseRemeshingRef
 *
 * computes sizes from the errors of the elements of a computation, such that a new mesh with these sizes
 * has about the error `target_error`, the root of the sum of the squares of the errors of its elements, with
 * as few elements as possible. See `sizes_for_number_of_elements()`.
 *
 * @param tmesh the mesh of the computation
 * @param errors errors of the elements, not negative
 * @param order \f$ p \f$: the error at a point goes with this power of the size
 * @param target_error larger than 0, in the unit of `errors`
 * @param sizes output: lengths
 *
 * \throw std::invalid_argument if an argument is out of its range or an error is not finite
 */
template <typename TriangleMesh, typename FaceErrorMap, typename VertexSizeMap>
void sizes_for_error(const TriangleMesh& tmesh, const FaceErrorMap& errors, const double order,
                     const double target_error, const VertexSizeMap& sizes)
{
  internal::check_positive_parameter("the target error", target_error);
  const internal::Error_distribution<TriangleMesh, FaceErrorMap, VertexSizeMap> distribution(tmesh, errors, order);
  distribution.write(distribution.power_for_error(target_error), sizes);
}

} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_SIZES_FROM_ERRORS_H
