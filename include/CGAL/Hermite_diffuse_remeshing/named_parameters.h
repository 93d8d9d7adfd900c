// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_REMESHING_NAMED_PARAMETERS_H
#define CGAL_HERMITE_DIFFUSE_REMESHING_NAMED_PARAMETERS_H

#include <CGAL/license/Hermite_diffuse_remeshing.h>

#include <CGAL/Hermite_diffuse_remeshing/internal/compatibility.h>

#include <CGAL/Named_function_parameters.h>

#include <type_traits>

// The parameters that CGAL does not have, and those of CGAL that may follow them in a chain.
// A chain started by one of ours takes both kinds in any order; a chain started by a name of
// CGAL takes names of CGAL only, because `Named_function_parameters` has a closed list.
// tag type, tag, function

// those that only later versions of CGAL have
#define CGAL_HDR_DISTANCE_PARAMETERS(ADD)                                         \
  ADD(maximum_distance_t, maximum_distance, maximum_distance)
#define CGAL_HDR_CURVATURE_PARAMETERS(ADD)                                        \
  ADD(vertex_mean_curvature_map_t, vertex_mean_curvature_map, vertex_mean_curvature_map) \
  ADD(vertex_Gaussian_curvature_map_t, vertex_Gaussian_curvature_map, vertex_Gaussian_curvature_map) \
  ADD(vertex_principal_curvatures_and_directions_map_t, vertex_principal_curvatures_and_directions_map, \
      vertex_principal_curvatures_and_directions_map)                            \
  ADD(vertex_mean_curvature_t, vertex_mean_curvature, vertex_mean_curvature)     \
  ADD(vertex_Gaussian_curvature_t, vertex_Gaussian_curvature, vertex_Gaussian_curvature) \
  ADD(vertex_principal_curvatures_and_directions_t, vertex_principal_curvatures_and_directions, \
      vertex_principal_curvatures_and_directions)

#ifdef CGAL_HDR_HAS_MAXIMUM_DISTANCE
#define CGAL_HDR_OWN_DISTANCE_PARAMETERS(ADD)
#define CGAL_HDR_SHARED_DISTANCE_PARAMETERS(ADD) CGAL_HDR_DISTANCE_PARAMETERS(ADD)
#else
#define CGAL_HDR_OWN_DISTANCE_PARAMETERS(ADD) CGAL_HDR_DISTANCE_PARAMETERS(ADD)
#define CGAL_HDR_SHARED_DISTANCE_PARAMETERS(ADD)
#endif

#ifdef CGAL_HDR_HAS_CURVATURE_PARAMETERS
#define CGAL_HDR_OWN_CURVATURE_PARAMETERS(ADD)
#define CGAL_HDR_SHARED_CURVATURE_PARAMETERS(ADD) CGAL_HDR_CURVATURE_PARAMETERS(ADD)
#else
#define CGAL_HDR_OWN_CURVATURE_PARAMETERS(ADD) CGAL_HDR_CURVATURE_PARAMETERS(ADD)
#define CGAL_HDR_SHARED_CURVATURE_PARAMETERS(ADD)
#endif

#define CGAL_HDR_OWN_PARAMETERS(ADD)                                              \
  ADD(approximation_error_t, approximation_error, approximation_error)           \
  ADD(maximum_deviation_t, maximum_deviation, maximum_deviation)                 \
  ADD(maximum_displacement_t, maximum_displacement, maximum_displacement)        \
  ADD(minimum_edge_length_t, minimum_edge_length, minimum_edge_length)           \
  ADD(maximum_edge_length_t, maximum_edge_length, maximum_edge_length)           \
  ADD(size_field_t, size_field, size_field)                                      \
  ADD(gradation_t, gradation, gradation)                                         \
  ADD(sharp_dihedral_angle_t, sharp_dihedral_angle, sharp_dihedral_angle)        \
  ADD(corner_angle_t, corner_angle, corner_angle)                                \
  ADD(apex_angular_defect_t, apex_angular_defect, apex_angular_defect)           \
  ADD(polynomial_degree_t, polynomial_degree, polynomial_degree)                 \
  ADD(hermite_weight_t, hermite_weight, hermite_weight)                          \
  ADD(normal_estimation_t, normal_estimation, normal_estimation)                 \
  ADD(vertex_location_map_t, vertex_location_map, vertex_location_map)           \
  ADD(face_origin_map_t, face_origin_map, face_origin_map)                       \
  ADD(vertex_size_map_t, vertex_size_map, vertex_size_map)                       \
  ADD(face_deviation_map_t, face_deviation_map, face_deviation_map)              \
  ADD(surface_model_t, surface_model, surface_model)                             \
  ADD(sagitta_t, sagitta, sagitta)                                               \
  ADD(elements_per_circle_t, elements_per_circle, elements_per_circle)           \
  ADD(angle_per_element_t, angle_per_element, angle_per_element)                 \
  ADD(sagitta_over_length_t, sagitta_over_length, sagitta_over_length)           \
  ADD(edge_policy_map_t, edge_policy_map, edge_policy_map)                       \
  ADD(edge_class_map_t, edge_class_map, edge_class_map)                          \
  CGAL_HDR_OWN_DISTANCE_PARAMETERS(ADD)                                          \
  CGAL_HDR_OWN_CURVATURE_PARAMETERS(ADD)

#define CGAL_HDR_SHARED_PARAMETERS(ADD)                                           \
  ADD(geom_traits_t, geom_traits, geom_traits)                                   \
  ADD(vertex_point_t, vertex_point, vertex_point_map)                            \
  ADD(vertex_normal_map_t, vertex_normal_map, vertex_normal_map)                 \
  ADD(edge_is_constrained_t, edge_is_constrained, edge_is_constrained_map)       \
  ADD(vertex_is_constrained_t, vertex_is_constrained, vertex_is_constrained_map) \
  ADD(protect_constraints_t, protect_constraints, protect_constraints)           \
  ADD(face_patch_t, face_patch, face_patch_map)                                  \
  ADD(do_self_intersection_tests_t, do_self_intersection_tests, do_self_intersection_tests) \
  ADD(maximum_number_of_faces_t, maximum_number_of_faces, maximum_number_of_faces) \
  ADD(maximum_running_time_t, maximum_running_time, maximum_running_time)          \
  ADD(number_of_iterations_t, number_of_iterations, number_of_iterations)        \
  ADD(visitor_t, visitor, visitor)                                               \
  CGAL_HDR_SHARED_DISTANCE_PARAMETERS(ADD)                                       \
  CGAL_HDR_SHARED_CURVATURE_PARAMETERS(ADD)

namespace CGAL {
namespace internal_np {

#define CGAL_HDR_TAG(TYPE, TAG, NAME) enum TYPE { TAG };
CGAL_HDR_OWN_PARAMETERS(CGAL_HDR_TAG)
#undef CGAL_HDR_TAG

} // namespace internal_np

namespace Hermite_diffuse_remeshing {
namespace internal {

template <typename T, typename Tag, typename Base = internal_np::No_property>
struct Parameter_chain
  : public Named_function_parameters<T, Tag, Base>
{
  typedef Named_function_parameters<T, Tag, Base> Pack;

  explicit Parameter_chain(const T& value) : Pack(value) {}
  Parameter_chain(const T& value, const Base& base) : Pack(value, base) {}

#define CGAL_HDR_LINK(TYPE, TAG, NAME)                                  \
  template <typename K>                                                 \
  Parameter_chain<K, internal_np::TYPE, Pack> NAME(const K& k) const    \
  { return Parameter_chain<K, internal_np::TYPE, Pack>(k, *this); }
  CGAL_HDR_OWN_PARAMETERS(CGAL_HDR_LINK)
  CGAL_HDR_SHARED_PARAMETERS(CGAL_HDR_LINK)
#undef CGAL_HDR_LINK
};

template <typename T>
struct is_named_parameters : std::false_type {};
template <typename T, typename Tag, typename Base>
struct is_named_parameters<Named_function_parameters<T, Tag, Base> > : std::true_type {};
template <typename T, typename Tag, typename Base>
struct is_named_parameters<Parameter_chain<T, Tag, Base> > : std::true_type {};

// The pack of CGAL behind either kind of argument: a chain has two bases that
// are packs, its own and the nested one.
template <typename T, typename Tag, typename Base>
const Named_function_parameters<T, Tag, Base>&
pack(const Named_function_parameters<T, Tag, Base>& np)
{
  return np;
}

template <typename T, typename Tag, typename Base>
const Named_function_parameters<T, Tag, Base>&
pack(const Parameter_chain<T, Tag, Base>& np)
{
  return np;
}

} // namespace internal
} // namespace Hermite_diffuse_remeshing

namespace parameters {

#define CGAL_HDR_START(TYPE, TAG, NAME)                                             \
  template <typename K>                                                             \
  Hermite_diffuse_remeshing::internal::Parameter_chain<K, internal_np::TYPE>        \
  NAME(const K& k)                                                                  \
  { return Hermite_diffuse_remeshing::internal::Parameter_chain<K, internal_np::TYPE>(k); }
CGAL_HDR_OWN_PARAMETERS(CGAL_HDR_START)
#undef CGAL_HDR_START

} // namespace parameters
} // namespace CGAL

#undef CGAL_HDR_OWN_PARAMETERS
#undef CGAL_HDR_SHARED_PARAMETERS
#undef CGAL_HDR_OWN_DISTANCE_PARAMETERS
#undef CGAL_HDR_SHARED_DISTANCE_PARAMETERS
#undef CGAL_HDR_DISTANCE_PARAMETERS
#undef CGAL_HDR_OWN_CURVATURE_PARAMETERS
#undef CGAL_HDR_SHARED_CURVATURE_PARAMETERS
#undef CGAL_HDR_CURVATURE_PARAMETERS

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_NAMED_PARAMETERS_H
