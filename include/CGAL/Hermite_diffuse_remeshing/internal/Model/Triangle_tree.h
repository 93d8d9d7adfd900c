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

#include <CGAL/AABB_tree.h>
#include <CGAL/Bbox_3.h>
#include <CGAL/Object.h>
#include <CGAL/Search_traits_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Spatial_sort_traits_adapter_3.h>
#include <CGAL/hilbert_sort.h>
#include <CGAL/property_map.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <utility>
#include <vector>

namespace CGAL {
namespace Hermite_diffuse_remeshing {
namespace internal {

// What CGAL's AABB tree asks for, over groups of faces that are near each other, as one box per face would take four
// times the memory. A group is known by its number. The traits of searches are asked for by CGAL 6, which could search
// among points of the groups too.
struct Face_group_traits : public CGAL::Simple_cartesian<double>,
                           public CGAL::Search_traits_3<CGAL::Simple_cartesian<double> >
{
  typedef double FT;
  typedef Point_3 Point;
  typedef CGAL::Bbox_3 Bounding_box;

  struct Primitive
  {
    typedef int Id;
    typedef Point_3 Datum;
    typedef Point_3 Point;

    int group;

    Id id() const { return group; }
  };

  typedef std::pair<Point_3, int> Point_and_primitive_id;
  typedef std::pair<CGAL::Object, int> Object_and_primitive_id;
  template <typename Query>
  struct Intersection_and_primitive_id
  {
    typedef Object_and_primitive_id Type;
  };

  typedef std::vector<Bounding_box> Boxes;

  const Boxes* boxes = nullptr;                                    // of the groups, read while the tree is built only

  struct Compute_bbox
  {
    const Boxes& boxes;

    template <typename Iterator>
    Bounding_box operator()(const Iterator first, const Iterator beyond) const
    {
      Bounding_box result;
      for(Iterator it = first; it != beyond; ++it)
        result += boxes[it->group];
      return result;
    }
  };
  Compute_bbox compute_bbox_object() const { return Compute_bbox{*boxes}; }

  // by the middles of the boxes, where the box of them all is longest
  struct Split_primitives
  {
    const Boxes& boxes;

    template <typename Iterator>
    void operator()(const Iterator first, const Iterator beyond, const Bounding_box& box) const
    {
      int longest = 0;
      for(int k = 1; k < 3; ++k)
        if(box.max_coord(k) - box.min_coord(k) > box.max_coord(longest) - box.min_coord(longest))
          longest = k;
      const auto middle = [&](const Primitive& p)
      {
        const Bounding_box& b = boxes[p.group];
        return b.min_coord(longest) + b.max_coord(longest);
      };
      std::nth_element(first, first + std::distance(first, beyond) / 2, beyond,
                       [&](const Primitive& a, const Primitive& b) { return middle(a) < middle(b); });
    }
  };
  Split_primitives split_primitives_object() const { return Split_primitives{*boxes}; }
};

// Finds the closest of some faces of indexed triangles, which must outlive it. It takes some 20 bytes per face, and is
// complete when it is constructed, so that queries from several threads are safe.
class Triangle_tree
{
  typedef CGAL::Simple_cartesian<double>::Point_3 Point_3;

  // Some faces in an order in which those with near numbers are near each other
  class Face_groups
  {
    static constexpr std::size_t group_size = 4;

    const Indexed_triangles* m_triangles;
    std::vector<int> m_faces;                                      // group i begins at group_size * i

  public:
    Face_groups(const Indexed_triangles& triangles, std::vector<int> faces)
      : m_triangles(&triangles), m_faces(std::move(faces))
    {}

    int size() const { return static_cast<int>((m_faces.size() + group_size - 1) / group_size); }

    void order(const Progress& progress)
    {
      std::vector<Point_3> centers;
      centers.reserve(m_faces.size());
      for(const int f : m_faces)
      {
        const Vector c = (m_triangles->point(f, 0) + m_triangles->point(f, 1) + m_triangles->point(f, 2)) / 3.;
        centers.push_back(Point_3(c[0], c[1], c[2]));
      }
      progress(0.2);
      std::vector<std::size_t> order(m_faces.size());
      std::iota(order.begin(), order.end(), std::size_t(0));
      typedef Spatial_sort_traits_adapter_3<CGAL::Simple_cartesian<double>,
                                            Pointer_property_map<Point_3>::const_type> Order_traits;
      hilbert_sort(order.begin(), order.end(), Order_traits(make_property_map(std::as_const(centers))));
      std::vector<int> sorted;
      sorted.reserve(order.size());
      for(const std::size_t i : order)
        sorted.push_back(m_faces[i]);
      m_faces.swap(sorted);
    }

    template <typename Visit>
    void for_each_face(const int group, const Visit& visit) const
    {
      const std::size_t first = static_cast<std::size_t>(group) * group_size;
      const std::size_t last = (std::min)(first + group_size, m_faces.size());
      for(std::size_t i = first; i < last; ++i)
        visit(m_faces[i]);
    }

    Face_group_traits::Boxes boxes() const
    {
      Face_group_traits::Boxes result(size());
      for(int group = 0; group < size(); ++group)
        for_each_face(group, [&](const int f)
        {
          for(int k = 0; k < 3; ++k)
          {
            const Vector p = m_triangles->point(f, k);
            result[group] += CGAL::Bbox_3(p[0], p[1], p[2], p[0], p[1], p[2]);
          }
        });
      return result;
    }

    const Indexed_triangles& triangles() const { return *m_triangles; }
  };

  typedef CGAL::AABB_tree<Face_group_traits> Tree;

  Face_groups m_groups;
  Tree m_tree;

public:
  Triangle_tree(const Indexed_triangles& triangles, std::vector<int> faces, const Progress& progress = Progress())
    : m_groups(triangles, std::move(faces))
  {
    progress(0.);
    m_groups.order(progress);
    progress(0.5);
    const Face_group_traits::Boxes boxes = m_groups.boxes();
    progress(0.7);
    Face_group_traits traits;
    traits.boxes = &boxes;
    m_tree = Tree(traits);
    for(int group = 0; group < m_groups.size(); ++group)
      m_tree.insert(Face_group_traits::Primitive{group});
    m_tree.build();
  }

  explicit Triangle_tree(const Indexed_triangles& triangles, const Progress& progress = Progress())
    : Triangle_tree(triangles, all_faces(triangles), progress)
  {}

  // Face and point. Throws std::invalid_argument if the query has no distance that is a number.
  std::pair<int, Vector> closest(const Vector& p) const
  {
    Nearest nearest(m_groups, p);
    m_tree.traversal_with_priority(p, nearest);
    if(nearest.best.first == -1)
      throw std::invalid_argument("a query point is not finite, or so far away that its distance overflows");
    return nearest.best;
  }

private:
  // visits boxes in the order of their distances
  class Nearest
  {
    const Face_groups& m_groups;
    double m_best_distance2 = (std::numeric_limits<double>::max)();

  public:
    typedef double Priority;

    std::pair<int, Vector> best;

    Nearest(const Face_groups& groups, const Vector& query) : m_groups(groups), best(-1, query) {}

    constexpr bool go_further() const { return true; }

    template <typename Node>
    bool do_intersect(const Vector& query, const Node& node) const
    { return do_intersect_with_priority(query, node).first; }

    template <typename Node>
    std::pair<bool, Priority> do_intersect_with_priority(const Vector& query, const Node& node) const
    {
      double distance2 = 0.;
      for(int k = 0; k < 3; ++k)
      {
        const double d = (std::max)({0., node.bbox().min_coord(k) - query[k], query[k] - node.bbox().max_coord(k)});
        distance2 += d * d;
      }
      return std::make_pair(distance2 < m_best_distance2, -distance2);
    }

    void intersection(const Vector& query, const Face_group_traits::Primitive& primitive)
    {
      const Indexed_triangles& triangles = m_groups.triangles();
      m_groups.for_each_face(primitive.group, [&](const int f)
      {
        const Vector point = triangles.point(closest_on_face(triangles, f, query));
        const double distance2 = (point - query).squaredNorm();
        if(distance2 < m_best_distance2)
        {
          m_best_distance2 = distance2;
          best = std::make_pair(f, point);
        }
      });
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
