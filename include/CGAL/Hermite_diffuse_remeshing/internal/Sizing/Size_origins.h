// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_SIZING_SIZE_ORIGINS_H
#define CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_SIZING_SIZE_ORIGINS_H

#include <CGAL/Hermite_diffuse_remeshing/internal/Indexed_triangles.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Sizing/Sample_pair.h>

#include <array>
#include <cstddef>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Hermite_diffuse_remeshing {
namespace internal {

// Of each sample of the size map the side from which its size has been passed on across a cell, so that it can be told
// which sizes hold no more when cells have been bisected.
class Size_origins
{
  std::vector<Sample_pair> m_origins;                   // empty if they are not followed
  std::vector<std::array<int, 3> > m_bisected;          // the samples of cells that are none any more

public:
  bool is_followed() const { return !m_origins.empty(); }

  // `number_of_samples`: with those that have come since
  void follow(const int number_of_samples) { m_origins.resize(number_of_samples, none()); }

  void forget()
  {
    m_origins = std::vector<Sample_pair>();
    m_bisected.clear();
  }

  // The size of a sample comes from the side between i and j.
  void set(const int sample, const int i, const int j)
  {
    if(is_followed())
      m_origins[sample] = ordered(i, j);
  }

  // It is the sample's own.
  void reset(const int sample)
  {
    if(is_followed())
      m_origins[sample] = none();
  }

  void note_bisected(const std::array<int, 3>& samples)
  {
    if(is_followed())
      m_bisected.push_back(samples);
  }

  // The samples that lose what has been passed on to them: across cells that are none any more, or from others that lose
  // theirs. They have no origin any more.
  std::vector<int> take_lost()
  {
    std::vector<int> result;
    const auto lose = [&](const int i)
    {
      reset(i);
      result.push_back(i);
    };
    for(const std::array<int, 3>& s : m_bisected)
      for(int k = 0; k < 3; ++k)
        // samples that have come since have their own sizes
        if(s[k] < static_cast<int>(m_origins.size()) && m_origins[s[k]] == ordered(s[next(k)], s[previous(k)]))
          lose(s[k]);
    m_bisected.clear();
    if(result.empty())
      return result;
    // packed: for each sample those that have their sizes from it
    std::vector<int> first(m_origins.size() + 1, 0);
    visit([&](const int origin, int) { ++first[origin + 1]; });
    std::partial_sum(first.begin(), first.end(), first.begin());
    std::vector<int> dependent(first.back()), next_free(first.begin(), first.end() - 1);
    visit([&](const int origin, const int i) { dependent[next_free[origin]++] = i; });
    for(std::size_t at = 0; at < result.size(); ++at)
      for(int n = first[result[at]]; n < first[result[at] + 1]; ++n)
        if(m_origins[dependent[n]] != none())
          lose(dependent[n]);
    return result;
  }

private:
  static Sample_pair none() { return Sample_pair(-1, -1); }

  // calls `visit(origin, sample)` for both ends of each side
  template <typename Visit>
  void visit(const Visit& visit_origin) const
  {
    for(std::size_t i = 0; i < m_origins.size(); ++i)
      if(m_origins[i] != none())
      {
        visit_origin(m_origins[i].first, static_cast<int>(i));
        visit_origin(m_origins[i].second, static_cast<int>(i));
      }
  }
};

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_SIZING_SIZE_ORIGINS_H
