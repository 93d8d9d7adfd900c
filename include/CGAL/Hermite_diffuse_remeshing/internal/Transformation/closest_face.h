// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_CLOSEST_FACE_H
#define CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_CLOSEST_FACE_H

#include <CGAL/Hermite_diffuse_remeshing/internal/Model/Triangle_tree.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Transformation/Working_mesh.h>

#include <CGAL/number_utils.h>

#include <array>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL {
namespace Hermite_diffuse_remeshing {
namespace internal {

template <typename FaceDescriptor>
struct Closest_on_mesh
{
  FaceDescriptor face;
  Barycentric coordinates;              // the first is that of the source of the face's halfedge
  double distance2;
};

template <typename UserMesh>
Closest_on_mesh<typename Working_mesh<UserMesh>::face_descriptor>
closest_on_face(const Working_mesh<UserMesh>& mesh, const typename Working_mesh<UserMesh>::face_descriptor f,
                const Vector& p)
{
  const auto& tm = mesh.tmesh();
  const auto h = halfedge(f, tm);
  const Vector& a = mesh.point(source(h, tm));
  const Vector& b = mesh.point(target(h, tm));
  const Vector& c = mesh.point(target(next(h, tm), tm));
  Closest_on_mesh<typename Working_mesh<UserMesh>::face_descriptor> result;
  result.face = f;
  result.coordinates = closest_barycentric(a, b, c, p);
  const Barycentric& l = result.coordinates;
  result.distance2 = (l[0] * a + l[1] * b + l[2] * c - p).squaredNorm();
  return result;
}

// Descends from face to face of the mesh to a point that no neighbouring face improves.
template <typename UserMesh>
Closest_on_mesh<typename Working_mesh<UserMesh>::face_descriptor>
walk_to_closest(const Working_mesh<UserMesh>& mesh, const typename Working_mesh<UserMesh>::face_descriptor start,
                const Vector& p)
{
  typedef typename Working_mesh<UserMesh>::halfedge_descriptor halfedge_descriptor;
  const auto& tm = mesh.tmesh();
  auto best = closest_on_face(mesh, start, p);
  for(;;)
  {
    const auto current = best;
    // a step must be a real one: ties between faces end the walk
    const double least_gain = 1e-12 * current.distance2;
    const auto visit = [&](const halfedge_descriptor h)
    {
      if(mesh.is_border_or_outside(h))
        return;
      const auto candidate = closest_on_face(mesh, face(h, tm), p);
      if(candidate.distance2 < best.distance2 - least_gain)
        best = candidate;
    };
    halfedge_descriptor h = halfedge(current.face, tm);
    for(int k = 0; k < 3; ++k, h = next(h, tm))
      if(current.coordinates[k] == 1.)
      {
        for(const halfedge_descriptor g : CGAL::halfedges_around_source(h, tm))
          visit(g);
      }
      else if(current.coordinates[previous(k)] == 0. && current.coordinates[next(k)] < 1.)
        visit(opposite(h, tm));
    if(best.face == current.face)
      return best;
  }
}

// Is the point, to a tolerance in barycentric coordinates, on an edge that may not be changed?
template <typename UserMesh>
bool is_on_protected_edge(const Working_mesh<UserMesh>& mesh,
                          const Closest_on_mesh<typename Working_mesh<UserMesh>::face_descriptor>& closest,
                          const double tolerance)
{
  const auto& tm = mesh.tmesh();
  auto h = halfedge(closest.face, tm);
  for(int k = 0; k < 3; ++k, h = next(h, tm))
    if(closest.coordinates[previous(k)] <= tolerance && mesh.is_protected(h))
      return true;
  return false;
}

// Finds the closest of some faces of the mesh, which do not change meanwhile.
template <typename UserMesh>
class Face_search
{
  typedef Working_mesh<UserMesh> Mesh;
  typedef typename Mesh::face_descriptor face_descriptor;
  typedef Closest_on_mesh<face_descriptor> Closest;

  const Mesh& m_mesh;
  std::vector<face_descriptor> m_faces;
  Progress m_progress;
  int m_number_of_queries = 0;
  Indexed_triangles m_triangles;
  std::unique_ptr<Triangle_tree> m_tree;

  // As long as there are no more queries than this each looks at all faces: to build the tree takes as long as fifteen.
  static constexpr int largest_number_without_tree = 8;

public:
  Face_search(const Mesh& mesh, std::vector<face_descriptor> faces, const Progress& progress)
    : m_mesh(mesh), m_faces(std::move(faces)), m_progress(progress)
  {}

  Face_search(const Face_search&) = delete;             // the tree refers to the triangles
  Face_search& operator=(const Face_search&) = delete;

  Closest closest(const Vector& p)
  {
    if(m_number_of_queries++ < largest_number_without_tree)
      return closest_of_all(p);
    if(m_tree == nullptr)
    {
      m_triangles = copy_triangles();
      m_tree = std::make_unique<Triangle_tree>(m_triangles, m_progress);
    }
    return closest_on_face(m_mesh, m_faces[m_tree->closest(p).first], p);
  }

private:
  Closest closest_of_all(const Vector& p) const
  {
    Closest best = closest_on_face(m_mesh, m_faces.front(), p);
    for(std::size_t i = 1; i < m_faces.size(); ++i)
    {
      if(m_mesh.is_stopped_at(i))
        throw Interrupted();
      if(CGAL::square(Bounding_box(m_mesh.triangle(m_faces[i]).points).distance(p)) >= best.distance2)
        continue;
      const Closest candidate = closest_on_face(m_mesh, m_faces[i], p);
      if(candidate.distance2 < best.distance2)
        best = candidate;
    }
    return best;
  }

  Indexed_triangles copy_triangles() const
  {
    Indexed_triangles result;
    for(std::size_t i = 0; i < m_faces.size(); ++i)
    {
      if(m_mesh.is_stopped_at(i))
        throw Interrupted();
      const int first = result.number_of_vertices();
      const std::array<Vector, 3> points = m_mesh.triangle(m_faces[i]).points;
      result.points.insert(result.points.end(), points.begin(), points.end());
      result.triangles.push_back({{first, first + 1, first + 2}});
    }
    return result;
  }
};

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_CLOSEST_FACE_H
