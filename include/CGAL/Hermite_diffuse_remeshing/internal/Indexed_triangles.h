// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_INDEXED_TRIANGLES_H
#define CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_INDEXED_TRIANGLES_H

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace CGAL {
namespace Hermite_diffuse_remeshing {
namespace internal {

// All computations on the reference are made in double, whatever the number type of the user's
// points: the least-squares fits need the digits.
typedef Eigen::Vector3d Vector;

typedef std::array<double, 3> Barycentric;

// A point of the reference: face and barycentric coordinates with respect to its three corners.
struct Location
{
  int face = -1;
  Barycentric coordinates = {{1., 0., 0.}};
};

// corner k of face f is the corner 3f + k
inline Location location_of_corner(const int corner)
{
  Location location;
  location.face = corner / 3;
  location.coordinates = {{0., 0., 0.}};
  location.coordinates[corner % 3] = 1.;
  return location;
}

inline int next(const int corner) { return corner == 2 ? 0 : corner + 1; }
inline int previous(const int corner) { return corner == 0 ? 2 : corner - 1; }

// The frozen copy of the input: side k of a face goes from its corner k to its corner k+1.
struct Indexed_triangles
{
  std::vector<Vector> points;
  std::vector<std::array<int, 3> > triangles;

  int number_of_faces() const { return static_cast<int>(triangles.size()); }
  int number_of_vertices() const { return static_cast<int>(points.size()); }

  const Vector& point(const int face, const int corner) const
  {
    return points[triangles[face][corner]];
  }

  // twice the area times the unit normal
  Vector area_vector(const int face) const
  {
    return (point(face, 1) - point(face, 0)).cross(point(face, 2) - point(face, 0));
  }

  Vector point(const Location& location) const
  {
    return location.coordinates[0] * point(location.face, 0)
         + location.coordinates[1] * point(location.face, 1)
         + location.coordinates[2] * point(location.face, 2);
  }
};

// Scaled by a power of two, which rounds nothing, to a length near 1: area vectors of small meshes are the squares of
// small lengths, and the square of their product may vanish.
inline Vector scaled_to_one(const Vector& v)
{
  const double largest = v.cwiseAbs().maxCoeff();
  return largest > 0. && std::isfinite(largest) ? Vector(v * std::ldexp(1., -std::ilogb(largest))) : v;
}

inline double angle_between(const Vector& u, const Vector& v)
{
  const Vector a = scaled_to_one(u), b = scaled_to_one(v);
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

// Twice the largest distance of a vertex to the centroid of the surface. Unlike the diagonal of
// a bounding box it does not change when the input is rotated.
inline double model_diameter(const Indexed_triangles& surface)
{
  Vector centroid = Vector::Zero();
  const Vector base = surface.points.front();
  double area = 0.;
  for(int f = 0; f < surface.number_of_faces(); ++f)
  {
    const double face_area = surface.area_vector(f).norm();
    area += face_area;
    centroid += face_area / 3. * (surface.point(f, 0) + surface.point(f, 1) + surface.point(f, 2)
                                  - 3. * base);
  }
  if(area > 0.)
    centroid /= area;
  centroid += base;

  double radius = 0.;
  for(const std::array<int, 3>& triangle : surface.triangles)
    for(const int v : triangle)
      radius = (std::max)(radius, (surface.points[v] - centroid).norm());
  return 2. * radius;
}

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_INDEXED_TRIANGLES_H
