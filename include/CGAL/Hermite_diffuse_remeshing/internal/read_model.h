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

// The model of a mesh, or of a part of one, that was read as indexed triangles: face i is `face_descriptors[i]`,
// vertex i `vertex_descriptors[i]`.
template <typename ConcurrencyTag = Sequential_tag, typename TriangleMesh, typename GeomTraits, typename Pack>
std::unique_ptr<Input_model>
read_model(const TriangleMesh& tmesh, const Indexed_triangles& triangles,
           const std::vector<typename boost::graph_traits<TriangleMesh>::vertex_descriptor>& vertex_descriptors,
           const std::vector<typename boost::graph_traits<TriangleMesh>::face_descriptor>& face_descriptors,
           const GeomTraits& traits, const Pack& pack)
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  typedef boost::graph_traits<TriangleMesh> Graph_traits;
  typedef typename Graph_traits::vertex_descriptor vertex_descriptor;
  typedef typename Graph_traits::edge_descriptor edge_descriptor;
  typedef typename Graph_traits::face_descriptor face_descriptor;

  const auto ecm = choose_parameter(get_parameter(pack, internal_np::edge_is_constrained),
                                    Static_boolean_property_map<edge_descriptor, false>());
  const auto vcm = choose_parameter(get_parameter(pack, internal_np::vertex_is_constrained),
                                    Static_boolean_property_map<vertex_descriptor, false>());
  const auto fpm = choose_parameter(get_parameter(pack, internal_np::face_patch),
                                    Constant_property_map<face_descriptor, int>());
  const Is_user_edge<TriangleMesh, std::decay_t<decltype(ecm)>, std::decay_t<decltype(fpm)> >
    is_user_edge{tmesh, face_descriptors, ecm, fpm};
  Model_options options = read_model_options(pack);
  options.is_parallel = is_parallel<ConcurrencyTag>();
  return std::unique_ptr<Input_model>(
    new Input_model(triangles, read_feature_options(pack), options, is_user_edge,
                    [&](const int v) { return get(vcm, vertex_descriptors[v]); },
                    read_vertex_normals(vertex_descriptors, traits, pack)));
}

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_READ_MODEL_H
