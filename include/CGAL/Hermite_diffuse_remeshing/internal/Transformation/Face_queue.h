// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_FACE_QUEUE_H
#define CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_FACE_QUEUE_H

#include <CGAL/Hermite_diffuse_remeshing/internal/Transformation/legality.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <set>

namespace CGAL {
namespace Hermite_diffuse_remeshing {
namespace internal {

// Numbers of the vertices of a face in their order around it, the smallest first
typedef std::array<int, 3> Face_corners;

// Faces of a mesh that changes meanwhile, the one with the lowest score first. Equal ones come in the order of their
// vertices' numbers, which is the same for every type of mesh. A face for which nothing could be done a few times
// waits until all others have had their turn, however often something changes beside it.
template <typename UserMesh>
class Face_queue
{
  typedef Working_mesh<UserMesh> Mesh;
  typedef typename Mesh::vertex_descriptor vertex_descriptor;
  typedef typename Mesh::halfedge_descriptor halfedge_descriptor;

  struct Entry
  {
    int level;                          // of the score, quantised: rounding does not decide the order
    Face_corners corners;

    bool operator<(const Entry& other) const
    { return level != other.level ? level < other.level : corners < other.corners; }
  };

  const Mesh& m_mesh;
  std::set<Entry> m_entries, m_waiting;
  std::map<Face_corners, int> m_number_of_failures;

  // One in five succeeds after so many failures; in a crowded fold there would be hundreds of tries.
  static constexpr int patience = 2;

public:
  explicit Face_queue(const Mesh& mesh) : m_mesh(mesh) {}

  bool is_empty() const { return m_entries.empty() && m_waiting.empty(); }
  std::size_t size() const { return m_entries.size() + m_waiting.size(); }

  Face_corners corners(const halfedge_descriptor h) const
  {
    Face_corners result = m_mesh.triangle(face(h, m_mesh.tmesh())).vertices;
    std::rotate(result.begin(), std::min_element(result.begin(), result.end()), result.end());
    return result;
  }

  // the face of h
  void push(const halfedge_descriptor h)
  {
    const Entry entry = make_entry(h);
    const auto failures = m_number_of_failures.find(entry.corners);
    (failures != m_number_of_failures.end() && failures->second >= patience ? m_waiting : m_entries).insert(entry);
  }

  // Nothing can be done for the face of h now.
  void note_failure(const halfedge_descriptor h) { ++m_number_of_failures[corners(h)]; }

  // a halfedge of the first face; null if it has changed since it was pushed
  halfedge_descriptor pop()
  {
    if(m_entries.empty())
      m_entries.swap(m_waiting);
    const Entry entry = *m_entries.begin();
    m_entries.erase(m_entries.begin());
    const halfedge_descriptor h = halfedge_of(entry);
    return h != Mesh::Graph_traits::null_halfedge() && make_entry(h).level == entry.level
         ? h : Mesh::Graph_traits::null_halfedge();
  }

private:
  Entry make_entry(const halfedge_descriptor h) const
  {
    constexpr double levels = 1024., offset = 0.37;
    Entry entry;
    entry.level = static_cast<int>(std::floor(levels * face_worth(m_mesh, h).score + offset));
    entry.corners = corners(h);
    return entry;
  }

  // null if the face is no more
  halfedge_descriptor halfedge_of(const Entry& entry) const
  {
    const auto& tm = m_mesh.tmesh();
    halfedge_descriptor result = Mesh::Graph_traits::null_halfedge();
    if(m_mesh.vertex(entry.corners[0]) == Mesh::Graph_traits::null_vertex())
      return result;
    m_mesh.visit_copies(m_mesh.vertex(entry.corners[0]), [&](const vertex_descriptor v)
    {
      for(const halfedge_descriptor g : CGAL::halfedges_around_target(v, tm))
        if(!m_mesh.is_border_or_outside(g) && m_mesh.index(target(next(g, tm), tm)) == entry.corners[1]
           && m_mesh.index(source(g, tm)) == entry.corners[2])
          result = next(g, tm);
    });
    return result;
  }
};

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_FACE_QUEUE_H
