// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_MODEL_TRIANGLE_TREE_H
#define CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_MODEL_TRIANGLE_TREE_H

#include <CGAL/Hermite_diffuse_remeshing/internal/Indexed_triangles.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/compatibility.h>

#include <CGAL/Bbox_3.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Hermite_diffuse_remeshing {
namespace internal {

// An AABB tree over some faces of indexed triangles, which must outlive it. The tree is built by
// the constructor, so that queries from several threads are safe.
class Triangle_tree
{
  typedef CGAL::Simple_cartesian<double> Kernel;
  typedef Kernel::Point_3 Point_3;

  struct Primitive
  {
    typedef int Id;
    typedef Point_3 Point;
    typedef Kernel::Triangle_3 Datum;
    typedef const Indexed_triangles* Shared_data;
    typedef Datum Datum_reference;
    typedef Point Point_reference;

    int face;

    Primitive(const std::vector<int>::const_iterator it, const Indexed_triangles*) : face(*it) {}
    static Shared_data construct_shared_data(const Indexed_triangles* triangles) { return triangles; }
    Id id() const { return face; }
    Datum datum(const Shared_data& s) const
    {
      return Datum(to_point(s->point(face, 0)), to_point(s->point(face, 1)), to_point(s->point(face, 2)));
    }
    Point reference_point(const Shared_data& s) const { return to_point(s->point(face, 0)); }
  };
  typedef internal::AABB_traits<Kernel, Primitive> Tree_traits;

  CGAL::AABB_tree<Tree_traits> m_tree;

public:
  Triangle_tree(const Indexed_triangles& triangles, const std::vector<int>& faces)
    : m_tree(faces.begin(), faces.end(), &triangles)
  {
    m_tree.build();
  }

  explicit Triangle_tree(const Indexed_triangles& triangles)
    : Triangle_tree(triangles, all_faces(triangles))
  {}

  // face and point
  std::pair<int, Vector> closest(const Vector& p) const
  {
    const auto found = m_tree.closest_point_and_primitive(to_point(p));
    return std::make_pair(found.second, Vector(found.first.x(), found.first.y(), found.first.z()));
  }

  double squared_distance_to_box(const Vector& p) const
  {
    const CGAL::Bbox_3 box = m_tree.bbox();
    double sum = 0.;
    for(int i = 0; i < 3; ++i)
    {
      const double d = (std::max)({0., (box.min)(i) - p[i], p[i] - (box.max)(i)});
      sum += d * d;
    }
    return sum;
  }

private:
  static Point_3 to_point(const Vector& v) { return Point_3(v[0], v[1], v[2]); }

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
