// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_MODEL_FLAT_REGIONS_H
#define CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_MODEL_FLAT_REGIONS_H

#include <CGAL/Hermite_diffuse_remeshing/internal/Classification/Cut_mesh.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Indexed_triangles.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/for_each_index.h>

#include <CGAL/number_type_basic.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace CGAL {
namespace Hermite_diffuse_remeshing {
namespace internal {

// Faces that lie in one plane and hang together across smooth edges from rim to rim. A flat side of a tessellated body is
// one region, however it was cut into triangles, and so is a plane quadrangle. Where a plane has vertices inside it is
// meshed on purpose, and its faces are as large as they are.
class Flat_regions
{
  const Indexed_triangles& m_surface;
  std::vector<int> m_region;            // of the faces
  std::vector<double> m_area;           // of the regions, twice

  // In sizes of a node: what of a region is farther away does not matter. So a part of the surface around the node tells as
  // much of it as all.
  static constexpr double largest_extent = 6.;
  // Of the longest side of two faces: if the tip of one is less above the other, rounding to single precision may have
  // put it there. An angle would not do: that of a needle is not known.
  static constexpr double rounding = 1e-6;

public:
  Flat_regions(const Indexed_triangles& surface, const Cut_mesh& cut_mesh, const bool is_parallel, const Progress& progress)
    : m_surface(surface), m_region(surface.number_of_faces(), -1)
  {
    std::vector<std::array<char, 3> > is_flat(surface.number_of_faces());             // of the sides
    for_each_index(surface.number_of_faces(), is_parallel, [&]
    {
      return [&](const int f)
      {
        for(int k = 0; k < 3; ++k)
        {
          const int neighbor = cut_mesh.neighbor(f, k);
          is_flat[f][k] = neighbor != -1 && are_coplanar(f, neighbor);
        }
      };
    }, progress);
    std::vector<char> is_at_rim(cut_mesh.number_of_nodes(), false);
    for(int f = 0; f < surface.number_of_faces(); ++f)
      for(int k = 0; k < 3; ++k)
        if(!is_flat[f][k])
          is_at_rim[cut_mesh.node(f, k)] = is_at_rim[cut_mesh.node(f, next(k))] = true;
    std::vector<int> faces;
    for(int seed = 0; seed < surface.number_of_faces(); ++seed)
    {
      if(m_region[seed] != -1)
        continue;
      const int region = static_cast<int>(m_area.size());
      m_area.push_back(0.);
      m_region[seed] = region;
      faces.assign(1, seed);
      for(std::size_t i = 0; i < faces.size(); ++i)
      {
        const int f = faces[i];
        m_area.back() += surface.area_vector(f).norm();
        for(int k = 0; k < 3; ++k)
        {
          if(!is_flat[f][k] || !is_at_rim[cut_mesh.node(f, k)] || !is_at_rim[cut_mesh.node(f, next(k))])
            continue;
          const int neighbor = cut_mesh.neighbor(f, k);
          if(m_region[neighbor] != -1)
            continue;
          m_region[neighbor] = region;
          faces.push_back(neighbor);
        }
      }
    }
  }

  // twice, of the region of a face at a node of a size; a face alone may be larger
  double area(const int face, const double size) const
  {
    return (std::max)(m_surface.area_vector(face).norm(),
                      (std::min)(m_area[m_region[face]], 2. * CGAL::square(largest_extent * size)));
  }

private:
  // two faces with a common side
  bool are_coplanar(const int f, const int g) const
  {
    double longest = 0.;
    for(const int face : {f, g})
      for(int k = 0; k < 3; ++k)
        longest = (std::max)(longest, (m_surface.point(face, next(k)) - m_surface.point(face, k)).norm());
    const double height = rounding * longest;
    return m_surface.area_vector(f).dot(m_surface.area_vector(g)) > 0.
        && rise(f, g) <= height && rise(g, f) <= height;
  }

  // of the corners of g above f, the farthest
  double rise(const int f, const int g) const
  {
    const Vector normal = m_surface.area_vector(f).stableNormalized();
    double result = 0.;
    for(int k = 0; k < 3; ++k)
      result = (std::max)(result, std::abs(normal.dot(m_surface.point(g, k) - m_surface.point(f, 0))));
    return result;
  }
};

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_MODEL_FLAT_REGIONS_H
