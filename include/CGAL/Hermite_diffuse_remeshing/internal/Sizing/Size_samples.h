// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_SIZING_SIZE_SAMPLES_H
#define CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_SIZING_SIZE_SAMPLES_H

#include <CGAL/Hermite_diffuse_remeshing/internal/Indexed_triangles.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Sizing/Bisection_tree.h>

#include <algorithm>
#include <array>
#include <limits>
#include <vector>

namespace CGAL {
namespace Hermite_diffuse_remeshing {
namespace internal {

// The points where a size is asked for: the corners of the cells of the size map.
class Size_samples
{
  typedef Bisection_tree::Cell Cell;

  struct Sample
  {
    Vector position;
    double own_size;                      // of curvature, user and bounds, before gradation
    double user_size;                     // the user's part of it
    double cap;                           // asked for later
    double radius;                        // of curvature
    std::array<int, 2> ends;              // of the side that it halves; itself if there is none
    bool is_corner;                       // of a cell
  };

  std::vector<Sample> m_samples;

public:
  int size() const { return static_cast<int>(m_samples.size()); }
  const Vector& position(const int i) const { return m_samples[i].position; }
  double own_size(const int i) const { return m_samples[i].own_size; }
  double user_size(const int i) const { return m_samples[i].user_size; }
  const std::array<int, 2>& ends(const int i) const { return m_samples[i].ends; }
  // of a cell, not only probed
  bool is_corner(const int i) const { return m_samples[i].is_corner; }
  void set_corner(const int i) { m_samples[i].is_corner = true; }

  void add(const Vector& position, const double size)
  {
    m_samples.push_back({position, size, size, std::numeric_limits<double>::infinity(),
                         std::numeric_limits<double>::infinity(), {{this->size(), this->size()}}, true});
  }

  // between two others; caps and radii are linear there
  void add_middle(const int a, const int b, const double size)
  {
    add((m_samples[a].position + m_samples[b].position) / 2., size);
    m_samples.back().cap = (m_samples[a].cap + m_samples[b].cap) / 2.;
    m_samples.back().radius = (m_samples[a].radius + m_samples[b].radius) / 2.;
    m_samples.back().ends = {{a, b}};
    m_samples.back().is_corner = false;
  }

  void lower(const int i, const double size)
  {
    m_samples[i].own_size = (std::min)(m_samples[i].own_size, size);
  }

  void lower_user_size(const int i, const double size)
  {
    m_samples[i].user_size = (std::min)(m_samples[i].user_size, size);
    lower(i, size);
  }

  double cap(const int i) const { return m_samples[i].cap; }
  void lower_cap(const int i, const double size) { m_samples[i].cap = (std::min)(m_samples[i].cap, size); }

  double radius(const int i) const { return m_samples[i].radius; }
  void lower_radius(const int i, const double curvature)
  {
    if(curvature * m_samples[i].radius > 1.)
      m_samples[i].radius = 1. / curvature;
  }

  // before gradation; `scale`: of the own size
  double asked_size(const int i, const double scale) const
  {
    return (std::min)(scale * m_samples[i].own_size, m_samples[i].cap);
  }

  double side_length(const Cell& cell, const int k) const
  {
    return (position(cell.samples[next(k)]) - position(cell.samples[k])).norm();
  }

  int longest_side(const Cell& cell) const
  {
    int longest = 0;
    for(int k = 1; k < 3; ++k)
      // a tie must not be decided by rounding
      if(side_length(cell, k) > (1. + 1e-9) * side_length(cell, longest))
        longest = k;
    return longest;
  }
};

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_SIZING_SIZE_SAMPLES_H
