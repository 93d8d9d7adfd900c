// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_POLYGON_MESH_PROCESSING_HERMITE_DIFFUSE_REMESH_TRIANGLE_SOUP_H
#define CGAL_POLYGON_MESH_PROCESSING_HERMITE_DIFFUSE_REMESH_TRIANGLE_SOUP_H

#include <CGAL/Hermite_diffuse_remeshing/Default_remeshing_visitor.h>
#include <CGAL/Hermite_diffuse_remeshing/Remeshing_report.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/read_parameters.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/read_size_options.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/remesh_surface.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/soup_mesh.h>
#include <CGAL/Hermite_diffuse_remeshing/named_parameters.h>

#include <CGAL/Kernel_traits.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <limits>
#include <memory>
#include <numeric>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Hermite_diffuse_remeshing {
namespace internal {

// What the user says of the edges of a soup.
template <typename EdgePolicyMap, typename EdgeIsConstrainedMap>
struct Soup_edge_policies
{
  EdgePolicyMap policies;
  EdgeIsConstrainedMap is_constrained;
  bool are_constraints_protected;

  typedef std::pair<std::size_t, std::size_t> Edge;

  static Edge edge(const int a, const int b) { return Edge((std::min)(a, b), (std::max)(a, b)); }

  Edge_mark mark(const int a, const int b) const
  {
    const Edge_policy policy = get(policies, edge(a, b));
    if(policy != DETECTED_EDGE)
      return policy == FREE_EDGE ? MARKED_FREE : MARKED_FEATURE;
    return get(is_constrained, edge(a, b)) ? MARKED_FEATURE : UNMARKED_EDGE;
  }

  bool is_protected(const int a, const int b) const
  {
    const Edge_policy policy = get(policies, edge(a, b));
    return policy == DETECTED_EDGE ? are_constraints_protected && get(is_constrained, edge(a, b))
                                   : policy == PROTECTED_EDGE;
  }
};

// The marks of the edges as the classification asks for them.
template <typename Policies, typename FacePatchMap>
std::vector<std::array<Edge_mark, 3> >
mark_soup_edges(const Indexed_triangles& surface, const Policies& policies, const FacePatchMap& labels)
{
  const Edge_table edges(surface);
  std::vector<std::array<Edge_mark, 3> > result(surface.number_of_faces());
  for(int e = 0; e < edges.number_of_edges(); ++e)
  {
    Edge_mark mark = policies.mark(edges.vertices(e)[0], edges.vertices(e)[1]);
    if(mark == UNMARKED_EDGE && edges.number_of_sides(e) == 2
       && get(labels, std::size_t(edges.side(e, 0).face)) != get(labels, std::size_t(edges.side(e, 1).face)))
      mark = MARKED_PATCH_BORDER;
    for(int i = 0; i < edges.number_of_sides(e); ++i)
      result[edges.side(e, i).face][edges.side(e, i).side] = mark;
  }
  return result;
}

// Writes the mesh back as a soup, the copies of a vertex as one, and what is known of vertices and triangles.
template <typename Mesh, typename Deviation, typename LabelOfFace, typename FacePatchMap, typename Pack,
          typename PointRange, typename TriangleRange>
void write_soup(const Mesh& mesh, const std::vector<Deviation>& deviations, const std::vector<char>& is_turned,
                const LabelOfFace& label_of_face, const FacePatchMap& labels, const Pack& pack,
                PointRange& points, TriangleRange& triangles)
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
    Location location = mesh.site(v).location;
    if(is_turned[location.face])
      std::swap(location.coordinates[1], location.coordinates[2]);
    put(location_map, i, std::make_pair(std::size_t(location.face), location.coordinates));
    put(size_map, i, mesh.size(v));
  }
  // in the order of faces(tm)
  for(const Deviation& entry : deviations)
  {
    const std::size_t i = new_triangles.size();
    const auto h = halfedge(entry.face, tm);
    const std::array<std::size_t, 3> corners = {{rank[mesh.index(source(h, tm))], rank[mesh.index(target(h, tm))],
                                                 rank[mesh.index(target(next(h, tm), tm))]}};
    typename TriangleRange::value_type triangle{corners[0], corners[1], corners[2]};
    new_triangles.push_back(triangle);
    put(labels, i, get(label_of_face, entry.face));
    put(origin_map, i, std::size_t(mesh.hint(entry.face)));
    put(deviation_map, i, entry.deviation);
  }
  points = std::move(new_points);
  triangles = std::move(new_triangles);
}

} // namespace internal
} // namespace Hermite_diffuse_remeshing

namespace Polygon_mesh_processing {

/*!
 * \ingroup PkgHermiteDiffuseRemeshingRef
 *
 * remeshes a soup of triangles, which may be non-manifold: edges with any number of triangles, vertices where sheets
 * touch, open and closed parts, triangles that are not coherently oriented, sheets that cannot be oriented. Apart
 * from that it does the same as `hermite_diffuse_remesh()`.
 *
 * The soup is cut into sheets along its non-manifold edges. These edges, the junctions, are feature edges: they form
 * curves between corners, each with one spline and one sampling, which all its sheets share. They are split,
 * collapsed and moved like the edges and vertices of other curves, in all the sheets at once, so that the result
 * conforms: along a junction as many triangles meet at every edge as in the input, and nowhere else do more than two.
 * The size is one function on the whole surface, and its gradation runs across the junctions.
 *
 * Triangles are joined by the indices of their vertices, not by their coordinates.
 * `CGAL::Polygon_mesh_processing::repair_polygon_soup()` merges points that coincide. Those that no triangle uses
 * are not in the result. In each sheet the orientation of most of its triangles is given to all.
 *
 * @tparam PointRange a model of `RandomAccessContainer` and `BackInsertionSequence` whose value type is the point type
 * @tparam TriangleRange a model of `BackInsertionSequence` whose value type is a model of
 *         `RandomAccessContainer` of `std::size_t` that can be constructed from a list of three indices:
 *         `std::vector<std::size_t>` or `std::array<std::size_t, 3>`
 * @tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
 *
 * @param points the points, which are replaced
 * @param triangles the triangles as indices into `points`, which are replaced
 * @param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{approximation_error, sagitta, elements_per_circle, angle_per_element, sagitta_over_length,
 *     maximum_deviation, minimum_edge_length, maximum_edge_length, size_field, gradation, sharp_dihedral_angle,
 *     corner_angle, apex_angular_defect, polynomial_degree, hermite_weight, normal_estimation, surface_model,
 *     number_of_iterations, maximum_number_of_faces, protect_constraints}
 *     \cgalParamDescription{as for `hermite_diffuse_remesh()`; a size field that asks for a face gets the index of a
 *       triangle}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{face_patch_map}
 *     \cgalParamDescription{labels of the triangles, for instance the two materials at its sides. Edges between two
 *       triangles of different labels are features. It is read for the triangles of the input and written for those of the
 *       result, which may be more.}
 *     \cgalParamType{a model of `ReadWritePropertyMap` with key type `std::size_t`, for instance
 *       `boost::associative_property_map<std::map<std::size_t, int> >`, and a value type that can be compared}
 *     \cgalParamDefault{one label}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{edge_is_constrained_map}
 *     \cgalParamDescription{edges that are features whatever their angle; not kept up to date}
 *     \cgalParamType{a model of `ReadablePropertyMap` with key type `std::pair<std::size_t, std::size_t>`, the indices
 *       of the ends with the smaller one first, and value type `bool`}
 *     \cgalParamDefault{no edge}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{edge_policy_map}
 *     \cgalParamDescription{a decision on each edge, which goes before the rules of the detection; not kept up to
 *       date. A junction cannot be free.}
 *     \cgalParamType{a model of `ReadablePropertyMap` with the same key type and value type
 *       `CGAL::Hermite_diffuse_remeshing::Edge_policy`}
 *     \cgalParamDefault{`CGAL::Hermite_diffuse_remeshing::DETECTED_EDGE` for all edges}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{vertex_is_constrained_map}
 *     \cgalParamDescription{points that are corners}
 *     \cgalParamType{a model of `ReadablePropertyMap` with key type `std::size_t` and value type `bool`}
 *     \cgalParamDefault{no point}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{visitor}
 *     \cgalParamDescription{is told about stages and operations and may stop the remeshing. The elements that it
 *       is given are those of the mesh of the sheets; an operation at a junction is reported once per sheet.}
 *     \cgalParamType{a model of `HermiteDiffuseRemeshingVisitor` for `CGAL::Surface_mesh<Point>`, by value or
 *       by `std::ref`}
 *     \cgalParamDefault{`CGAL::Hermite_diffuse_remeshing::Default_remeshing_visitor<CGAL::Surface_mesh<Point> >`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{vertex_location_map, vertex_size_map, face_origin_map, face_deviation_map}
 *     \cgalParamDescription{output: as for `hermite_diffuse_remesh()`, with indices into the new points and triangles as
 *       keys. A location is the index of a triangle of the input and the coordinates with respect to its corners.}
 *     \cgalParamType{models of `WritablePropertyMap` with key type `std::size_t`}
 *     \cgalParamDefault{none}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{geom_traits}
 *     \cgalParamDescription{an instance of a geometric traits class}
 *     \cgalParamType{a model of `HermiteDiffuseRemeshingTraits`}
 *     \cgalParamDefault{a \cgal kernel deduced from the point type, using `CGAL::Kernel_traits`}
 *   \cgalParamNEnd
 * \cgalNamedParamsEnd
 *
 * @return what was done, and which promises were kept. `CGAL::SM_Face_index(i)` in it stands for triangle `i` of the
 *         result.
 *
 * \throw std::invalid_argument if there is no triangle, if a polygon is not a triangle or names a vertex twice or one
 *        that is not there, if a coordinate is not finite, or if a parameter is out of its range. The message
 *        names it, and the soup is unchanged.
 *
 * @sa `hermite_diffuse_remesh()`
 */
template <typename PointRange, typename TriangleRange,
          typename NamedParameters = parameters::Default_named_parameters>
Hermite_diffuse_remeshing::Remeshing_report<Surface_mesh<typename PointRange::value_type> >
hermite_diffuse_remesh_triangle_soup(PointRange& points, TriangleRange& triangles,
                                     const NamedParameters& np = parameters::default_values())
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  using parameters::get_parameter_reference;
  using namespace CGAL::Hermite_diffuse_remeshing;
  using namespace CGAL::Hermite_diffuse_remeshing::internal;

  const auto& pack = CGAL::Hermite_diffuse_remeshing::internal::pack(np);
  typedef std::decay_t<decltype(pack)> Pack;
  typedef typename PointRange::value_type Point;
  typedef Surface_mesh<Point> Mesh;
  typedef typename boost::graph_traits<Mesh>::halfedge_descriptor halfedge_descriptor;
  typedef typename boost::graph_traits<Mesh>::edge_descriptor edge_descriptor;
  typedef typename boost::graph_traits<Mesh>::face_descriptor face_descriptor;
  typedef std::pair<std::size_t, std::size_t> Edge;
  typedef typename internal_np::Lookup_named_param_def<internal_np::geom_traits_t, Pack,
    typename Kernel_traits<Point>::Kernel>::type GT;
  static_assert(std::is_floating_point<typename GT::FT>::value,
                "hermite_diffuse_remesh_triangle_soup() needs a kernel with floating point coordinates");
  const GT gt = choose_parameter<GT>(get_parameter(pack, internal_np::geom_traits));

  const auto labels = choose_parameter(get_parameter(pack, internal_np::face_patch),
                                       Constant_property_map<std::size_t, int>());
  typedef typename boost::property_traits<std::decay_t<decltype(labels)> >::value_type Label;
  const auto ecm = choose_parameter(get_parameter(pack, internal_np::edge_is_constrained),
                                    Static_boolean_property_map<Edge, false>());
  const auto vcm = choose_parameter(get_parameter(pack, internal_np::vertex_is_constrained),
                                    Static_boolean_property_map<std::size_t, false>());
  const auto policy_map = read_edge_policy_map<Edge>(pack);
  const Soup_edge_policies<std::decay_t<decltype(policy_map)>, std::decay_t<decltype(ecm)> > policies{
    policy_map, ecm, choose_parameter(get_parameter(pack, internal_np::protect_constraints), false)};

  typedef Default_remeshing_visitor<Mesh> Default_visitor;
  typedef typename internal_np::Lookup_named_param_def<internal_np::visitor_t, Pack, Default_visitor>::reference
    Visitor_reference;
  typedef std::remove_reference_t<Visitor_reference> Visitor;
  Default_visitor default_visitor;
  Visitor_reference visitor = choose_parameter(get_parameter_reference(pack, internal_np::visitor), default_visitor);

  // everything is read and checked before the first change
  const double iterations = choose_parameter(get_parameter(pack, internal_np::number_of_iterations), 10);
  check_parameter("number_of_iterations", iterations, 1, (std::numeric_limits<int>::max)());
  const std::size_t maximum_number_of_faces =
    choose_parameter(get_parameter(pack, internal_np::maximum_number_of_faces),
                     std::size_t((std::numeric_limits<int>::max)()));
  const Feature_options feature_options = read_feature_options(pack);
  const Model_options model_options = read_model_options(pack);
  Indexed_triangles surface = read_soup(points, triangles, gt);
  std::vector<std::size_t> triangle_indices(surface.number_of_faces());
  std::iota(triangle_indices.begin(), triangle_indices.end(), std::size_t(0));
  const Size_options size_options = read_size_options(pack, gt, model_diameter(surface), triangle_indices);

  const std::vector<char> is_turned = orient_sheets(surface);
  const std::vector<std::array<Edge_mark, 3> > marks = mark_soup_edges(surface, policies, labels);
  Mesh mesh;
  const std::vector<int> vertices_of_soup = make_soup_mesh(surface, gt, mesh);
  const std::vector<face_descriptor> face_descriptors(faces(mesh).begin(), faces(mesh).end());
  auto label_of_face = mesh.template add_property_map<face_descriptor, Label>("f:label").first;
  for(const face_descriptor f : face_descriptors)
    put(label_of_face, f, get(labels, std::size_t(f)));

  typedef typename boost::property_map<Mesh, CGAL::vertex_point_t>::type VPM;
  typedef Static_boolean_property_map<edge_descriptor, false> ECM;
  const User_mesh<Mesh, VPM, ECM, std::decay_t<decltype(label_of_face)>, GT, Visitor>
    user{mesh, get(CGAL::vertex_point, mesh), ECM(), label_of_face, gt, visitor};
  auto report = remesh_surface(user, face_descriptors, std::vector<char>(face_descriptors.size(), true),
    Remeshing_options{size_options, static_cast<int>(iterations), maximum_number_of_faces},
    [&]
    {
      return std::unique_ptr<Input_model>(
        new Input_model(surface, feature_options, model_options,
                        [&](const int f, const int side) { return marks[f][side]; },
                        [&](const int v) -> bool { return get(vcm, std::size_t(v)); }));
    },
    [&](const halfedge_descriptor h)
    {
      return policies.is_protected(vertices_of_soup[std::size_t(source(h, mesh))],
                                   vertices_of_soup[std::size_t(target(h, mesh))]);
    },
    [&](const auto& working_mesh, const auto& deviations)
    { write_soup(working_mesh, deviations, is_turned, label_of_face, labels, pack, points, triangles); });

  report.number_of_vertices = points.size();
  std::vector<std::size_t> rank(mesh.num_faces());
  std::size_t number = 0;
  for(const face_descriptor f : faces(mesh))
    rank[std::size_t(f)] = number++;
  for(face_descriptor& f : report.faces_above_maximum_deviation)
    f = face_descriptor(static_cast<typename Mesh::size_type>(rank[std::size_t(f)]));
  return report;
}

} // namespace Polygon_mesh_processing
} // namespace CGAL

#endif // CGAL_POLYGON_MESH_PROCESSING_HERMITE_DIFFUSE_REMESH_TRIANGLE_SOUP_H
