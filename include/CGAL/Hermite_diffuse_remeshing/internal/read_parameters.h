// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_READ_PARAMETERS_H
#define CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_READ_PARAMETERS_H

#include <CGAL/Hermite_diffuse_remeshing/internal/Model/Input_model.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/validate_input.h>
#include <CGAL/Hermite_diffuse_remeshing/named_parameters.h>

#include <boost/math/constants/constants.hpp>

#include <limits>

namespace CGAL {
namespace Hermite_diffuse_remeshing {
namespace internal {

// What the functions of the package read in the same way from their named parameters; all values are
// checked here, before anything is built or modified.

template <typename Pack>
Feature_options read_feature_options(const Pack& pack)
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  constexpr double degree = boost::math::constants::pi<double>() / 180.;
  const auto read_angle = [](const char* name, const double angle)
  {
    check_parameter(name, angle, 0., 180.);
    return angle < 180. ? angle * degree : std::numeric_limits<double>::infinity();
  };
  Feature_options options;
  options.sharp_angle = read_angle("sharp_dihedral_angle",
    choose_parameter(get_parameter(pack, internal_np::sharp_dihedral_angle), 40.));
  options.corner_angle = read_angle("corner_angle",
    choose_parameter(get_parameter(pack, internal_np::corner_angle), 60.));
  options.apex_defect = read_angle("apex_angular_defect",
    choose_parameter(get_parameter(pack, internal_np::apex_angular_defect), 30.));
  return options;
}

template <typename Pack>
Model_options read_model_options(const Pack& pack)
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  const Surface_model surface_model = choose_parameter(get_parameter(pack, internal_np::surface_model), CONTINUOUS_MODEL);
  check_parameter("surface_model", surface_model, CONTINUOUS_MODEL, PAPER_MODEL);
  const bool is_of_paper = surface_model == PAPER_MODEL;
  Model_options options;
  options.is_solved_at_centroids = is_of_paper;
  options.degree = choose_parameter(get_parameter(pack, internal_np::polynomial_degree), is_of_paper ? 2 : 3);
  check_parameter("polynomial_degree", options.degree, 2, is_of_paper ? 2 : 4);
  options.hermite_weight = choose_parameter(get_parameter(pack, internal_np::hermite_weight), is_of_paper ? 0.5 : 0.3);
  // with slopes only the position is not determined, with positions only the slopes do not count
  check_parameter("hermite_weight", options.hermite_weight, 0.001, 0.999);
  options.normals = choose_parameter(get_parameter(pack, internal_np::normal_estimation),
                                     is_of_paper ? AREA_NORMALS : FITTED_NORMALS);
  check_parameter("normal_estimation", options.normals, FITTED_NORMALS, AREA_NORMALS);
  if(is_of_paper || options.normals == SMOOTH_NORMALS)
    options.exponent = 1;                // the paper's; also averages the noise of the positions
  options.maximum_displacement = choose_parameter(get_parameter(pack, internal_np::maximum_displacement),
                                                  options.maximum_displacement);
  check_parameter("maximum_displacement", options.maximum_displacement, 0., std::numeric_limits<double>::infinity());
  return options;
}

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_READ_PARAMETERS_H
