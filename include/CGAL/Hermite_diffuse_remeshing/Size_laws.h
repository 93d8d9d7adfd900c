// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_REMESHING_SIZE_LAWS_H
#define CGAL_HERMITE_DIFFUSE_REMESHING_SIZE_LAWS_H

#include <CGAL/license/Hermite_diffuse_remeshing.h>

#include <CGAL/Hermite_diffuse_remeshing/internal/Sizing/size_from_curvature.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/validate_input.h>

#include <boost/math/constants/constants.hpp>

#include <cmath>
#include <limits>
#include <sstream>

namespace CGAL {
namespace Hermite_diffuse_remeshing {

/*!
 * \defgroup PkgHermiteDiffuseRemeshingSizeLaws Size Laws
 * \ingroup PkgHermiteDiffuseRemeshingRef
 *
 * How fine must a mesh be on a circle of radius \f$ R \f$? Programs ask for it in different words, which
 * all are laws for the ratio \f$ \xi = L/R \f$ of the edge length to the radius. With
 * \f$ s = R\,(1 - \sqrt{1 - \xi^2/4}) \f$, the sagitta, that is the largest distance between an edge and its
 * arc:
 *
 * | law | value | ratio \f$ \xi \f$ | `hermite_diffuse_remesh()` |
 * | --- | ----- | ------ | -------- |
 * | relative error | \f$ \varepsilon = \frac{\xi^2}{8} \sqrt{1 + (1 - \xi^2/4)^{-2}} \f$ | inverse of it | `approximation_error` |
 * | sagitta | \f$ s/R \f$ | \f$ 2 \sqrt{(s/R)\,(2 - s/R)} \f$ | `sagitta`, the length \f$ s \f$ |
 * | elements per circle | \f$ n = \pi / \arcsin(\xi/2) \f$ | \f$ 2 \sin(\pi/n) \f$ | `elements_per_circle` |
 * | angle per element | \f$ \vartheta = 2 \arcsin(\xi/2) \f$ | \f$ 2 \sin(\vartheta/2) \f$ | `angle_per_element`, in degrees |
 * | De Cougny and Shephard | \f$ \delta = s/L \f$ | \f$ 8 \delta / (1 + 4 \delta^2) \f$ | `sagitta_over_length` |
 *
 * The same meshes in the words of each law:
 *
 * | relative error | \f$ L/R \f$ | sagitta over radius | elements per circle | angle per element | sagitta over length |
 * | ------ | ------ | ------- | ---- | ----- | ------- |
 * | 0.1    | 0.7244 | 6.79 %  | 8.5  | 42.5° | 0.0937  |
 * | 0.05   | 0.5222 | 3.47 %  | 11.9 | 30.3° | 0.0664  |
 * | 0.02   | 0.3340 | 1.40 %  | 18.7 | 19.2° | 0.0420  |
 * | 0.01   | 0.2370 | 0.705 % | 26.4 | 13.6° | 0.0297  |
 * | 0.001  | 0.0752 | 0.071 % | 83.5 | 4.3°  | 0.00940 |
 *
 * All laws but one give a ratio, whatever the radius: the mesh of a body twice as large has the same
 * faces. A sagitta that is given as a length gives edges that grow with the square root of the radius.
 *
 * The relative error is the norm of the strains between an edge and its arc (J. Bonet; used for sizes by
 * A. Rassineux, P. Villon, J.-M. Savignat and O. Stab, <em>Surface remeshing by local Hermite diffuse
 * interpolation</em>, 2000); the last law is of H. L. De Cougny and M. S. Shephard, <em>Surface
 * meshing using vertex insertion</em>, 1996.
 *
 * An edge is a chord, so \f$ 0 < \xi \le 2 \f$. Each function takes constant time and throws
 * `std::invalid_argument` for an argument outside of the range that it names.
 */

namespace internal {

// the ranges are closed at the largest value
inline void check_law(const char* name, const double value, const double largest)
{
  if(value > 0. && value <= largest)
    return;
  std::ostringstream accepted;
  accepted << "it must be larger than 0 and at most " << largest;
  refuse(name, value, accepted.str());
}

inline void check_ratio(const double length_over_radius)
{
  check_law("the ratio of length and radius", length_over_radius, 2.);
}

} // namespace internal

/// \ingroup PkgHermiteDiffuseRemeshingSizeLaws
/// returns \f$ L/R \f$ for a relative error, larger than 0.
inline double length_over_radius_of_error(const double relative_error)
{
  internal::check_law("the relative error", relative_error, (std::numeric_limits<double>::max)());
  return internal::length_of_error(relative_error);
}

/// \ingroup PkgHermiteDiffuseRemeshingSizeLaws
/// returns the relative error for \f$ L/R \f$ in (0, 2]; infinity for 2.
inline double error_of_length_over_radius(const double length_over_radius)
{
  internal::check_ratio(length_over_radius);
  return internal::error_of_length(length_over_radius);
}

/// \ingroup PkgHermiteDiffuseRemeshingSizeLaws
/// returns \f$ L/R \f$ for a sagitta divided by the radius, in (0, 1].
inline double length_over_radius_of_sagitta(const double sagitta_over_radius)
{
  internal::check_law("the ratio of sagitta and radius", sagitta_over_radius, 1.);
  return internal::length_of_sagitta(sagitta_over_radius, 1.);
}

/// \ingroup PkgHermiteDiffuseRemeshingSizeLaws
/// returns the sagitta divided by the radius for \f$ L/R \f$ in (0, 2].
inline double sagitta_of_length_over_radius(const double length_over_radius)
{
  internal::check_ratio(length_over_radius);
  // 1 - sqrt(1 - u) without the cancellation for a small u
  const double u = length_over_radius * length_over_radius / 4.;
  return u / (1. + std::sqrt(1. - u));
}

/// \ingroup PkgHermiteDiffuseRemeshingSizeLaws
/// returns \f$ L/R \f$ for a number of edges on the full circle, at least 2; need not be an integer.
inline double length_over_radius_of_elements_per_circle(const double number_of_elements)
{
  if(!(number_of_elements >= 2. && number_of_elements <= (std::numeric_limits<double>::max)()))
    internal::refuse("the number of elements per circle", number_of_elements, "it must be finite and at least 2");
  return 2. * std::sin(boost::math::constants::pi<double>() / number_of_elements);
}

/// \ingroup PkgHermiteDiffuseRemeshingSizeLaws
/// returns the number of edges on the full circle, not rounded, for \f$ L/R \f$ in (0, 2].
inline double elements_per_circle_of_length_over_radius(const double length_over_radius)
{
  internal::check_ratio(length_over_radius);
  return boost::math::constants::pi<double>() / std::asin(length_over_radius / 2.);
}

/// \ingroup PkgHermiteDiffuseRemeshingSizeLaws
/// returns \f$ L/R \f$ for the angle that an edge spans at the centre, in (0, 180] degrees.
inline double length_over_radius_of_angle(const double degrees)
{
  internal::check_law("the angle per element", degrees, 180.);
  return 2. * std::sin(degrees * boost::math::constants::pi<double>() / 360.);
}

/// \ingroup PkgHermiteDiffuseRemeshingSizeLaws
/// returns the angle, in degrees, that an edge spans at the centre for \f$ L/R \f$ in (0, 2].
inline double angle_of_length_over_radius(const double length_over_radius)
{
  internal::check_ratio(length_over_radius);
  return 360. * std::asin(length_over_radius / 2.) / boost::math::constants::pi<double>();
}

/// \ingroup PkgHermiteDiffuseRemeshingSizeLaws
/// returns \f$ L/R \f$ for a sagitta divided by the length of the edge, in (0, 0.5]: the law of De Cougny
/// and Shephard.
inline double length_over_radius_of_sagitta_over_length(const double sagitta_over_length)
{
  internal::check_law("the ratio of sagitta and length", sagitta_over_length, 0.5);
  return 8. * sagitta_over_length / (1. + 4. * sagitta_over_length * sagitta_over_length);
}

/// \ingroup PkgHermiteDiffuseRemeshingSizeLaws
/// returns the sagitta divided by the length of the edge for \f$ L/R \f$ in (0, 2].
inline double sagitta_over_length_of_length_over_radius(const double length_over_radius)
{
  return sagitta_of_length_over_radius(length_over_radius) / length_over_radius;
}

} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_SIZE_LAWS_H
