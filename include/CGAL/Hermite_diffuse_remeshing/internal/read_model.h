// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_READ_MODEL_H
#define CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_READ_MODEL_H

#include <CGAL/Hermite_diffuse_remeshing/internal/read_parameters.h>

#include <memory>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Hermite_diffuse_remeshing {
namespace internal {

// Unit normals that the user gives for vertices, zero where he gives none; no vector at all without
// the parameter.
template <typename GeomTraits, typename VertexRange, typename Pack>
std::vector<Vector> read_vertex_normals(const VertexRange& vertex_descriptors, const GeomTraits& traits,
                                        const Pack& pack)
{
  std::vector<Vector> normals;
  if constexpr(!parameters::is_default_parameter<Pack, internal_np::vertex_normal_map_t>::value)
  {
    const auto map = parameters::get_parameter(pack, internal_np::vertex_normal_map);
    const auto x = traits.compute_x_3_object();
    const auto y = traits.compute_y_3_object();
    const auto z = traits.compute_z_3_object();
    normals.reserve(vertex_descriptors.size());
    for(const auto v : vertex_descriptors)
    {
      const auto& n = get(map, v);
      const Vector normal(x(n), y(n), z(n));
      if(!normal.allFinite())
        refuse("the normal of vertex " + std::to_string(normals.size()), "not a finite vector",
               "a normal must be finite, or zero where it is not known");
      normals.push_back(normal.stableNormalized());
    }
  }
  CGAL_USE(vertex_descriptors);
  CGAL_USE(traits);
  CGAL_USE(pack);
  return normals;
}

// What the user says of the edges.
template <typename TriangleMesh, typename Pack>
auto read_edge_marks(const TriangleMesh& tmesh,
                     const std::vector<typename boost::graph_traits<TriangleMesh>::face_descriptor>& face_descriptors,
                     const Pack& pack)
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  typedef typename boost::graph_traits<TriangleMesh>::edge_descriptor edge_descriptor;
  typedef typename boost::graph_traits<TriangleMesh>::face_descriptor face_descriptor;
  const auto policies = read_edge_policy_map<edge_descriptor>(pack);
  const auto ecm = choose_parameter(get_parameter(pack, internal_np::edge_is_constrained),
                                    Static_boolean_property_map<edge_descriptor, false>());
  const auto fpm = choose_parameter(get_parameter(pack, internal_np::face_patch),
                                    Constant_property_map<face_descriptor, int>());
  return Edge_marks<TriangleMesh, std::decay_t<decltype(policies)>, std::decay_t<decltype(ecm)>,
                    std::decay_t<decltype(fpm)> >{tmesh, face_descriptors, policies, ecm, fpm};
}

// The vertices that the user wants to be corners.
template <typename VertexDescriptor, typename Pack>
auto read_vertex_marks(const std::vector<VertexDescriptor>& vertex_descriptors, const Pack& pack)
{
  const auto vcm = parameters::choose_parameter(
    parameters::get_parameter(pack, internal_np::vertex_is_constrained),
    Static_boolean_property_map<VertexDescriptor, false>());
  return [&vertex_descriptors, vcm](const int v) -> bool { return get(vcm, vertex_descriptors[v]); };
}

// The model of a mesh, or of a part of one, that was read as indexed triangles: face i is `face_descriptors[i]`,
// vertex i `vertex_descriptors[i]`.
template <typename TriangleMesh, typename GeomTraits, typename Pack>
std::unique_ptr<Input_model>
read_model(const TriangleMesh& tmesh, const Indexed_triangles& triangles,
           const std::vector<typename boost::graph_traits<TriangleMesh>::vertex_descriptor>& vertex_descriptors,
           const std::vector<typename boost::graph_traits<TriangleMesh>::face_descriptor>& face_descriptors,
           const GeomTraits& traits, const Pack& pack)
{
  return std::unique_ptr<Input_model>(
    new Input_model(triangles, read_feature_options(pack), read_model_options(pack),
                    read_edge_marks(tmesh, face_descriptors, pack), read_vertex_marks(vertex_descriptors, pack),
                    read_vertex_normals(vertex_descriptors, traits, pack)));
}

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_READ_MODEL_H
