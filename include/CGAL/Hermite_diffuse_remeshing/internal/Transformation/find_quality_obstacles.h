// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_FIND_QUALITY_OBSTACLES_H
#define CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_FIND_QUALITY_OBSTACLES_H

#include <CGAL/Hermite_diffuse_remeshing/Remeshing_report.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Transformation/raise_worst_faces.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <tuple>
#include <vector>

namespace CGAL {
namespace Hermite_diffuse_remeshing {
namespace internal {

// The quality of a triangle with a given angle, at most 60 degrees, between sides of lengths 1 and `ratio` <= 1:
// Q = 2 sqrt(3) rho / L with rho = (double area) / (perimeter) and L = 1. It grows with the ratio, so the best
// triangle with that angle is the isosceles one, with base 2 sin(a / 2): Q = sqrt(3) sin(a) / (1 + sin(a / 2)).
inline double quality_of_corner(const double angle, const double ratio)
{
  const double third = std::sqrt(1. + ratio * ratio - 2. * ratio * std::cos(angle));
  return 2. * std::sqrt(3.) * ratio * std::sin(angle) / (1. + ratio + third);
}

// Finds out why faces have a low quality.
template <typename UserMesh>
class Quality_obstacles
{
  typedef Working_mesh<UserMesh> Mesh;
  typedef typename Mesh::vertex_descriptor vertex_descriptor;
  typedef typename Mesh::halfedge_descriptor halfedge_descriptor;
  typedef typename Mesh::face_descriptor face_descriptor;
  typedef Low_quality_face<face_descriptor> Entry;

  Mesh& m_mesh;
  const Worst_face_hunt<UserMesh> m_hunt;

  static constexpr double right_angle = 1.57079632679489661923, sixty_degrees = right_angle / 1.5;

public:
  explicit Quality_obstacles(Mesh& mesh) : m_mesh(mesh), m_hunt(mesh, 1., 1.) {}

  // The worst first. Those that are reached after a stop have that for a reason.
  std::vector<Entry> explain(const std::vector<face_descriptor>& low_faces) const
  {
    struct Ranked
    {
      Entry entry;
      std::array<int, 3> corners;       // decide between equals, in an order that is the same for every type of mesh
    };
    std::vector<Ranked> ranked;
    for(const face_descriptor f : low_faces)
    {
      const Numbered_triangle t = m_mesh.triangle(f);
      Ranked r{Entry(), t.vertices};
      std::sort(r.corners.begin(), r.corners.end());
      r.entry.face = f;
      r.entry.quality = quality(t.points[0], t.points[1], t.points[2]);
      for(int i = 0; i < 3; ++i)
        r.entry.point[i] = (t.points[0][i] + t.points[1][i] + t.points[2][i]) / 3.;
      ranked.push_back(r);
    }
    std::sort(ranked.begin(), ranked.end(), [](const Ranked& a, const Ranked& b)
              { return std::tie(a.entry.quality, a.corners) < std::tie(b.entry.quality, b.corners); });
    std::vector<Entry> result;
    for(Ranked& r : ranked)
    {
      explain(r.entry);
      result.push_back(r.entry);
    }
    return result;
  }

private:
  void explain(Entry& entry) const
  {
    const auto& tm = m_mesh.tmesh();
    const halfedge_descriptor h = halfedge(entry.face, tm);
    const std::array<halfedge_descriptor, 3> sides = {{h, next(h, tm), prev(h, tm)}};
    entry.size = (m_mesh.size(source(h, tm)) + m_mesh.size(target(h, tm)) + m_mesh.size(target(next(h, tm), tm))) / 3.;
    if(m_mesh.is_stopped())
      return;
    const double angle = smallest_feature_angle(sides);
    if(is_low_quality_forced(angle))
    {
      entry.obstacle = QUALITY_AT_FEATURE_ANGLE;
      entry.angle = 90. * angle / right_angle;
      entry.best_quality = quality_of_corner(angle, 1.);
      return;
    }
    if(std::any_of(sides.begin(), sides.end(), [this](const halfedge_descriptor s) { return m_mesh.is_protected(s); }))
    {
      entry.obstacle = QUALITY_AT_PROTECTED_EDGE;
      return;
    }
    const auto is_shorter = [this](const halfedge_descriptor a, const halfedge_descriptor b)
                            { return m_mesh.length(a) < m_mesh.length(b); };
    const halfedge_descriptor shortest = *std::min_element(sides.begin(), sides.end(), is_shorter);
    const halfedge_descriptor longest = *std::max_element(sides.begin(), sides.end(), is_shorter);
    if(m_mesh.length(shortest) < entry.size
       && m_mesh.is_fixed(source(shortest, tm)) && m_mesh.is_fixed(target(shortest, tm))
       && is_low_quality_forced(2. * std::asin(m_mesh.length(shortest) / (2. * m_mesh.length(longest)))))
    {
      entry.obstacle = QUALITY_AT_CLOSE_CORNERS;
      entry.distance = m_mesh.length(shortest);
      return;
    }
    const double height = smallest_height(entry.face, m_mesh.length(longest));
    if(height < entry.size && is_between_features(sides))
    {
      entry.obstacle = QUALITY_BETWEEN_FEATURES;
      entry.distance = height;
      return;
    }
    const auto prospect = m_hunt.prospect(h);
    // a search that was stopped says nothing
    if(m_mesh.is_stopped())
    {
      entry.obstacle = QUALITY_AFTER_STOP;
      return;
    }
    switch(prospect)
    {
      case Worst_face_hunt<UserMesh>::FREE:         entry.obstacle = QUALITY_AFTER_STOP; break;
      case Worst_face_hunt<UserMesh>::NOT_FREE:     entry.obstacle = QUALITY_AT_INTERSECTION; break;
      case Worst_face_hunt<UserMesh>::NO_OPERATION:
        entry.obstacle = is_at_fold(sides) ? QUALITY_AT_FOLD : QUALITY_AT_OTHER_FACES;
    }
  }

  // Must a triangle with this angle have a low quality? The other edges at a feature have their own lengths, the ratio
  // of which may be the square root of 2 where all are as long as they should be.
  static bool is_low_quality_forced(const double angle)
  {
    constexpr double ratio_of_lengths = 0.70710678118654752440;
    return angle < sixty_degrees && quality_of_corner(angle, ratio_of_lengths) < Entry::low_quality;
  }

  // between the side h and the next one
  double corner_angle(const halfedge_descriptor h) const
  {
    const auto& tm = m_mesh.tmesh();
    const Vector a = m_mesh.point(source(h, tm)) - m_mesh.point(target(h, tm));
    const Vector b = m_mesh.point(target(next(h, tm), tm)) - m_mesh.point(target(h, tm));
    return std::atan2(a.cross(b).norm(), a.dot(b));
  }

  bool is_feature(const halfedge_descriptor h) const { return m_mesh.is_on_curve(h) || m_mesh.is_protected(h); }

  // The faces at the target of h between two features share the angle of these. Infinite if there are not two.
  double feature_angle(const halfedge_descriptor h) const
  {
    const auto& tm = m_mesh.tmesh();
    double sum = corner_angle(h);
    for(halfedge_descriptor g = h; !is_feature(next(g, tm)); sum += corner_angle(g))
    {
      g = opposite(next(g, tm), tm);
      if(g == h || m_mesh.is_border_or_outside(g))
        return std::numeric_limits<double>::infinity();
    }
    for(halfedge_descriptor g = h; !is_feature(g); sum += corner_angle(g))
    {
      g = prev(opposite(g, tm), tm);
      if(m_mesh.is_border_or_outside(g))
        return std::numeric_limits<double>::infinity();
    }
    return sum;
  }

  double smallest_feature_angle(const std::array<halfedge_descriptor, 3>& sides) const
  {
    double result = std::numeric_limits<double>::infinity();
    for(const halfedge_descriptor side : sides)
      result = (std::min)(result, feature_angle(side));
    return result;
  }

  double smallest_height(const face_descriptor f, const double longest) const
  {
    const Numbered_triangle t = m_mesh.triangle(f);
    return longest > 0. ? (t.points[1] - t.points[0]).cross(t.points[2] - t.points[0]).norm() / longest : 0.;
  }

  bool is_between_features(const std::array<halfedge_descriptor, 3>& sides) const
  {
    int number_on_curves = 0;
    for(const halfedge_descriptor side : sides)
    {
      if(m_mesh.data(target(side, m_mesh.tmesh())).type == SURFACE_VERTEX)
        return false;
      number_on_curves += m_mesh.is_on_curve(side);
    }
    return number_on_curves < 2;        // otherwise it fills a bend of one of them
  }

  // Is the face, or one beside it, turned against the model? The score of a triangle that is turned away by 45 degrees
  // is half its quality.
  bool is_at_fold(const std::array<halfedge_descriptor, 3>& sides) const
  {
    const Worth own = face_worth(m_mesh, sides[0]);
    return own.score <= 0.5 * own.quality
        || std::any_of(sides.begin(), sides.end(), [this](const halfedge_descriptor side)
                       { return worth_around(m_mesh, target(side, m_mesh.tmesh())).score <= 0.; });
  }
};

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_FIND_QUALITY_OBSTACLES_H
