// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_RUN_STAGES_H
#define CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_RUN_STAGES_H

#include <CGAL/Hermite_diffuse_remeshing/Remeshing_report.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Transformation/Remesher.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Transformation/coarse_levels.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Transformation/enforce_deviation.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Transformation/find_quality_obstacles.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Transformation/measure.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Transformation/meet_budget.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/make_size_map.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <memory>
#include <vector>

namespace CGAL {
namespace Hermite_diffuse_remeshing {
namespace internal {

struct Stage_options
{
  Size_options sizes;
  std::size_t maximum_number_of_faces;
  int maximum_number_of_iterations;
  bool is_guarded;                      // against new intersections
};

template <typename TriangleMesh>
void describe_preparation(const Input_model& model, const Size_map& sizes, const std::vector<char>& is_remeshed,
                          Remeshing_report<TriangleMesh>& report)
{
  report.number_of_corners = std::count_if(model.vertex_classes.begin(), model.vertex_classes.end(), is_corner);
  report.number_of_feature_edges = std::count_if(model.edge_classes.begin(), model.edge_classes.end(), is_feature);
  report.number_of_curves = model.curves.curves.size();
  report.size_scale = sizes.scale();
  report.predicted_number_of_faces = sizes.number_of_faces([&](const int f) { return is_remeshed[f] != 0; })
                                   + double(std::count(is_remeshed.begin(), is_remeshed.end(), false));
}

// The whole method, in the order of the paper: the input is classified and fitted, sizes follow from the
// curvature, then the mesh is adapted to them, improved, and measured against the fit.
// `make_model()` returns the model; `begin_changes()` is called before the first change of the mesh, whose faces are
// those of the reference from then on; `write_result(working_mesh, deviations)` at the end. Their types depend on the
// named parameters of the call, of which all of this is to be compiled but once.
template <typename User>
void run_stages(const User& user, const std::vector<typename Working_mesh<User>::face_descriptor>& face_descriptors,
                const Side_marks& marks, const std::vector<char>& is_remeshed, const Stage_options& options,
                const std::function<std::unique_ptr<Input_model>()>& make_model,
                const std::function<void()>& begin_changes,
                const std::function<void(const Working_mesh<User>&,
                                         const decltype(Deviations<User>::faces)&)>& write_result,
                Remeshing_report<typename User::TriangleMesh>& report)
{
  auto& watched = user.visitor;
  report.maximum_deviation = options.sizes.maximum_deviation;
  report.is_maximum_deviation_met = !std::isfinite(report.maximum_deviation);
  std::unique_ptr<Input_model> model;
  std::unique_ptr<Feature_displacements> displacements;
  std::unique_ptr<Size_map> sizes;
  const bool is_prepared =
    watched.stage("model", [&]
    { model = make_model();
      displacements.reset(new Feature_displacements(model->surface, model->edges, model->curves,
                                                    watched.progress_of_stage().part(1., 1.))); })
    && watched.stage("size map", [&]
       { sizes = make_size_map(*model, options.sizes, marks, options.maximum_number_of_faces,
                               [&](const int f) { return is_remeshed[f] != 0; }, watched.progress_of_stage());
         describe_preparation(*model, *sizes, is_remeshed, report); });
  if(!is_prepared)
  {
    report.stop_reason = watched.stop_reason();
    return;
  }
  begin_changes();
  const Reference reference{model->edges, model->edge_classes, model->vertex_classes, model->curves, model->surface,
                            model->locator, *displacements, *sizes};
  Working_mesh<User> mesh(user, reference, face_descriptors, is_remeshed,
                          [&](const int f, const int side) { return marks[f][side] == MARKED_PROTECTED; },
                          options.maximum_number_of_faces, options.is_guarded);
  Remesher<User> remesher(mesh, options.maximum_number_of_iterations);
  Deviations<User> deviations;
  watched.stage("adaptation", [&] { report.stop_reason = remesher.adapt(); });
  // a stop, which may come as an exception, leaves those of a coarser level
  if(sizes->is_coarse())
    set_level(mesh, 0);
  if(!watched.is_stopped())
    watched.stage("optimisation", [&]
    { report.stop_reason = meet_budget(mesh, remesher, remesher.raise_worst(remesher.optimise(report.stop_reason))); });
  if(!watched.is_stopped())
    report.is_deviation_measured = watched.stage("deviation", [&]
    { deviations = enforce_deviation(mesh, *sizes, remesher, options.sizes.maximum_deviation,
                                     report.number_of_deviation_rounds); });
  const auto describe_result = [&]
  {
    report.low_quality_faces = Quality_obstacles<User>(mesh).explain(measure_faces(mesh, report));
    fill_report(mesh, deviations, report);
    report.number_of_iterations = remesher.number_of_iterations();
    report.size_scale = sizes->scale();     // which may have grown since
    write_result(mesh, deviations.faces);
  };
  if(watched.is_stopped())
    describe_result();
  else
    watched.stage("report", describe_result);
  if(watched.is_stopped())
    report.stop_reason = watched.stop_reason();
  else if(mesh.is_full() || (deviations.is_bound_out_of_reach && !report.is_maximum_deviation_met))
    report.stop_reason = FACE_BUDGET;
  else if(!report.is_maximum_deviation_met)
    report.stop_reason = DEVIATION_NOT_MET;
}

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_RUN_STAGES_H
