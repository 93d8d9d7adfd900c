// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_CONTOUR_H
#define CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_CONTOUR_H

#include <CGAL/Hermite_diffuse_remeshing/internal/Transformation/delaunay_triangulation.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Transformation/legality.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Transformation/polygon_triangulations.h>

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Hermite_diffuse_remeshing {
namespace internal {

// A polygon of vertices of the mesh, counterclockwise, and the best way to fill it with triangles.
template <typename UserMesh>
class Contour
{
  typedef Working_mesh<UserMesh> Mesh;
  typedef typename Mesh::vertex_descriptor vertex_descriptor;

  std::vector<vertex_descriptor> m_corners;
  Polygon_triangulation m_triangles;

  // The best triangles of n corners take a time of O(n^3), and again after every change around. An edge between two
  // vertices of high degree, twice of that up to which their edges are worth a search, has so many around it.
  static constexpr int largest_number_to_optimize = 48;

public:
  void add(const vertex_descriptor v) { m_corners.push_back(v); }
  std::size_t size() const { return m_corners.size(); }
  vertex_descriptor corner(const std::size_t i) const { return m_corners[i]; }

  // Finds the best triangles, those of Delaunay in the plane of the model where the corners are many. An edge outside
  // the polygon may join two corners already: a diagonal would be a second one. What is worth nothing is no offer.
  Worth fill(const Mesh& mesh, const int hint)
  {
    const int n = static_cast<int>(m_corners.size());
    const auto is_free = [&](const int i, const int j)
    { return j - i == 1 || j - i == n - 1 || !mesh.are_joined(m_corners[i], m_corners[j]); };
    const auto triangle_worth = [&](const int i, const int j, const int k)
    {
      if(!is_free(i, j) || !is_free(j, k) || !is_free(i, k))
        return Worth{-1., 0.};
      return worth(mesh.reference(), mesh.site(m_corners[i]), mesh.site(m_corners[j]), mesh.site(m_corners[k]), hint);
    };
    if(n > largest_number_to_optimize)
      return fill_by_delaunay(mesh, hint, triangle_worth);
    const Scored_triangulation best = best_triangulation(n, triangle_worth);
    m_triangles = best.triangles;
    return best.worth;
  }

  std::vector<std::array<vertex_descriptor, 3> > triangles() const
  {
    std::vector<std::array<vertex_descriptor, 3> > result;
    for(const Corner_triple& t : m_triangles)
      result.push_back({{m_corners[t[0]], m_corners[t[1]], m_corners[t[2]]}});
    return result;
  }

  typename Mesh::Diagonals diagonals() const
  {
    typename Mesh::Diagonals result;
    for(const std::array<int, 2>& d : internal::diagonals(static_cast<int>(m_corners.size()), m_triangles))
      result.push_back(std::make_pair(m_corners[d[0]], m_corners[d[1]]));
    return result;
  }

private:
  template <typename TriangleWorth>
  Worth fill_by_delaunay(const Mesh& mesh, const int hint, const TriangleWorth& triangle_worth)
  {
    std::vector<Vector> points;
    Vector middle = Vector::Zero();
    for(const vertex_descriptor v : m_corners)
    {
      points.push_back(mesh.site(v).point);
      middle += points.back() / static_cast<double>(m_corners.size());
    }
    m_triangles = delaunay_triangulation(points, mesh.reference().normal_near(middle, hint));
    Worth result = m_triangles.empty() ? Worth{-1., 0.} : Worth();
    for(const Corner_triple& t : m_triangles)
      result.add(triangle_worth(t[0], t[1], t[2]));
    return result;
  }
};

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_CONTOUR_H
