// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_WRITE_OUTPUT_MAPS_H
#define CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_WRITE_OUTPUT_MAPS_H

#include <CGAL/Hermite_diffuse_remeshing/Feature_classes.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Former_faces.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Indexed_triangles.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/read_size_options.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Sizing/Size_sources.h>
#include <CGAL/Hermite_diffuse_remeshing/named_parameters.h>

#include <CGAL/property_map.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Hermite_diffuse_remeshing {
namespace internal {

// Writes where the vertices lie on the input, their sizes, the classes of the edges and the faces' origins and
// deviations. The reference is the input after the repairs.
template <typename Mesh, typename Deviation, typename Input, typename Pack>
void write_output_maps(const Mesh& mesh, const std::vector<Deviation>& deviations, const Input& input,
                       const Former_faces& former_faces, const Pack& pack)
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  typedef typename Mesh::vertex_descriptor vertex_descriptor;
  typedef typename Mesh::edge_descriptor edge_descriptor;
  typedef typename Mesh::face_descriptor face_descriptor;
  const auto location_map = choose_parameter(get_parameter(pack, internal_np::vertex_location_map),
    Constant_property_map<vertex_descriptor, std::pair<std::size_t, Barycentric> >());
  const auto size_map = choose_parameter(get_parameter(pack, internal_np::vertex_size_map),
    Constant_property_map<vertex_descriptor, double>());
  const auto origin_map = choose_parameter(get_parameter(pack, internal_np::face_origin_map),
    Constant_property_map<face_descriptor, std::size_t>());
  const auto deviation_map = choose_parameter(get_parameter(pack, internal_np::face_deviation_map),
    Constant_property_map<face_descriptor, double>());
  const auto class_map = choose_parameter(get_parameter(pack, internal_np::edge_class_map),
    Constant_property_map<edge_descriptor, Edge_class>());

  // what nobody asks for takes no time: after a stop the user waits for this
  if constexpr(is_given<Pack, internal_np::vertex_location_map_t>() || is_given<Pack, internal_np::vertex_size_map_t>())
    for(const vertex_descriptor v : vertices(mesh.tmesh()))
      if(mesh.index(v) != -1)
      {
        const Location& location = mesh.data(v).site.location;
        put(location_map, v, former_faces(location, input.triangles, input.face_ranks));
        put(size_map, v, mesh.size(v));
      }
  if constexpr(is_given<Pack, internal_np::edge_class_map_t>())
    for(const edge_descriptor e : edges(mesh.tmesh()))
      put(class_map, e, mesh.edge_class(halfedge(e, mesh.tmesh())));
  if constexpr(is_given<Pack, internal_np::face_origin_map_t>())
  {
    for(std::size_t i = 0; i < input.face_descriptors.size(); ++i)
      if(!mesh.is_reference_face_remeshed(static_cast<int>(i)))
        put(origin_map, input.face_descriptors[i], input.face_ranks[i]);
    for(const face_descriptor f : faces(mesh.tmesh()))
      if(mesh.is_remeshed(f))
        put(origin_map, f, input.face_ranks[mesh.face_of_reference(f)]);
  }
  for(const Deviation& entry : deviations)
    put(deviation_map, entry.face, entry.deviation);
}

// Of a mesh that a stop came too early to change, or to repair: every vertex and every face is where it was. There is no
// more to tell.
template <typename TriangleMesh, typename Pack>
void write_output_maps_of_input(const TriangleMesh& tmesh, const Pack& pack)
{
  using parameters::get_parameter;
  CGAL_USE(pack);
  std::size_t rank = 0;
  for(const auto f : faces(tmesh))
  {
    if constexpr(is_given<Pack, internal_np::face_origin_map_t>())
      put(get_parameter(pack, internal_np::face_origin_map), f, rank);
    if constexpr(is_given<Pack, internal_np::vertex_location_map_t>())
    {
      auto h = halfedge(f, tmesh);
      for(int k = 0; k < 3; ++k, h = next(h, tmesh))
        put(get_parameter(pack, internal_np::vertex_location_map), source(h, tmesh),
            std::make_pair(rank, location_of_corner(k).coordinates));
    }
    ++rank;
  }
}

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_WRITE_OUTPUT_MAPS_H
