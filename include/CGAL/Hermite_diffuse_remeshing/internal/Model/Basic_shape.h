// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_MODEL_BASIC_SHAPE_H
#define CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_MODEL_BASIC_SHAPE_H

#include <CGAL/Hermite_diffuse_remeshing/Model_choices.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Indexed_triangles.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Model/Monge_form.h>

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <vector>

namespace CGAL {
namespace Hermite_diffuse_remeshing {

namespace internal {

// One of the basic surfaces with its parameters.
struct Basic_shape
{
  Basic_surface_type type = FREE_FORM_SURFACE;
  Vector point = Vector::Zero(), direction = Vector::UnitZ();
  double radius = 0.;                   // sphere, cylinder, torus
  double tube_radius = 0.;              // torus
  double half_angle = 0.;               // cone

  // number of parameters that determine it
  int degrees_of_freedom() const
  {
    switch(type)
    {
      case PLANE_SURFACE:    return 3;
      case SPHERE_SURFACE:   return 4;
      case CYLINDER_SURFACE: return 5;
      case CONE_SURFACE:     return 6;
      case TORUS_SURFACE:    return 7;
      default:               return 0;
    }
  }

  // signed distance, and the unit normal: the gradient of the distance
  double distance(const Vector& p, Vector& normal) const
  {
    const Vector v = p - point;
    const double z = v.dot(direction);
    const Vector across = v - z * direction;
    switch(type)
    {
      case PLANE_SURFACE:
        normal = direction;
        return z;
      case SPHERE_SURFACE:
        normal = unit(v);
        return v.norm() - radius;
      case CYLINDER_SURFACE:
        normal = unit(across);
        return across.norm() - radius;
      case CONE_SURFACE:
        normal = std::cos(half_angle) * unit(across) - std::sin(half_angle) * direction;
        return std::cos(half_angle) * across.norm() - std::sin(half_angle) * z;
      default:
      {
        const Vector from_circle = v - radius * unit(across);
        normal = unit(from_circle);
        return from_circle.norm() - tube_radius;
      }
    }
  }

  double distance(const Vector& p) const
  {
    Vector normal;
    return distance(p, normal);
  }

  // largest absolute curvature at a point of the surface; of a torus that of its tube, which that of the circle around the
  // axis exceeds inside of a fat one
  double curvature(const Vector& p) const
  {
    const Vector v = p - point;
    const double across = (v - v.dot(direction) * direction).norm();
    switch(type)
    {
      case SPHERE_SURFACE:
      case CYLINDER_SURFACE: return 1. / radius;
      case CONE_SURFACE:     return across > 0. ? std::cos(half_angle) / across : 0.;
      case TORUS_SURFACE:    return 1. / tube_radius;
      default:               return 0.;
    }
  }

  // Gauss-Newton on the distances of points; false if it gets nowhere sensible. Moving the surface by
  // a small rotation w around its point changes a distance by -w . ((p - point) x normal).
  bool refine(const std::vector<Vector>& points)
  {
    typedef Eigen::Matrix<double, 7, 1> Row;
    constexpr int maximum_number_of_steps = 20;
    constexpr double relative_step = 1e-12, ridge = 1e-14;
    const int n = degrees_of_freedom();
    for(int step = 0; step < maximum_number_of_steps; ++step)
    {
      const Vector u = any_normal(direction), w = direction.cross(u);
      Eigen::Matrix<double, 7, 7> matrix = Eigen::Matrix<double, 7, 7>::Zero();
      Row rhs = Row::Zero();
      double scale = 0.;
      for(const Vector& p : points)
      {
        Vector normal;
        const double d = distance(p, normal);
        const Row row = derivatives(p, normal, u, w);
        matrix += row * row.transpose();
        rhs -= d * row;
        scale = (std::max)(scale, (p - points.front()).norm());
      }
      for(int i = 0; i < 7; ++i)
        matrix(i, i) += i < n ? ridge * matrix(i, i) : 1.;
      const Row x = matrix.ldlt().solve(rhs);
      if(!x.allFinite() || !apply(x, u, w))
        return false;
      // how far the surface moves at the points, rms, whatever the units of the unknowns
      if(x.dot(matrix * x) <= relative_step * relative_step * scale * scale * double(points.size()))
        break;
    }
    return true;
  }

private:
  static Vector unit(const Vector& v)
  {
    const double norm = v.norm();
    return norm > 0. ? Vector(v / norm) : Vector(Vector::Zero());
  }

  Eigen::Matrix<double, 7, 1> derivatives(const Vector& p, const Vector& normal, const Vector& u, const Vector& w) const
  {
    const Vector v = p - point, moment = v.cross(normal);
    Eigen::Matrix<double, 7, 1> row = Eigen::Matrix<double, 7, 1>::Zero();
    switch(type)
    {
      case PLANE_SURFACE:
        row.head<3>() << -1., -moment.dot(u), -moment.dot(w);
        break;
      case SPHERE_SURFACE:
        row.head<4>() << -normal, -1.;
        break;
      case CYLINDER_SURFACE:
        row.head<5>() << -normal.dot(u), -normal.dot(w), -moment.dot(u), -moment.dot(w), -1.;
        break;
      default:
      {
        row.head<5>() << -normal, -moment.dot(u), -moment.dot(w);
        const double z = v.dot(direction);
        const Vector across = v - z * direction;
        if(type == CONE_SURFACE)
          row[5] = -(std::sin(half_angle) * across.norm() + std::cos(half_angle) * z);
        else
        {
          row[5] = -normal.dot(unit(across));
          row[6] = -1.;
        }
      }
    }
    return row;
  }

  bool apply(const Eigen::Matrix<double, 7, 1>& x, const Vector& u, const Vector& w)
  {
    const auto turn = [&](const double a, const double b)
    { direction = (direction + (a * u + b * w).cross(direction)).normalized(); };
    switch(type)
    {
      case PLANE_SURFACE:
        point += x[0] * direction;
        turn(x[1], x[2]);
        return true;
      case SPHERE_SURFACE:
        point += x.head<3>();
        radius += x[3];
        return radius > 0.;
      case CYLINDER_SURFACE:
        point += x[0] * u + x[1] * w;
        turn(x[2], x[3]);
        radius += x[4];
        return radius > 0.;
      case CONE_SURFACE:
        point += x.head<3>();
        turn(x[3], x[4]);
        half_angle += x[5];
        return half_angle > 0. && half_angle < 1.57;
      default:
        point += x.head<3>();
        turn(x[3], x[4]);
        radius += x[5];
        tube_radius += x[6];
        return radius > 0. && tube_radius > 0.;
    }
  }
};

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_MODEL_BASIC_SHAPE_H
