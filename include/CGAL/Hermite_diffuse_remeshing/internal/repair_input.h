// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_REPAIR_INPUT_H
#define CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_REPAIR_INPUT_H

#include <CGAL/Hermite_diffuse_remeshing/Remeshing_report.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Former_faces.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Transformation/User_mesh.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/plan_repairs.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/read_input.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/read_size_options.h>

#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/iterator.h>

#include <boost/container/static_vector.hpp>

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Hermite_diffuse_remeshing {
namespace internal {

template <typename TriangleMesh, typename GeomTraits>
bool has_folded_face(const Input_mesh<TriangleMesh, GeomTraits>& input)
{
  const TriangleMesh& tm = input.tmesh;
  auto number = get(CGAL::dynamic_face_property_t<int>(), tm);
  std::vector<Vector> normals;
  for(int f = 0; f < input.triangles.number_of_faces(); ++f)
  {
    put(number, input.face_descriptors[f], f);
    normals.push_back(input.triangles.area_vector(f));
  }
  for(int f = 0; f < input.triangles.number_of_faces(); ++f)
    if(is_folded_over(normals[f], [&](const auto& visit)
       {
         for(const auto h : CGAL::halfedges_around_face(halfedge(input.face_descriptors[f], tm), tm))
           if(!is_border(opposite(h, tm), tm) && !visit(normals[get(number, face(opposite(h, tm), tm))]))
             return;
       }))
      return true;
  return false;
}

struct Repair_plan
{
  std::vector<Repair> repairs;
  Former_faces former_faces;
};

// Replaces the copy of the mesh, not the mesh, by one without the degenerate and folded faces that can be repaired, and
// drops the marks of the faces that are gone.
template <typename TriangleMesh, typename GeomTraits, typename Pack>
Repair_plan plan_repairs(Input_mesh<TriangleMesh, GeomTraits>& input, const Pack& pack,
                                 std::vector<char>& is_remeshed, Remeshing_report<TriangleMesh>& report)
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  typedef boost::graph_traits<TriangleMesh> Graph_traits;

  const double resolution = resolution_of_coordinates(input.triangles);
  const std::size_t number = count_degenerate_faces(input.triangles, resolution);
  check_has_area(input.triangles, number);
  if(number == 0 && !has_folded_face(input))
    return Repair_plan();

  const auto vcm = choose_parameter(get_parameter(pack, internal_np::vertex_is_constrained),
                                    Static_boolean_property_map<typename Graph_traits::vertex_descriptor, false>());
  std::vector<char> is_constrained(input.vertex_descriptors.size());
  for(std::size_t i = 0; i < is_constrained.size(); ++i)
    is_constrained[i] = get(vcm, input.vertex_descriptors[i]);
  for(int f = 0; f < input.triangles.number_of_faces(); ++f)
    for(int k = 0; k < 3; ++k)
      if(input.side_marks[f][k] == MARKED_PROTECTED)
        is_constrained[input.triangles.triangles[f][k]] = is_constrained[input.triangles.triangles[f][next(k)]] = true;
  // of the bounds of the distance that the user gives
  constexpr double part_of_bound = 0.1, infinity = std::numeric_limits<double>::infinity();
  const double largest_rise =
    part_of_bound * (std::min<double>)(choose_parameter(get_parameter(pack, internal_np::maximum_deviation), infinity),
                                       choose_parameter(get_parameter(pack, internal_np::maximum_displacement), infinity));
  const Repaired_triangles repaired = repair_triangles<Repair_planner>(input.triangles, input.side_marks, resolution,
                                                                       largest_rise, is_remeshed, is_constrained);
  report.number_of_degenerate_input_faces = repaired.number_of_degenerate_faces;
  report.number_of_folded_input_faces = repaired.number_of_folded_faces;
  report.number_of_unrepaired_faces = repaired.number_of_degenerate_faces_left + repaired.number_of_folded_faces_left;
  report.largest_unfolding = repaired.highest_rise;

  Repair_plan plan{repaired.repairs, {}};
  if constexpr(is_given<Pack, internal_np::vertex_location_map_t>())
    plan.former_faces = Former_faces(input.triangles, input.face_ranks, repaired);
  input.triangles.triangles = repaired.triangles;
  input.side_marks = repaired.side_marks;
  for(std::size_t i = 0; i < repaired.faces.size(); ++i)
  {
    const int former = repaired.faces[i];          // never smaller than i
    input.face_descriptors[i] = input.face_descriptors[former];
    input.face_ranks[i] = input.face_ranks[former];
    is_remeshed[i] = is_remeshed[former];
  }
  input.face_descriptors.resize(repaired.faces.size());
  input.face_ranks.resize(repaired.faces.size());
  is_remeshed.resize(repaired.faces.size());
  return plan;
}

// after a stop before the repairs were carried out
template <typename TriangleMesh>
void undo_plan_of_repairs(Remeshing_report<TriangleMesh>& report)
{
  report.number_of_unrepaired_faces = report.number_of_degenerate_input_faces + report.number_of_folded_input_faces;
  report.largest_unfolding = 0.;
}

// Removes the source of a halfedge; its target stays at its point p, and merged edges are constrained if one
// of the two was. Allocates nothing.
template <typename TriangleMesh>
typename boost::graph_traits<TriangleMesh>::vertex_descriptor
collapse_at_target(const User_mesh<TriangleMesh>& user,
                   const typename boost::graph_traits<TriangleMesh>::halfedge_descriptor h, const Vector& p)
{
  typedef boost::graph_traits<TriangleMesh> Graph_traits;
  typedef typename Graph_traits::vertex_descriptor vertex_descriptor;
  auto& tm = user.tmesh;
  user.visitor.before_edge_collapse(h);
  // what will be gone must not be constrained
  user.set_constrained(edge(h, tm), false);
  boost::container::static_vector<std::pair<vertex_descriptor, bool>, 2> merged;
  for(const auto g : {h, opposite(h, tm)})
    if(!is_border(g, tm))
    {
      const auto e = edge(next(g, tm), tm), other = edge(prev(g, tm), tm);
      merged.push_back(std::make_pair(target(next(g, tm), tm), user.is_constrained(e) || user.is_constrained(other)));
      user.set_constrained(e, false);
      user.set_constrained(other, false);
    }
  const vertex_descriptor v = CGAL::Euler::collapse_edge(edge(h, tm), tm);
  user.set_point(v, p);
  for(const auto& other : merged)
    user.set_constrained(edge(v, other.first, tm).first, other.second);
  user.visitor.after_edge_collapse(v);
  return v;
}

// Repeats on the user's mesh what has been planned on the copy, and lets the faces begin at the corners that the
// triangles begin at.
template <typename TriangleMesh, typename GeomTraits>
void carry_out_repairs(const std::vector<Repair>& repairs, const User_mesh<TriangleMesh>& user,
                       Input_mesh<TriangleMesh, GeomTraits>& input)
{
  TriangleMesh& tm = user.tmesh;
  for(const Repair& repair : repairs)
  {
    const auto h = halfedge(input.vertex_descriptors[repair.source], input.vertex_descriptors[repair.target], tm).first;
    if(repair.kind == Repair::COLLAPSE)
      input.vertex_descriptors[repair.target] = collapse_at_target(user, h, input.triangles.points[repair.target]);
    else
    {
      user.visitor.before_edge_flip(edge(h, tm));
      CGAL::Euler::flip_edge(h, tm);
      user.visitor.after_edge_flip(edge(h, tm));
    }
  }
  for(std::size_t i = 0; i < input.face_descriptors.size(); ++i)
  {
    const auto f = input.face_descriptors[i];
    const auto first = input.vertex_descriptors[input.triangles.triangles[i][0]];
    auto h = halfedge(f, tm);
    while(source(h, tm) != first)
      h = next(h, tm);
    if(h != halfedge(f, tm))
      set_halfedge(f, h, tm);
  }
}

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_REPAIR_INPUT_H
