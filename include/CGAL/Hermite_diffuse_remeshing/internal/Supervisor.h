// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_SUPERVISOR_H
#define CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_SUPERVISOR_H

#include <CGAL/Hermite_diffuse_remeshing/Remeshing_report.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Progress.h>

#include <boost/graph/graph_traits.hpp>

#include <chrono>
#include <cmath>
#include <string>
#include <utility>

namespace CGAL {
namespace Hermite_diffuse_remeshing {
namespace internal {

// Between the remeshing and the user's visitor: tells the visitor and the report of the stages, and asks the
// visitor and the clock whether to stop. Once the answer is yes it stays yes.
template <typename TriangleMesh, typename Visitor>
class Supervisor
{
  typedef boost::graph_traits<TriangleMesh> Graph_traits;
  typedef typename Graph_traits::vertex_descriptor vertex_descriptor;
  typedef typename Graph_traits::halfedge_descriptor halfedge_descriptor;
  typedef typename Graph_traits::edge_descriptor edge_descriptor;
  typedef typename Graph_traits::face_descriptor face_descriptor;
  typedef std::chrono::steady_clock Clock;

  Visitor& m_visitor;
  Remeshing_report<TriangleMesh>& m_report;
  double m_maximum_running_time;                      // seconds
  Clock::time_point m_begin = Clock::now();
  double m_told_fraction = 0.;
  bool m_is_stopped = false, m_is_out_of_time = false;

public:
  Supervisor(Visitor& visitor, Remeshing_report<TriangleMesh>& report, const double maximum_running_time)
    : m_visitor(visitor), m_report(report), m_maximum_running_time(maximum_running_time)
  {}

  // Runs a stage. Returns whether it came to its end.
  template <typename Work>
  bool stage(const char* name, const Work& work)
  {
    m_visitor.stage_begins(name);
    m_told_fraction = 0.;
    const Clock::time_point begin = Clock::now();
    bool is_complete = true;
    try { work(); }
    catch(const Interrupted&) { is_complete = false; }
    m_report.stages.push_back(std::make_pair(std::string(name), seconds_since(begin)));
    m_report.seconds = seconds_since(m_begin);
    m_visitor.stage_ends(name);
    return is_complete;
  }

  // of the current stage, for what knows nothing of visitors
  Progress progress_of_stage()
  {
    return Progress([this](const double fraction) { progress(fraction); return !is_stop_requested(); });
  }

  bool is_stopped() const { return m_is_stopped; }
  Stop_reason stop_reason() const { return m_is_out_of_time ? TIME_BUDGET : STOPPED_BY_VISITOR; }

  // \name What the working mesh calls
  bool is_stop_requested()
  {
    if(!m_is_stopped)
    {
      // a look at the clock costs as much as a small operation
      m_is_out_of_time = std::isfinite(m_maximum_running_time) && seconds_since(m_begin) > m_maximum_running_time;
      m_is_stopped = m_is_out_of_time || m_visitor.is_stop_requested();
    }
    return m_is_stopped;
  }
  void progress(const double fraction)
  {
    // more often than this nobody can see it, and the adaptation to a deviation begins anew several times
    constexpr double least_step = 0.01;
    if(fraction < m_told_fraction + least_step || fraction > 1.)
      return;
    m_told_fraction = fraction;
    m_visitor.progress(fraction);
  }
  void before_edge_split(const edge_descriptor e) { m_visitor.before_edge_split(e); }
  void after_edge_split(const vertex_descriptor v) { m_visitor.after_edge_split(v); }
  void after_face_split(const face_descriptor f, const face_descriptor part) { m_visitor.after_face_split(f, part); }
  void before_edge_collapse(const halfedge_descriptor h) { m_visitor.before_edge_collapse(h); }
  void after_edge_collapse(const vertex_descriptor v) { m_visitor.after_edge_collapse(v); }
  void before_edge_flip(const edge_descriptor e) { m_visitor.before_edge_flip(e); }
  void after_edge_flip(const edge_descriptor e) { m_visitor.after_edge_flip(e); }
  void before_vertex_removal(const vertex_descriptor v) { m_visitor.before_vertex_removal(v); }
  void after_vertex_removal() { m_visitor.after_vertex_removal(); }
  void before_vertex_relocation(const vertex_descriptor v) { m_visitor.before_vertex_relocation(v); }
  void after_vertex_relocation(const vertex_descriptor v) { m_visitor.after_vertex_relocation(v); }

private:
  static double seconds_since(const Clock::time_point begin)
  {
    return std::chrono::duration<double>(Clock::now() - begin).count();
  }
};

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_SUPERVISOR_H
