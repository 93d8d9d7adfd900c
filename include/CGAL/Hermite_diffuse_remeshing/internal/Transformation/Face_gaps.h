// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_FACE_GAPS_H
#define CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_FACE_GAPS_H

#include <CGAL/Hermite_diffuse_remeshing/internal/Indexed_triangles.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace CGAL {
namespace Hermite_diffuse_remeshing {
namespace internal {

// The height of the model over a face of the mesh, from where it has been measured: zero at the vertices, which lie
// on the model, and known at the middles of the sides and at the centroid. The cubic through these values
//   4 sum m_k l_k l_next(k) + 27 b l_0 l_1 l_2,   b = c - 4/9 sum m_k
// tells where in between it is largest: where the curvatures differ, up to 7 % above all of them.
struct Face_gaps
{
  std::array<double, 3> middles = {{0., 0., 0.}};       // of side k from corner k to the next
  double centroid = 0.;
  double ridge = 0.;                    // by how much a ridge across a side may rise above these

  double operator()(const Barycentric& l) const
  {
    return 4. * (middles[0] * l[0] * l[1] + middles[1] * l[1] * l[2] + middles[2] * l[2] * l[0])
         + 27. * bubble() * l[0] * l[1] * l[2];
  }

  // never below the largest height
  double bound() const
  {
    // the sum of the products of two coordinates is at most 1/3, that of all three 1/27
    const double largest = (std::max)({std::abs(middles[0]), std::abs(middles[1]), std::abs(middles[2])});
    return 4. / 3. * largest + std::abs(bubble());
  }

  // The place of the largest height, of a grid: an arc between two of its points rises by 1 % at most.
  Barycentric peak() const
  {
    constexpr int n = 9;
    Barycentric result = {{1. / 3., 1. / 3., 1. / 3.}};
    double largest = std::abs(centroid);
    for(int i = 0; i <= n; ++i)
      for(int j = 0; i + j <= n; ++j)
      {
        const Barycentric l = {{double(n - i - j) / n, double(i) / n, double(j) / n}};
        const double height = std::abs((*this)(l));
        if(height > largest)
        {
          largest = height;
          result = l;
        }
      }
    return result;
  }

  // at the centroid, of the quadric through the other heights
  double height_of_quadric() const { return 4. / 9. * (middles[0] + middles[1] + middles[2]); }

private:
  double bubble() const { return centroid - height_of_quadric(); }
};

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_FACE_GAPS_H
