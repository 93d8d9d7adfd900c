// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_DEVIATIONS_H
#define CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_DEVIATIONS_H

#include <CGAL/Hermite_diffuse_remeshing/Remeshing_report.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Transformation/Working_mesh.h>

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
  double mean = 0.;                     // over its vertices, the middles of its sides and its centroid
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
  double largest = 0., mean = 0.;       // the mean: of the faces'
  double model_distance = 0.;           // between the model and the facets of the reference
  Vector point_of_largest = Vector::Zero();
};

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_DEVIATIONS_H
