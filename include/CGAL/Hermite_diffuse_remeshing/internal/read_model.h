// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_READ_MODEL_H
#define CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_READ_MODEL_H

#include <CGAL/Hermite_diffuse_remeshing/internal/read_input.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/read_parameters.h>

#include <algorithm>
#include <iterator>
#include <memory>
#include <string>
#include <vector>

namespace CGAL {
namespace Hermite_diffuse_remeshing {
namespace internal {

// Unit normals that the user gives for vertices, zero where he gives none; no vector at all without
// the parameter. `rank_of(vertex)` names a vertex to the user.
template <typename GeomTraits, typename VertexRange, typename Pack, typename RankOf>
std::vector<Vector> read_vertex_normals(const VertexRange& vertex_descriptors, const GeomTraits& traits,
                                        const Pack& pack, const RankOf& rank_of)
{
  std::vector<Vector> normals;
  if constexpr(!parameters::is_default_parameter<Pack, internal_np::vertex_normal_map_t>::value)
  {
    const auto map = parameters::get_parameter(pack, internal_np::vertex_normal_map);
    const Point_reader<GeomTraits> read(traits);
    normals.reserve(vertex_descriptors.size());
    for(const auto v : vertex_descriptors)
    {
      const Vector normal = read(get(map, v));
      if(!normal.allFinite())
        refuse("the normal of vertex " + std::to_string(rank_of(v)), "not a finite vector",
               "a normal must be finite, or zero where it is not known");
      normals.push_back(normal.stableNormalized());
    }
  }
  CGAL_USE(vertex_descriptors);
  CGAL_USE(traits);
  CGAL_USE(pack);
  CGAL_USE(rank_of);
  return normals;
}

// `Model` is `Input_model`, or `Input_surface` where no points are to be found
template <typename ConcurrencyTag = Sequential_tag, typename Model = Input_model, typename TriangleMesh,
          typename GeomTraits, typename Pack>
std::unique_ptr<Model> read_model(const Input_mesh<TriangleMesh, GeomTraits>& input, const Pack& pack,
                                  const Progress& progress = Progress())
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  typedef boost::graph_traits<TriangleMesh> Graph_traits;
  typedef typename Graph_traits::vertex_descriptor vertex_descriptor;

  const auto vcm = choose_parameter(get_parameter(pack, internal_np::vertex_is_constrained),
                                    Static_boolean_property_map<vertex_descriptor, false>());
  checked_diameter(input.triangles);
  const auto rank_of = [&](const vertex_descriptor v)
  {
    const auto all = vertices(input.tmesh);
    return std::distance(all.begin(), std::find(all.begin(), all.end(), v));
  };
  Model_options options = read_model_options(pack);
  options.is_parallel = is_parallel<ConcurrencyTag>();
  return make_model<Model>(input.triangles, read_feature_options(pack), options,
                           [&](const int f, const int side) { return input.side_marks[f][side]; },
                           [&](const int v) { return get(vcm, input.vertex_descriptors[v]); },
                           read_vertex_normals(input.vertex_descriptors, input.traits, pack, rank_of), progress);
}

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_READ_MODEL_H
