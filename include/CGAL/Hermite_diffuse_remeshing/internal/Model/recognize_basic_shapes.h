// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_MODEL_RECOGNIZE_BASIC_SHAPES_H
#define CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_MODEL_RECOGNIZE_BASIC_SHAPES_H

#include <CGAL/Hermite_diffuse_remeshing/internal/Model/Node_curvature_fitter.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Model/fit_basic_shape.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Hermite_diffuse_remeshing {
namespace internal {

// Splits a surface into regions that are basic surfaces, the types of which are tried one after the other, and connected
// rests.
// A region grows from the neighbourhood of a node, from face to face and never across a feature, as
// long as the corners of the faces are on the shape, which is then fitted again to all of them.
class Shape_recognizer
{
  const Reference_surface& m_surface;
  const double m_tolerance;
  Node_curvature_fitter m_curvature;
  Node_neighborhood m_neighborhood;
  std::vector<int> m_region;                       // of a face, or -1
  std::vector<int> m_visit;                        // the growth that saw a face last
  int m_number_of_visits = 0;
  std::vector<Basic_shape> m_shapes;
  std::vector<double> m_shortest_edges;            // around a node

  // Part of h^2 k that a corner may be off a curved shape; the facets are off by an eighth. A surface that is tangent but
  // differs in curvature by a hundredth is told apart at the first edge. h: of the shortest edge around, since on a
  // cylinder the long ones bend not at all.
  static constexpr double part_of_sagitta = 4e-3;

public:
  // `tolerance` is the distance that roundings of the coordinates make
  Shape_recognizer(const Reference_surface& surface, const double tolerance)
    : m_surface(surface), m_tolerance(tolerance), m_curvature(surface),
      m_neighborhood(surface.cut_mesh(), surface.nodes()),
      m_region(surface.triangles().number_of_faces(), -1), m_visit(m_region.size(), 0),
      m_shortest_edges(surface.cut_mesh().number_of_nodes(), std::numeric_limits<double>::infinity())
  {
    const Indexed_triangles& triangles = surface.triangles();
    for(int f = 0; f < triangles.number_of_faces(); ++f)
      for(int k = 0; k < 3; ++k)
      {
        const double length = (triangles.point(f, next(k)) - triangles.point(f, k)).norm();
        for(const int corner : {k, next(k)})
        {
          double& shortest = m_shortest_edges[surface.cut_mesh().node(f, corner)];
          shortest = (std::min)(shortest, length);
        }
      }
  }

  // fills `regions()` and `shapes()`
  void operator()()
  {
    // The flattest first: two circles around an axis, as a tessellated cylinder has no others, lie on a cone, a sphere and
    // a torus too. Its facets bend one way only.
    // Two rings determine a shape better, one may be all there is on a narrow fillet; but one ring at the straight rim of
    // a cylinder is a strip between two rulings, which is plane.
    const std::pair<Basic_surface_type, std::vector<int> > tries[] = {
      {PLANE_SURFACE, {2}}, {CYLINDER_SURFACE, {2}}, {PLANE_SURFACE, {1}}, {CYLINDER_SURFACE, {1}},
      {CONE_SURFACE, {2, 1}}, {SPHERE_SURFACE, {2, 1}}, {TORUS_SURFACE, {2, 1}}};
    for(const auto& [type, numbers_of_rings] : tries)
      for(int i = 0; i < m_surface.cut_mesh().number_of_nodes(); ++i)
        for(const int rings : numbers_of_rings)
          for(const int c : m_surface.cut_mesh().corners(i))
            if(m_region[c / 3] == -1)
            {
              start(type, c / 3, i, rings);
              break;
            }
    for(int f = 0; f < int(m_region.size()); ++f)
      if(m_region[f] == -1)
        collect_rest(f);
  }

  const std::vector<int>& regions() const { return m_region; }
  const std::vector<Basic_shape>& shapes() const { return m_shapes; }

private:
  bool is_on(const Basic_shape& shape, const int node) const
  {
    const Vector& p = m_surface.node(node).position;
    const double h = m_shortest_edges[node];
    return std::abs(shape.distance(p)) <= (std::max)(m_tolerance, part_of_sagitta * h * h * shape.curvature(p));
  }

  bool is_face_on(const Basic_shape& shape, const int f) const
  {
    // the same surface, not one that it cuts
    constexpr double least_cosine = 0.7;
    const Indexed_triangles& triangles = m_surface.triangles();
    const Vector n = triangles.area_vector(f).stableNormalized();
    for(int k = 0; k < 3; ++k)
      if(!is_on(shape, m_surface.cut_mesh().node(f, k)))
        return false;
    Vector normal;
    shape.distance((triangles.point(f, 0) + triangles.point(f, 1) + triangles.point(f, 2)) / 3., normal);
    return n == Vector::Zero() || std::abs(n.dot(normal)) >= least_cosine;
  }

  void start(const Basic_surface_type type, const int f, const int node, const int rings)
  {
    if(!m_surface.node(node).has_normal())
      return;
    m_neighborhood.collect(node, rings);
    std::vector<int> nodes(1, node);
    for(const int j : m_neighborhood.neighbors())
      if(m_surface.node(j).has_normal())
        nodes.push_back(j);
    std::vector<Vector> points;
    for(const int i : nodes)
      points.push_back(m_surface.node(i).position);
    Principal_curvatures curvatures;
    if(type == TORUS_SURFACE)
      curvatures = m_curvature(node).principal_curvatures();
    for(const bool is_first : {true, false})
    {
      if(!is_first && (type == PLANE_SURFACE || type == SPHERE_SURFACE))
        return;
      // Of a torus, which curvature is the tube's? Of the others, are the normals of the nodes better known, or those of
      // the facets, as along the few long ones of a cylinder or cone?
      const bool are_facets_asked = !is_first && type != TORUS_SURFACE;
      Basic_shape shape;
      if(fit_basic_shape(type, points, are_facets_asked ? planes_of_facets(nodes) : planes_of_nodes(nodes),
                         is_first ? curvatures.maximum : curvatures.minimum, shape)
         && int(points.size()) >= shape.degrees_of_freedom()
         && std::all_of(nodes.begin(), nodes.end(), [&](const int i) { return is_on(shape, i); })
         && is_face_on(shape, f) && accept(shape, f))
        return;
    }
  }

  Tangent_planes planes_of_nodes(const std::vector<int>& nodes) const
  {
    Tangent_planes result;
    for(const int i : nodes)
      result.add(m_surface.node(i).position, m_surface.node(i).normal);
    return result;
  }

  // of those that are in no region yet
  Tangent_planes planes_of_facets(const std::vector<int>& nodes) const
  {
    const Indexed_triangles& triangles = m_surface.triangles();
    Tangent_planes result;
    for(const int i : nodes)
      for(const int c : m_surface.cut_mesh().corners(i))
        if(m_region[c / 3] == -1)
          result.add(triangles.point(c / 3, 0), triangles.area_vector(c / 3).stableNormalized());
    return result;
  }

  // grows and refits until nothing is added
  bool accept(Basic_shape shape, const int f)
  {
    constexpr int maximum_number_of_rounds = 8;
    std::vector<int> faces, nodes;
    for(int round = 0; round < maximum_number_of_rounds; ++round)
    {
      const std::size_t number_before = faces.size();
      bool is_whole_patch;
      grow(shape, f, faces, nodes, is_whole_patch);
      // points enough to prove the shape, unless it is all there is; a triangle proves no plane
      const int spare = is_whole_patch ? 0 : shape.type == PLANE_SURFACE ? 1 : 8;
      if(faces.empty() || int(nodes.size()) < shape.degrees_of_freedom() + spare)
        return false;
      if(faces.size() <= number_before)
        break;
      std::vector<Vector> points;
      for(const int i : nodes)
        points.push_back(m_surface.node(i).position);
      Basic_shape refined = shape;
      if(!refined.refine(points) || !is_face_on(refined, f))
        break;
      shape = refined;
    }
    for(const int g : faces)
      m_region[g] = int(m_shapes.size());
    m_shapes.push_back(shape);
    return true;
  }

  void grow(const Basic_shape& shape, const int seed, std::vector<int>& faces, std::vector<int>& nodes,
            bool& is_whole_patch)
  {
    const Cut_mesh& cut_mesh = m_surface.cut_mesh();
    ++m_number_of_visits;
    faces.assign(1, seed);
    nodes.clear();
    m_visit[seed] = m_number_of_visits;
    is_whole_patch = true;
    for(std::size_t i = 0; i < faces.size(); ++i)
      for(int k = 0; k < 3; ++k)
      {
        nodes.push_back(cut_mesh.node(faces[i], k));
        const int g = cut_mesh.neighbor(faces[i], k);
        if(g == -1 || m_visit[g] == m_number_of_visits)
          continue;
        if(m_region[g] == -1 && is_face_on(shape, g))
        {
          m_visit[g] = m_number_of_visits;
          faces.push_back(g);
        }
        else
          is_whole_patch = false;
      }
    std::sort(nodes.begin(), nodes.end());
    nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  }

  void collect_rest(const int seed)
  {
    std::vector<int> stack(1, seed);
    m_region[seed] = int(m_shapes.size());
    while(!stack.empty())
    {
      const int f = stack.back();
      stack.pop_back();
      for(int k = 0; k < 3; ++k)
      {
        const int g = m_surface.cut_mesh().neighbor(f, k);
        if(g == -1 || m_region[g] != -1)
          continue;
        m_region[g] = m_region[seed];
        stack.push_back(g);
      }
    }
    m_shapes.push_back(Basic_shape());
  }
};

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_MODEL_RECOGNIZE_BASIC_SHAPES_H
