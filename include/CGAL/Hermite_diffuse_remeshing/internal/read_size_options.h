// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_READ_SIZE_OPTIONS_H
#define CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_READ_SIZE_OPTIONS_H

#include <CGAL/Hermite_diffuse_remeshing/Size_laws.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Sizing/Size_sources.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/validate_input.h>
#include <CGAL/Hermite_diffuse_remeshing/named_parameters.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <limits>
#include <sstream>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Hermite_diffuse_remeshing {
namespace internal {

template <typename Pack, typename Tag>
constexpr bool is_given() { return !parameters::is_default_parameter<Pack, Tag>::value; }

// The law that the user names, or the smallest size of several; the relative error of 0.01 if he names
// none.
template <typename Pack>
void read_size_law(const Pack& pack, Size_options& options)
{
  using parameters::get_parameter;
  const auto add = [&options](const double length_over_radius)
  {
    options.length_over_radius = (std::min)(options.length_over_radius, length_over_radius);
  };
  constexpr bool is_other_law_given = is_given<Pack, internal_np::elements_per_circle_t>()
                                   || is_given<Pack, internal_np::angle_per_element_t>()
                                   || is_given<Pack, internal_np::sagitta_over_length_t>()
                                   || is_given<Pack, internal_np::sagitta_t>();
  if constexpr(is_given<Pack, internal_np::elements_per_circle_t>())
  {
    const double number = get_parameter(pack, internal_np::elements_per_circle);
    check_parameter("elements_per_circle", number, 2., (std::numeric_limits<double>::max)());
    add(length_over_radius_of_elements_per_circle(number));
  }
  if constexpr(is_given<Pack, internal_np::angle_per_element_t>())
  {
    const double degrees = get_parameter(pack, internal_np::angle_per_element);
    check_positive_parameter("angle_per_element", degrees);
    check_parameter("angle_per_element", degrees, 0., 180.);
    add(length_over_radius_of_angle(degrees));
  }
  if constexpr(is_given<Pack, internal_np::sagitta_over_length_t>())
  {
    const double ratio = get_parameter(pack, internal_np::sagitta_over_length);
    check_positive_parameter("sagitta_over_length", ratio);
    check_parameter("sagitta_over_length", ratio, 0., 0.5);
    add(length_over_radius_of_sagitta_over_length(ratio));
  }
  if constexpr(is_given<Pack, internal_np::sagitta_t>())
  {
    options.sagitta = get_parameter(pack, internal_np::sagitta);
    check_positive_parameter("sagitta", options.sagitta);
  }
  if constexpr(is_given<Pack, internal_np::approximation_error_t>() || !is_other_law_given)
  {
    constexpr double default_error = 0.01;
    const double error = parameters::choose_parameter(get_parameter(pack, internal_np::approximation_error),
                                                      default_error);
    check_parameter("approximation_error", error, 0., (std::numeric_limits<double>::max)());
    if(error > 0.)
      add(length_of_error(error));
  }
}

inline double checked_user_size(double size, const Vector& p)
{
  if(!(size > 0.))
  {
    std::ostringstream place;
    place << "the value of size_field at (" << p[0] << ", " << p[1] << ", " << p[2] << ")";
    refuse(place.str(), size, "a size must be larger than zero");
  }
  return size;
}

// After the repairs: `face_descriptors[i]` is face i of the reference; they are asked as long as the options are used.
template <typename FaceDescriptor, typename GeomTraits, typename Pack>
void read_size_field(const Pack& pack, const GeomTraits& traits, const std::vector<FaceDescriptor>& face_descriptors,
                     Size_options& options)
{
  if constexpr(is_given<Pack, internal_np::size_field_t>())
  {
    typedef typename GeomTraits::FT FT;
    const auto field = parameters::get_parameter(pack, internal_np::size_field);
    constexpr bool is_local = std::is_invocable<decltype(field), const typename GeomTraits::Point_3&,
                                                FaceDescriptor, const std::array<FT, 3>&>::value;
    const auto point = [construct_point = traits.construct_point_3_object()](const Vector& p)
    {
      return construct_point(FT(p[0]), FT(p[1]), FT(p[2]));
    };
    options.is_user_size_local = is_local;
    if constexpr(is_local)
      options.user_size = [field, point, &face_descriptors](const Vector& p, const Location& location)
      {
        std::array<FT, 3> coordinates;
        std::copy(location.coordinates.begin(), location.coordinates.end(), coordinates.begin());
        return checked_user_size(CGAL::to_double(field(point(p), face_descriptors[location.face], coordinates)), p);
      };
    else
      options.user_size = [field, point](const Vector& p, const Location&)
      {
        return checked_user_size(CGAL::to_double(field(point(p))), p);
      };
  }
  CGAL_USE(pack);
  CGAL_USE(traits);
  CGAL_USE(face_descriptors);
  CGAL_USE(options);
}

// Shorter edges than this would be made of the rounding of the coordinates.
template <typename FT>
double shortest_length(const Indexed_triangles& triangles)
{
  constexpr double units_in_last_place = 64.;
  double largest = 0.;
  for(const std::array<int, 3>& t : triangles.triangles)
    for(const int v : t)
      largest = (std::max)(largest, triangles.points[v].cwiseAbs().maxCoeff());
  return units_in_last_place * double(std::numeric_limits<FT>::epsilon()) * largest;
}

// all but the field
template <typename GeomTraits, typename Pack>
Size_options read_size_options(const Pack& pack, const Indexed_triangles& triangles)
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  constexpr double infinity = std::numeric_limits<double>::infinity();
  constexpr double smallest_part = 1e-4, largest_part = 0.1, largest_part_of_curve_radius = 0.2;
  // sizes beyond the diameter are all the same, and infinite ones cannot be interpolated
  constexpr double largest_useful_multiple = 10.;
  const double diameter = checked_diameter(triangles);
  const double shortest = shortest_length<typename GeomTraits::FT>(triangles);
  Size_options options;
  read_size_law(pack, options);
  options.maximum_deviation = choose_parameter(get_parameter(pack, internal_np::maximum_deviation), infinity);
  check_positive_parameter("maximum_deviation", options.maximum_deviation);
  options.largest_curve_radius = largest_part_of_curve_radius * diameter;
  options.gradation = choose_parameter(get_parameter(pack, internal_np::gradation), 1.3);
  check_parameter("gradation", options.gradation, 1., 2.);
  options.minimum_length = choose_parameter(get_parameter(pack, internal_np::minimum_edge_length), 0.);
  check_parameter("minimum_edge_length", options.minimum_length, 0., (std::numeric_limits<double>::max)());
  options.maximum_length = choose_parameter(get_parameter(pack, internal_np::maximum_edge_length), 0.);
  check_parameter("maximum_edge_length", options.maximum_length, 0., infinity);
  const bool is_maximum_given = options.maximum_length > 0.;
  if(is_maximum_given)
    check_parameter("maximum_edge_length", options.maximum_length, shortest, infinity);
  if(options.minimum_length == 0.)
    options.minimum_length = is_maximum_given ? (std::min)(smallest_part * diameter, options.maximum_length)
                                              : smallest_part * diameter;
  if(!is_maximum_given)
    options.maximum_length = (std::max)(largest_part * diameter, options.minimum_length);
  if(options.minimum_length > options.maximum_length)
    refuse("minimum_edge_length", options.minimum_length, "it must not be larger than maximum_edge_length");
  for(double* const length : {&options.minimum_length, &options.maximum_length})
    *length = (std::min)((std::max)(*length, shortest), largest_useful_multiple * diameter);
  return options;
}

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_READ_SIZE_OPTIONS_H
