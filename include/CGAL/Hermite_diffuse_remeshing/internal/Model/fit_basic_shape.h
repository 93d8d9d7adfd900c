// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_MODEL_FIT_BASIC_SHAPE_H
#define CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_MODEL_FIT_BASIC_SHAPE_H

#include <CGAL/Hermite_diffuse_remeshing/internal/Model/Basic_shape.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Model/Monge_form.h>

#include <Eigen/Dense>

#include <cmath>
#include <vector>

namespace CGAL {
namespace Hermite_diffuse_remeshing {
namespace internal {

// First guesses of basic surfaces from points, and from tangent planes, which may be those of other points; refined
// afterwards. False if the data do not have such a shape at all.

struct Tangent_planes
{
  std::vector<Vector> points, normals;

  void add(const Vector& point, const Vector& normal)
  {
    points.push_back(point);
    normals.push_back(normal);
  }
};

inline Vector mean_point(const std::vector<Vector>& points)
{
  Vector sum = Vector::Zero();
  for(const Vector& p : points)
    sum += p;
  return sum / double(points.size());
}

// unit eigenvector of the smallest eigenvalue of sum (v - center) (v - center)^T
inline Vector least_direction(const std::vector<Vector>& vectors, const Vector& center)
{
  Eigen::Matrix3d matrix = Eigen::Matrix3d::Zero();
  for(const Vector& v : vectors)
    matrix += (v - center) * (v - center).transpose();
  return Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(matrix).eigenvectors().col(0);
}

// center and radius by |p|^2 = 2 p.c + (r^2 - |c|^2), which is linear, with coordinates from the mean
inline bool guess_sphere(const std::vector<Vector>& points, Basic_shape& shape)
{
  const Vector origin = mean_point(points);
  Eigen::Matrix4d matrix = Eigen::Matrix4d::Zero();
  Eigen::Vector4d rhs = Eigen::Vector4d::Zero();
  for(const Vector& p : points)
  {
    Eigen::Vector4d row;
    row << 2. * (p - origin), 1.;
    matrix += row * row.transpose();
    rhs += (p - origin).squaredNorm() * row;
  }
  const Eigen::Vector4d x = matrix.ldlt().solve(rhs);
  const double radius2 = x[3] + x.head<3>().squaredNorm();
  if(!x.allFinite() || !(radius2 > 0.))
    return false;
  shape.point = origin + x.head<3>();
  shape.radius = std::sqrt(radius2);
  return true;
}

// The circle, seen along the direction of the shape, through points: by the same linear equation in a plane.
inline bool guess_circle(const std::vector<Vector>& points, Basic_shape& shape)
{
  const Vector origin = mean_point(points), u = any_normal(shape.direction), w = shape.direction.cross(u);
  Eigen::Matrix3d matrix = Eigen::Matrix3d::Zero();
  Vector rhs = Vector::Zero();
  for(const Vector& p : points)
  {
    const double x = (p - origin).dot(u), y = (p - origin).dot(w);
    const Vector row(2. * x, 2. * y, 1.);
    matrix += row * row.transpose();
    rhs += (x * x + y * y) * row;
  }
  const Vector x = matrix.ldlt().solve(rhs);
  const double radius2 = x[2] + x.head<2>().squaredNorm();
  if(!x.allFinite() || !(radius2 > 0.))
    return false;
  shape.point = origin + x[0] * u + x[1] * w;
  shape.radius = std::sqrt(radius2);
  return true;
}

// the axis is normal to all normals; across it, a circle
inline bool guess_cylinder(const std::vector<Vector>& points, const Tangent_planes& planes, Basic_shape& shape)
{
  shape.direction = least_direction(planes.normals, Vector::Zero());
  return guess_circle(points, shape);
}

// all tangent planes meet at the apex, and make the same angle with the axis
inline bool guess_cone(const std::vector<Vector>& points, const Tangent_planes& planes, Basic_shape& shape)
{
  const std::vector<Vector>& normals = planes.normals;
  const Vector origin = mean_point(points);
  Eigen::Matrix3d matrix = Eigen::Matrix3d::Zero();
  Vector rhs = Vector::Zero();
  for(std::size_t i = 0; i < normals.size(); ++i)
  {
    matrix += normals[i] * normals[i].transpose();
    rhs += (planes.points[i] - origin).dot(normals[i]) * normals[i];
  }
  const Vector apex = matrix.ldlt().solve(rhs);
  if(!apex.allFinite())
    return false;
  shape.point = origin + apex;
  shape.direction = least_direction(normals, mean_point(normals));
  if(shape.direction.dot(apex) > 0.)
    shape.direction = -shape.direction;              // into the cone: from the apex to the points
  double angle = 0.;
  for(const Vector& p : points)
  {
    const Vector v = p - shape.point;
    angle += angle_between(v, shape.direction) / points.size();
  }
  shape.half_angle = angle;
  return angle > 0. && angle < 1.57;
}

// The centers of the tube, one radius of curvature below the points, lie on a circle. `curvature` is
// that of the tube, as of `Principal_curvatures`.
inline bool guess_torus(const Tangent_planes& planes, const double curvature, Basic_shape& shape)
{
  std::vector<Vector> centers;
  for(std::size_t i = 0; i < planes.points.size(); ++i)
    centers.push_back(planes.points[i] + planes.normals[i] / curvature);
  shape.direction = least_direction(centers, mean_point(centers));
  shape.tube_radius = std::abs(1. / curvature);
  return guess_circle(centers, shape);
}

// A surface of the given type through points; `tube_curvature`: of a torus
inline bool fit_basic_shape(const Basic_surface_type type, const std::vector<Vector>& points, const Tangent_planes& planes,
                            const double tube_curvature, Basic_shape& shape)
{
  shape = Basic_shape();
  shape.type = type;
  switch(type)
  {
    case PLANE_SURFACE:
      shape.point = mean_point(points);
      shape.direction = least_direction(points, shape.point);
      return true;
    case SPHERE_SURFACE:
      return guess_sphere(points, shape) && shape.refine(points);
    case CYLINDER_SURFACE:
      return guess_cylinder(points, planes, shape) && shape.refine(points);
    case CONE_SURFACE:
      return guess_cone(points, planes, shape) && shape.refine(points);
    case TORUS_SURFACE:
      return tube_curvature != 0. && guess_torus(planes, tube_curvature, shape) && shape.refine(points);
    default:
      return false;
  }
}

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_MODEL_FIT_BASIC_SHAPE_H
