// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_REMESH_SURFACE_H
#define CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_REMESH_SURFACE_H

#include <CGAL/Hermite_diffuse_remeshing/Remeshing_report.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Model/Input_model.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Transformation/Remesher.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Transformation/enforce_deviation.h>

#include <CGAL/Real_timer.h>

#include <algorithm>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Hermite_diffuse_remeshing {
namespace internal {

struct Remeshing_options
{
  Size_options sizes;
  int number_of_iterations;
  std::size_t maximum_number_of_faces;
};

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

// The edges that cannot be changed: those that the user protects, and between what is remeshed and the rest.
template <typename TriangleMesh, typename FaceDescriptor, typename IsProtected>
std::vector<char> find_frozen_edges(const TriangleMesh& tmesh, const std::vector<FaceDescriptor>& face_descriptors,
                                    const Edge_table& edge_table, const std::vector<char>& is_remeshed,
                                    const IsProtected& is_protected)
{
  std::vector<char> result(edge_table.number_of_edges(), false);
  for(int e = 0; e < edge_table.number_of_edges(); ++e)
  {
    const Face_side& side = edge_table.side(e, 0);
    auto h = halfedge(face_descriptors[side.face], tmesh);
    for(int k = 0; k < side.side; ++k)
      h = next(h, tmesh);
    const bool is_seam = edge_table.number_of_sides(e) == 2
                      && is_remeshed[side.face] != is_remeshed[edge_table.side(e, 1).face];
    result[e] = is_seam || is_protected(h);
  }
  return result;
}

// The stages from the model to the report, on a mesh with the faces of the reference, of which a part is remeshed.
// `make_model()` returns the model; `write_result(working_mesh, deviations)` is called at the end.
template <typename User, typename MakeModel, typename IsProtected, typename WriteResult>
Remeshing_report<typename User::TriangleMesh>
remesh_surface(const User& user, const std::vector<typename Working_mesh<User>::face_descriptor>& face_descriptors,
               const std::vector<char>& is_remeshed, const Remeshing_options& options, const MakeModel& make_model,
               const IsProtected& is_protected, const WriteResult& write_result)
{
  Remeshing_report<typename User::TriangleMesh> report;
  report.number_of_input_faces = face_descriptors.size();
  report.maximum_deviation = options.sizes.maximum_deviation;
  Stage_clock<typename User::TriangleMesh, typename User::Visitor> stage(report, user.visitor);

  std::unique_ptr<Input_model> model;
  stage("model", [&] { model = make_model(); });

  std::unique_ptr<Size_map> sizes;
  stage("size map", [&]
  {
    sizes.reset(new Size_map(model->surface, model->edges, model->curves, options.sizes,
                             find_frozen_edges(user.tmesh, face_descriptors, model->edges, is_remeshed, is_protected)));
    const auto is_selected = [&is_remeshed](const int f) { return is_remeshed[f] != 0; };
    // the rest is for the places where the sizes do not fit the shape
    constexpr double used_part = 0.9;
    sizes->limit_number_of_faces(used_part * double(options.maximum_number_of_faces), is_selected);
    report.size_scale = sizes->scale();
    report.predicted_number_of_faces = sizes->number_of_faces(is_selected)
                                     + double(std::count(is_remeshed.begin(), is_remeshed.end(), false));
  });

  const Reference reference{model->edges, model->edge_classes, model->vertex_classes, model->curves,
                            model->surface, model->locator, *sizes};
  Working_mesh<User> mesh(user, reference, face_descriptors, is_remeshed, is_protected,
                          options.maximum_number_of_faces);
  const Quality_statistics input_quality = measure_quality(mesh);
  report.smallest_input_quality = input_quality.smallest;
  report.mean_input_quality = input_quality.mean;

  Remesher<User> remesher(mesh, options.number_of_iterations);
  stage("adaptation", [&] { report.stop_reason = remesher.adapt(); });
  if(!mesh.is_stopped())
    stage("optimisation", [&] { report.stop_reason = remesher.optimise(report.stop_reason); });

  Deviations<User> deviations;
  stage("deviation", [&]
  { deviations = enforce_deviation(mesh, *sizes, remesher, report.maximum_deviation, report.stop_reason); });

  fill_report(mesh, deviations, report);
  report.number_of_iterations = remesher.number_of_iterations();
  report.number_of_corners = std::count_if(model->vertex_classes.begin(), model->vertex_classes.end(), is_corner);
  report.number_of_feature_edges = std::count_if(model->edge_classes.begin(), model->edge_classes.end(), is_feature);
  report.number_of_curves = model->curves.curves.size();
  write_result(mesh, deviations.faces);
  return report;
}

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_REMESH_SURFACE_H
