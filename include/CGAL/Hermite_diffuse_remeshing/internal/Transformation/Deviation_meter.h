// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_DEVIATION_METER_H
#define CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_DEVIATION_METER_H

#include <CGAL/Hermite_diffuse_remeshing/internal/Transformation/Face_gaps.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Transformation/Ridge_point.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Transformation/Target_meter.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Transformation/measure_edge.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Transformation/propose_and_accept.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Transformation/select_vertices.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/for_each_index.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/selected_elements.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <initializer_list>
#include <utility>
#include <vector>

namespace CGAL {
namespace Hermite_diffuse_remeshing {
namespace internal {

// Measures the deviation of the working mesh from the reference. From the mesh to the model: at vertices and edge
// middles, at the centroids of faces that are not low, and where these tell that it is larger in between; at feature
// edges between the edge and its curve. And back, to the closest facet of the mesh: from points of the model, and of its
// ridges where edges cross them and between these. What is between the points is allowed for by a margin. Throws
// Interrupted on request.
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
  std::vector<int> m_new_faces;         // the numbers of those
  std::vector<Face_gaps> m_gaps;        // of those
  std::vector<Vector> m_normals;        // of those
  double m_second_look = 0.;            // distances below it need none

  // a face is measured at its vertices, its middles and its centroid
  static constexpr double weight_in_mean = 1. / 7.;
  // of the height from which a second look is needed: where the sides of a face are lower, the model needs not be asked
  // at the centroid
  static constexpr double part_of_centroids = 0.25;
  // Same: lower faces need no look at ridges. A ridge across an edge is twice as high as the model over its middle, the
  // rest is for what a curvature against it takes away from there.
  static constexpr double part_of_ridges = 0.25;
  // Of the height of the model over a face: a ridge that may rise by less is left to the part by which all deviations are
  // raised, and the face to its peak. What such ridges have been seen to add is 0.012 of the height.
  static constexpr double negligible_ridge = 0.02;
  // Of what is expected at ridges: none has been seen to rise to more than 1.3 times as much, but at folds, which the points
  // of the model tell of.
  static constexpr double largest_rise = 1.5;

public:
  // `bound`: deviations below it need no second look
  Deviation_meter(const Mesh& mesh, const double bound)
    : m_mesh(mesh), m_bound(bound / raised(mesh)), m_index(make_index_map())
    , m_targets(mesh.reference(), bound, (std::max)(mesh.maximum_number_of_faces(), mesh.number_of_faces()),
                [&mesh](const int f) { return mesh.is_reference_face_remeshed(f); }, mesh.progress())
  {
    m_deviations.raised = raised(mesh);
    m_deviations.model_distance = m_targets.model_distance();
  }

  Deviations<UserMesh>& deviations() { return m_deviations; }

  void measure()
  {
    m_deviations.faces.clear();
    m_is_new.clear();
    m_new_faces.clear();
    m_index = make_index_map();
    m_deviations.faces.reserve(m_mesh.number_of_faces());
    m_is_new.reserve(m_mesh.number_of_faces());
    m_new_faces.reserve(m_mesh.number_of_faces());
    for(const face_descriptor f : faces(m_mesh.tmesh()))
    {
      put(m_index, f, -1);
      if(m_mesh.is_remeshed(f))
        add_new_face(f);
    }
    for(Deviation_target& target : m_targets.targets())
      target.face = -1;
    measure_new_faces();
  }

  // Measures again what has changed since, and what deviates too much beside that. The points of the reference whose
  // closest face has changed look for it near by and among the faces that have changed: the distance to some of the
  // faces is an upper bound of the distance to all.
  void update(const std::size_t since)
  {
    std::vector<Face_deviation<face_descriptor> > old_faces;
    old_faces.swap(m_deviations.faces);
    m_is_new.clear();
    m_new_faces.clear();
    const Face_index_map old_index = m_index;
    m_index = make_index_map();
    std::vector<int> new_index(old_faces.size(), -1);
    for(const face_descriptor f : faces(m_mesh.tmesh()))
    {
      put(m_index, f, -1);
      if(!m_mesh.is_remeshed(f))
        continue;
      const bool is_new = m_mesh.has_new_shape(f, since);
      const int i = is_new ? -1 : get(old_index, f);
      if(is_new || (old_faces[i].deviation > m_deviations.raised * m_bound && has_changed_beside(f, since)))
      {
        add_new_face(f);
        continue;
      }
      m_mesh.give_up_if_stopped();
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
  static double raised(const Mesh& mesh)
  {
    return 1. + (is_smooth(mesh) ? Deviations<UserMesh>::unseen_part : Deviations<UserMesh>::unseen_part_at_facets);
  }

  // else the model stays near the facets of the reference, and has their edges
  static bool is_smooth(const Mesh& mesh) { return !mesh.reference().surface.saturation().is_bounded(); }

  // of the faces that there are now: the mesh is not ours, so the map does not grow with it
  Face_index_map make_index_map() const { return get(CGAL::dynamic_face_property_t<int>(), m_mesh.tmesh()); }

  void add_new_face(const face_descriptor f)
  {
    m_mesh.give_up_if_stopped();
    m_new_faces.push_back(static_cast<int>(m_deviations.faces.size()));
    put(m_index, f, m_new_faces.back());
    Face_deviation<face_descriptor> entry;
    entry.face = f;
    m_deviations.faces.push_back(entry);
    m_is_new.push_back(true);
  }

  // a closer face for a point of the reference may be there now
  bool has_changed_beside(const face_descriptor f, const std::size_t since) const
  {
    const TriangleMesh& tm = m_mesh.tmesh();
    for(const auto v : CGAL::vertices_around_face(halfedge(f, tm), tm))
      for(const halfedge_descriptor h : CGAL::halfedges_around_target(v, tm))
        if(m_mesh.has_changed(h, since))
          return true;
    return false;
  }

  void measure_new_faces()
  {
    m_gaps.assign(m_deviations.faces.size(), Face_gaps());
    m_normals.assign(m_deviations.faces.size(), Vector::Zero());
    for_each_index(static_cast<int>(m_new_faces.size()), m_mesh.is_parallel(), [&]
    {
      return [&](const int i)
      {
        const int f = m_new_faces[i];
        m_normals[f] = area_vector(m_mesh.triangle(m_deviations.faces[f].face)).stableNormalized();
      };
    }, m_mesh.progress());
    measure_edges();
    measure_vertices();
    find_second_look();
    measure_centroids();
    find_second_look();
    measure_ridges();
    find_second_look();
    measure_peaks();
    std::vector<face_descriptor> new_faces;
    for(const int f : m_new_faces)
      new_faces.push_back(m_deviations.faces[f].face);
    Target_meter<UserMesh>(m_mesh, m_index, std::move(new_faces), m_bound, m_second_look, m_targets, m_deviations)
      .measure(m_mesh.progress());
    m_deviations.summarize();
    m_gaps.clear();
    m_normals.clear();
  }

  void find_second_look()
  {
    m_deviations.summarize();
    m_second_look = (std::min)(m_bound, m_deviations.largest / m_deviations.raised);
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

  void add_to_mean(const double distance, const int f)
  {
    if(is_new(f))
      m_deviations.faces[f].mean += weight_in_mean * distance;
  }

  int index_at(const halfedge_descriptor h) const
  {
    return m_mesh.is_border_or_outside(h) ? -1 : get(m_index, face(h, m_mesh.tmesh()));
  }
  bool is_new(const int f) const { return f != -1 && m_is_new[f]; }

  // A face with low sides has a low centroid, which they tell without the model, if this is smooth.
  void measure_centroids()
  {
    const Barycentric center = {{1. / 3., 1. / 3., 1. / 3.}};
    std::vector<int> high_faces;
    for(const int f : m_new_faces)
    {
      Face_gaps& gaps = m_gaps[f];
      gaps.centroid = gaps.height_of_quadric();
      if(!is_smooth(m_mesh) || gaps.bound() + gaps.ridge > part_of_centroids * m_second_look)
        high_faces.push_back(f);
      else
        enter_centroid(f, {m_deviations.faces[f].location, std::abs(gaps.centroid)});
    }
    measure_at(high_faces, [&](const int f) { return nearest_at(f, center); },
               [&](const int f, const Reference::Nearest& nearest)
    {
      enter_centroid(f, nearest);
      m_gaps[f].centroid = std::copysign(nearest.distance, nearest.gap.dot(m_normals[f]));
    });
  }

  void enter_centroid(const int f, const Reference::Nearest& nearest)
  {
    m_deviations.add(point_of_face(f, {{1. / 3., 1. / 3., 1. / 3.}}), nearest.distance, nearest.location, {f});
    add_to_mean(nearest.distance, f);
  }

  Vector point_of_face(const int f, const Barycentric& l) const
  {
    const std::array<Vector, 3> p = m_mesh.triangle(m_deviations.faces[f].face).points;
    return l[0] * p[0] + l[1] * p[1] + l[2] * p[2];
  }

  void measure_edges()
  {
    const TriangleMesh& tm = m_mesh.tmesh();
    std::vector<halfedge_descriptor> new_edges;
    new_edges.reserve(2 * m_new_faces.size());
    for(const int f : m_new_faces)
    {
      m_mesh.give_up_if_stopped();
      for(const halfedge_descriptor h : CGAL::halfedges_around_face(halfedge(m_deviations.faces[f].face, tm), tm))
        // each once, from the side that is the same for every mesh type
        if(!is_new(index_at(opposite(h, tm))) || m_mesh.index(source(h, tm)) < m_mesh.index(target(h, tm)))
          new_edges.push_back(h);
    }
    measure_at(new_edges, [&](const halfedge_descriptor h) { return measure_edge(m_mesh, h, m_bound); },
               [&](const halfedge_descriptor h, const Edge_measurement& measured)
    {
      const bool is_on_curve = m_mesh.is_on_curve(h);
      const Reference::Nearest& nearest = measured.nearest;
      m_deviations.add(middle_of_chord(m_mesh, h), measured.deviation, nearest.location, {index_at(h), index_at(opposite(h, tm))},
                       is_on_curve && m_mesh.is_protected(h));
      for(const halfedge_descriptor side : {h, opposite(h, tm)})
      {
        const int i = index_at(side);
        add_to_mean(nearest.distance, i);
        if(!is_new(i))
          continue;
        set_gap(side, is_on_curve ? 0. : nearest.distance, nearest.gap);
        m_gaps[i].ridge = (std::max)(m_gaps[i].ridge, measured.ridge);
      }
    });
  }

  void measure_ridges()
  {
    const TriangleMesh& tm = m_mesh.tmesh();
    const auto is_high = [&](const int f)
    {
      // near its facets the model may go up and down between the middles, which tell nothing
      if(!is_smooth(m_mesh))
        return true;
      return f != -1 && m_gaps[f].ridge > negligible_ridge * m_gaps[f].bound()
          && m_gaps[f].bound() > part_of_ridges * m_second_look
          && largest_rise * (m_gaps[f].bound() + m_gaps[f].ridge) > m_second_look;
    };
    const std::vector<int> high_faces = selected_elements(m_new_faces, m_mesh.is_parallel(), [&](const int f)
    {
      const auto sides = CGAL::halfedges_around_face(halfedge(m_deviations.faces[f].face, tm), tm);
      // what is too high at an edge is so for both its faces
      return is_high(f) || std::any_of(sides.begin(), sides.end(), [&](const halfedge_descriptor h)
                                       { return is_high(index_at(opposite(h, tm))); });
    }, m_mesh.progress());
    measure_at(high_faces, [&](const int f) { return ridge_points_over_face(m_mesh, m_deviations.faces[f].face); },
               [&](const int f, const std::vector<Ridge_point>& points)
    {
      for(const Ridge_point& ridge : points)
        m_deviations.add(ridge.point, ridge.distance, ridge.location, {f});
    });
  }

  // At an edge on a curve, which the model may leave in the plane of the face, only what is across the plane counts.
  void set_gap(const halfedge_descriptor side, const double distance, const Vector& gap)
  {
    const TriangleMesh& tm = m_mesh.tmesh();
    const halfedge_descriptor first = halfedge(face(side, tm), tm);
    const int k = side == first ? 0 : side == next(first, tm) ? 1 : 2;
    const double across = gap.dot(m_normals[index_at(side)]);
    m_gaps[index_at(side)].middles[k] = std::copysign((std::max)(distance, std::abs(across)), across);
  }

  // The vertices inside the surface are on the model, but for those that could not be put there.
  void measure_vertices()
  {
    const TriangleMesh& tm = m_mesh.tmesh();
    std::vector<halfedge_descriptor> new_vertices;      // a halfedge to each
    for(const auto v : vertices(tm))
    {
      m_mesh.give_up_if_stopped();
      if(m_mesh.index(v) == -1 || (m_mesh.site(v).curve == -1 && !m_mesh.site(v).is_sketched))
        continue;
      const halfedge_descriptor h = first_remeshed_halfedge(m_mesh, v);
      if(h != Mesh::Graph_traits::null_halfedge() && has_new_face(v))
        new_vertices.push_back(h);
    }
    measure_at(new_vertices, [&](const halfedge_descriptor h)
    {
      const Site& site = m_mesh.site(target(h, tm));
      return m_mesh.reference().nearest(site.point, site.location, tolerance_of_deviation);
    }, [&](const halfedge_descriptor h, const Reference::Nearest& nearest)
    {
      m_deviations.add(m_mesh.point(target(h, tm)), nearest.distance, nearest.location, {index_at(h)});
      for(const halfedge_descriptor g : CGAL::halfedges_around_target(target(h, tm), tm))
        add_to_mean(nearest.distance, index_at(g));
    });
  }

  bool has_new_face(const typename Mesh::vertex_descriptor v) const
  {
    for(const halfedge_descriptor h : CGAL::halfedges_around_target(v, m_mesh.tmesh()))
      if(is_new(index_at(h)))
        return true;
    return false;
  }

  void measure_peaks()
  {
    const std::vector<int> high_faces = selected_elements(m_new_faces, m_mesh.is_parallel(), [&](const int f)
    {
      if(m_gaps[f].bound() <= m_second_look)
        return false;
      const double height = std::abs(m_gaps[f](m_gaps[f].peak()));
      return height > m_second_look && m_deviations.raised * height > m_deviations.faces[f].deviation;
    }, m_mesh.progress());
    measure_at(high_faces, [&](const int f) { return nearest_at(f, m_gaps[f].peak()); },
               [&](const int f, const Reference::Nearest& nearest)
               { m_deviations.add(point_of_face(f, m_gaps[f].peak()), nearest.distance, nearest.location, {f}); });
  }

  Reference::Nearest nearest_at(const int f, const Barycentric& l) const
  {
    return nearest_on_model(m_mesh, point_of_face(f, l), halfedge(m_deviations.faces[f].face, m_mesh.tmesh()), m_bound);
  }
};

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_DEVIATION_METER_H
