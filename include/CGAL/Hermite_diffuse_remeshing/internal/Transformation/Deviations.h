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

#include <initializer_list>
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

  // Distances are measured at points. Between them they are larger by this part at most: by 1 % for the grid on which
  // the height over a face is looked for, and the rest for what the model has between its points and what a cubic
  // does not tell of it. CGAL's distances are up to 3 % above those at the points, and 4.5 % on coarse slivers.
  static constexpr double unseen_part = 0.05;
  // and where the model may not leave its facets, and has their edges, of which cubics know nothing: 14 % have been seen
  // at faces near their bound
  static constexpr double unseen_part_at_facets = 0.15;

  std::vector<Face_deviation<face_descriptor> > faces;
  double raised = 1. + unseen_part;     // deviations are as many times larger than what is measured at points
  double largest = 0., mean = 0.;       // the mean: of the faces'
  double model_distance = 0.;           // between the model and the facets of the reference
  Vector point_of_largest = Vector::Zero();
  bool is_bound_out_of_reach = false;   // of as many faces as there may be

  // `distance`: measured between a point p and the location; -1 among the faces is none
  void add(const Vector& p, const double distance, const Location& location,
           const std::initializer_list<int> at_faces, const bool is_on_protected_edge = false)
  {
    const double deviation = raised * distance;
    for(const int f : at_faces)
      if(f != -1 && deviation >= faces[f].deviation)
      {
        Face_deviation<face_descriptor>& entry = faces[f];
        entry.deviation = deviation;
        entry.point = p;
        entry.location = location;
        entry.is_on_protected_edge = is_on_protected_edge;
      }
  }

  void summarize()
  {
    largest = mean = 0.;
    for(const Face_deviation<face_descriptor>& entry : faces)
    {
      mean += entry.mean / double(faces.size());
      if(entry.deviation > largest)
      {
        largest = entry.deviation;
        point_of_largest = entry.point;
      }
    }
  }
};

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_DEVIATIONS_H
