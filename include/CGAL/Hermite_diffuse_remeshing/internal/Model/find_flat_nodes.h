// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_MODEL_FIND_FLAT_NODES_H
#define CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_MODEL_FIND_FLAT_NODES_H

#include <CGAL/Hermite_diffuse_remeshing/internal/Classification/Cut_mesh.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Model/Node_data.h>

#include <algorithm>
#include <vector>

namespace CGAL {
namespace Hermite_diffuse_remeshing {
namespace internal {

// Nodes that lie in one plane with their rings, and have one normal with them. Of the caps of tessellated bodies, whose
// vertices may have very many faces, nearly all are.
inline std::vector<char> find_flat_nodes(const Cut_mesh& cut_mesh, const std::vector<Node>& nodes)
{
  std::vector<char> is_flat(nodes.size());
  for(std::size_t i = 0; i < nodes.size(); ++i)
  {
    const Node& node = nodes[i];
    const Index_range ring = cut_mesh.ring(static_cast<int>(i));
    is_flat[i] = !node.is_singular && node.has_normal() && std::all_of(ring.begin(), ring.end(), [&](const int j)
    {
      return (nodes[j].normal - node.normal).norm() <= Node::rounding_of_planes
          && node.sees_in_plane(nodes[j].position, node.normal);
    });
  }
  return is_flat;
}

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_MODEL_FIND_FLAT_NODES_H
