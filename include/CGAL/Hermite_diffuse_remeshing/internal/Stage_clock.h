// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_STAGE_CLOCK_H
#define CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_STAGE_CLOCK_H

#include <CGAL/Hermite_diffuse_remeshing/Remeshing_report.h>

#include <CGAL/Real_timer.h>

#include <string>
#include <utility>

namespace CGAL {
namespace Hermite_diffuse_remeshing {
namespace internal {

// Tells the visitor and the report of a stage.
template <typename TriangleMesh, typename Visitor>
class Stage_clock
{
  Remeshing_report<TriangleMesh>& m_report;
  Visitor& m_visitor;
  Real_timer m_timer;

public:
  Stage_clock(Remeshing_report<TriangleMesh>& report, Visitor& visitor)
    : m_report(report), m_visitor(visitor)
  {}

  template <typename Work>
  void operator()(const char* name, const Work& work)
  {
    m_visitor.stage_begins(name);
    m_timer.reset();
    m_timer.start();
    work();
    m_timer.stop();
    m_report.stages.push_back(std::make_pair(std::string(name), m_timer.time()));
    m_report.seconds += m_timer.time();
    m_visitor.stage_ends(name);
  }
};

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_STAGE_CLOCK_H
