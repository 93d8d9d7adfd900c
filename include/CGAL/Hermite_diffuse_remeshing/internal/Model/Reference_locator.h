// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_MODEL_REFERENCE_LOCATOR_H
#define CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_MODEL_REFERENCE_LOCATOR_H

#include <CGAL/Hermite_diffuse_remeshing/internal/Model/Reference_surface.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Model/Triangle_tree.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Progress.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

namespace CGAL {
namespace Hermite_diffuse_remeshing {
namespace internal {

// Finds points on the reference. A query with a hint walks from face to face without ever crossing
// a feature; one without asks the tree.
class Reference_locator
{
  const Reference_surface& m_surface;
  std::unique_ptr<Triangle_tree> m_tree;          // null: all queries have hints, as those of a remeshing

public:
  explicit Reference_locator(const Reference_surface& surface) : m_surface(surface) {}

  // for queries without hints
  void build_tree(const Progress& progress = Progress())
  {
    m_tree = std::make_unique<Triangle_tree>(m_surface.triangles(), progress);
  }

  // closest point of all facets; asks the tree
  Location closest(const Vector& p) const
  {
    CGAL_precondition(m_tree != nullptr);
    return location_on_face(m_tree->closest(p).first, p);
  }

  // Descends from face to face to a facet point that no neighbouring face improves. The result is
  // the closest point in the neighbourhood of the hint, on its side of every feature.
  Location walk(const Vector& p, const int hint) const
  {
    const Indexed_triangles& triangles = m_surface.triangles();
    const Cut_mesh& cut_mesh = m_surface.cut_mesh();
    Location best = location_on_face(hint, p);
    double best_distance2 = (triangles.point(best) - p).squaredNorm();
    for(;;)
    {
      const Location current = best;
      // a step must be a real one: ties between faces end the walk
      const double least_gain = 1e-12 * best_distance2;
      const auto visit = [&](const int f)
      {
        if(f == -1)
          return;
        const Location candidate = location_on_face(f, p);
        const double distance2 = (triangles.point(candidate) - p).squaredNorm();
        if(distance2 < best_distance2 - least_gain)
        {
          best_distance2 = distance2;
          best = candidate;
        }
      };

      const Barycentric& l = current.coordinates;
      const int number_of_zeros = is_zero(l[0]) + is_zero(l[1]) + is_zero(l[2]);
      if(number_of_zeros == 0)
        break;
      for(int k = 0; k < 3; ++k)
        if(number_of_zeros == 1 && is_zero(l[previous(k)]))
          visit(cut_mesh.neighbor(current.face, k));
        else if(number_of_zeros == 2 && !is_zero(l[k]))
          for(const int corner : cut_mesh.corners(cut_mesh.node(current.face, k)))
            visit(corner / 3);
      if(best.face == current.face)
        break;
    }
    return canonical(best);
  }

  // A point on an interior edge belongs to two faces: the one with the smaller index is used, so
  // that rounding does not decide.
  Location canonical(const Location& location) const
  {
    const Barycentric& l = location.coordinates;
    for(int k = 0; k < 3; ++k)
    {
      if(!is_zero(l[previous(k)]) || is_zero(l[k]) || is_zero(l[next(k)]))
        continue;
      const int g = m_surface.cut_mesh().neighbor(location.face, k);
      if(g == -1 || g > location.face)
        continue;
      const std::array<int, 3>& t = m_surface.triangles().triangles[location.face];
      const std::array<int, 3>& u = m_surface.triangles().triangles[g];
      Location moved;
      moved.face = g;
      const double sum = l[k] + l[next(k)];
      for(int j = 0; j < 3; ++j)
        moved.coordinates[j] = u[j] == t[k] ? l[k] / sum : u[j] == t[next(k)] ? l[next(k)] / sum : 0.;
      return moved;
    }
    return location;
  }

  // Newton on the local quadric (foot of p), walking on the facets: the point of the model closest
  // to p near the hint. `tolerance` is relative to the local size.
  struct Projection
  {
    Location location;
    Local_quadric quadric;
    bool is_foot = false;     // else a border or a feature has stopped it, or it has not converged
  };

  Projection project(const Vector& p, const int hint, const double tolerance = 1e-6) const
  {
    return project_from(p, start_at(walk(p, hint)), tolerance);
  }

  // no projection yet
  Projection start_at(const Location& location) const { return {location, m_surface.evaluate(location)}; }

  // same, with a start for Newton's method. Whom the distance alone concerns is content with less: the height of p
  // above the tangent plane, where that is the distance up to `part_of_distance` of it.
  Projection project_from(const Vector& p, const Projection& start, const double tolerance,
                          const double part_of_distance = 0.) const
  {
    constexpr int maximum_number_of_steps = 30;
    // At a fold Newton's method may go from one part of the surface to another for ever: so many steps together have to
    // bring it nearer by a considerable part.
    constexpr int maximum_number_of_steps_in_vain = 4;
    constexpr double considerable_part = 0.7;
    // a step far below the tolerance; one just below it may still be the one that reaches it
    constexpr double stall = 1e-3;
    Projection best = start;
    double best_residual = tangential_residual(best.quadric, p);
    Projection current = best;
    int steps_in_vain = 0;
    double last_considerable_residual = best_residual;
    for(int step = 0; step < maximum_number_of_steps; ++step)
    {
      best.is_foot = best_residual <= tolerance
                  || (is_height_distance(best.quadric, best_residual, p, part_of_distance) && !is_at_rim(best.location));
      if(best.is_foot || steps_in_vain == maximum_number_of_steps_in_vain)
        break;
      const Vector target = base_point_of_foot(current.quadric, p);
      const Location location = walk_along(target, current.location.face, current.quadric.z_axis);
      if((m_surface.triangles().point(location) - current.quadric.origin).norm()
         <= stall * tolerance * current.quadric.size)
        break;                   // stopped by a border or a feature
      current.location = location;
      current.quadric = m_surface.evaluate(location);
      const double residual = tangential_residual(current.quadric, p);
      const bool is_considerable = residual < considerable_part * last_considerable_residual;
      steps_in_vain = is_considerable ? 0 : steps_in_vain + 1;
      if(is_considerable)
        last_considerable_residual = residual;
      if(residual < best_residual)
      {
        best = current;
        best_residual = residual;
      }
    }
    return best;
  }

  Location location_on_face(const int f, const Vector& p) const
  {
    return closest_on_face(m_surface.triangles(), f, p);
  }

private:
  // of a barycentric coordinate: far above its rounding, far below anything that can be seen
  static bool is_zero(const double coordinate)
  {
    constexpr double on_edge = 1e-9;
    return coordinate <= on_edge;
  }

  // walk to the base point `target` of the moving frame; the reference's facets are the parameter
  // domain, so the foot of the perpendicular in direction z is taken on the first face
  Location walk_along(const Vector& target, const int face, const Vector& z) const
  {
    const Vector n = m_surface.triangles().area_vector(face);
    const double nz = n.dot(z);
    constexpr double least_cosine = 0.2;
    if(nz > least_cosine * n.norm())
      return walk(target - (target - m_surface.triangles().point(face, 0)).dot(n) / nz * z, face);
    return walk(target, face);
  }

  static double tangential_residual(const Local_quadric& quadric, const Vector& p)
  {
    const Vector r = p - quadric.point();
    const Vector n = quadric.normal();
    return (r - r.dot(n) * n).norm() / quadric.size;
  }

  // on a border or a feature, where the model ends
  bool is_at_rim(const Location& location) const
  {
    const Barycentric& l = location.coordinates;
    const Cut_mesh& cut_mesh = m_surface.cut_mesh();
    for(int k = 0; k < 3; ++k)
      if((is_zero(l[previous(k)]) && cut_mesh.neighbor(location.face, k) == -1)
         || (is_zero(l[previous(k)]) && is_zero(l[next(k)]) && cut_mesh.is_open(cut_mesh.node(location.face, k))))
        return true;
    return false;
  }

  // At s along the surface from the foot the height above the tangent plane differs from the distance by k s^2 / 2,
  // k the curvature.
  static bool is_height_distance(const Local_quadric& quadric, const double s, const Vector& p, const double part)
  {
    const std::array<double, 6>& a = quadric.a;
    const double largest_curvature = std::sqrt(4.*a[3]*a[3] + 2.*a[4]*a[4] + 4.*a[5]*a[5]);
    const double height = std::abs((p - quadric.point()).dot(quadric.normal())) / quadric.size;
    return largest_curvature * s * s / 2. <= part * height;
  }

  // foot of p on the quadratic part of the fit, moved back to the plane of the frame
  static Vector base_point_of_foot(const Local_quadric& quadric, const Vector& p)
  {
    constexpr int number_of_newton_steps = 5;
    constexpr double least_determinant = 0.05, longest_step = 2.;
    const std::array<double, 6>& a = quadric.a;
    const Vector d = (p - quadric.origin) / quadric.size;
    const double qx = d.dot(quadric.x_axis), qy = d.dot(quadric.y_axis), qz = d.dot(quadric.z_axis);
    double x = 0., y = 0.;
    for(int i = 0; i < number_of_newton_steps; ++i)
    {
      const double e = a[0] + a[1]*x + a[2]*y + a[3]*x*x + a[4]*x*y + a[5]*y*y - qz;
      const double zx = a[1] + 2.*a[3]*x + a[4]*y, zy = a[2] + a[4]*x + 2.*a[5]*y;
      const double gx = (x - qx) + e * zx, gy = (y - qy) + e * zy;
      double hxx = 1. + zx*zx + 2.*e*a[3], hxy = zx*zy + e*a[4], hyy = 1. + zy*zy + 2.*e*a[5];
      double determinant = hxx*hyy - hxy*hxy;
      if(determinant < least_determinant || hxx < least_determinant)
      {
        hxx = 1. + zx*zx;
        hxy = zx*zy;
        hyy = 1. + zy*zy;
        determinant = hxx*hyy - hxy*hxy;
      }
      x -= (hyy*gx - hxy*gy) / determinant;
      y -= (hxx*gy - hxy*gx) / determinant;
      const double length = std::hypot(x, y);
      if(length > longest_step)
      {
        x *= longest_step / length;
        y *= longest_step / length;
        break;
      }
    }
    return quadric.origin + quadric.size * (x * quadric.x_axis + y * quadric.y_axis);
  }
};

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_MODEL_REFERENCE_LOCATOR_H
