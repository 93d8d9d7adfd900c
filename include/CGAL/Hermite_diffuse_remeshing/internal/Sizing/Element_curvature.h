// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_SIZING_ELEMENT_CURVATURE_H
#define CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_SIZING_ELEMENT_CURVATURE_H

#include <CGAL/Hermite_diffuse_remeshing/internal/Model/Node_curvature_fitter.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Sizing/Size_sources.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/for_each_index.h>

#include <CGAL/number_type_basic.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Hermite_diffuse_remeshing {
namespace internal {

// The mean of the second fundamental form over faces, from normals that are linear over each, as in
// J.-O. Lachaud, P. Romon, B. Thibert, D. Coeurjolly, Interpolated corrected curvature measures for polygonal surfaces,
// Computer Graphics Forum 39(5), 2020. The integral of their derivative over a triangle with the sides e_k opposite to
// its corners is the sum of n_k (x) (u x e_k) / 2, where u is its normal; with the mean of the three normals in place of
// the facet's, which means nothing on a sliver, the sum over adjacent faces is one over their rim: noise inside does
// not count. Before they are added, all are turned into the plane of one normal.
class Mean_second_form
{
  Vector m_normal, m_x, m_y;
  double m_area = 0.;
  Second_form m_sum;                    // times the areas

public:
  explicit Mean_second_form(const Vector& normal) : m_normal(normal), m_x(any_normal(normal)), m_y(normal.cross(m_x)) {}

  void add(const Reference_surface& surface, const int face)
  {
    const Indexed_triangles& triangles = surface.triangles();
    const Vector facet = triangles.area_vector(face);
    std::array<Vector, 3> normals;
    for(int k = 0; k < 3; ++k)
      normals[k] = surface.node(face, k).has_normal() ? surface.node(face, k).normal : Vector(facet.stableNormalized());
    const Vector u = (normals[0] + normals[1] + normals[2]).stableNormalized();
    // of what is turned away farther nothing is told by a curvature
    constexpr double least_cosine = 0.2;
    const double cosine = u.dot(m_normal);
    if(cosine < least_cosine)
      return;
    const auto turned = [&](const Vector& axis) { return Vector(axis - u.dot(axis) / (1. + cosine) * (m_normal + u)); };
    const Vector x = turned(m_x), y = turned(m_y);
    m_area += facet.dot(u) / 2.;
    for(int k = 0; k < 3; ++k)
    {
      const Vector across = u.cross(triangles.point(face, previous(k)) - triangles.point(face, next(k))) / 2.;
      m_sum.xx += normals[k].dot(x) * across.dot(x);
      m_sum.xy += (normals[k].dot(x) * across.dot(y) + normals[k].dot(y) * across.dot(x)) / 2.;
      m_sum.yy += normals[k].dot(y) * across.dot(y);
    }
  }

  // of the faces, as far as they are seen along their normals
  double area() const { return m_area; }

  double largest_curvature() const { return m_sum.largest_absolute_curvature() / m_area; }
};

// The largest curvature at the nodes of a noisy surface, as the elements see it that it asks for: the mean over the
// faces around, the closest ones first, until they are as many as six elements of its size cover. What noise adds between
// them the elements would not see, but asks for so small ones that it asks for them everywhere. Where the faces are as
// large as that a polynomial over two rings of neighbours tells more.
class Element_curvature
{
  const Reference_surface& m_surface;
  const Size_sources& m_sources;
  Node_curvature_fitter m_fitter;
  std::vector<int> m_mark;              // of the faces: the query that has met it last
  int m_query = 0;
  std::vector<std::pair<double, int> > m_queue;         // a heap: the closest face first

  // of six equilateral triangles around a vertex, over the square of their side
  static constexpr double area_of_star = 2.5980762113533160;
  // so many faces have averaged their noise away
  static constexpr int largest_number_of_faces = 256;
  // Of the distance: faces that are as close to each other as that come in at one time, so that rounding does not decide on
  // regular meshes.
  static constexpr double tie = 1e-6;

public:
  Element_curvature(const Reference_surface& surface, const Size_sources& sources)
    : m_surface(surface), m_sources(sources), m_fitter(surface), m_mark(surface.triangles().number_of_faces(), 0)
  {}

  double operator()(const int node)
  {
    const std::pair<double, double> fitted = m_fitter(node).curvatures();
    const double curvature_of_fit = (std::max)(std::abs(fitted.first), std::abs(fitted.second));
    // the mean can only make sizes larger
    if(!m_surface.node(node).has_normal() || !(size(curvature_of_fit) < m_sources.options().maximum_length))
      return curvature_of_fit;
    const double curvature = mean_curvature(node, curvature_of_fit);
    // of the lengths, 1/2 and 1
    constexpr double all = 0.25, none = 1.;
    const double share = ramp(area_around(node) / area_of_elements(curvature), none, all);
    if(!(share > 0.) || !(curvature < curvature_of_fit))
      return curvature_of_fit;
    // Blended are the radii, to which the sizes are proportional: the fit's curvature may be any times too large, and the
    // mean may be zero.
    return 1. / (share / curvature + (1. - share) / curvature_of_fit);
  }

private:
  double size(const double curvature) const { return m_sources.clamped(m_sources.of_curvature(curvature)); }
  double area_of_elements(const double curvature) const { return area_of_star * CGAL::square(size(curvature)); }

  double area_around(const int node) const
  {
    double result = 0.;
    for(const int c : m_surface.cut_mesh().corners(node))
      result += m_surface.triangles().area_vector(c / 3).norm() / 2.;
    return result;
  }

  double mean_curvature(const int node, const double curvature_of_fit)
  {
    const Vector& p = m_surface.node(node).position;
    Mean_second_form form(m_surface.node(node).normal);
    ++m_query;
    m_queue.clear();
    for(const int c : m_surface.cut_mesh().corners(node))
      add_to_queue(c / 3, p);
    double last_distance = -1.;
    for(int number = 0; number < largest_number_of_faces && !m_queue.empty(); ++number)
    {
      std::pop_heap(m_queue.begin(), m_queue.end(), std::greater<std::pair<double, int> >());
      const auto [distance, face] = m_queue.back();
      m_queue.pop_back();
      if(distance > (1. + tie) * last_distance && form.area() > 0.
         && form.area() >= area_of_elements(form.largest_curvature()))
        break;
      last_distance = distance;
      form.add(m_surface, face);
      for(int k = 0; k < 3; ++k)
        if(m_surface.cut_mesh().neighbor(face, k) != -1)
          add_to_queue(m_surface.cut_mesh().neighbor(face, k), p);
    }
    return form.area() > 0. ? form.largest_curvature() : curvature_of_fit;
  }

  void add_to_queue(const int face, const Vector& p)
  {
    if(m_mark[face] == m_query)
      return;
    m_mark[face] = m_query;
    const Indexed_triangles& t = m_surface.triangles();
    const Vector center = (t.point(face, 0) + t.point(face, 1) + t.point(face, 2)) / 3.;
    m_queue.push_back(std::make_pair((center - p).norm(), face));
    std::push_heap(m_queue.begin(), m_queue.end(), std::greater<std::pair<double, int> >());
  }
};

// largest curvatures at the nodes; zero at apices, which have none
inline std::vector<double> largest_curvatures_of_nodes(const Reference_surface& surface, const Size_sources& sources,
                                                       const Progress& progress)
{
  const int n = surface.cut_mesh().number_of_nodes();
  std::vector<double> result(n, 0.);
  const auto find = [&](const auto& make_curvature)
  {
    for_each_index(n, sources.is_parallel(), [&]
    {
      return [&, curvature = make_curvature()](const int i) mutable
      {
        if(!surface.node(i).is_singular)
          result[i] = curvature(i);
      };
    }, progress);
  };
  if(surface.options().normals == SMOOTH_NORMALS)
    find([&] { return Element_curvature(surface, sources); });
  else
    find([&] { return [&](const int i) { return sources.largest_curvature(i); }; });
  return result;
}

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_SIZING_ELEMENT_CURVATURE_H
