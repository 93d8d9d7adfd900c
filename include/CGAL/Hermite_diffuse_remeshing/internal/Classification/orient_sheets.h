// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_CLASSIFICATION_ORIENT_SHEETS_H
#define CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_CLASSIFICATION_ORIENT_SHEETS_H

#include <CGAL/Hermite_diffuse_remeshing/internal/Classification/Edge_table.h>

#include <utility>
#include <vector>

namespace CGAL {
namespace Hermite_diffuse_remeshing {
namespace internal {

// Turns triangles over until the faces of every edge with two faces are coherently oriented, wherever the sheet
// can be oriented. In each sheet the orientation of the majority stays. Returns which faces were turned: their
// corners 1 and 2 are exchanged.
inline std::vector<char> orient_sheets(Indexed_triangles& surface)
{
  const Edge_table edges(surface);
  const int nf = surface.number_of_faces();
  const auto runs_forward = [&](const Face_side& s)
  { return surface.triangles[s.face][s.side] < surface.triangles[s.face][next(s.side)]; };

  std::vector<char> is_turned(nf, false), is_seen(nf, false);
  std::vector<int> sheet;
  for(int seed = 0; seed < nf; ++seed)
  {
    if(is_seen[seed])
      continue;
    sheet.assign(1, seed);
    is_seen[seed] = true;
    int number_of_turned = 0;
    for(std::size_t i = 0; i < sheet.size(); ++i)
    {
      const int f = sheet[i];
      number_of_turned += is_turned[f];
      for(int k = 0; k < 3; ++k)
      {
        const int e = edges.edge(f, k);
        if(edges.number_of_sides(e) != 2)
          continue;
        const Face_side& s = edges.side(e, 0);
        const Face_side& t = edges.side(e, 1);
        const int other = s.face == f ? t.face : s.face;
        if(is_seen[other])
          continue;
        is_seen[other] = true;
        is_turned[other] = (runs_forward(s) == runs_forward(t)) != (is_turned[f] != 0);
        sheet.push_back(other);
      }
    }
    if(2 * number_of_turned > static_cast<int>(sheet.size()))
      for(const int f : sheet)
        is_turned[f] = !is_turned[f];
  }
  for(int f = 0; f < nf; ++f)
    if(is_turned[f])
      std::swap(surface.triangles[f][1], surface.triangles[f][2]);
  return is_turned;
}

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_CLASSIFICATION_ORIENT_SHEETS_H
