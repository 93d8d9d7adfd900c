// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_MODEL_TRIANGLE_TREE_H
#define CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_MODEL_TRIANGLE_TREE_H

#include <CGAL/Hermite_diffuse_remeshing/internal/Model/closest_barycentric.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Progress.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Spatial_sort_traits_adapter_3.h>
#include <CGAL/hilbert_sort.h>
#include <CGAL/property_map.h>

#include <unsupported/Eigen/BVH>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Hermite_diffuse_remeshing {
namespace internal {

// Finds the closest of some faces of indexed triangles, which must outlive it. A tree of bounding boxes over
// small groups of faces that are near each other: 20 bytes per face, a quarter of what one box per face
// takes. It is complete when it is constructed, so that queries from several threads are safe.
class Triangle_tree
{
  typedef CGAL::Simple_cartesian<double>::Point_3 Point_3;
  typedef Eigen::KdBVH<double, 3, int> Tree;                     // of groups

  static constexpr int group_size = 4;

  const Indexed_triangles* m_triangles;
  std::vector<int> m_faces;                                      // group i begins at group_size * i
  Tree m_tree;

public:
  Triangle_tree(const Indexed_triangles& triangles, std::vector<int> faces, const Progress& progress = Progress())
    : m_triangles(&triangles), m_faces(std::move(faces))
  {
    progress(0.);
    std::vector<Point_3> centers;
    centers.reserve(m_faces.size());
    for(const int f : m_faces)
    {
      const Vector c = (triangles.point(f, 0) + triangles.point(f, 1) + triangles.point(f, 2)) / 3.;
      centers.push_back(Point_3(c[0], c[1], c[2]));
    }
    progress(0.2);
    std::vector<std::size_t> order(m_faces.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    typedef Spatial_sort_traits_adapter_3<CGAL::Simple_cartesian<double>,
                                          Pointer_property_map<Point_3>::const_type> Order_traits;
    hilbert_sort(order.begin(), order.end(), Order_traits(make_property_map(std::as_const(centers))));
    progress(0.5);
    std::vector<int> sorted;
    sorted.reserve(order.size());
    for(const std::size_t i : order)
      sorted.push_back(m_faces[i]);
    m_faces.swap(sorted);

    std::vector<int> groups((m_faces.size() + group_size - 1) / group_size);
    std::iota(groups.begin(), groups.end(), 0);
    std::vector<Eigen::AlignedBox3d> boxes(groups.size());
    for(std::size_t i = 0; i < m_faces.size(); ++i)
      for(int k = 0; k < 3; ++k)
        boxes[i / group_size].extend(triangles.point(m_faces[i], k));
    progress(0.7);
    m_tree.init(groups.begin(), groups.end(), boxes.begin(), boxes.end());
  }

  explicit Triangle_tree(const Indexed_triangles& triangles, const Progress& progress = Progress())
    : Triangle_tree(triangles, all_faces(triangles), progress)
  {}

  // face and point
  std::pair<int, Vector> closest(const Vector& p) const
  {
    Nearest nearest{*this, p, std::make_pair(-1, p), (std::numeric_limits<double>::max)()};
    Eigen::BVMinimize(m_tree, nearest);
    return nearest.best;
  }

private:
  // what Eigen's search asks for: bounds of the squared distance
  struct Nearest
  {
    typedef double Scalar;

    const Triangle_tree& tree;
    const Vector& query;
    std::pair<int, Vector> best;
    double best_distance2;

    double minimumOnVolume(const Eigen::AlignedBox3d& box) const { return box.squaredExteriorDistance(query); }

    double minimumOnObject(const int group)
    {
      const Indexed_triangles& triangles = *tree.m_triangles;
      const std::size_t first = static_cast<std::size_t>(group) * group_size;
      const std::size_t last = (std::min)(first + group_size, tree.m_faces.size());
      for(std::size_t i = first; i < last; ++i)
      {
        const int f = tree.m_faces[i];
        const Vector point = triangles.point(closest_on_face(triangles, f, query));
        const double distance2 = (point - query).squaredNorm();
        if(distance2 < best_distance2)
        {
          best_distance2 = distance2;
          best = std::make_pair(f, point);
        }
      }
      return best_distance2;
    }
  };

  static std::vector<int> all_faces(const Indexed_triangles& triangles)
  {
    std::vector<int> faces(triangles.triangles.size());
    std::iota(faces.begin(), faces.end(), 0);
    return faces;
  }
};

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_MODEL_TRIANGLE_TREE_H
