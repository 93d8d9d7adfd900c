// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_PROPOSE_AND_ACCEPT_H
#define CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_PROPOSE_AND_ACCEPT_H

#include <CGAL/Hermite_diffuse_remeshing/internal/Transformation/Working_mesh.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/for_each_index.h>

#include <algorithm>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Hermite_diffuse_remeshing {
namespace internal {

// Most of the time of an operator goes into looking at its candidates, which changes nothing. With threads many of
// them are looked at ahead; the calling thread alone changes the mesh, in the order of the candidates.

// Calls `accept(candidate, propose(candidate), since)` for one candidate after the other, until the visitor asks for a
// stop. `propose()` reads only, and is called ahead if the mesh is remeshed by several threads: `since` is the number
// of changes then, and `accept()` has to see to it that the proposal is what would be proposed now.
template <typename UserMesh, typename Iterator, typename Propose, typename Accept>
void propose_and_accept(const Working_mesh<UserMesh>& mesh, const Iterator first, const Iterator last,
                        const Propose& propose, const Accept& accept)
{
  if(!mesh.is_parallel())
  {
    for(Iterator it = first; it != last && !mesh.is_stopped(); ++it)
      accept(*it, propose(*it), mesh.number_of_changes());
    return;
  }
  // proposals grow old while earlier ones are accepted, and a stop has to wait for all
  constexpr std::ptrdiff_t block_size = 2048;
  struct Proposal { std::decay_t<decltype(propose(*first))> value; };   // no vector of bits, which threads share
  std::vector<Proposal> proposals;
  for(Iterator begin = first; begin != last; )
  {
    const int n = static_cast<int>((std::min)(block_size, std::ptrdiff_t(last - begin)));
    const std::size_t since = mesh.number_of_changes();
    proposals.resize(n);
    for_each_index(n, true, [&] { return [&](const int i) { proposals[i].value = propose(begin[i]); }; });
    for(int i = 0; i < n; ++i, ++begin)
    {
      if(mesh.is_stopped())
        return;
      accept(*begin, proposals[i].value, since);
    }
  }
}

// Vertices with the numbers of their waves, in the order of these: no two of a wave are neighbours. They are the vertices
// from `first` to `last` - 1 of a list; `rank`, by the number of the vertex, is the place in this list, or -1.
template <typename UserMesh>
std::vector<std::pair<int, typename Working_mesh<UserMesh>::vertex_descriptor> >
find_waves(const Working_mesh<UserMesh>& mesh,
           const std::vector<typename Working_mesh<UserMesh>::vertex_descriptor>& vertices, const std::vector<int>& rank,
           const int first, const int last)
{
  typedef typename Working_mesh<UserMesh>::vertex_descriptor vertex_descriptor;
  std::vector<std::pair<int, vertex_descriptor> > result;
  result.reserve(last - first);
  std::vector<int> waves_around;
  for(int i = first; i < last; ++i)
  {
    // the first wave without a neighbour: there are hardly more than the vertices have neighbours among them
    waves_around.clear();
    mesh.visit_copies(vertices[i], [&](const vertex_descriptor copy)
    {
      for(const auto h : CGAL::halfedges_around_target(copy, mesh.tmesh()))
      {
        const int other = rank[mesh.index(source(h, mesh.tmesh()))];
        if(other >= first && other < i)
          waves_around.push_back(result[other - first].first);
      }
    });
    int free_wave = 0;
    while(std::find(waves_around.begin(), waves_around.end(), free_wave) != waves_around.end())
      ++free_wave;
    result.push_back(std::make_pair(free_wave, vertices[i]));
  }
  std::stable_sort(result.begin(), result.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  return result;
}

// Same for vertices where a proposal depends on the neighbours, and `accept(vertex, proposal)` changes the vertex alone.
// They are taken in waves, so that proposals are what they would be if the vertices were taken one after the other.
template <typename UserMesh, typename Propose, typename Accept>
void propose_and_accept_in_waves(const Working_mesh<UserMesh>& mesh,
                                 const std::vector<typename Working_mesh<UserMesh>::vertex_descriptor>& vertices,
                                 const Propose& propose, const Accept& accept)
{
  // many enough for long waves, few enough for what is around them to stay in the cache
  constexpr int window_size = 1024;
  const int number = static_cast<int>(vertices.size()), number_of_windows = (number + window_size - 1) / window_size;
  std::vector<int> rank(mesh.number_of_vertex_slots(), -1);
  for(int i = 0; i < number; ++i)
    rank[mesh.index(vertices[i])] = i;
  const auto find_window = [&](const int w)
  { return find_waves(mesh, vertices, rank, w * window_size, (std::min)(number, (w + 1) * window_size)); };
  // No neighbour changes. One thread finds the waves of a window while it has what is around it in the cache.
  std::vector<decltype(find_window(0))> windows(number_of_windows);
  if(mesh.is_parallel())
    for_each_index(number_of_windows, true, [&] { return [&](const int w) { windows[w] = find_window(w); }; }, mesh.progress());
  for(int w = 0; w < number_of_windows; ++w)
  {
    const auto window = mesh.is_parallel() ? std::move(windows[w]) : find_window(w);
    for(auto begin = window.begin(); begin != window.end(); )
    {
      const auto end = std::find_if(begin, window.end(), [&](const auto& entry) { return entry.first != begin->first; });
      propose_and_accept(mesh, begin, end, [&](const auto& entry) { return propose(entry.second); },
                         [&](const auto& entry, const auto& proposal, std::size_t) { accept(entry.second, proposal); });
      if(mesh.is_stopped())
        return;
      begin = end;
    }
  }
}

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_PROPOSE_AND_ACCEPT_H
