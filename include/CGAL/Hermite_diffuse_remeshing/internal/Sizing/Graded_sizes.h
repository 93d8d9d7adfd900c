// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_SIZING_GRADED_SIZES_H
#define CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_SIZING_GRADED_SIZES_H

#include <CGAL/Hermite_diffuse_remeshing/internal/Progress.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Sizing/Bisection_tree.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Sizing/Frozen_lengths.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Sizing/Size_samples.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Sizing/limit_gradation.h>

#include <boost/range/irange.hpp>

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace CGAL {
namespace Hermite_diffuse_remeshing {
namespace internal {

// The sizes at the samples of the size map, limited in slope. When sizes have been lowered and cells bisected, only
// what follows from that is passed on.
class Graded_sizes
{
  std::vector<double> m_sizes;
  std::vector<double> m_last_sizes;       // when changes were looked for; empty if all may have changed since
  std::vector<int> m_noted;

public:
  int number_of_samples() const { return static_cast<int>(m_sizes.size()); }
  double operator[](const int sample) const { return m_sizes[sample]; }

  const std::vector<double>& values() const { return m_sizes; }
  // of all samples
  void set(std::vector<double> values)
  {
    m_sizes = std::move(values);
    m_last_sizes.clear();
  }

  // Of the samples: has its size or its cells changed since the last call, or the size in the middle of one of its
  // sides?
  std::vector<char> find_changes(const Size_samples& samples)
  {
    std::vector<char> result(samples.size(), m_last_sizes.empty());
    for(int i = 0; i < number_of_samples(); ++i)
      if(i >= static_cast<int>(m_last_sizes.size()) || m_sizes[i] != m_last_sizes[i])
        result[i] = result[samples.ends(i)[0]] = result[samples.ends(i)[1]] = true;
    m_last_sizes = m_sizes;
    return result;
  }

  // A sample has been added or lowered, or has got new neighbours.
  void note(const int sample) { m_noted.push_back(sample); }
  bool is_up_to_date() const { return m_noted.empty(); }

  void grade(const Bisection_tree& cells, const Size_samples& samples, const Frozen_lengths& frozen,
             const double scale, const double gradation, const Progress& progress)
  {
    m_sizes.clear();
    add_sizes(samples, scale);
    frozen.lower(m_sizes);
    mark_noted();
    m_noted.clear();
    if(gradation == 1.)
      std::fill(m_sizes.begin(), m_sizes.end(), *std::min_element(m_sizes.begin(), m_sizes.end()));
    else
      limit_slopes(cells, samples, frozen, gradation, boost::irange(0, samples.size()), progress);
  }

  // Without a new scale: what is not noted stays, or falls.
  void grade_again(const Bisection_tree& cells, const Size_samples& samples, const Frozen_lengths& frozen,
                   const double scale, const double gradation, const Progress& progress)
  {
    // with one size for all, or where the lengths of frozen edges raise others, a lower one may change any
    if(m_sizes.empty() || gradation == 1. || !frozen.is_empty())
    {
      grade(cells, samples, frozen, scale, gradation, progress);
      return;
    }
    add_sizes(samples, scale);
    std::sort(m_noted.begin(), m_noted.end());
    m_noted.erase(std::unique(m_noted.begin(), m_noted.end()), m_noted.end());
    mark_noted();
    for(const int i : m_noted)
      m_sizes[i] = (std::min)(m_sizes[i], samples.asked_size(i, scale));
    if(!m_noted.empty())
      limit_slopes(cells, samples, frozen, gradation, m_noted, progress);
    m_noted.clear();
  }

private:
  // They may be in other cells, and have changed in any case.
  void mark_noted()
  {
    for(const int i : m_noted)
      if(i < static_cast<int>(m_last_sizes.size()))
        m_last_sizes[i] = -1.;
  }

  void add_sizes(const Size_samples& samples, const double scale)
  {
    for(int i = number_of_samples(); i < samples.size(); ++i)
      m_sizes.push_back(samples.asked_size(i, scale));
  }

  template <typename IndexRange>
  void limit_slopes(const Bisection_tree& cells, const Size_samples& samples, const Frozen_lengths& frozen,
                    const double gradation, const IndexRange& seeds, const Progress& progress)
  {
    progress(0.);
    const std::vector<std::array<int, 3> > leaves = cells.samples_of_leaves();
    const auto position = [&](const int i) -> const Vector& { return samples.position(i); };
    limit_gradation(leaves, position, slope_of_gradation(gradation), seeds, m_sizes, progress);
    if(!frozen.is_empty())
      frozen.raise(leaves, position, m_sizes, progress);
  }
};

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_SIZING_GRADED_SIZES_H
