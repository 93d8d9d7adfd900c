// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_SELECTED_ELEMENTS_H
#define CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_SELECTED_ELEMENTS_H

#include <CGAL/Hermite_diffuse_remeshing/internal/Progress.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/for_each_index.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Hermite_diffuse_remeshing {
namespace internal {

// The elements that `is_selected` takes, in their order. Threads ask at the same time.
template <typename Element, typename IsSelected>
std::vector<Element> selected_elements(const std::vector<Element>& elements, const bool is_parallel,
                                       const IsSelected& is_selected, const Progress& progress)
{
  std::vector<char> is_taken(elements.size());        // no vector of bits, which threads share
  for_each_index(static_cast<int>(elements.size()), is_parallel, [&]
  {
    return [&](const int i) { is_taken[i] = is_selected(elements[i]); };
  }, progress);
  std::vector<Element> result;
  for(std::size_t i = 0; i < elements.size(); ++i)
    if(is_taken[i])
      result.push_back(elements[i]);
  return result;
}

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_SELECTED_ELEMENTS_H
