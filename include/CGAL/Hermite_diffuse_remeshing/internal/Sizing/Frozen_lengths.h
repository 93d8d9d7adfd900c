// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_SIZING_FROZEN_LENGTHS_H
#define CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_SIZING_FROZEN_LENGTHS_H

#include <CGAL/Hermite_diffuse_remeshing/internal/Sizing/Sample_pair.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Sizing/limit_gradation.h>

#include <algorithm>
#include <array>
#include <vector>

namespace CGAL {
namespace Hermite_diffuse_remeshing {
namespace internal {

// Edges that stay as they are have their length, whatever the size there. The triangles at them can only be good
// if the sizes around start from this length: smaller ones grow from it with the gradation, and larger ones fall to
// the size that was asked for as fast as any gradation allows.
class Frozen_lengths
{
  struct Sample_length
  {
    double sum = 0.;
    int number = 0;
    double mean() const { return sum / number; }
  };

  Pair_map<double> m_lengths;   // of an edge, by pieces of it
  std::vector<Sample_length> m_samples;
  bool m_is_empty = true;

public:
  bool is_empty() const { return m_is_empty; }

  void add_edge(const int a, const int b, const double length)
  {
    m_is_empty = false;
    m_lengths[ordered(a, b)] = length;
    add_sample(a, length);
    add_sample(b, length);
  }

  // `middle` halves the side from a to b, which may be a piece of a frozen edge
  void add_middle(const int a, const int b, const int middle)
  {
    const auto found = m_lengths.find(ordered(a, b));
    if(found == m_lengths.end() || (middle < static_cast<int>(m_samples.size()) && m_samples[middle].number > 0))
      return;
    const double length = found->second;
    m_lengths[ordered(a, middle)] = m_lengths[ordered(middle, b)] = length;
    add_sample(middle, length);
  }

  void lower(std::vector<double>& sizes) const
  {
    for(std::size_t i = 0; i < m_samples.size(); ++i)
      if(m_samples[i].number > 0)
        sizes[i] = (std::min)(sizes[i], m_samples[i].mean());
  }

  // The limit of the slope from above to below is that from below to above of what is missing to the largest length.
  template <typename PointOfIndex>
  void raise(const std::vector<std::array<int, 3> >& triangles, const PointOfIndex& point,
             std::vector<double>& sizes, const Progress& progress) const
  {
    // the largest gradation that can be asked for
    constexpr double steepest_gradation = 2.;
    double largest = 0.;
    for(const Sample_length& sample : m_samples)
      if(sample.number > 0)
        largest = (std::max)(largest, sample.mean());
    std::vector<double> missing(sizes.size(), largest);
    for(std::size_t i = 0; i < m_samples.size(); ++i)
      if(m_samples[i].number > 0)
        missing[i] = largest - m_samples[i].mean();
    limit_gradation(triangles, point, slope_of_gradation(steepest_gradation), missing, progress);
    for(std::size_t i = 0; i < sizes.size(); ++i)
      sizes[i] = (std::max)(sizes[i], largest - missing[i]);
  }

private:
  void add_sample(const int i, const double length)
  {
    if(i >= static_cast<int>(m_samples.size()))
      m_samples.resize(i + 1);
    m_samples[i].sum += length;
    ++m_samples[i].number;
  }
};

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_SIZING_FROZEN_LENGTHS_H
