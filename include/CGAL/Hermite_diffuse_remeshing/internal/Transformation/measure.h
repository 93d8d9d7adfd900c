// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_MEASURE_H
#define CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_MEASURE_H

#include <CGAL/Hermite_diffuse_remeshing/Remeshing_report.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Model/Triangle_tree.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Transformation/select_vertices.h>

#include <algorithm>
#include <array>
#include <initializer_list>
#include <iterator>
#include <utility>
#include <vector>

namespace CGAL {
namespace Hermite_diffuse_remeshing {
namespace internal {

// The distance between the result and the reference at one face of the result.
template <typename FaceDescriptor>
struct Face_deviation
{
  FaceDescriptor face;
  double deviation = 0.;
  Location location;                    // of the largest, on the reference
};

template <typename UserMesh>
struct Deviations
{
  typedef typename Working_mesh<UserMesh>::face_descriptor face_descriptor;

  std::vector<Face_deviation<face_descriptor> > faces;
  double largest = 0., mean = 0.;
  Vector point_of_largest = Vector::Zero();
};

struct Quality_statistics
{
  double smallest = 1., mean = 0.;
};

template <typename IsSelected>
Quality_statistics measure_quality(const Indexed_triangles& triangles, const IsSelected& is_selected)
{
  Quality_statistics result;
  std::size_t number = 0;
  for(int f = 0; f < triangles.number_of_faces(); ++f)
  {
    if(!is_selected(f))
      continue;
    const double q = quality(triangles.point(f, 0), triangles.point(f, 1), triangles.point(f, 2));
    result.smallest = (std::min)(result.smallest, q);
    result.mean += q;
    ++number;
  }
  result.mean /= (std::max)(std::size_t(1), number);
  return result;
}

template <typename UserMesh>
Quality_statistics measure_quality(const Working_mesh<UserMesh>& mesh)
{
  Quality_statistics result;
  std::size_t number = 0;
  for(const auto f : faces(mesh.tmesh()))
  {
    if(!mesh.is_remeshed(f))
      continue;
    const auto h = halfedge(f, mesh.tmesh());
    const double q = quality(mesh.point(source(h, mesh.tmesh())), mesh.point(target(h, mesh.tmesh())),
                             mesh.point(target(next(h, mesh.tmesh()), mesh.tmesh())));
    result.smallest = (std::min)(result.smallest, q);
    result.mean += q;
    ++number;
  }
  result.mean /= (std::max)(std::size_t(1), number);
  return result;
}

// part of the edges with a length between half and twice their size
template <typename UserMesh>
double measure_size_conformity(const Working_mesh<UserMesh>& mesh)
{
  std::size_t number = 0, conforming = 0;
  for(const auto e : edges(mesh.tmesh()))
    if(mesh.is_inside(e))
    {
      const double length = mesh.relative_length(halfedge(e, mesh.tmesh()));
      ++number;
      conforming += length >= 0.5 && length <= 2.;
    }
  return double(conforming) / (std::max)(std::size_t(1), number);
}

// From the result to the model at vertices, edge middles and face centroids; on feature edges to the
// curve. And back: from the vertices of the reference to the closest facet of the result. Throws
// Interrupted on request.
template <typename UserMesh>
Deviations<UserMesh> measure_deviations(const Working_mesh<UserMesh>& mesh)
{
  typedef Working_mesh<UserMesh> Mesh;
  typedef typename Mesh::face_descriptor face_descriptor;
  typedef typename Mesh::halfedge_descriptor halfedge_descriptor;
  const auto& tm = mesh.tmesh();
  const Reference& reference = mesh.reference();
  // relative to the local size; a deviation needs two digits
  constexpr double tolerance = 1e-3;

  Deviations<UserMesh> result;
  Indexed_triangles facets;
  auto index = get(CGAL::dynamic_face_property_t<int>(), tm);
  for(const face_descriptor f : faces(tm))
  {
    put(index, f, -1);
    if(!mesh.is_remeshed(f))
      continue;
    put(index, f, static_cast<int>(result.faces.size()));
    Face_deviation<face_descriptor> entry;
    entry.face = f;
    result.faces.push_back(entry);
    std::array<int, 3> triangle;
    halfedge_descriptor h = halfedge(f, tm);
    for(int k = 0; k < 3; ++k, h = next(h, tm))
    {
      triangle[k] = facets.number_of_vertices();
      facets.points.push_back(mesh.point(source(h, tm)));
    }
    facets.triangles.push_back(triangle);
  }

  double sum = 0.;
  std::size_t number = 0;
  const auto add = [&](const Vector& p, const double deviation, const Location& location,
                       const std::initializer_list<int> at_faces)
  {
    sum += deviation;
    ++number;
    if(deviation > result.largest)
    {
      result.largest = deviation;
      result.point_of_largest = p;
    }
    for(const int f : at_faces)
      if(f != -1 && deviation > result.faces[f].deviation)
      {
        result.faces[f].deviation = deviation;
        result.faces[f].location = location;
      }
  };
  const auto add_projection = [&](const Vector& p, const int hint, const std::initializer_list<int> at_faces)
  {
    const Reference::Nearest nearest = reference.nearest(p, hint, tolerance);
    add(p, nearest.distance, nearest.location, at_faces);
  };

  for(std::size_t i = 0; i < result.faces.size(); ++i)
  {
    mesh.give_up_if_stopped();
    const int f = static_cast<int>(i);
    result.faces[i].location.face = mesh.hint(result.faces[i].face);
    result.faces[i].location.coordinates.fill(1. / 3.);
    add_projection((facets.point(f, 0) + facets.point(f, 1) + facets.point(f, 2)) / 3.,
                   mesh.hint(result.faces[i].face), {f});
  }
  for(const auto e : edges(tm))
  {
    if(!mesh.is_inside(e))
      continue;
    halfedge_descriptor h = halfedge(e, tm);
    if(mesh.is_border_or_outside(h))
      h = opposite(h, tm);
    const halfedge_descriptor o = opposite(h, tm);
    const int f = get(index, face(h, tm)), g = mesh.is_border_or_outside(o) ? -1 : get(index, face(o, tm));
    const auto s = source(h, tm), t = target(h, tm);
    const Vector p = (mesh.point(s) + mesh.point(t)) / 2.;
    const int curve = mesh.curve(h);
    mesh.give_up_if_stopped();
    if(curve == -1)
      add_projection(p, mesh.hint(h), {f, g});
    else
    {
      const Site site = reference.curve_site(curve, (mesh.parameter(s, curve) + mesh.parameter(t, curve)) / 2.);
      add(p, (site.point - p).norm(), site.location, {f, g});
    }
  }
  for(const auto v : vertices(tm))
  {
    if(mesh.index(v) == -1)
      continue;
    mesh.give_up_if_stopped();
    const halfedge_descriptor h = first_remeshed_halfedge(mesh, v);
    if(h != Mesh::Graph_traits::null_halfedge())
      add_projection(mesh.point(v), mesh.data(v).site.location.face, {get(index, face(h, tm))});
  }

  const Triangle_tree tree(facets);
  const Indexed_triangles& triangles = reference.surface.triangles();
  std::vector<char> is_done(triangles.number_of_vertices(), false);
  for(int f = 0; f < triangles.number_of_faces(); ++f)
    for(int k = 0; k < 3; ++k)
    {
      const int v = triangles.triangles[f][k];
      if(is_done[v] || !mesh.is_reference_face_remeshed(f))
        continue;
      is_done[v] = true;
      mesh.give_up_if_stopped();
      const std::pair<int, Vector> closest = tree.closest(triangles.points[v]);
      add(triangles.points[v], (closest.second - triangles.points[v]).norm(),
          reference.vertex_site(f, k).location, {closest.first});
    }
  result.mean = sum / (std::max)(std::size_t(1), number);
  return result;
}

template <typename UserMesh, typename TriangleMesh>
void fill_report(const Working_mesh<UserMesh>& mesh, const Deviations<UserMesh>& deviations,
                 Remeshing_report<TriangleMesh>& report)
{
  report.number_of_faces = std::distance(faces(mesh.tmesh()).begin(), faces(mesh.tmesh()).end());
  report.number_of_vertices = std::distance(vertices(mesh.tmesh()).begin(), vertices(mesh.tmesh()).end());
  const Quality_statistics quality = measure_quality(mesh);
  report.smallest_quality = quality.smallest;
  report.mean_quality = quality.mean;
  report.size_conformity = measure_size_conformity(mesh);

  report.largest_deviation = deviations.largest;
  report.mean_deviation = deviations.mean;
  for(int i = 0; i < 3; ++i)
    report.point_of_largest_deviation[i] = deviations.point_of_largest[i];
  report.is_maximum_deviation_met = report.is_deviation_measured && deviations.largest <= report.maximum_deviation;
  for(const auto& entry : deviations.faces)
    if(entry.deviation > report.maximum_deviation)
      report.faces_above_maximum_deviation.push_back(entry.face);

  report.number_of_splits = mesh.counts().splits;
  report.number_of_collapses = mesh.counts().collapses;
  report.number_of_flips = mesh.counts().flips;
  report.number_of_relocations = mesh.counts().relocations;
}

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_MEASURE_H
