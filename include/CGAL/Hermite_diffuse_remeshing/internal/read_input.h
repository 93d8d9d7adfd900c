// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_READ_INPUT_H
#define CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_READ_INPUT_H

#include <CGAL/Hermite_diffuse_remeshing/Feature_classes.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/collect_neighborhood.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/plan_repairs.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/validate_input.h>
#include <CGAL/Hermite_diffuse_remeshing/named_parameters.h>

#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/property_map.h>

#include <numeric>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Hermite_diffuse_remeshing {
namespace internal {

// The user's mesh, or the part of it that is looked at: face i of the triangles is `face_descriptors[i]`, vertex
// i `vertex_descriptors[i]`.
template <typename TriangleMesh, typename GeomTraits>
struct Input_mesh
{
  typedef boost::graph_traits<TriangleMesh> Graph_traits;

  const TriangleMesh& tmesh;
  GeomTraits traits;
  std::vector<typename Graph_traits::vertex_descriptor> vertex_descriptors;
  std::vector<typename Graph_traits::face_descriptor> face_descriptors;
  Indexed_triangles triangles;
  Side_marks side_marks;                              // features by the will of the user
  std::vector<std::size_t> face_ranks;                // among the faces of the mesh when it was read
};

// The map `edge_policy_map`, or one that leaves all edges to the detection.
template <typename Edge, typename Pack>
auto read_edge_policy_map(const Pack& pack)
{
  return parameters::choose_parameter(parameters::get_parameter(pack, internal_np::edge_policy_map),
                                      Constant_property_map<Edge, Edge_policy>(DETECTED_EDGE));
}

// A policy goes before the rest, but what the map of constraints says of a feature is kept with it.
inline Edge_mark make_edge_mark(const Edge_policy policy, const bool is_constrained, const bool are_constraints_protected,
                                const bool is_between_patches)
{
  switch(policy)
  {
    case FREE_EDGE:      return MARKED_FREE;
    case RESAMPLED_EDGE: return is_constrained ? MARKED_CONSTRAINED : MARKED_FEATURE;
    case PROTECTED_EDGE: return MARKED_PROTECTED;
    case DETECTED_EDGE:  break;
  }
  if(is_constrained)
    return are_constraints_protected ? MARKED_PROTECTED : MARKED_CONSTRAINED;
  return is_between_patches ? MARKED_PATCH_BORDER : UNMARKED_EDGE;
}

// What the user says of the edges, by his maps and by labels.
template <typename TriangleMesh, typename GeomTraits, typename Pack>
void read_user_features(Input_mesh<TriangleMesh, GeomTraits>& input, const Pack& pack)
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  typedef boost::graph_traits<TriangleMesh> Graph_traits;
  const TriangleMesh& tm = input.tmesh;
  const auto policies = read_edge_policy_map<typename Graph_traits::edge_descriptor>(pack);
  const auto ecm = choose_parameter(get_parameter(pack, internal_np::edge_is_constrained),
                                    Static_boolean_property_map<typename Graph_traits::edge_descriptor, false>());
  const auto fpm = choose_parameter(get_parameter(pack, internal_np::face_patch),
                                    Constant_property_map<typename Graph_traits::face_descriptor, int>());
  const bool protect = choose_parameter(get_parameter(pack, internal_np::protect_constraints), false);
  for(const typename Graph_traits::face_descriptor f : input.face_descriptors)
  {
    input.side_marks.push_back({{UNMARKED_EDGE, UNMARKED_EDGE, UNMARKED_EDGE}});
    auto h = halfedge(f, tm);
    for(int k = 0; k < 3; ++k, h = next(h, tm))
    {
      const auto o = opposite(h, tm);
      input.side_marks.back()[k] = make_edge_mark(get(policies, edge(h, tm)), get(ecm, edge(h, tm)), protect,
                                                  !is_border(o, tm) && get(fpm, f) != get(fpm, face(o, tm)));
    }
  }
}

// What `geom_traits` is, or the kernel of the points.
template <typename TriangleMesh, typename Pack>
using Traits_of = typename GetGeomTraits<TriangleMesh, Pack>::type;

template <typename GeomTraits, typename TriangleMesh, typename Pack>
Input_mesh<TriangleMesh, GeomTraits> start_reading(const TriangleMesh& tmesh, const Pack& pack)
{
  static_assert(std::is_floating_point<typename GeomTraits::FT>::value,
                "Hermite diffuse surfaces need a kernel with floating point coordinates: "
                "their constructions are least-squares fits, which are not exact");
  return {tmesh, parameters::choose_parameter<GeomTraits>(parameters::get_parameter(pack, internal_np::geom_traits)),
          {}, {}, {}, {}, {}};
}

template <typename TriangleMesh, typename Pack>
auto read_point_map(const TriangleMesh& tmesh, const Pack& pack)
{
  return parameters::choose_parameter(parameters::get_parameter(pack, internal_np::vertex_point),
                                      get_const_property_map(CGAL::vertex_point, tmesh));
}

// the whole mesh; refuses what validate_input.h names
template <typename GeomTraits, typename TriangleMesh, typename Pack>
Input_mesh<TriangleMesh, GeomTraits> read_input(const TriangleMesh& tmesh, const Pack& pack)
{
  Input_mesh<TriangleMesh, GeomTraits> input = start_reading<GeomTraits>(tmesh, pack);
  input.vertex_descriptors.assign(vertices(tmesh).begin(), vertices(tmesh).end());
  input.triangles = read_triangles(tmesh, read_point_map(tmesh, pack), input.traits, input.face_descriptors);
  read_user_features(input, pack);
  input.face_ranks.resize(input.face_descriptors.size());
  std::iota(input.face_ranks.begin(), input.face_ranks.end(), std::size_t(0));
  return input;
}

// the faces within a number of edges of a vertex
template <typename GeomTraits, typename TriangleMesh, typename Pack>
Input_mesh<TriangleMesh, GeomTraits>
read_neighborhood(const typename boost::graph_traits<TriangleMesh>::vertex_descriptor v, const TriangleMesh& tmesh,
                  const int number_of_rings, const Pack& pack)
{
  Input_mesh<TriangleMesh, GeomTraits> input = start_reading<GeomTraits>(tmesh, pack);
  input.triangles = collect_neighborhood(v, tmesh, number_of_rings, read_point_map(tmesh, pack), input.traits,
                                         input.vertex_descriptors, input.face_descriptors);
  read_user_features(input, pack);
  return input;
}

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_READ_INPUT_H
