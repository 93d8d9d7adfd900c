// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_REMESH_H
#define CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_REMESH_H

#include <CGAL/Hermite_diffuse_remeshing/Default_remeshing_visitor.h>
#include <CGAL/Hermite_diffuse_remeshing/Remeshing_report.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Supervisor.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/make_size_map.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/order_for_locality.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/read_model.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/read_size_options.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/repair_input.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/run_stages.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/write_output_maps.h>

#include <limits>
#include <stdexcept>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Hermite_diffuse_remeshing {
namespace internal {

template <typename TriangleMesh, typename GeomTraits, typename IsSelected>
void describe_input(const Input_mesh<TriangleMesh, GeomTraits>& input, const IsSelected& is_selected,
                    Remeshing_report<TriangleMesh>& report)
{
  report.number_of_input_faces = report.number_of_faces = input.face_descriptors.size();
  report.number_of_vertices = input.vertex_descriptors.size();
  const Quality_statistics quality = measure_quality(input.triangles, is_selected);
  report.smallest_input_quality = report.smallest_quality = quality.smallest;
  report.mean_input_quality = report.mean_quality = quality.mean;
  report.number_of_isolated_vertices = count_isolated_vertices(input.triangles);
  report.number_of_coincident_vertices = count_coincident_points(input.triangles.points);
}

// Everything is read and checked before the first change.
template <typename ConcurrencyTag, typename FaceRange, typename TriangleMesh, typename Pack>
Remeshing_report<TriangleMesh> remesh(const FaceRange& faces, TriangleMesh& tmesh, const Pack& pack)
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  using parameters::get_parameter_reference;
  typedef boost::graph_traits<TriangleMesh> Graph_traits;
  typedef typename Graph_traits::edge_descriptor edge_descriptor;
  typedef typename Graph_traits::face_descriptor face_descriptor;
  typedef Traits_of<TriangleMesh, Pack> GT;
  typedef typename GetVertexPointMap<TriangleMesh, Pack>::type VPM;
  typedef typename internal_np::Lookup_named_param_def<internal_np::edge_is_constrained_t, Pack,
    Static_boolean_property_map<edge_descriptor, false> >::type ECM;
  typedef typename internal_np::Lookup_named_param_def<internal_np::face_patch_t, Pack,
    Constant_property_map<face_descriptor, int> >::type FPM;
  typedef Default_remeshing_visitor<TriangleMesh> Default_visitor;
  typedef typename internal_np::Lookup_named_param_def<internal_np::visitor_t, Pack, Default_visitor>::reference
    Visitor_reference;

  const VPM vpm = choose_parameter(get_parameter(pack, internal_np::vertex_point),
                                   get_property_map(CGAL::vertex_point, tmesh));
  const ECM ecm = choose_parameter<ECM>(get_parameter(pack, internal_np::edge_is_constrained));
  const FPM fpm = choose_parameter<FPM>(get_parameter(pack, internal_np::face_patch));
  Default_visitor default_visitor;
  Visitor_reference visitor = choose_parameter(get_parameter_reference(pack, internal_np::visitor), default_visitor);
  const double iterations = choose_parameter(get_parameter(pack, internal_np::number_of_iterations), 10);
  check_parameter("number_of_iterations", iterations, 1, (std::numeric_limits<int>::max)());
  const bool is_guarded = choose_parameter(get_parameter(pack, internal_np::do_self_intersection_tests), true);
  const double maximum_running_time =
    choose_parameter(get_parameter(pack, internal_np::maximum_running_time), std::numeric_limits<double>::infinity());
  check_positive_parameter("maximum_running_time", maximum_running_time);

  Input_mesh<TriangleMesh, GT> input = read_input<GT>(tmesh, pack);
  check_is_manifold(tmesh, input.vertex_descriptors, input.triangles);
  std::vector<char> is_remeshed(input.face_descriptors.size(), false);
  {
    // not for longer: the map of a mesh that grows grows with it
    const auto rank = get(CGAL::dynamic_face_property_t<int>(), tmesh);
    order_for_locality(rank, input);
    for(const face_descriptor f : faces)
    {
      const int i = get(rank, f);
      if(i < 0 || i >= static_cast<int>(is_remeshed.size()) || input.face_descriptors[i] != f)
        throw std::invalid_argument("a face to be remeshed is not a face of the mesh: it may have been removed");
      is_remeshed[i] = true;
    }
  }
  Size_options size_options = read_size_options<GT>(pack, input.triangles);

  const auto is_selected = [&](const int f) { return is_remeshed[f] != 0; };
  const std::size_t maximum_number_of_faces = read_face_budget(pack, input.face_descriptors.size());

  Remeshing_report<TriangleMesh> report;
  describe_input(input, is_selected, report);
  const Repair_plan plan = plan_repairs(input, pack, is_remeshed, report);
  read_size_field(pack, input.traits, input.face_descriptors, size_options);
  Supervisor_of_visitor<TriangleMesh, std::remove_reference_t<Visitor_reference> >
    watched(visitor, report, maximum_running_time);

  bool is_begun = false;
  const User_mesh_with_maps<TriangleMesh, VPM, ECM, FPM, GT> user(tmesh, watched, vpm, ecm, fpm, input.traits);
  run_stages<User_mesh<TriangleMesh> >(
    user, input.face_descriptors, input.side_marks, is_remeshed,
    Stage_options{size_options, maximum_number_of_faces, static_cast<int>(iterations), is_guarded},
    [&] { return read_model<ConcurrencyTag>(input, pack, watched.progress_of_stage()); },
    [&]
    {
      is_begun = true;
      if(!plan.repairs.empty())
        watched.stage("repair", [&] { carry_out_repairs(plan.repairs, user, input); });
    },
    [&](const auto& mesh, const auto& deviations)
    { write_output_maps(mesh, deviations, input, plan.former_faces, pack); },
    report);
  if(!is_begun)
  {
    write_output_maps_of_input(tmesh, pack);
    undo_plan_of_repairs(report);
  }
  return report;
}

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_REMESH_H
