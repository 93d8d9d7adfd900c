// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_PROGRESS_H
#define CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_PROGRESS_H

#include <functional>
#include <utility>

namespace CGAL {
namespace Hermite_diffuse_remeshing {
namespace internal {

// Thrown where a computation is given up on request. Nothing but its result is lost.
struct Interrupted {};

// What a computation says while it runs: which part of it is done, in [0, 1]. The answer may be that it
// is to be given up.
class Progress
{
  std::function<bool(double)> m_may_go_on;
  double m_first = 0., m_length = 1.;

public:
  // tells nobody
  Progress() {}

  explicit Progress(std::function<bool(double)> may_go_on) : m_may_go_on(std::move(may_go_on)) {}

  void operator()(const double fraction) const
  {
    if(m_may_go_on && !m_may_go_on(m_first + m_length * fraction))
      throw Interrupted();
  }

  // of a step that is a part of the whole
  Progress part(const double first, const double last) const
  {
    Progress result(*this);
    result.m_first += m_length * first;
    result.m_length *= last - first;
    return result;
  }
};

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_PROGRESS_H
