// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_SPLIT_AND_FLIP_H
#define CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_SPLIT_AND_FLIP_H

#include <CGAL/Hermite_diffuse_remeshing/internal/Transformation/flip_edges.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Transformation/relocate_vertices.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Transformation/split_long_edges.h>

#include <algorithm>
#include <utility>

namespace CGAL {
namespace Hermite_diffuse_remeshing {
namespace internal {

// The best site to split the edge of h at, on the surface or on its curve, for the triangles of the new vertex
template <typename UserMesh>
Site better_site_of_split(const Working_mesh<UserMesh>& mesh,
                          const typename Working_mesh<UserMesh>::halfedge_descriptor h, const Star& star)
{
  const Site middle = middle_site(mesh, h);
  const int curve = mesh.curve(h);
  if(curve == -1)
    return star.better_site(middle);
  const std::pair<double, double> ends = std::minmax({mesh.parameter(source(h, mesh.tmesh()), curve),
                                                      mesh.parameter(target(h, mesh.tmesh()), curve)});
  return better_site_on_curve(mesh.reference(), middle, ends, star, [](double) { return true; });
}

// Splits a side of a face, and flips another side of it. Of a needle a split alone makes the half at the tip as thin as the
// whole was; where all three vertices stay, as between corners that are close to each other, no other operation helps.
// Nor where two features meet at a wide angle: the new vertex has to come as far from the corner as its neighbours are,
// past a side of the face behind.
template <typename UserMesh>
class Split_and_flip
{
  typedef Working_mesh<UserMesh> Mesh;
  typedef typename Mesh::halfedge_descriptor halfedge_descriptor;

  halfedge_descriptor m_split, m_flipped;
  Site m_site;

public:
  // two sides of a face; a score of -1 where they may not be split and flipped
  Worth plan(const Mesh& mesh, const halfedge_descriptor split, const halfedge_descriptor flipped)
  {
    const auto& tm = mesh.tmesh();
    m_split = split;
    m_flipped = flipped;
    const halfedge_descriptor o = opposite(m_split, tm), across = opposite(m_flipped, tm);
    if(mesh.siblings(m_split).size() != 1 || !is_split_topologically_legal(mesh, m_split)
       || !is_flippable(mesh, m_flipped)
       || (!mesh.is_border_or_outside(o) && target(next(o, tm), tm) == target(next(across, tm), tm)))
      return Worth{-1., 0.};
    Star star(mesh.reference(), Star::WORST);
    star.add_side(mesh, third_side(mesh));
    star.add_side(mesh, next(across, tm));
    star.add_side(mesh, prev(across, tm));
    if(!mesh.is_border_or_outside(o))
    {
      star.add_side(mesh, next(o, tm));
      star.add_side(mesh, prev(o, tm));
    }
    m_site = better_site_of_split(mesh, m_split, star);
    return star.worth(m_site);
  }

  bool is_free(Mesh& mesh) const
  {
    if(!mesh.is_guarded())
      return true;
    const auto& tm = mesh.tmesh();
    const auto with_new = [&](const Numbered_triangle& t, const auto v)
    { return with_corner(t, mesh.index(v), number_of_new_vertex, m_site.point); };
    Numbered_triangles made, replaced;
    replaced.push_back(mesh.triangle(face(m_split, tm)));
    // the end that the sides have in common is the one that the third side has not
    made.push_back(with_new(replaced.back(), target(next(third_side(mesh), tm), tm)));
    const halfedge_descriptor across = opposite(m_flipped, tm);
    replaced.push_back(mesh.triangle(face(across, tm)));
    for(const auto v : {source(across, tm), target(across, tm)})
      made.push_back(with_new(replaced.back(), v));
    const halfedge_descriptor o = opposite(m_split, tm);
    if(!CGAL::is_border(o, tm))
    {
      replaced.push_back(mesh.triangle(face(o, tm)));
      for(const auto v : {source(o, tm), target(o, tm)})
        made.push_back(with_new(replaced.back(), v));
    }
    const auto center = CGAL::is_border(o, tm) ? Mesh::Graph_traits::null_vertex()
                                               : center_of_disc(mesh, source(m_split, tm));
    return mesh.is_free(center, made, replaced);
  }

  void execute(Mesh& mesh) const
  {
    mesh.split_edge(m_split, m_site);
    mesh.flip_edge(m_flipped);
  }

private:
  halfedge_descriptor third_side(const Mesh& mesh) const
  {
    const halfedge_descriptor after = next(m_split, mesh.tmesh());
    return after == m_flipped ? prev(m_split, mesh.tmesh()) : after;
  }
};

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_SPLIT_AND_FLIP_H
