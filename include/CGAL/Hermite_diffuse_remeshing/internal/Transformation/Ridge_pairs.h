// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_RIDGE_PAIRS_H
#define CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_RIDGE_PAIRS_H

#include <CGAL/Hermite_diffuse_remeshing/internal/Indexed_triangles.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Progress.h>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Hermite_diffuse_remeshing {
namespace internal {

// Collects where edges of the mesh cross edges of the reference, along which the model may have ridges: between two
// such places at the same face and the same edge the ridge goes over the face.
class Ridge_pairs
{
  struct Place
  {
    int face, edge;                     // the numbers of the face of the mesh and of the edge of the reference
    Location location;
  };
  std::vector<Place> m_places;

public:
  struct Pair
  {
    int face;
    Location first, second;
  };

  void add(const int face, const int edge, const Location& location) { m_places.push_back({face, edge, location}); }

  // The pairs in the order of the faces, then of the edges; the places are gone then. Sorts face by face, so that the
  // progress is told all the time.
  std::vector<Pair> take_pairs(const int number_of_faces, const Progress& progress)
  {
    // of the faces in `sorted`: one place farther, until those of each are there
    std::vector<std::size_t> begin(number_of_faces + 2, 0);
    for(const Place& place : m_places)
      ++begin[place.face + 2];
    std::partial_sum(begin.begin(), begin.end(), begin.begin());
    std::vector<Place> sorted(m_places.size());
    for(const Place& place : m_places)
      sorted[begin[place.face + 1]++] = place;
    m_places.clear();

    std::vector<Pair> result;
    for(int f = 0; f < number_of_faces; ++f, progress(0.))
    {
      const auto first = sorted.begin() + begin[f], last = sorted.begin() + begin[f + 1];
      std::stable_sort(first, last, [](const Place& a, const Place& b) { return a.edge < b.edge; });
      for(auto it = first; it != last; ++it)
        for(auto other = it; other != first && (other - 1)->edge == it->edge; --other)
          result.push_back({f, (other - 1)->location, it->location});
    }
    return result;
  }
};

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_RIDGE_PAIRS_H
