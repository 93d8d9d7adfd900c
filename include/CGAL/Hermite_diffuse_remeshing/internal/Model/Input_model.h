// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_MODEL_INPUT_MODEL_H
#define CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_MODEL_INPUT_MODEL_H

#include <CGAL/Hermite_diffuse_remeshing/internal/Curves/chain_feature_edges.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Model/Reference_locator.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Progress.h>

#include <functional>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL {
namespace Hermite_diffuse_remeshing {
namespace internal {

// Angles in radians; infinity turns a detection off.
struct Feature_options
{
  double sharp_angle, corner_angle, apex_defect;
};

// what the user says of the edge at a side of a face, and of a vertex; not as types, for which all that follows would
// be compiled anew
typedef std::function<Edge_mark(int face, int side)> Read_edge_mark;
typedef std::function<bool(int vertex)> Read_vertex_constraint;

// What is derived from the input alone: classified, cut, chained and fitted.
struct Input_surface
{
  Edge_table edges;
  std::vector<Edge_class> edge_classes;
  std::vector<Vertex_class> vertex_classes;
  Feature_curves curves;
  Reference_surface surface;

  // `vertex_normals`: unit normals that the user knows, or zero, or no vector at all
  Input_surface(const Indexed_triangles& triangles, const Feature_options& features, const Model_options& options,
                const Read_edge_mark& edge_mark, const Read_vertex_constraint& is_vertex_constrained,
                const std::vector<Vector>& vertex_normals = std::vector<Vector>(),
                const Progress& progress = Progress())
    : edges(triangles)
    , edge_classes(classify_edges(triangles, edges, features.sharp_angle, edge_mark))
    , surface(make_surface(triangles, features, options, edge_mark, is_vertex_constrained, vertex_normals, progress))
  {}

  // gives up what only a remeshing needs, or makes it fast: half of the memory
  void keep_surface_only()
  {
    edges = Edge_table(Indexed_triangles());
    edge_classes = std::vector<Edge_class>();
    vertex_classes = std::vector<Vertex_class>();
    curves = Feature_curves();
    surface.save_memory();
  }

private:
  // rough parts of the time that the steps take
  static constexpr double before_cut = 0.1, before_curves = 0.15, before_fit = 0.2;

  Reference_surface make_surface(const Indexed_triangles& triangles, const Feature_options& features,
                                 const Model_options& options, const Read_edge_mark& edge_mark,
                                 const Read_vertex_constraint& is_vertex_constrained,
                                 const std::vector<Vector>& vertex_normals, const Progress& progress)
  {
    progress(before_cut);
    Cut_mesh cut_mesh(triangles, edges, edge_classes);
    progress(before_curves);
    vertex_classes = classify_vertices(triangles, edges, edge_classes, cut_mesh, features.corner_angle,
                                       features.apex_defect, edge_mark, is_vertex_constrained);
    curves = chain_feature_edges(triangles, edges, edge_classes, vertex_classes,
                                 Saturation(options.maximum_displacement));
    progress(before_fit);
    const Known_normals known_normals = {vertex_normals, find_end_tangents(edges, cut_mesh, curves)};
    return Reference_surface(triangles, std::move(cut_mesh), vertex_classes, options, known_normals,
                             progress.part(before_fit, 1.));
  }
};

// and where points are found on it; curvatures at vertices do not need that
struct Input_model : Input_surface
{
  Reference_locator locator;

  Input_model(const Indexed_triangles& triangles, const Feature_options& features, const Model_options& options,
              const Read_edge_mark& edge_mark, const Read_vertex_constraint& is_vertex_constrained,
              const std::vector<Vector>& vertex_normals = std::vector<Vector>(), const Progress& progress = Progress())
    : Input_surface(triangles, features, options, edge_mark, is_vertex_constrained, vertex_normals, progress)
    , locator(surface)
  {}

  Input_model(const Input_model&) = delete;             // the locator refers to the surface
  Input_model& operator=(const Input_model&) = delete;
};

// `Model` is `Input_model` or `Input_surface`. A template although nothing here depends on the type of a mesh: a program
// of many translation units can have it instantiated in one of them.
template <typename Model>
std::unique_ptr<Model> make_model(const Indexed_triangles& triangles, const Feature_options& features,
                                  const Model_options& options, const Read_edge_mark& edge_mark,
                                  const Read_vertex_constraint& is_vertex_constrained,
                                  const std::vector<Vector>& vertex_normals, const Progress& progress)
{
  return std::make_unique<Model>(triangles, features, options, edge_mark, is_vertex_constrained, vertex_normals, progress);
}

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_MODEL_INPUT_MODEL_H
