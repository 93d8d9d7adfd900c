// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_REMESHING_ATTRIBUTE_TRANSFER_H
#define CGAL_HERMITE_DIFFUSE_REMESHING_ATTRIBUTE_TRANSFER_H

#include <CGAL/license/Hermite_diffuse_remeshing.h>

#include <CGAL/Hermite_diffuse_remeshing/internal/interpolate_attribute.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/read_input.h>
#include <CGAL/Hermite_diffuse_remeshing/named_parameters.h>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/boost/graph/properties.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <limits>
#include <queue>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Hermite_diffuse_remeshing {

/*!
 * \ingroup PkgHermiteDiffuseRemeshingRef
 *
 * marks the edges at which a property of the corners of the faces jumps, such as the seams of texture coordinates:
 * features of the remeshing, if the map is given to it as `edge_is_constrained_map`. Other edges keep their mark.
 * Takes time proportional to the number of edges.
 *
 * @tparam TriangleMesh a model of `FaceListGraph` and `EdgeListGraph`
 * @tparam CornerMap a model of `ReadablePropertyMap` with key type `halfedge_descriptor` and a value type that can be
 *         compared for equality: the value of the face of the halfedge at its target
 * @tparam EdgeIsConstrainedMap a model of `WritablePropertyMap` with key type `edge_descriptor` and value type `bool`
 *
 * @param tmesh the mesh
 * @param values the property of the corners
 * @param edge_is_constrained output: `true` at the edges where it jumps
 *
 * @sa `Attribute_transfer`
 */
template <typename TriangleMesh, typename CornerMap, typename EdgeIsConstrainedMap>
void mark_seams(const TriangleMesh& tmesh, const CornerMap& values, EdgeIsConstrainedMap edge_is_constrained)
{
  for(const auto e : edges(tmesh))
    if(internal::is_seam(halfedge(e, tmesh), tmesh, values))
      put(edge_is_constrained, e, true);
}

/*!
 * \ingroup PkgHermiteDiffuseRemeshingRef
 *
 * The class `Attribute_transfer` carries properties of a mesh over to the result of its remeshing, with the output
 * maps `vertex_location_map` and `face_origin_map` of
 * `CGAL::Polygon_mesh_processing::hermite_diffuse_remesh()`.
 *
 * Values are interpolated linearly on the faces of the input. They may be floating point numbers, points and vectors
 * of \cgal or \eigen, anything that can be used like one of these, a `CGAL::IO::Color`, which is interpolated by
 * channels and rounded, or a `std::array` of such types. At a vertex that has stayed at its place the value is the
 * input's, to the last bit. Labels are of any type, and are copied from one element.
 *
 * Elements without a rank below the number of faces of the input in their map are left alone. Isolated vertices get no
 * location from the remeshing: where there are some, a map that holds the largest `std::size_t` before the call leaves
 * them alone.
 *
 * @tparam TriangleMesh a model of `FaceListGraph` and `VertexListGraph` that has dynamic properties
 * @tparam VertexLocationMap a model of `ReadablePropertyMap` with key type `vertex_descriptor` and value type
 *         `std::pair<std::size_t, std::array<double, 3> >`
 * @tparam FaceOriginMap a model of `ReadablePropertyMap` with key type `face_descriptor` and value type `std::size_t`
 *
 * @sa `mark_seams()`
 */
template <typename TriangleMesh, typename VertexLocationMap, typename FaceOriginMap>
class Attribute_transfer
{
  typedef boost::graph_traits<TriangleMesh> Graph_traits;
  typedef typename Graph_traits::halfedge_descriptor halfedge_descriptor;
  typedef typename Graph_traits::face_descriptor face_descriptor;
  typedef typename boost::property_map<TriangleMesh, CGAL::dynamic_face_property_t<int> >::const_type Rank_map;
  typedef internal::Location Location;
  typedef internal::Vector Vector;

  const TriangleMesh& m_input;
  const TriangleMesh& m_output;
  VertexLocationMap m_locations;
  FaceOriginMap m_origins;
  std::vector<face_descriptor> m_faces;               // of the input
  internal::Indexed_triangles m_triangles;
  Rank_map m_rank;

public:
  /*!
   * refers to the mesh as it was before the remeshing, for instance a copy, to the remeshed mesh, and to the maps
   * that the remeshing has written; all must stay as they are while the object is used.
   *
   * @param input a mesh with the faces of the input in the order that they had, and with the same `halfedge(f)`
   * @param output the result
   * @param locations the `vertex_location_map` of the result
   * @param origins the `face_origin_map` of the result
   * @param np an optional sequence of named parameters: `vertex_point_map` and `geom_traits` of the input, as for
   *        `CGAL::Polygon_mesh_processing::hermite_diffuse_remesh()`
   *
   * Takes time proportional to the number of faces of the input.
   *
   * \throw std::invalid_argument if the input has no face, a face that is not a triangle, or a coordinate that is
   *        not finite
   */
  template <typename NamedParameters = parameters::Default_named_parameters>
  Attribute_transfer(const TriangleMesh& input, const TriangleMesh& output, const VertexLocationMap& locations,
                     const FaceOriginMap& origins, const NamedParameters& np = parameters::default_values())
    : m_input(input), m_output(output), m_locations(locations), m_origins(origins)
    , m_rank(get(CGAL::dynamic_face_property_t<int>(), input))
  {
    const auto& pack = internal::pack(np);
    typedef std::decay_t<decltype(pack)> Pack;
    typedef internal::Traits_of<TriangleMesh, Pack> Traits;
    m_triangles = internal::read_triangles(input, internal::read_point_map(input, pack),
                                           parameters::choose_parameter<Traits>(
                                             parameters::get_parameter(pack, internal_np::geom_traits)), m_faces);
    for(std::size_t i = 0; i < m_faces.size(); ++i)
      put(m_rank, m_faces[i], static_cast<int>(i));
  }

  /*!
   * interpolates a property of the vertices.
   *
   * @tparam InputMap a model of `ReadablePropertyMap` with the vertices of the input as keys
   * @tparam OutputMap a model of `WritablePropertyMap` with the vertices of the output as keys, and the same values
   *
   * Takes time proportional to the number of vertices of the output.
   */
  template <typename InputMap, typename OutputMap>
  void transfer_vertex_values(const InputMap& from, OutputMap to) const
  {
    for_each_location([&](const auto v, const Location& location)
    {
      const std::array<halfedge_descriptor, 3> corners = corners_of(location.face);
      put(to, v, interpolated<typename boost::property_traits<InputMap>::value_type>(
        [&](const int k) { return get(from, target(corners[k], m_input)); }, location));
    });
  }

  /*!
   * copies a property of any type from the vertices: of the corners of the face that a vertex lies on, the one with
   * the largest barycentric coordinate counts.
   *
   * @tparam InputMap a model of `ReadablePropertyMap` with the vertices of the input as keys
   * @tparam OutputMap a model of `WritablePropertyMap` with the vertices of the output as keys, and the same values
   *
   * Takes time proportional to the number of vertices of the output.
   */
  template <typename InputMap, typename OutputMap>
  void transfer_vertex_labels(const InputMap& from, OutputMap to) const
  {
    for_each_location([&](const auto v, const Location& location)
    {
      const internal::Barycentric& l = location.coordinates;
      const int k = static_cast<int>(std::max_element(l.begin(), l.end()) - l.begin());
      put(to, v, get(from, target(corners_of(location.face)[k], m_input)));
    });
  }

  /*!
   * copies a property of any type from the faces: of the face that the centroid lies on. If the borders between
   * different labels shall stay where they are, they must be features: give the labels to the remeshing as
   * `face_patch_map`, too.
   *
   * @tparam InputMap a model of `ReadablePropertyMap` with the faces of the input as keys
   * @tparam OutputMap a model of `WritablePropertyMap` with the faces of the output as keys, and the same values
   *
   * Takes time proportional to the number of faces of the output.
   */
  template <typename InputMap, typename OutputMap>
  void transfer_face_values(const InputMap& from, OutputMap to) const
  {
    for(const face_descriptor f : faces(m_output))
      if(get(m_origins, f) < m_faces.size())
        put(to, f, get(from, m_faces[get(m_origins, f)]));
  }

  /*!
   * interpolates a property of the corners of the faces, such as texture coordinates. Where the values of two faces
   * differ at their edge there is a seam; no value crosses it. The seams must have been features of the remeshing,
   * see `mark_seams()`.
   *
   * @tparam InputMap a model of `ReadablePropertyMap` with the halfedges of the input as keys, and values that can
   *         be compared for equality: the value of the face of the halfedge at its target
   * @tparam OutputMap a model of `WritablePropertyMap` with the halfedges of the output as keys, and the same values
   *
   * Takes time proportional to the number of faces of input and output, and to the number of faces of the input that
   * the faces of the output at seams cover.
   */
  template <typename InputMap, typename OutputMap>
  void transfer_corner_values(const InputMap& from, OutputMap to) const
  {
    const Chart_walk walk(*this, from);
    for(const face_descriptor f : faces(m_output))
    {
      const std::size_t origin = get(m_origins, f);
      if(origin >= m_faces.size())
        continue;
      for(const halfedge_descriptor h : CGAL::halfedges_around_face(halfedge(f, m_output), m_output))
      {
        const std::pair<std::size_t, std::array<double, 3> > location = get(m_locations, target(h, m_output));
        if(location.first >= m_faces.size())
          continue;
        const Location inside = walk.seen_from(static_cast<int>(origin),
                                               Location{static_cast<int>(location.first), location.second});
        const std::array<halfedge_descriptor, 3> corners = corners_of(inside.face);
        put(to, h, interpolated<typename boost::property_traits<InputMap>::value_type>(
          [&](const int k) { return get(from, corners[k]); }, inside));
      }
    }
  }

private:
  // the halfedges of a face whose targets are its corners
  std::array<halfedge_descriptor, 3> corners_of(const int face) const
  {
    const halfedge_descriptor h = halfedge(m_faces[face], m_input);
    return {{prev(h, m_input), h, next(h, m_input)}};
  }

  template <typename Visit>
  void for_each_location(const Visit& visit) const
  {
    for(const auto v : vertices(m_output))
    {
      const std::pair<std::size_t, std::array<double, 3> > location = get(m_locations, v);
      if(location.first < m_faces.size())
        visit(v, Location{static_cast<int>(location.first), location.second});
    }
  }

  template <typename Value, typename At>
  static Value interpolated(const At& at, const Location& location)
  {
    return internal::Linear_interpolation<Value>()(at(0), at(1), at(2), location.coordinates);
  }

  // A place on a seam lies in several charts, and has another value in each of them. The face of the output that asks
  // has its centroid on one: the walk goes from there to the place without crossing a seam, on the shortest way over
  // centroids of faces, since a chart may meet itself at a seam.
  class Chart_walk
  {
    const Attribute_transfer& m_transfer;
    std::vector<std::array<bool, 3> > m_is_seam;      // side k of a face goes from its corner k on
    mutable std::vector<double> m_distance;           // infinite but during a walk

  public:
    template <typename CornerMap>
    Chart_walk(const Attribute_transfer& transfer, const CornerMap& values)
      : m_transfer(transfer)
      , m_distance(transfer.m_faces.size(), std::numeric_limits<double>::infinity())
    {
      for(const face_descriptor f : transfer.m_faces)
      {
        halfedge_descriptor h = halfedge(f, transfer.m_input);
        m_is_seam.push_back({});
        for(int k = 0; k < 3; ++k, h = next(h, transfer.m_input))
          m_is_seam.back()[k] = internal::is_seam(h, transfer.m_input, values);
      }
    }

    // the location in the chart that face `start` belongs to
    Location seen_from(const int start, const Location& location) const
    {
      const std::vector<Location> candidates = copies(location);
      if(candidates.size() == 1)
        return location;

      typedef std::pair<double, int> Entry;                         // distance, face
      std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry> > queue;
      std::vector<int> reached(1, start);
      m_distance[start] = 0.;
      queue.push(Entry(0., start));
      Location result = location;
      while(!queue.empty())
      {
        const Entry entry = queue.top();
        queue.pop();
        const auto found = std::find_if(candidates.begin(), candidates.end(),
                                        [&](const Location& candidate) { return candidate.face == entry.second; });
        if(found != candidates.end())
        {
          result = *found;
          break;
        }
        if(entry.first > m_distance[entry.second])
          continue;
        for(int k = 0; k < 3; ++k)
        {
          const int f = neighbor(entry.second, k);
          if(f == -1 || m_is_seam[entry.second][k])
            continue;
          const double distance = entry.first + (centroid(f) - centroid(entry.second)).norm();
          if(!(distance < m_distance[f]))
            continue;
          m_distance[f] = distance;
          reached.push_back(f);
          queue.push(Entry(distance, f));
        }
      }
      for(const int f : reached)
        m_distance[f] = std::numeric_limits<double>::infinity();
      return result;
    }

  private:
    halfedge_descriptor side(const int f, const int k) const
    {
      return m_transfer.corners_of(f)[internal::next(k)];
    }

    // across side k; -1: none
    int neighbor(const int f, const int k) const
    {
      const halfedge_descriptor o = opposite(side(f, k), m_transfer.m_input);
      return CGAL::is_border(o, m_transfer.m_input)
           ? -1 : get(m_transfer.m_rank, face(o, m_transfer.m_input));
    }

    Vector centroid(const int f) const
    {
      const internal::Indexed_triangles& t = m_transfer.m_triangles;
      return (t.point(f, 0) + t.point(f, 1) + t.point(f, 2)) / 3.;
    }

    int corner(const int f, const int vertex) const
    {
      const std::array<int, 3>& t = m_transfer.m_triangles.triangles[f];
      return static_cast<int>(std::find(t.begin(), t.end(), vertex) - t.begin());
    }

    // the same place seen from all faces that have it, if a seam is between them; else as it is
    std::vector<Location> copies(const Location& location) const
    {
      const internal::Barycentric& l = location.coordinates;
      const std::array<int, 3>& t = m_transfer.m_triangles.triangles[location.face];
      std::vector<Location> result(1, location);
      const auto apex = std::find_if(l.begin(), l.end(), [](const double c) { return c >= 1.; });
      if(apex != l.end())
      {
        const int vertex = t[apex - l.begin()];
        bool is_on_seam = false;
        const halfedge_descriptor h = m_transfer.corners_of(location.face)[apex - l.begin()];
        for(const halfedge_descriptor g : CGAL::halfedges_around_target(h, m_transfer.m_input))
        {
          if(CGAL::is_border(g, m_transfer.m_input))
            continue;
          Location copy;
          copy.face = get(m_transfer.m_rank, face(g, m_transfer.m_input));
          const int k = corner(copy.face, vertex);
          is_on_seam = is_on_seam || m_is_seam[copy.face][k];
          copy.coordinates.fill(0.);
          copy.coordinates[k] = 1.;
          if(copy.face != location.face)
            result.push_back(copy);
        }
        if(!is_on_seam)
          result.resize(1);
        return result;
      }
      const auto zero = std::find_if(l.begin(), l.end(), [](const double c) { return c <= 0.; });
      if(zero == l.end())
        return result;
      const int k = internal::next(static_cast<int>(zero - l.begin()));
      const int f = neighbor(location.face, k);
      if(f == -1 || !m_is_seam[location.face][k])
        return result;
      Location copy;
      copy.face = f;
      copy.coordinates.fill(0.);
      for(const int i : {k, internal::next(k)})
        copy.coordinates[corner(f, t[i])] = l[i];
      result.push_back(copy);
      return result;
    }
  };
};

} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_ATTRIBUTE_TRANSFER_H
