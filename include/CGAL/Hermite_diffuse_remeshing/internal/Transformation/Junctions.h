// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_JUNCTIONS_H
#define CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_JUNCTIONS_H

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <unordered_map>

namespace CGAL {
namespace Hermite_diffuse_remeshing {
namespace internal {

// A mesh with halfedges holds a surface with non-manifold edges as sheets that are cut along them: a vertex of such
// a junction has a copy in the mesh for each sheet. The copies have one number, one place and one size. This is the
// list of them, by number; a vertex that is not in it is its own and only copy.
template <typename VertexDescriptor>
class Junctions
{
public:
  typedef boost::container::small_vector<VertexDescriptor, 2> Copies;

private:
  std::unordered_map<int, Copies> m_copies;      // never iterated: the order would depend on addresses

public:
  bool is_empty() const { return m_copies.empty(); }
  bool has(const int number) const { return m_copies.count(number) != 0; }

  // calls `visit(copy)` for the copies of `v`, which has this number
  template <typename Visit>
  void visit_copies(const int number, const VertexDescriptor v, const Visit& visit) const
  {
    const auto found = m_copies.empty() ? m_copies.end() : m_copies.find(number);
    if(found == m_copies.end())
      return visit(v);
    for(const VertexDescriptor copy : found->second)
      visit(copy);
  }

  void set(const int number, const Copies& copies)
  {
    if(copies.size() > 1)
      m_copies[number] = copies;
    else
      m_copies.erase(number);
  }

  void replace(const int number, const VertexDescriptor old_copy, const VertexDescriptor new_copy)
  {
    const auto found = m_copies.find(number);
    if(found != m_copies.end())
      std::replace(found->second.begin(), found->second.end(), old_copy, new_copy);
  }

  void erase(const int number) { m_copies.erase(number); }
};

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_JUNCTIONS_H
