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
// visitor and the clock whether to stop. Once the answer is yes it stays yes. The type of the visitor stays behind
// virtual functions: the operators are compiled once for all visitors, and cost far more than such a call.
template <typename TriangleMesh>
class Supervisor
{
protected:
  typedef boost::graph_traits<TriangleMesh> Graph_traits;
  typedef typename Graph_traits::vertex_descriptor vertex_descriptor;
  typedef typename Graph_traits::halfedge_descriptor halfedge_descriptor;
  typedef typename Graph_traits::edge_descriptor edge_descriptor;
  typedef typename Graph_traits::face_descriptor face_descriptor;

private:
  typedef std::chrono::steady_clock Clock;

  Remeshing_report<TriangleMesh>& m_report;
  double m_maximum_running_time;                      // seconds
  Clock::time_point m_begin = Clock::now();
  double m_told_fraction = 0.;
  bool m_is_stopped = false, m_is_out_of_time = false;

public:
  Supervisor(Remeshing_report<TriangleMesh>& report, const double maximum_running_time)
    : m_report(report), m_maximum_running_time(maximum_running_time)
  {}
  Supervisor(const Supervisor&) = delete;
  Supervisor& operator=(const Supervisor&) = delete;
  virtual ~Supervisor() = default;

  // Runs a stage. Returns whether it came to its end.
  template <typename Work>
  bool stage(const char* name, const Work& work)
  {
    tell_stage_begins(name);
    m_told_fraction = 0.;
    const Clock::time_point begin = Clock::now();
    bool is_complete = true;
    try { work(); }
    catch(const Interrupted&) { is_complete = false; }
    m_report.stages.push_back(std::make_pair(std::string(name), seconds_since(begin)));
    m_report.seconds = seconds_since(m_begin);
    tell_stage_ends(name);
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
      m_is_stopped = m_is_out_of_time || does_visitor_stop();
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
    tell_progress(fraction);
  }
  virtual void before_edge_split(edge_descriptor e) = 0;
  virtual void after_edge_split(vertex_descriptor v) = 0;
  virtual void after_face_split(face_descriptor f, face_descriptor part) = 0;
  virtual void before_edge_collapse(halfedge_descriptor h) = 0;
  virtual void after_edge_collapse(vertex_descriptor v) = 0;
  virtual void before_edge_flip(edge_descriptor e) = 0;
  virtual void after_edge_flip(edge_descriptor e) = 0;
  virtual void before_vertex_removal(vertex_descriptor v) = 0;
  virtual void after_vertex_removal() = 0;
  virtual void before_vertex_relocation(vertex_descriptor v) = 0;
  virtual void after_vertex_relocation(vertex_descriptor v) = 0;

private:
  virtual void tell_stage_begins(const char* name) = 0;
  virtual void tell_progress(double fraction) = 0;
  virtual void tell_stage_ends(const char* name) = 0;
  virtual bool does_visitor_stop() = 0;

  static double seconds_since(const Clock::time_point begin)
  {
    return std::chrono::duration<double>(Clock::now() - begin).count();
  }
};

template <typename TriangleMesh, typename Visitor>
class Supervisor_of_visitor : public Supervisor<TriangleMesh>
{
  typedef Supervisor<TriangleMesh> Base;
  using typename Base::vertex_descriptor;
  using typename Base::halfedge_descriptor;
  using typename Base::edge_descriptor;
  using typename Base::face_descriptor;

  Visitor& m_visitor;

public:
  Supervisor_of_visitor(Visitor& visitor, Remeshing_report<TriangleMesh>& report, const double maximum_running_time)
    : Base(report, maximum_running_time), m_visitor(visitor)
  {}

  void before_edge_split(const edge_descriptor e) override { m_visitor.before_edge_split(e); }
  void after_edge_split(const vertex_descriptor v) override { m_visitor.after_edge_split(v); }
  void after_face_split(const face_descriptor f, const face_descriptor part) override { m_visitor.after_face_split(f, part); }
  void before_edge_collapse(const halfedge_descriptor h) override { m_visitor.before_edge_collapse(h); }
  void after_edge_collapse(const vertex_descriptor v) override { m_visitor.after_edge_collapse(v); }
  void before_edge_flip(const edge_descriptor e) override { m_visitor.before_edge_flip(e); }
  void after_edge_flip(const edge_descriptor e) override { m_visitor.after_edge_flip(e); }
  void before_vertex_removal(const vertex_descriptor v) override { m_visitor.before_vertex_removal(v); }
  void after_vertex_removal() override { m_visitor.after_vertex_removal(); }
  void before_vertex_relocation(const vertex_descriptor v) override { m_visitor.before_vertex_relocation(v); }
  void after_vertex_relocation(const vertex_descriptor v) override { m_visitor.after_vertex_relocation(v); }

private:
  void tell_stage_begins(const char* const name) override { m_visitor.stage_begins(name); }
  void tell_progress(const double fraction) override { m_visitor.progress(fraction); }
  void tell_stage_ends(const char* const name) override { m_visitor.stage_ends(name); }
  bool does_visitor_stop() override { return m_visitor.is_stop_requested(); }
};

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_SUPERVISOR_H
