// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_READ_INPUT_H
#define CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_READ_INPUT_H

#include <CGAL/Hermite_diffuse_remeshing/internal/collect_neighborhood.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/validate_input.h>
#include <CGAL/Hermite_diffuse_remeshing/named_parameters.h>

#include <CGAL/boost/graph/named_params_helper.h>

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
};

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
          {}, {}, {}};
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
  return input;
}

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_READ_INPUT_H
