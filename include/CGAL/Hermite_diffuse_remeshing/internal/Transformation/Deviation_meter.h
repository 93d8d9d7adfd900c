// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_DEVIATION_METER_H
#define CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_DEVIATION_METER_H

#include <CGAL/Hermite_diffuse_remeshing/Remeshing_report.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Model/Triangle_tree.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Transformation/Deviation_targets.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Transformation/select_vertices.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <initializer_list>
#include <utility>
#include <vector>

namespace CGAL {
namespace Hermite_diffuse_remeshing {
namespace internal {

// The distance between the result and the reference at one face of the result.
template <typename FaceDescriptor>
struct Face_deviation
{
  FaceDescriptor face;
  double deviation = 0.;
  Vector point = Vector::Zero();        // where it was measured
  Location location;                    // there, on the reference
  bool is_on_protected_edge = false;    // is it there?
  Deviation_obstacle obstacle = DEVIATION_AFTER_STOP;   // of a face that deviates too much
};

template <typename UserMesh>
struct Deviations
{
  typedef typename Working_mesh<UserMesh>::face_descriptor face_descriptor;

  std::vector<Face_deviation<face_descriptor> > faces;
  double largest = 0., mean = 0.;       // the mean: from the mesh to the model
  double model_distance = 0.;           // between the model and the facets of the reference
  Vector point_of_largest = Vector::Zero();
};

// Measures the deviation of the working mesh from the reference. From the mesh to the model: at vertices,
// edge middles and face centroids; at the middles of feature edges to the curve. And back: from
// points of the model to the closest facet of the mesh. Throws Interrupted on request.
template <typename UserMesh>
class Deviation_meter
{
  typedef Working_mesh<UserMesh> Mesh;
  typedef typename Mesh::TriangleMesh TriangleMesh;
  typedef typename Mesh::face_descriptor face_descriptor;
  typedef typename Mesh::halfedge_descriptor halfedge_descriptor;
  typedef typename boost::property_map<TriangleMesh, CGAL::dynamic_face_property_t<int> >::const_type
    Face_index_map;

  const Mesh& m_mesh;
  double m_bound;
  Face_index_map m_index;               // in `m_deviations.faces`; -1 for a face that is not remeshed
  Deviation_targets m_targets;
  Deviations<UserMesh> m_deviations;
  std::vector<char> m_is_new;           // of the faces: has to be measured
  double m_sum = 0.;
  std::size_t m_number = 0;

  // relative to the local size; a deviation needs two digits
  static constexpr double tolerance = 1e-3;

public:
  // `bound`: distances below it need no second look
  Deviation_meter(const Mesh& mesh, const double bound)
    : m_mesh(mesh), m_bound(bound), m_index(make_index_map())
    , m_targets(mesh.reference(), bound, [&mesh](const int f) { return mesh.is_reference_face_remeshed(f); },
                progress())
  {
    m_deviations.model_distance = m_targets.model_distance();
  }

  Deviations<UserMesh>& deviations() { return m_deviations; }

  void measure()
  {
    m_deviations.faces.clear();
    m_is_new.clear();
    m_index = make_index_map();
    m_sum = 0.;
    m_number = 0;
    for(const face_descriptor f : faces(m_mesh.tmesh()))
    {
      put(m_index, f, -1);
      if(m_mesh.is_remeshed(f))
        add_new_face(f);
    }
    for(Deviation_target& target : m_targets.targets())
      target.face = -1;
    measure_new_faces();
    m_deviations.mean = m_sum / (std::max)(std::size_t(1), m_number);
  }

  // Measures again what has changed since; the mean stays. The points of the reference whose closest face
  // has changed look for it among the faces that have changed: the distance to some of the faces is
  // an upper bound of the distance to all.
  void update(const std::size_t since)
  {
    std::vector<Face_deviation<face_descriptor> > old_faces;
    old_faces.swap(m_deviations.faces);
    m_is_new.clear();
    const Face_index_map old_index = m_index;
    m_index = make_index_map();
    std::vector<int> new_index(old_faces.size(), -1);
    for(const face_descriptor f : faces(m_mesh.tmesh()))
    {
      put(m_index, f, -1);
      if(!m_mesh.is_remeshed(f))
        continue;
      if(m_mesh.has_changed(f, since))
      {
        add_new_face(f);
        continue;
      }
      m_mesh.give_up_if_stopped();
      const int i = get(old_index, f);
      new_index[i] = static_cast<int>(m_deviations.faces.size());
      put(m_index, f, new_index[i]);
      m_deviations.faces.push_back(old_faces[i]);
      m_is_new.push_back(false);
    }
    for(Deviation_target& target : m_targets.targets())
      if(target.face != -1)
        target.face = new_index[target.face];
    measure_new_faces();
  }

private:
  // of the faces that there are now: the mesh is not ours, so the map does not grow with it
  Face_index_map make_index_map() const { return get(CGAL::dynamic_face_property_t<int>(), m_mesh.tmesh()); }

  Progress progress() const
  {
    return Progress([this](double) { return !m_mesh.is_stopped(); });
  }

  void add_new_face(const face_descriptor f)
  {
    m_mesh.give_up_if_stopped();
    put(m_index, f, static_cast<int>(m_deviations.faces.size()));
    Face_deviation<face_descriptor> entry;
    entry.face = f;
    m_deviations.faces.push_back(entry);
    m_is_new.push_back(true);
  }

  void measure_new_faces()
  {
    measure_centroids();
    measure_edges();
    measure_vertices();
    measure_targets();
    m_deviations.largest = 0.;
    for(const auto& entry : m_deviations.faces)
      if(entry.deviation > m_deviations.largest)
      {
        m_deviations.largest = entry.deviation;
        m_deviations.point_of_largest = entry.point;
      }
  }

  void count(const double deviation)
  {
    m_sum += deviation;
    ++m_number;
  }

  void add(const Vector& p, const double deviation, const Location& location,
           const std::initializer_list<int> at_faces, const bool is_on_protected_edge = false)
  {
    for(const int f : at_faces)
      if(f != -1 && deviation >= m_deviations.faces[f].deviation)
      {
        Face_deviation<face_descriptor>& entry = m_deviations.faces[f];
        entry.deviation = deviation;
        entry.point = p;
        entry.location = location;
        entry.is_on_protected_edge = is_on_protected_edge;
      }
  }

  // Newton's method starts from the facet's point that is closest. Where the surface is steep over its
  // facets it may end at another part of the surface: before a point counts as too far away, the
  // locations of the vertices around it are tried.
  void add_projection(const Vector& p, const halfedge_descriptor h, const std::initializer_list<int> at_faces)
  {
    const Reference& reference = m_mesh.reference();
    const TriangleMesh& tm = m_mesh.tmesh();
    Reference::Nearest nearest = reference.nearest(p, reference.locator.walk(p, m_mesh.hint(h)), tolerance);
    if(nearest.distance > m_bound)
      for(const auto v : {source(h, tm), target(h, tm), target(next(h, tm), tm)})
      {
        const Reference::Nearest other = reference.nearest(p, m_mesh.data(v).site.location, tolerance);
        if(other.distance < nearest.distance)
          nearest = other;
      }
    count(nearest.distance);
    add(p, nearest.distance, nearest.location, at_faces);
  }

  int index_at(const halfedge_descriptor h) const
  {
    return m_mesh.is_border_or_outside(h) ? -1 : get(m_index, face(h, m_mesh.tmesh()));
  }
  bool is_new(const int f) const { return f != -1 && m_is_new[f]; }

  void measure_centroids()
  {
    const TriangleMesh& tm = m_mesh.tmesh();
    for(std::size_t i = 0; i < m_deviations.faces.size(); ++i)
    {
      if(!m_is_new[i])
        continue;
      m_mesh.give_up_if_stopped();
      const halfedge_descriptor h = halfedge(m_deviations.faces[i].face, tm);
      add_projection((m_mesh.point(source(h, tm)) + m_mesh.point(target(h, tm))
                      + m_mesh.point(target(next(h, tm), tm))) / 3.,
                     h, {static_cast<int>(i)});
    }
  }

  void measure_edges()
  {
    const TriangleMesh& tm = m_mesh.tmesh();
    for(const auto e : edges(tm))
    {
      halfedge_descriptor h = halfedge(e, tm);
      if(m_mesh.is_border_or_outside(h))
        h = opposite(h, tm);
      const int f = index_at(h), g = index_at(opposite(h, tm));
      if(!is_new(f) && !is_new(g))
        continue;
      m_mesh.give_up_if_stopped();
      const auto s = source(h, tm), t = target(h, tm);
      const Vector p = (m_mesh.point(s) + m_mesh.point(t)) / 2.;
      const int curve = m_mesh.curve(h);
      if(curve == -1)
      {
        add_projection(p, h, {f, g});
        continue;
      }
      const Site site = m_mesh.reference().curve_site(curve, (m_mesh.parameter(s, curve)
                                                             + m_mesh.parameter(t, curve)) / 2.);
      count((site.point - p).norm());
      add(p, (site.point - p).norm(), site.location, {f, g}, m_mesh.is_protected(h));
    }
  }

  void measure_vertices()
  {
    const TriangleMesh& tm = m_mesh.tmesh();
    for(const auto v : vertices(tm))
    {
      if(m_mesh.index(v) == -1)
        continue;
      const halfedge_descriptor h = first_remeshed_halfedge(m_mesh, v);
      if(h == Mesh::Graph_traits::null_halfedge() || !is_new(index_at(h)))
        continue;
      m_mesh.give_up_if_stopped();
      const Site& site = m_mesh.data(v).site;
      if(site.curve == -1)
      {
        count(0.);
        continue;
      }
      const Reference::Nearest nearest = m_mesh.reference().nearest(site.point, site.location, tolerance);
      count(nearest.distance);
      add(site.point, nearest.distance, nearest.location, {index_at(h)});
    }
  }

  void measure_targets()
  {
    const TriangleMesh& tm = m_mesh.tmesh();
    Indexed_triangles facets;
    std::vector<int> index_of_facet;
    for(std::size_t i = 0; i < m_deviations.faces.size(); ++i)
    {
      if(!m_is_new[i])
        continue;
      m_mesh.give_up_if_stopped();
      std::array<int, 3> triangle;
      halfedge_descriptor h = halfedge(m_deviations.faces[i].face, tm);
      for(int k = 0; k < 3; ++k, h = next(h, tm))
      {
        triangle[k] = facets.number_of_vertices();
        facets.points.push_back(m_mesh.point(source(h, tm)));
      }
      facets.triangles.push_back(triangle);
      index_of_facet.push_back(static_cast<int>(i));
    }
    if(index_of_facet.empty())
      return;
    const Triangle_tree tree(facets, progress());
    for(Deviation_target& target : m_targets.targets())
    {
      if(target.face != -1)
        continue;
      m_mesh.give_up_if_stopped();
      const std::pair<int, Vector> closest = tree.closest(target.point);
      target.face = index_of_facet[closest.first];
      const double distance = (closest.second - target.point).norm();
      add(target.point, distance, target.location, {target.face},
          distance > m_bound && is_on_protected_edge(closest.second, m_deviations.faces[target.face].face));
    }
  }

  bool is_on_protected_edge(const Vector& p, const face_descriptor f) const
  {
    const TriangleMesh& tm = m_mesh.tmesh();
    for(const halfedge_descriptor h : CGAL::halfedges_around_face(halfedge(f, tm), tm))
    {
      if(!m_mesh.is_protected(h))
        continue;
      const Vector a = m_mesh.point(source(h, tm)), direction = m_mesh.point(target(h, tm)) - a;
      if(direction.cross(p - a).norm() <= tolerance * direction.squaredNorm())
        return true;
    }
    return false;
  }
};

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_DEVIATION_METER_H
