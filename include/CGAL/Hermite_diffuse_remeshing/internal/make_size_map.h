// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_MAKE_SIZE_MAP_H
#define CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_MAKE_SIZE_MAP_H

#include <CGAL/Hermite_diffuse_remeshing/internal/Model/Input_model.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Sizing/limit_number_of_faces.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/validate_input.h>
#include <CGAL/Hermite_diffuse_remeshing/named_parameters.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <memory>
#include <vector>

namespace CGAL {
namespace Hermite_diffuse_remeshing {
namespace internal {

// The user's budget of faces, or the cap that keeps an absurdly small size from eating the memory.
template <typename Pack>
std::size_t read_face_budget(const Pack& pack, const std::size_t number_of_input_faces)
{
  constexpr std::size_t default_number = 1000000, default_multiple = 10;
  const auto number =
    parameters::choose_parameter(parameters::get_parameter(pack, internal_np::maximum_number_of_faces), std::size_t(0));
  check_parameter("maximum_number_of_faces", double(number), 0., (std::numeric_limits<double>::max)());
  // the user's number may be of any type
  constexpr std::size_t largest = (std::numeric_limits<std::size_t>::max)();
  const std::size_t budget = double(number) < double(largest) ? static_cast<std::size_t>(number) : largest;
  return budget > 0 ? budget : (std::max)(default_number, default_multiple * number_of_input_faces);
}

// The edges that cannot be changed: those that the user protects, and between what is remeshed and the rest.
template <typename IsSelected>
std::vector<char> find_frozen_edges(const Edge_table& edges, const Side_marks& marks, const IsSelected& is_selected)
{
  std::vector<char> result(edges.number_of_edges(), false);
  for(int e = 0; e < edges.number_of_edges(); ++e)
    for(int i = 0; i < edges.number_of_sides(e); ++i)
    {
      const Face_side& side = edges.side(e, i);
      if(marks[side.face][side.side] == MARKED_PROTECTED || is_selected(side.face) != is_selected(edges.side(e, 0).face))
        result[e] = true;
    }
  return result;
}

// The sizes, scaled so that the faces that `is_selected(face)` takes meet the budget.
template <typename IsSelected>
std::unique_ptr<Size_map> make_size_map(const Input_model& model, const Size_options& options, const Side_marks& marks,
                                        const std::size_t maximum_number_of_faces, const IsSelected& is_selected,
                                        const Progress& progress = Progress())
{
  // cells and probes much closer than the faces that may come of them would be for nothing
  constexpr double least_number_of_cells = 50000., cells_per_face = 4., probes_per_cell = 10.;
  // the rest is for the places where the sizes do not fit the shape
  constexpr double used_part = 0.9;
  const double useful_cells = least_number_of_cells + cells_per_face * double(maximum_number_of_faces);
  Size_options bounded = options;
  bounded.maximum_number_of_cells = model.surface.triangles().number_of_faces()
    + static_cast<int>((std::min)(double(options.maximum_number_of_cells), useful_cells));
  bounded.maximum_number_of_probes = (std::min)(options.maximum_number_of_probes, probes_per_cell * useful_cells);
  std::unique_ptr<Size_map> sizes(new Size_map(model.surface, model.edges, model.curves, bounded,
                                               find_frozen_edges(model.edges, marks, is_selected), progress));
  limit_number_of_faces(*sizes, used_part * double(maximum_number_of_faces), is_selected, progress.part(0., 0.));
  return sizes;
}

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_MAKE_SIZE_MAP_H
