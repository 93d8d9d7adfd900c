// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_MODEL_SIDE_MIDDLES_H
#define CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_MODEL_SIDE_MIDDLES_H

#include <CGAL/Hermite_diffuse_remeshing/internal/Classification/Cut_mesh.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Classification/Edge_table.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Indexed_triangles.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Model/Reference_surface.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Progress.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/for_each_index.h>

#include <vector>

namespace CGAL {
namespace Hermite_diffuse_remeshing {
namespace internal {

// Points of the model over the middles of the sides of faces, `point_at(location)`. They are the same for both faces of
// an edge that is no feature, and found once.
template <typename PointAt>
class Side_middles
{
  const Cut_mesh& m_cut_mesh;
  const Edge_table& m_edges;
  PointAt m_point_at;
  std::vector<Vector> m_shared;         // by the edge

public:
  // `is_asked_for(face)`
  template <typename IsAskedFor>
  Side_middles(const Reference_surface& surface, const Edge_table& edges, const IsAskedFor& is_asked_for,
               const PointAt& point_at, const Progress& progress)
    : m_cut_mesh(surface.cut_mesh()), m_edges(edges), m_point_at(point_at), m_shared(edges.number_of_edges())
  {
    for_each_index(surface.triangles().number_of_faces(), surface.options().is_parallel, [&]
    {
      return [&](const int f)
      {
        for(int k = 0; k < 3 && is_asked_for(f); ++k)
        {
          const int g = m_cut_mesh.neighbor(f, k);
          if(g != -1 && (f < g || !is_asked_for(g)))
            m_shared[m_edges.edge(f, k)] = m_point_at(location(f, k));
        }
      };
    }, progress);
  }

  // of a face that was asked for
  Vector operator()(const int face, const int side) const
  {
    return m_cut_mesh.neighbor(face, side) != -1 ? m_shared[m_edges.edge(face, side)]
                                                 : m_point_at(location(face, side));
  }

  static Location location(const int face, const int side) { return location_on_side({face, side}, 0.5); }
};

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_MODEL_SIDE_MIDDLES_H
