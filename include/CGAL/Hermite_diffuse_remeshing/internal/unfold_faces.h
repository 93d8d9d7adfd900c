// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_UNFOLD_FACES_H
#define CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_UNFOLD_FACES_H

#include <CGAL/Hermite_diffuse_remeshing/internal/Repair_mesh.h>
#include <CGAL/Hermite_diffuse_remeshing/internal/Transformation/do_triangles_meet.h>

#include <CGAL/Bbox_3.h>
#include <CGAL/box_intersection_d.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Hermite_diffuse_remeshing {
namespace internal {

// A face that is turned by more than 120 degrees against every face beside it, two at least, is folded over: it lies
// upside down on one of them, as triangles of scans do where vertices are closer than their noise, and those of
// tessellations where a border bends inwards. The faces of a spike, however sharp, are not: around a tip with three
// faces these are turned by 120 degrees against each other.
inline bool is_turned_over(const Vector& normal, const Vector& normal_beside)
{
  constexpr double cosine_of_turn = -0.5;
  return normal.dot(normal_beside) < cosine_of_turn * normal.norm() * normal_beside.norm();
}

// `visit_beside(visit)` calls `visit(normal)` for the faces beside a face, until that returns false
template <typename VisitBeside>
bool is_folded_over(const Vector& normal, const VisitBeside& visit_beside)
{
  constexpr int least_number = 2;
  int number = 0;
  bool are_all_turned = true;
  visit_beside([&](const Vector& normal_beside)
  {
    ++number;
    are_all_turned = are_all_turned && is_turned_over(normal, normal_beside);
    return are_all_turned;
  });
  return are_all_turned && number >= least_number;
}

// Flips the longest sides of faces that are folded over: the apex then lies on the face beside. This is done where the
// fold is flat, loses area, and the new faces meet no more others than the old ones do. As the area falls, it ends.
class Face_unfolding
{
  typedef Repair_mesh::Connectivity Connectivity;
  typedef Repair_mesh::Vertex_index Vertex_index;
  typedef Repair_mesh::Halfedge_index Halfedge_index;
  typedef Repair_mesh::Face_index Face_index;
  typedef CGAL::Box_intersection_d::Box_with_info_d<double, 3, int> Box;

  Repair_mesh& m_mesh;
  double m_largest_rise;
  double m_highest = 0.;

  // Of the length of the side, which is how far the surface moves at most: a fold of 6 degrees if it is as high as its
  // side is long. What stands higher may be meant.
  static constexpr double largest_relative_rise = 0.1;
  // of the area of the folded face: one that lies flat on its neighbor takes twice its area with it
  static constexpr double least_loss_of_area = 0.1;
  // A flip can make the next one possible; longer chains are no accident.
  static constexpr int maximum_number_of_passes = 16;

public:
  // `largest_rise`: how far the surface may move
  Face_unfolding(Repair_mesh& mesh, const double largest_rise) : m_mesh(mesh), m_largest_rise(largest_rise) {}

  // how far the surface has moved at most
  double highest_rise() const { return m_highest; }

  void operator()()
  {
    for(int pass = 0; pass < maximum_number_of_passes && flip_once(); ++pass)
      ;
  }

  std::vector<Face_index> folded_faces() const
  {
    std::vector<Face_index> result;
    for(const Face_index f : mesh().faces())
      if(is_folded_over(m_mesh.area_vector(mesh().halfedge(f)), [&](const auto& visit)
         {
           for(const Halfedge_index h : CGAL::halfedges_around_face(mesh().halfedge(f), mesh()))
             if(!mesh().is_border(mesh().opposite(h)) && !visit(m_mesh.area_vector(mesh().opposite(h))))
               return;
         }))
        result.push_back(f);
    return result;
  }

private:
  const Connectivity& mesh() const { return m_mesh.connectivity(); }

  // Returns whether there is more to be done: sides near a face that has changed are left to the next pass.
  bool flip_once()
  {
    std::vector<Halfedge_index> sides;
    for(const Face_index f : folded_faces())
    {
      const Halfedge_index longest = m_mesh.shortest_and_longest_side(f).second;
      if(does_unfold(longest))
        sides.push_back(longest);
    }
    if(sides.empty())
      return false;
    const std::vector<std::vector<int> > near = faces_near(sides);
    std::vector<char> is_changed(mesh().num_faces(), false);
    bool is_more_to_do = false;
    for(std::size_t i = 0; i < sides.size(); ++i)
    {
      const Halfedge_index h = sides[i];
      const bool is_near_change =
        std::any_of(near[i].begin(), near[i].end(), [&](const int f) { return is_changed[f] != 0; });
      if(!is_near_change && do_more_meet(h, near[i]))
        continue;
      is_more_to_do = true;
      if(is_near_change)
        continue;
      m_highest = (std::max)(m_highest, rise(h));
      for(const Halfedge_index g : {h, mesh().opposite(h)})
        is_changed[mesh().face(g)] = true;
      m_mesh.flip(h);
    }
    return is_more_to_do;
  }

  // of the apex over the plane of the face beside
  double rise(const Halfedge_index h) const
  {
    const Vector normal = m_mesh.area_vector(mesh().opposite(h)).stableNormalized();
    return std::abs(normal.dot(m_mesh.point(m_mesh.apex(h)) - m_mesh.point(mesh().target(h))));
  }

  bool does_unfold(const Halfedge_index h) const
  {
    if(!m_mesh.is_flip_legal(h) || !(rise(h) <= (std::min)(largest_relative_rise * m_mesh.length(h), m_largest_rise)))
      return false;
    const Vertex_index a = mesh().source(h), b = mesh().target(h), c = m_mesh.apex(h), d = m_mesh.apex(mesh().opposite(h));
    const double folded = m_mesh.area_vector(h).norm(), beside = m_mesh.area_vector(mesh().opposite(h)).norm();
    return !m_mesh.is_degenerate(a, d, c) && !m_mesh.is_degenerate(d, b, c)
        && m_mesh.area_vector(a, d, c).norm() + m_mesh.area_vector(d, b, c).norm()
             <= beside + (1. - least_loss_of_area) * folded;
  }

  CGAL::Bbox_3 bbox(const Halfedge_index h) const
  {
    const Bounding_box box(triangle(h).points);
    return CGAL::Bbox_3(box.low[0], box.low[1], box.low[2], box.high[0], box.high[1], box.high[2]);
  }

  // The faces with boxes that meet the one of the two faces of a side, by their numbers. Faces that a flip of another side
  // makes are within the box of the two that were there.
  std::vector<std::vector<int> > faces_near(const std::vector<Halfedge_index>& sides) const
  {
    std::vector<Box> boxes, boxes_of_sides;
    for(const Face_index f : mesh().faces())
      boxes.push_back(Box(bbox(mesh().halfedge(f)), int(f)));
    for(std::size_t i = 0; i < sides.size(); ++i)
    {
      const Halfedge_index o = mesh().opposite(sides[i]);
      const CGAL::Bbox_3 box = bbox(sides[i]) + bbox(o);
      boxes_of_sides.push_back(Box(box, int(i)));
      for(const Halfedge_index h : {sides[i], o})
        boxes.push_back(Box(box, int(mesh().face(h))));
    }
    std::vector<std::vector<int> > result(sides.size());
    CGAL::box_intersection_d(boxes_of_sides.begin(), boxes_of_sides.end(), boxes.begin(), boxes.end(),
                             [&](const Box& side, const Box& face) { result[side.info()].push_back(face.info()); });
    for(std::vector<int>& faces : result)
    {
      std::sort(faces.begin(), faces.end());
      faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
    }
    return result;
  }

  Numbered_triangle triangle(const Vertex_index a, const Vertex_index b, const Vertex_index c) const
  {
    return {{{int(a), int(b), int(c)}}, {{m_mesh.point(a), m_mesh.point(b), m_mesh.point(c)}}};
  }

  Numbered_triangle triangle(const Halfedge_index h) const
  {
    return triangle(mesh().source(h), mesh().target(h), m_mesh.apex(h));
  }

  bool do_more_meet(const Halfedge_index h, const std::vector<int>& near) const
  {
    const Halfedge_index o = mesh().opposite(h);
    const Vertex_index a = mesh().source(h), b = mesh().target(h), c = m_mesh.apex(h), d = m_mesh.apex(o);
    int before = 0, after = 0;
    for(const int f : near)
    {
      if(Face_index(f) == mesh().face(h) || Face_index(f) == mesh().face(o))
        continue;
      const Numbered_triangle other = triangle(mesh().halfedge(Face_index(f)));
      for(const Numbered_triangle& t : {triangle(h), triangle(o)})
        before += do_triangles_meet(t, other);
      for(const Numbered_triangle& t : {triangle(a, d, c), triangle(d, b, c)})
        after += do_triangles_meet(t, other);
    }
    return after > before;
  }
};

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_UNFOLD_FACES_H
