// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_CHANGE_RECORD_H
#define CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_CHANGE_RECORD_H

#include <CGAL/boost/graph/properties.h>
#include <CGAL/property_map.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Hermite_diffuse_remeshing {
namespace internal {

// When the elements of a mesh have changed. Changes are numbered. Who remembers how many there were when it began its
// last pass needs to look only at what has changed since: at vertices around which something is another, its size or
// its faces, and at faces that are other triangles.
template <typename TriangleMesh>
class Change_record
{
  typedef typename boost::graph_traits<TriangleMesh>::face_descriptor face_descriptor;
  typedef typename boost::property_map<TriangleMesh, CGAL::dynamic_face_property_t<std::size_t> >::type Face_map;

  std::size_t m_number = 0;
  std::vector<std::size_t> m_last_at_vertex;    // by the number of the vertex
  Face_map m_last_of_face;
  std::vector<int> m_log;
  bool m_is_logging = false;

public:
  explicit Change_record(TriangleMesh& tmesh)
    : m_last_of_face(get(CGAL::dynamic_face_property_t<std::size_t>(), tmesh))
  {}

  std::size_t number() const { return m_number; }
  void begin() { ++m_number; }

  // \name Of the last change
  void set_at_vertex(const int i)
  {
    if(static_cast<std::size_t>(i) >= m_last_at_vertex.size())
      m_last_at_vertex.resize(i + 1);
    m_last_at_vertex[i] = m_number;
    if(m_is_logging)
      m_log.push_back(i);
  }
  void set_of_face(const face_descriptor f) { put(m_last_of_face, f, m_number); }

  // -1: a vertex of no face
  bool is_since_at_vertex(const int i, const std::size_t number) const { return i != -1 && m_last_at_vertex[i] > number; }
  bool is_since_of_face(const face_descriptor f, const std::size_t number) const { return get(m_last_of_face, f) > number; }

  // \name A log of the vertices, for who must follow single operations
  void start_log() { m_log.clear(); m_is_logging = true; }
  void stop_log() { m_is_logging = false; }
  const std::vector<int>& log() const { return m_log; }
};

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_CHANGE_RECORD_H
