// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_REMESH_SOUP_H
#define CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_REMESH_SOUP_H

#include <CGAL/Hermite_diffuse_remeshing/Default_remeshing_visitor.h>
#include <CGAL/Hermite_diffuse_remeshing/Remeshing_report.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Supervisor.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/plan_repairs.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/read_input.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/read_model.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/read_parameters.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/read_size_options.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/run_stages.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/soup_mesh.h>
#include <CGAL/Hermite_diffuse_remeshing/named_parameters.h>

#include <CGAL/Kernel_traits.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <numeric>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Hermite_diffuse_remeshing {
namespace internal {

// The edges of a soup are pairs of indices, the smaller one first.
inline std::pair<std::size_t, std::size_t> edge_of_soup(const std::size_t a, const std::size_t b)
{
  return std::minmax({a, b});
}

// What the user says of the edges of a soup.
template <typename FacePatchMap, typename Pack>
Side_marks read_soup_marks(const Indexed_triangles& surface, const FacePatchMap& labels, const Pack& pack)
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  typedef std::pair<std::size_t, std::size_t> Edge;
  const auto policies = read_edge_policy_map<Edge>(pack);
  const auto ecm = choose_parameter(get_parameter(pack, internal_np::edge_is_constrained),
                                    Static_boolean_property_map<Edge, false>());
  const bool protect = choose_parameter(get_parameter(pack, internal_np::protect_constraints), false);
  const Edge_table edges(surface);
  Side_marks result(surface.number_of_faces());
  for(int e = 0; e < edges.number_of_edges(); ++e)
  {
    const Edge edge = edge_of_soup(edges.vertices(e)[0], edges.vertices(e)[1]);
    const bool is_between_patches = edges.number_of_sides(e) == 2
      && get(labels, std::size_t(edges.side(e, 0).face)) != get(labels, std::size_t(edges.side(e, 1).face));
    for(int i = 0; i < edges.number_of_sides(e); ++i)
      result[edges.side(e, i).face][edges.side(e, i).side] =
        make_edge_mark(get(policies, edge), get(ecm, edge), protect, is_between_patches);
  }
  return result;
}

// with the coordinates in the order of the corners that the triangle had before it was turned
inline Location location_in_soup(Location location, const std::vector<char>& is_turned)
{
  if(is_turned[location.face])
    std::swap(location.coordinates[1], location.coordinates[2]);
  return location;
}

// Of a soup that a stop came too early to change.
template <typename TriangleRange, typename Pack>
void write_output_maps_of_soup(const TriangleRange& triangles, const Pack& pack)
{
  using parameters::get_parameter;
  CGAL_USE(pack);
  std::size_t f = 0;
  for(const auto& triangle : triangles)
  {
    if constexpr(is_given<Pack, internal_np::face_origin_map_t>())
      put(get_parameter(pack, internal_np::face_origin_map), f, f);
    if constexpr(is_given<Pack, internal_np::vertex_location_map_t>())
      for(int k = 0; k < 3; ++k)
        put(get_parameter(pack, internal_np::vertex_location_map), std::size_t(triangle[k]),
            std::make_pair(f, location_of_corner(k).coordinates));
    ++f;
  }
}

// Writes the mesh back as a soup, the copies of a vertex as one, and what is known of vertices and triangles, which
// the report names by their indices from then on.
template <typename Mesh, typename Deviation, typename LabelOfFace, typename FacePatchMap, typename Pack,
          typename PointRange, typename TriangleRange>
void write_soup(const Mesh& mesh, const std::vector<Deviation>& deviations, const std::vector<char>& is_turned,
                const LabelOfFace& label_of_face, const FacePatchMap& labels, const Pack& pack,
                PointRange& points, TriangleRange& triangles, Remeshing_report<typename Mesh::TriangleMesh>& report)
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  const auto location_map = choose_parameter(get_parameter(pack, internal_np::vertex_location_map),
    Constant_property_map<std::size_t, std::pair<std::size_t, Barycentric> >());
  const auto size_map = choose_parameter(get_parameter(pack, internal_np::vertex_size_map),
    Constant_property_map<std::size_t, double>());
  const auto origin_map = choose_parameter(get_parameter(pack, internal_np::face_origin_map),
    Constant_property_map<std::size_t, std::size_t>());
  const auto deviation_map = choose_parameter(get_parameter(pack, internal_np::face_deviation_map),
    Constant_property_map<std::size_t, double>());

  PointRange new_points;
  TriangleRange new_triangles;
  const auto& tm = mesh.tmesh();
  std::vector<std::size_t> rank(mesh.number_of_vertex_slots(), std::size_t(-1));
  for(const auto v : vertices(tm))
  {
    if(rank[mesh.index(v)] != std::size_t(-1))
      continue;
    const std::size_t i = rank[mesh.index(v)] = new_points.size();
    new_points.push_back(tm.point(v));
    const Location location = location_in_soup(mesh.site(v).location, is_turned);
    put(location_map, i, std::make_pair(std::size_t(location.face), location.coordinates));
    put(size_map, i, mesh.size(v));
  }
  std::vector<std::size_t> rank_of_face(tm.num_faces());
  for(const auto f : faces(tm))
  {
    const std::size_t i = rank_of_face[std::size_t(f)] = new_triangles.size();
    const auto h = halfedge(f, tm);
    const std::array<std::size_t, 3> corners = {{rank[mesh.index(source(h, tm))], rank[mesh.index(target(h, tm))],
                                                 rank[mesh.index(target(next(h, tm), tm))]}};
    typename TriangleRange::value_type triangle{corners[0], corners[1], corners[2]};
    new_triangles.push_back(triangle);
    put(origin_map, i, std::size_t(mesh.face_of_reference(f)));
  }
  if constexpr(is_given<Pack, internal_np::edge_class_map_t>())
    for(const auto e : edges(tm))
    {
      const auto h = halfedge(e, tm);
      put(get_parameter(pack, internal_np::edge_class_map),
          edge_of_soup(rank[mesh.index(source(h, tm))], rank[mesh.index(target(h, tm))]), mesh.edge_class(h));
    }
  for(const Deviation& entry : deviations)
    put(deviation_map, rank_of_face[std::size_t(entry.face)], entry.deviation);
  typedef typename Mesh::face_descriptor face_descriptor;
  const auto renumber = [&](face_descriptor& f)
  { f = face_descriptor(static_cast<typename Mesh::TriangleMesh::size_type>(rank_of_face[std::size_t(f)])); };
  for(face_descriptor& f : report.faces_above_maximum_deviation)
    renumber(f);
  for(Low_quality_face<face_descriptor>& entry : report.low_quality_faces)
    renumber(entry.face);
  report.number_of_vertices = new_points.size();
  // what is read, too, comes last: everything before may throw
  for(const auto f : faces(tm))
    put(labels, rank_of_face[std::size_t(f)], get(label_of_face, f));
  points = std::move(new_points);
  triangles = std::move(new_triangles);
}

template <typename TriangleMesh>
void describe_soup(const Indexed_triangles& surface, Remeshing_report<TriangleMesh>& report)
{
  report.number_of_input_faces = report.number_of_faces = surface.triangles.size();
  report.number_of_vertices = surface.points.size();
  const Quality_statistics quality = measure_quality(surface, [](int) { return true; });
  report.smallest_input_quality = report.smallest_quality = quality.smallest;
  report.mean_input_quality = report.mean_quality = quality.mean;
}

// Everything is read and checked before the first change.
template <typename ConcurrencyTag, typename PointRange, typename TriangleRange, typename Pack>
Remeshing_report<Surface_mesh<typename PointRange::value_type> >
remesh_soup(PointRange& points, TriangleRange& triangles, const Pack& pack)
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  using parameters::get_parameter_reference;
  typedef typename PointRange::value_type Point;
  typedef Surface_mesh<Point> Mesh;
  typedef typename boost::graph_traits<Mesh>::edge_descriptor edge_descriptor;
  typedef typename boost::graph_traits<Mesh>::face_descriptor face_descriptor;
  typedef typename internal_np::Lookup_named_param_def<internal_np::geom_traits_t, Pack,
    typename Kernel_traits<Point>::Kernel>::type GT;
  typedef Default_remeshing_visitor<Mesh> Default_visitor;
  typedef typename internal_np::Lookup_named_param_def<internal_np::visitor_t, Pack, Default_visitor>::reference
    Visitor_reference;
  static_assert(std::is_floating_point<typename GT::FT>::value,
                "hermite_diffuse_remesh_triangle_soup() needs a kernel with floating point coordinates");

  const GT gt = choose_parameter<GT>(get_parameter(pack, internal_np::geom_traits));
  const auto labels = choose_parameter(get_parameter(pack, internal_np::face_patch),
                                       Constant_property_map<std::size_t, int>());
  const auto vcm = choose_parameter(get_parameter(pack, internal_np::vertex_is_constrained),
                                    Static_boolean_property_map<std::size_t, false>());
  Default_visitor default_visitor;
  Visitor_reference visitor = choose_parameter(get_parameter_reference(pack, internal_np::visitor), default_visitor);
  const double iterations = choose_parameter(get_parameter(pack, internal_np::number_of_iterations), 10);
  check_parameter("number_of_iterations", iterations, 1, (std::numeric_limits<int>::max)());
  const double maximum_running_time =
    choose_parameter(get_parameter(pack, internal_np::maximum_running_time), std::numeric_limits<double>::infinity());
  check_positive_parameter("maximum_running_time", maximum_running_time);
  const Feature_options feature_options = read_feature_options(pack);
  Model_options model_options = read_model_options(pack);
  model_options.is_parallel = is_parallel<ConcurrencyTag>();
  Indexed_triangles surface = read_soup(points, triangles, gt);
  check_has_area(surface, count_degenerate_faces(surface, resolution_of_coordinates(surface)));
  std::vector<std::size_t> triangle_indices(surface.number_of_faces()), point_indices(surface.points.size());
  std::iota(triangle_indices.begin(), triangle_indices.end(), std::size_t(0));
  std::iota(point_indices.begin(), point_indices.end(), std::size_t(0));
  const std::vector<Vector> vertex_normals = read_vertex_normals(point_indices, gt, pack, [](const std::size_t i) { return i; });
  Size_options size_options = read_size_options<GT>(pack, surface);
  read_size_field(pack, gt, triangle_indices, size_options);

  const std::vector<char> is_turned = orient_sheets(surface);
  if(size_options.user_size)
    size_options.user_size = [&is_turned, user_size = size_options.user_size](const Vector& p, const Location& location)
    { return user_size(p, location_in_soup(location, is_turned)); };
  const Side_marks marks = read_soup_marks(surface, labels, pack);
  Mesh mesh;
  make_soup_mesh(surface, gt, mesh);
  const std::vector<face_descriptor> face_descriptors(faces(mesh).begin(), faces(mesh).end());
  auto label_of_face = mesh.template add_property_map<face_descriptor,
    typename boost::property_traits<std::decay_t<decltype(labels)> >::value_type>("f:label").first;
  for(const face_descriptor f : face_descriptors)
    put(label_of_face, f, get(labels, std::size_t(f)));

  Remeshing_report<Mesh> report;
  describe_soup(surface, report);
  Supervisor_of_visitor<Mesh, std::remove_reference_t<Visitor_reference> >
    watched(visitor, report, maximum_running_time);

  typedef typename boost::property_map<Mesh, CGAL::vertex_point_t>::type VPM;
  typedef Static_boolean_property_map<edge_descriptor, false> ECM;
  const User_mesh_with_maps<Mesh, VPM, ECM, std::decay_t<decltype(label_of_face)>, GT>
    user(mesh, watched, get(CGAL::vertex_point, mesh), ECM(), label_of_face, gt);
  const bool is_guarded = choose_parameter(get_parameter(pack, internal_np::do_self_intersection_tests), true);
  bool is_written = false;
  run_stages<User_mesh<Mesh> >(
    user, face_descriptors, marks, std::vector<char>(face_descriptors.size(), true),
    Stage_options{size_options, read_face_budget(pack, surface.triangles.size()), static_cast<int>(iterations),
                  is_guarded},
    [&]
    {
      return make_model<Input_model>(surface, feature_options, model_options,
                                     [&](const int f, const int side) { return marks[f][side]; },
                                     [&](const int v) -> bool { return get(vcm, std::size_t(v)); },
                                     vertex_normals, watched.progress_of_stage());
    },
    [] {},
    [&](const auto& working_mesh, const auto& deviations)
    {
      write_soup(working_mesh, deviations, is_turned, label_of_face, labels, pack, points, triangles, report);
      is_written = true;
    },
    report);
  if(!is_written)
    write_output_maps_of_soup(triangles, pack);
  return report;
}

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_REMESH_SOUP_H
