// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_FORMER_FACES_H
#define CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_FORMER_FACES_H

#include <CGAL/Hermite_diffuse_remeshing/internal/Indexed_triangles.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Model/Triangle_tree.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Model/closest_barycentric.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/plan_repairs.h>

#include <cstddef>
#include <memory>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Hermite_diffuse_remeshing {
namespace internal {

// Where places on the repaired input are on the faces as they were before the repairs, to which the user's maps refer.
class Former_faces
{
  std::vector<char> m_is_changed;                       // of the repaired faces
  std::vector<std::size_t> m_ranks;                     // of the former faces that are gone or changed
  std::unique_ptr<Indexed_triangles> m_triangles;       // the same ones
  std::unique_ptr<Triangle_tree> m_tree;
  std::unordered_map<int, Location> m_corners;          // of the vertices of these

public:
  // no repairs
  Former_faces() = default;

  // `ranks`: of the faces of `former`
  Former_faces(const Indexed_triangles& former, const std::vector<std::size_t>& ranks, const Repaired_triangles& repaired)
    : m_triangles(new Indexed_triangles{former.points, {}})
  {
    std::vector<char> is_kept(former.number_of_faces(), false);
    for(std::size_t i = 0; i < repaired.faces.size(); ++i)
    {
      is_kept[repaired.faces[i]] = repaired.triangles[i] == former.triangles[repaired.faces[i]];
      m_is_changed.push_back(!is_kept[repaired.faces[i]]);
    }
    for(int f = 0; f < former.number_of_faces(); ++f)
    {
      if(is_kept[f])
        continue;
      const int number = m_triangles->number_of_faces();
      for(int k = 0; k < 3; ++k)
        m_corners.insert(std::make_pair(former.triangles[f][k], location_of_corner(3 * number + k)));
      m_triangles->triangles.push_back(former.triangles[f]);
      m_ranks.push_back(ranks[f]);
    }
    if(!m_ranks.empty())
      m_tree.reset(new Triangle_tree(*m_triangles));
  }

  // The rank of a face and coordinates in it. `repaired`: the triangles of the location, with the given ranks.
  std::pair<std::size_t, Barycentric> operator()(const Location& location, const Indexed_triangles& repaired,
                                                 const std::vector<std::size_t>& ranks) const
  {
    if(m_is_changed.empty() || !m_is_changed[location.face])
      return std::make_pair(ranks[location.face], location.coordinates);
    const Location former = former_location(location, repaired);
    return std::make_pair(m_ranks[former.face], former.coordinates);
  }

private:
  // A vertex is a corner, to the last bit; other places are as far from the faces as the repair has moved the surface.
  Location former_location(const Location& location, const Indexed_triangles& repaired) const
  {
    for(int k = 0; k < 3; ++k)
      if(location.coordinates[k] == 1.)
      {
        const auto corner = m_corners.find(repaired.triangles[location.face][k]);
        if(corner != m_corners.end())
          return corner->second;
      }
    const Vector p = repaired.point(location);
    return closest_on_face(*m_triangles, m_tree->closest(p).first, p);
  }
};

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_FORMER_FACES_H
