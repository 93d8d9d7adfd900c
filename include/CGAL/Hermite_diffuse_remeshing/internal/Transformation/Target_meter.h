// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_TARGET_METER_H
#define CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_TARGET_METER_H

#include <CGAL/Hermite_diffuse_remeshing/internal/Transformation/Deviation_targets.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Transformation/Deviations.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Transformation/closest_face.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Transformation/propose_and_accept.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL {
namespace Hermite_diffuse_remeshing {
namespace internal {

// of the bound: above it the surroundings of a point are looked at, too
constexpr double part_to_look_around = 0.8;

// Measures back, from points of the model to the closest facet of the mesh: those points whose face is not known.
template <typename UserMesh>
class Target_meter
{
  typedef Working_mesh<UserMesh> Mesh;
  typedef typename Mesh::face_descriptor face_descriptor;
  typedef typename boost::property_map<typename Mesh::TriangleMesh,
                                       CGAL::dynamic_face_property_t<int> >::const_type Face_index_map;
  typedef Closest_on_mesh<face_descriptor> Closest;

  const Mesh& m_mesh;
  Face_index_map m_index;               // in `m_deviations.faces`
  std::vector<face_descriptor> m_new_faces;
  double m_bound, m_second_look;
  Deviation_targets& m_targets;
  Deviations<UserMesh>& m_deviations;

  // relative to the height of a face: so near is on an edge
  static constexpr double tolerance = 1e-3;

public:
  Target_meter(const Mesh& mesh, const Face_index_map& index, std::vector<face_descriptor> new_faces,
               const double bound, const double second_look, Deviation_targets& targets,
               Deviations<UserMesh>& deviations)
    : m_mesh(mesh), m_index(index), m_new_faces(std::move(new_faces)), m_bound(bound), m_second_look(second_look)
    , m_targets(targets), m_deviations(deviations)
  {}

  // What is found from a face near by, in several threads, is a distance already; where it is large, all new faces are
  // searched.
  void measure(const Progress& progress)
  {
    std::vector<Deviation_target*> targets;
    for(Deviation_target& target : m_targets.targets())
      if(target.face == -1)
        targets.push_back(&target);
    const std::vector<int> near = faces_near_reference();
    const auto walk = [&](const Vector& p, const int start)
    { return start != -1 ? walk_to_closest(m_mesh, m_deviations.faces[start].face, p) : Closest(); };
    std::unique_ptr<Face_search<UserMesh> > search;
    const auto look_farther = [&](const Vector& p, const int start, const Closest& found)
    {
      if(start != -1 && found.distance2 <= m_second_look * m_second_look)
        return found;
      if(search == nullptr)
        search.reset(new Face_search<UserMesh>(m_mesh, m_new_faces, progress));
      const Closest other = search->closest(p);
      return start == -1 || other.distance2 < found.distance2 ? other : found;
    };
    double largest = 0.;
    propose_and_accept(m_mesh, targets.begin(), targets.end(), [&](const Deviation_target* const target)
                       { return walk(target->point, near[target->location.face]); },
                       [&](Deviation_target* const target, const Closest& found, std::size_t)
    {
      const Closest at_target = look_farther(target->point, near[target->location.face], found);
      target->face = get(m_index, at_target.face);
      add_target(target->point, at_target, target->location);
      // Above the bound it matters no more how far a point is, but for the farthest.
      const double distance = std::sqrt(at_target.distance2);
      if(distance > part_to_look_around * m_bound && (distance <= m_bound || distance > largest)
         && m_targets.number_of_parts(target->location) > 1)
        climb(*target, at_target, [&](const Vector& p, const int start) { return look_farther(p, start, walk(p, start)); });
      largest = (std::max)(largest, distance);
    });
    m_mesh.give_up_if_stopped();
  }

private:
  // For each face of the reference one of the mesh: over it, or over the nearest one around that has some, in steps
  // from face to face across interior edges; -1 where there is none.
  std::vector<int> faces_near_reference() const
  {
    const Cut_mesh& cut_mesh = m_mesh.reference().surface.cut_mesh();
    std::vector<int> result(m_mesh.reference().surface.triangles().number_of_faces(), -1), queue;
    for(std::size_t i = 0; i < m_deviations.faces.size(); ++i)
    {
      int& near = result[m_mesh.hint(m_deviations.faces[i].face)];
      if(near == -1)
        queue.push_back(m_mesh.hint(m_deviations.faces[i].face));
      near = static_cast<int>(i);
    }
    for(std::size_t at = 0; at < queue.size(); ++at)
      for(int k = 0; k < 3; ++k)
      {
        const int beside = cut_mesh.neighbor(queue[at], k);
        if(beside == -1 || result[beside] != -1)
          continue;
        result[beside] = result[queue[at]];
        queue.push_back(beside);
      }
    return result;
  }

  void add_target(const Vector& p, const Closest& closest, const Location& location)
  {
    const double distance = std::sqrt(closest.distance2);
    m_deviations.add(p, distance, location, {get(m_index, closest.face)},
                     distance > m_bound && is_on_protected_edge(m_mesh, closest, tolerance));
  }

  // From a point of the model that is nearly too far away to one between it and the next ones that is farther. The
  // model has a slight ridge along the sides of coarse faces, of which smooth heights over a face of the mesh know nothing.
  // Ends where the bound is out of reach.
  template <typename FindClosest>
  void climb(const Deviation_target& target, const Closest& at_target, const FindClosest& find_closest)
  {
    constexpr int number_of_halvings = 3;
    Closest best = at_target;
    Vector best_point = target.point;
    Location best_location = target.location;
    double step = 1. / m_targets.number_of_parts(target.location);
    for(int i = 0; i < number_of_halvings; ++i)
    {
      step /= 2.;
      double least_distance2 = best.distance2;
      for(const Location& location : locations_around(best_location, step))
      {
        const Vector p = m_mesh.reference().surface_point(location);
        const Closest closest = find_closest(p, get(m_index, best.face));
        least_distance2 = (std::min)(least_distance2, closest.distance2);
        if(closest.distance2 <= best.distance2)
          continue;
        best = closest;
        best_point = p;
        best_location = location;
      }
      // The steps that are left are shorter together than this one, over which the distance has changed by so much
      // at most.
      const double distance = std::sqrt(best.distance2), largest_change = distance - std::sqrt(least_distance2);
      if(distance + largest_change <= m_bound)
        break;
    }
    if(best.distance2 > at_target.distance2)
      add_target(best_point, best, best_location);
  }
};

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_TARGET_METER_H
