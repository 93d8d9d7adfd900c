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
#include <CGAL/Hermite_diffuse_remeshing/internal/Sizing/Size_origins.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Sizing/Size_samples.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Sizing/limit_gradation.h>

#include <boost/range/irange.hpp>

#include <algorithm>
#include <array>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Hermite_diffuse_remeshing {
namespace internal {

// What sizes are graded on, and how
struct Grading
{
  const Bisection_tree& cells;
  const Size_samples& samples;
  const Frozen_lengths& frozen;
  double scale;                           // of the own sizes of the samples
  double gradation;
  Progress progress;

  double asked_size(const int sample) const { return samples.asked_size(sample, scale); }

  // With one size for all, or where the lengths of frozen edges raise others, a lower one may change any.
  bool is_local() const { return gradation > 1. && frozen.is_empty(); }
};

// The sizes at the samples of the size map, limited in slope. When sizes have been lowered and cells bisected, only
// what follows from that is passed on.
class Graded_sizes
{
  std::vector<double> m_sizes;
  std::vector<double> m_last_sizes;       // when changes were looked for; empty if all may have changed since
  std::vector<int> m_noted;
  Size_origins m_origins;

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
    m_origins.note_bisected(samples);
  }

  // all anew
  void grade(const Grading& grading)
  {
    m_origins.forget();
    m_sizes.clear();
    add_sizes(grading);
    grading.frozen.lower(m_sizes);
    mark_noted();
    m_noted.clear();
    if(grading.gradation == 1.)
      std::fill(m_sizes.begin(), m_sizes.end(), *std::min_element(m_sizes.begin(), m_sizes.end()));
    else
      limit_slopes(grading, boost::irange(0, grading.samples.size()));
  }

  // Same, where little has changed since the last time: sizes that have come across cells that are bisected now, and what
  // these have passed on, begin anew, and rise. The others are what all anew would make of them.
  void grade_bisected(const Grading& grading)
  {
    if(!grading.is_local())
    {
      grade(grading);
      return;
    }
    if(!m_origins.is_followed())
    {
      m_sizes.clear();
      m_noted.resize(grading.samples.size());
      std::iota(m_noted.begin(), m_noted.end(), 0);
    }
    const std::vector<int> lost = m_origins.take_lost();
    m_origins.follow(grading.samples.size());
    for(const int i : lost)
      m_sizes[i] = grading.asked_size(i);
    note_around(lost, grading);
    lower_noted(grading);
  }

  // Without a new scale: what is not noted stays, or falls, whatever is bisected.
  void grade_again(const Grading& grading)
  {
    forget_origins();
    if(m_sizes.empty() || !grading.is_local())
      grade(grading);
    else
      lower_noted(grading);
  }

  // takes no memory for `grade_bisected()` any more, which begins with all anew the next time
  void forget_origins() { m_origins.forget(); }

private:
  // They may be in other cells, and have changed in any case.
  void mark_noted()
  {
    for(const int i : m_noted)
      if(i < static_cast<int>(m_last_sizes.size()))
        m_last_sizes[i] = -1.;
  }

  void add_sizes(const Grading& grading)
  {
    for(int i = number_of_samples(); i < grading.samples.size(); ++i)
      m_sizes.push_back(grading.asked_size(i));
  }

  // the samples, and those with which they share a cell
  void note_around(const std::vector<int>& samples, const Grading& grading)
  {
    if(samples.empty())
      return;
    std::vector<char> is_among(grading.samples.size(), false);
    for(const int i : samples)
      is_among[i] = true;
    m_noted.insert(m_noted.end(), samples.begin(), samples.end());
    for(int c = 0; c < grading.cells.number_of_cells(); ++c)
    {
      const std::array<int, 3>& s = grading.cells[c].samples;
      if(grading.cells.is_leaf(c) && (is_among[s[0]] || is_among[s[1]] || is_among[s[2]]))
        m_noted.insert(m_noted.end(), s.begin(), s.end());
    }
  }

  // what is noted falls to what has been asked for, and is passed on
  void lower_noted(const Grading& grading)
  {
    add_sizes(grading);
    std::sort(m_noted.begin(), m_noted.end());
    m_noted.erase(std::unique(m_noted.begin(), m_noted.end()), m_noted.end());
    mark_noted();
    for(const int i : m_noted)
      lower(i, grading.asked_size(i));
    if(!m_noted.empty())
      limit_slopes(grading, m_noted);
    m_noted.clear();
  }

  void lower(const int i, const double size)
  {
    if(!(size < m_sizes[i]))
      return;
    m_sizes[i] = size;
    m_origins.reset(i);
  }

  template <typename IndexRange>
  void limit_slopes(const Grading& grading, const IndexRange& seeds)
  {
    grading.progress(0.);
    const std::vector<std::array<int, 3> > leaves = grading.cells.samples_of_leaves();
    const auto position = [&](const int i) -> const Vector& { return grading.samples.position(i); };
    limit_gradation(leaves, position, slope_of_gradation(grading.gradation), seeds, m_sizes, grading.progress,
                    [&](const int sample, const int i, const int j) { m_origins.set(sample, i, j); });
    if(!grading.frozen.is_empty())
      grading.frozen.raise(leaves, position, m_sizes, grading.progress);
  }
};

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_SIZING_GRADED_SIZES_H
