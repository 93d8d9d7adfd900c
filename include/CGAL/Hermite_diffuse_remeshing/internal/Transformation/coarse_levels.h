// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_COARSE_LEVELS_H
#define CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_COARSE_LEVELS_H

#include <CGAL/Hermite_diffuse_remeshing/internal/Transformation/mesh_statistics.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace CGAL {
namespace Hermite_diffuse_remeshing {
namespace internal {

// Levels of sizes: those that were asked for are level 0, and each level doubles them where the shape allows.

// the size map gives the sizes of a level from now on
template <typename UserMesh>
void set_level(Working_mesh<UserMesh>& mesh, const int level)
{
  mesh.reference().sizes.set_coarseness(std::ldexp(1., level));
  mesh.update_sizes();
}

// how many faces the sizes of the level make
template <typename UserMesh>
double predicted_number_of_faces(const Working_mesh<UserMesh>& mesh)
{
  return mesh.reference().sizes.number_of_faces([&](const int f) { return mesh.is_reference_face_remeshed(f); });
}

// Level by level: with sizes that are far too small the mesh would ask for more memory than there is before a stop could
// be asked for.
template <typename UserMesh>
void make_room_for_level(Working_mesh<UserMesh>& mesh)
{
  // of the predicted faces: some more are made by splits and go by collapses
  constexpr double part_of_room = 1.1;
  const double most = (std::min)(double(mesh.maximum_number_of_faces()), double((std::numeric_limits<int>::max)()));
  mesh.make_room(static_cast<std::size_t>((std::min)(part_of_room * predicted_number_of_faces(mesh), most)));
}

// The level to begin with
template <typename UserMesh>
int coarsest_level(const Working_mesh<UserMesh>& mesh)
{
  // faces: below this little is gained, and features are so large a part of the mesh that they shape its triangles
  constexpr double least_number = 4000.;
  // of the input's faces: it needs not be made much coarser only to be refined again
  constexpr double least_part_of_input = 0.25;
  // From one level to the next the number of faces falls by four; by less than this it is the shape that rules.
  constexpr double least_ratio = 2.5;
  if(is_nearly_adapted(mesh))
    return 0;
  Size_map& sizes = mesh.reference().sizes;
  const double least = (std::max)(least_number, least_part_of_input * double(mesh.number_of_faces()));
  double number = predicted_number_of_faces(mesh);
  int level = 0;
  for(; number >= least_ratio * least; ++level)
  {
    sizes.set_coarseness(std::ldexp(1., level + 1));
    const double coarser_number = predicted_number_of_faces(mesh);
    if(coarser_number < least || number < least_ratio * coarser_number)
      break;
    number = coarser_number;
  }
  sizes.set_coarseness(1.);
  return level;
}

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_COARSE_LEVELS_H
