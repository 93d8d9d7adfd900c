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
#include <cstddef>
#include <numeric>
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
  // of each sample the side from which its size has been passed on across a cell; empty if that is not followed
  std::vector<Sample_pair> m_origins;
  std::vector<std::array<int, 3> > m_bisected;          // the samples of cells that are none any more

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

  // the middle of one of the sides is noted, too
  void note_bisected(const std::array<int, 3>& samples)
  {
    m_noted.insert(m_noted.end(), samples.begin(), samples.end());
    if(!m_origins.empty())
      m_bisected.push_back(samples);
  }

  // all anew
  void grade(const Bisection_tree& cells, const Size_samples& samples, const Frozen_lengths& frozen,
             const double scale, const double gradation, const Progress& progress)
  {
    m_sizes.clear();
    m_origins.clear();
    add_sizes(samples, scale);
    frozen.lower(m_sizes);
    mark_noted();
    m_noted.clear();
    m_bisected.clear();
    if(gradation == 1.)
      std::fill(m_sizes.begin(), m_sizes.end(), *std::min_element(m_sizes.begin(), m_sizes.end()));
    else
      limit_slopes(cells, samples, frozen, gradation, boost::irange(0, samples.size()), progress);
  }

  // Same, where little has changed since the last time: sizes that have come across cells that are bisected now, and what
  // these have passed on, begin anew, and rise. The others are what all anew would make of them, but for a few in obtuse
  // slivers, see `bound_from_segment()`: a size may stay lower by some percent that another has fallen below since.
  void grade_bisected(const Bisection_tree& cells, const Size_samples& samples, const Frozen_lengths& frozen,
                      const double scale, const double gradation, const Progress& progress)
  {
    // with one size for all, or where the lengths of frozen edges raise others, a lower one may change any
    if(gradation == 1. || !frozen.is_empty())
    {
      grade(cells, samples, frozen, scale, gradation, progress);
      return;
    }
    if(m_origins.empty())
    {
      m_sizes.clear();
      m_noted.resize(samples.size());
      std::iota(m_noted.begin(), m_noted.end(), 0);
    }
    const std::vector<int> lost = find_lost();
    for(const int i : lost)
      m_sizes[i] = samples.asked_size(i, scale);
    m_origins.resize(samples.size(), no_origin());
    m_noted.insert(m_noted.end(), lost.begin(), lost.end());
    std::vector<char> is_lost(samples.size(), false);
    for(const int i : lost)
      is_lost[i] = true;
    for(int c = 0; c < cells.number_of_cells() && !lost.empty(); ++c)
    {
      const std::array<int, 3>& s = cells[c].samples;
      if(cells.is_leaf(c) && (is_lost[s[0]] || is_lost[s[1]] || is_lost[s[2]]))
        m_noted.insert(m_noted.end(), s.begin(), s.end());
    }
    lower_noted(cells, samples, frozen, scale, gradation, progress);
  }

  // Without a new scale: what is not noted stays, or falls, whatever is bisected.
  void grade_again(const Bisection_tree& cells, const Size_samples& samples, const Frozen_lengths& frozen,
                   const double scale, const double gradation, const Progress& progress)
  {
    forget_origins();
    if(m_sizes.empty() || gradation == 1. || !frozen.is_empty())
      grade(cells, samples, frozen, scale, gradation, progress);
    else
      lower_noted(cells, samples, frozen, scale, gradation, progress);
  }

  // takes no memory for `grade_bisected()` any more, which begins with all anew the next time
  void forget_origins()
  {
    m_origins = std::vector<Sample_pair>();
    m_bisected.clear();
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

  static Sample_pair no_origin() { return Sample_pair(-1, -1); }

  // The samples that lose what has been passed on to them: across cells that are none any more, or from others that lose
  // theirs.
  std::vector<int> find_lost()
  {
    std::vector<int> result;
    const auto lose = [&](const int i)
    {
      m_origins[i] = no_origin();
      result.push_back(i);
    };
    for(const std::array<int, 3>& s : m_bisected)
      for(int k = 0; k < 3; ++k)
        if(m_origins[s[k]] == ordered(s[next(k)], s[previous(k)]))
          lose(s[k]);
    m_bisected.clear();
    if(result.empty())
      return result;
    // packed: for each sample those that have their sizes from it
    std::vector<int> first(m_origins.size() + 1, 0);
    const auto visit_origins = [&](const auto& visit)
    {
      for(std::size_t i = 0; i < m_origins.size(); ++i)
        if(m_origins[i] != no_origin())
        {
          visit(m_origins[i].first, static_cast<int>(i));
          visit(m_origins[i].second, static_cast<int>(i));
        }
    };
    visit_origins([&](const int origin, int) { ++first[origin + 1]; });
    std::partial_sum(first.begin(), first.end(), first.begin());
    std::vector<int> dependent(first.back()), next_free(first.begin(), first.end() - 1);
    visit_origins([&](const int origin, const int i) { dependent[next_free[origin]++] = i; });
    for(std::size_t at = 0; at < result.size(); ++at)
      for(int n = first[result[at]]; n < first[result[at] + 1]; ++n)
        if(m_origins[dependent[n]] != no_origin())
          lose(dependent[n]);
    return result;
  }

  // what is noted falls to what has been asked for, and is passed on
  void lower_noted(const Bisection_tree& cells, const Size_samples& samples, const Frozen_lengths& frozen,
                   const double scale, const double gradation, const Progress& progress)
  {
    add_sizes(samples, scale);
    std::sort(m_noted.begin(), m_noted.end());
    m_noted.erase(std::unique(m_noted.begin(), m_noted.end()), m_noted.end());
    mark_noted();
    for(const int i : m_noted)
      lower(i, samples.asked_size(i, scale));
    if(!m_noted.empty())
      limit_slopes(cells, samples, frozen, gradation, m_noted, progress);
    m_noted.clear();
  }

  void lower(const int i, const double size)
  {
    if(!(size < m_sizes[i]))
      return;
    m_sizes[i] = size;
    if(!m_origins.empty())
      m_origins[i] = no_origin();
  }

  template <typename IndexRange>
  void limit_slopes(const Bisection_tree& cells, const Size_samples& samples, const Frozen_lengths& frozen,
                    const double gradation, const IndexRange& seeds, const Progress& progress)
  {
    progress(0.);
    const std::vector<std::array<int, 3> > leaves = cells.samples_of_leaves();
    const auto position = [&](const int i) -> const Vector& { return samples.position(i); };
    limit_gradation(leaves, position, slope_of_gradation(gradation), seeds, m_sizes, progress,
                    [&](const int sample, const int i, const int j)
    {
      if(!m_origins.empty())
        m_origins[sample] = ordered(i, j);
    });
    if(!frozen.is_empty())
      frozen.raise(leaves, position, m_sizes, progress);
  }
};

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_SIZING_GRADED_SIZES_H
