// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_SORT_FREE_ELEMENTS_H
#define CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_SORT_FREE_ELEMENTS_H

#include <CGAL/Surface_mesh/Surface_mesh_fwd.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Hermite_diffuse_remeshing {
namespace internal {

// Elements that have been removed leave places, which new ones take. Edges are collapsed in an order that has nothing to
// do with space: after many collapses elements that are made one after the other would be scattered over the memory.

// `take()` gives the place that was left last, `leave(place)` leaves it again.
template <typename Take, typename Leave>
void sort_free_places(const std::size_t number, const Take& take, const Leave& leave)
{
  std::vector<decltype(take())> places;
  places.reserve(number);
  for(std::size_t i = 0; i < number; ++i)
    places.push_back(take());
  std::sort(places.begin(), places.end());
  std::for_each(places.rbegin(), places.rend(), leave);
}

// What a mesh does with free places is its own affair
template <typename TriangleMesh>
void sort_free_elements(TriangleMesh&) {}

// but of this one, which gives out the place that was left last.
template <typename Point>
void sort_free_elements(Surface_mesh<Point>& mesh)
{
  if(!mesh.does_recycle_garbage())
    return;
  sort_free_places(mesh.number_of_removed_vertices(), [&] { return mesh.add_vertex(); },
                   [&](const auto v) { mesh.remove_vertex(v); });
  sort_free_places(mesh.number_of_removed_edges(), [&] { return mesh.edge(mesh.add_edge()); },
                   [&](const auto e) { mesh.remove_edge(e); });
  sort_free_places(mesh.number_of_removed_faces(), [&] { return mesh.add_face(); },
                   [&](const auto f) { mesh.remove_face(f); });
}

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_SORT_FREE_ELEMENTS_H
