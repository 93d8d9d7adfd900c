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
#include <CGAL/Hermite_diffuse_remeshing/internal/Transformation/propose_and_accept.h>
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

  // between a point of the mesh and the reference
  struct Distance
  {
    Vector point = Vector::Zero();
    Reference::Nearest nearest;
  };

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

  // Measures at places of the mesh, `measure(place)` in several threads, and enters the results in the order of the
  // places.
  template <typename Place, typename Measure, typename Enter>
  void measure_at(const std::vector<Place>& places, const Measure& measure, const Enter& enter) const
  {
    propose_and_accept(m_mesh, places.begin(), places.end(), measure,
                       [&](const Place& place, const auto& result, std::size_t) { enter(place, result); });
    m_mesh.give_up_if_stopped();
  }

  void add(const Distance& distance, const std::initializer_list<int> at_faces, const bool is_on_protected_edge = false)
  {
    for(const int f : at_faces)
      if(f != -1 && distance.nearest.distance >= m_deviations.faces[f].deviation)
      {
        Face_deviation<face_descriptor>& entry = m_deviations.faces[f];
        entry.deviation = distance.nearest.distance;
        entry.point = distance.point;
        entry.location = distance.nearest.location;
        entry.is_on_protected_edge = is_on_protected_edge;
      }
  }

  // of a point of the mesh, which counts for the mean
  void add_and_count(const Distance& distance, const std::initializer_list<int> at_faces,
                     const bool is_on_protected_edge = false)
  {
    m_sum += distance.nearest.distance;
    ++m_number;
    add(distance, at_faces, is_on_protected_edge);
  }

  // Newton's method starts from the facet's point that is closest. Where the surface is steep over its
  // facets it may end at another part of the surface: before a point counts as too far away, the
  // locations of the vertices around it are tried.
  Distance distance_of_facet_point(const Vector& p, const halfedge_descriptor h) const
  {
    const Reference& reference = m_mesh.reference();
    const TriangleMesh& tm = m_mesh.tmesh();
    Distance result{p, reference.nearest(p, reference.locator.walk(p, m_mesh.hint(h)), tolerance)};
    if(result.nearest.distance > m_bound)
      for(const auto v : {source(h, tm), target(h, tm), target(next(h, tm), tm)})
      {
        const Reference::Nearest other = reference.nearest(p, m_mesh.data(v).site.location, tolerance);
        if(other.distance < result.nearest.distance)
          result.nearest = other;
      }
    return result;
  }

  int index_at(const halfedge_descriptor h) const
  {
    return m_mesh.is_border_or_outside(h) ? -1 : get(m_index, face(h, m_mesh.tmesh()));
  }
  bool is_new(const int f) const { return f != -1 && m_is_new[f]; }

  void measure_centroids()
  {
    std::vector<int> new_faces;
    for(std::size_t i = 0; i < m_deviations.faces.size(); ++i)
      if(m_is_new[i])
        new_faces.push_back(static_cast<int>(i));
    measure_at(new_faces, [&](const int i)
    {
      const std::array<Vector, 3> corners = m_mesh.triangle(m_deviations.faces[i].face).points;
      return distance_of_facet_point((corners[0] + corners[1] + corners[2]) / 3.,
                                     halfedge(m_deviations.faces[i].face, m_mesh.tmesh()));
    }, [&](const int i, const Distance& distance) { add_and_count(distance, {i}); });
  }

  void measure_edges()
  {
    const TriangleMesh& tm = m_mesh.tmesh();
    std::vector<halfedge_descriptor> new_edges;
    for(const auto e : edges(tm))
    {
      const halfedge_descriptor h = m_mesh.is_border_or_outside(halfedge(e, tm)) ? opposite(halfedge(e, tm), tm)
                                                                                 : halfedge(e, tm);
      if(is_new(index_at(h)) || is_new(index_at(opposite(h, tm))))
        new_edges.push_back(h);
    }
    measure_at(new_edges, [&](const halfedge_descriptor h)
    {
      const auto s = source(h, tm), t = target(h, tm);
      const Vector p = (m_mesh.point(s) + m_mesh.point(t)) / 2.;
      const int curve = m_mesh.curve(h);
      if(curve == -1)
        return distance_of_facet_point(p, h);
      const Site site = m_mesh.reference().curve_site(curve, (m_mesh.parameter(s, curve)
                                                             + m_mesh.parameter(t, curve)) / 2.);
      return Distance{p, {site.location, (site.point - p).norm()}};
    }, [&](const halfedge_descriptor h, const Distance& distance)
    {
      add_and_count(distance, {index_at(h), index_at(opposite(h, tm))}, m_mesh.is_on_curve(h) && m_mesh.is_protected(h));
    });
  }

  void measure_vertices()
  {
    const TriangleMesh& tm = m_mesh.tmesh();
    std::vector<halfedge_descriptor> new_vertices;      // of curves; a halfedge to each
    for(const auto v : vertices(tm))
    {
      if(m_mesh.index(v) == -1)
        continue;
      const halfedge_descriptor h = first_remeshed_halfedge(m_mesh, v);
      if(h == Mesh::Graph_traits::null_halfedge() || !is_new(index_at(h)))
        continue;
      if(m_mesh.site(v).curve == -1)
        ++m_number;                     // on the model
      else
        new_vertices.push_back(h);
    }
    measure_at(new_vertices, [&](const halfedge_descriptor h)
    {
      const Site& site = m_mesh.site(target(h, tm));
      return Distance{site.point, m_mesh.reference().nearest(site.point, site.location, tolerance)};
    }, [&](const halfedge_descriptor h, const Distance& distance) { add_and_count(distance, {index_at(h)}); });
  }

  void measure_targets()
  {
    Indexed_triangles facets;
    std::vector<int> index_of_facet;
    for(std::size_t i = 0; i < m_deviations.faces.size(); ++i)
    {
      if(!m_is_new[i])
        continue;
      m_mesh.give_up_if_stopped();
      const int first = facets.number_of_vertices();
      for(const Vector& p : m_mesh.triangle(m_deviations.faces[i].face).points)
        facets.points.push_back(p);
      facets.triangles.push_back({{first, first + 1, first + 2}});
      index_of_facet.push_back(static_cast<int>(i));
    }
    if(index_of_facet.empty())
      return;
    const Triangle_tree tree(facets, progress());
    std::vector<Deviation_target*> lost_targets;
    for(Deviation_target& target : m_targets.targets())
      if(target.face == -1)
        lost_targets.push_back(&target);
    measure_at(lost_targets, [&](const Deviation_target* const target) { return tree.closest(target->point); },
               [&](Deviation_target* const target, const std::pair<int, Vector>& closest)
    {
      target->face = index_of_facet[closest.first];
      const double distance = (closest.second - target->point).norm();
      add({target->point, {target->location, distance}}, {target->face},
          distance > m_bound && is_on_protected_edge(closest.second, m_deviations.faces[target->face].face));
    });
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
