// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_FLIP_EDGES_H
#define CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_FLIP_EDGES_H

#include <CGAL/Hermite_diffuse_remeshing/internal/Transformation/Edge_queue.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Transformation/is_free.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Transformation/legality.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace CGAL {
namespace Hermite_diffuse_remeshing {
namespace internal {

// What is best for a flip: that the worse triangle is better, or that the vertices have about the number
// of triangles that fit their angle, so that relocation can make them equilateral.
enum Flip_criterion { BY_SCORE, BY_VALENCE };

// How many triangles the part of the surface between two curves has at the target of h, more than fit
// into the angle there; 0 is best. Six fit around a vertex inside the surface.
template <typename UserMesh>
int excess_of_faces(const Working_mesh<UserMesh>& mesh, const typename Working_mesh<UserMesh>::halfedge_descriptor h)
{
  const auto& tm = mesh.tmesh();
  constexpr int ideal_number = 6;
  const auto v = target(h, tm);
  if(mesh.data(v).type == SURFACE_VERTEX)
    return static_cast<int>(degree(v, tm)) - ideal_number;

  const auto ends_sector = [&](const auto g) { return mesh.is_on_curve(g) || mesh.is_protected(g)
                                                   || mesh.is_border_or_outside(g) != mesh.is_border_or_outside(opposite(g, tm)); };
  int number = 0;
  double angle = 0.;
  const auto add_face_of = [&](const auto g)
  {
    const Vector a = mesh.point(source(g, tm)) - mesh.point(v);
    const Vector b = mesh.point(target(next(g, tm), tm)) - mesh.point(v);
    angle += std::atan2(a.cross(b).norm(), a.dot(b));
    ++number;
  };
  // to the one side, then to the other
  auto g = h;
  do
  {
    add_face_of(g);
    g = opposite(next(g, tm), tm);
  }
  while(g != h && !ends_sector(g));
  if(g != h)
    for(g = h; !ends_sector(g); )
    {
      g = prev(opposite(g, tm), tm);
      add_face_of(g);
    }
  const double fitting = angle * ideal_number / (2. * boost::math::constants::pi<double>());
  // keeps a right angle, where one and a half would fit, away from the limit
  constexpr double offset = 0.037;
  return number - (std::max)(1, static_cast<int>(std::lround(fitting + offset)));
}

template <typename UserMesh>
bool is_flippable(const Working_mesh<UserMesh>& mesh, const typename Working_mesh<UserMesh>::halfedge_descriptor h)
{
  return !mesh.is_on_curve(h) && !mesh.is_protected(h) && !mesh.is_border_or_outside(h)
      && !mesh.is_border_or_outside(opposite(h, mesh.tmesh()));
}

template <typename UserMesh>
bool is_flip_topologically_legal(const Working_mesh<UserMesh>& mesh,
                                 const typename Working_mesh<UserMesh>::halfedge_descriptor h)
{
  const auto& tm = mesh.tmesh();
  const auto o = opposite(h, tm);
  if(!is_flippable(mesh, h))
    return false;
  const auto c = target(next(h, tm), tm), d = target(next(o, tm), tm);
  return c != d && !mesh.are_joined(c, d);
}

// the change of the sum of squares of the excesses
template <typename UserMesh>
int valence_gain(const Working_mesh<UserMesh>& mesh, const typename Working_mesh<UserMesh>::halfedge_descriptor h)
{
  const auto& tm = mesh.tmesh();
  const auto o = opposite(h, tm);
  int gain = 0;
  for(const auto g : {h, o})                       // loses a triangle
  {
    const int excess = excess_of_faces(mesh, g);
    gain += CGAL::square(excess) - CGAL::square(excess - 1);
  }
  for(const auto g : {next(h, tm), next(o, tm)})   // gets one
  {
    const int excess = excess_of_faces(mesh, g);
    gain += CGAL::square(excess) - CGAL::square(excess + 1);
  }
  return gain;
}

// the two faces of an edge, now and with the other diagonal
template <typename UserMesh>
Worth worth_of_pair(const Working_mesh<UserMesh>& mesh, const typename Working_mesh<UserMesh>::halfedge_descriptor h)
{
  Worth result = face_worth(mesh, h);
  result.add(face_worth(mesh, opposite(h, mesh.tmesh())));
  return result;
}

template <typename UserMesh>
Worth worth_after_flip(const Working_mesh<UserMesh>& mesh, const typename Working_mesh<UserMesh>::halfedge_descriptor h)
{
  const auto& tm = mesh.tmesh();
  const auto o = opposite(h, tm);
  const Site& c = mesh.site(target(next(h, tm), tm));
  const Site& d = mesh.site(target(next(o, tm), tm));
  Worth result = worth(mesh.reference(), mesh.site(source(h, tm)), d, c, mesh.hint(h));
  result.add(worth(mesh.reference(), d, mesh.site(target(h, tm)), c, mesh.hint(o)));
  return result;
}

template <typename UserMesh>
bool is_flip_legal(const Working_mesh<UserMesh>& mesh, const typename Working_mesh<UserMesh>::halfedge_descriptor h,
                   const Flip_criterion criterion)
{
  // the cheaper and the more selective questions come first
  if(!is_flippable(mesh, h))
    return false;
  const int gain = criterion == BY_VALENCE ? valence_gain(mesh, h) : 0;
  if(gain < 0)
    return false;
  const Worth before = worth_of_pair(mesh, h);
  // The quality of the halves of a square, for both of its diagonals: two triangles that are both better than these
  // have no better diagonal.
  constexpr double quality_of_square = 0.7175;
  if(gain == 0 && before.score > quality_of_square)
    return false;
  const Worth after = worth_after_flip(mesh, h);
  // triangles worse than this would hinder the relocation
  constexpr double least_score_of_flip = 0.4;
  return (gain > 0 ? is_score_acceptable(after.score, before.score, least_score_of_flip) : is_better(after, before))
      && is_flip_topologically_legal(mesh, h);
}

template <typename UserMesh>
std::size_t flip_edges(Working_mesh<UserMesh>& mesh, const Flip_criterion criterion, const std::size_t since)
{
  typedef typename Working_mesh<UserMesh>::halfedge_descriptor halfedge_descriptor;
  const std::size_t before = mesh.counts().flips;
  for(const auto& candidate : collect_edges(mesh, 1, [&](const halfedge_descriptor h, double)
                                            { return mesh.has_changed(h, since) && !mesh.is_on_curve(h)
                                                     && !mesh.is_protected(h); }))
  {
    if(mesh.is_stopped())
      break;
    if(is_flip_legal(mesh, candidate.halfedge, criterion) && is_flip_free(mesh, candidate.halfedge))
      mesh.flip_edge(candidate.halfedge);
  }
  return mesh.counts().flips - before;
}

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_FLIP_EDGES_H
