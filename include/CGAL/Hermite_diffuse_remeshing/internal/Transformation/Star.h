// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_STAR_H
#define CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_STAR_H

#include <CGAL/Hermite_diffuse_remeshing/internal/Transformation/Working_mesh.h>

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace CGAL {
namespace Hermite_diffuse_remeshing {
namespace internal {

// The triangles that a vertex makes with the edges opposite to it, whether they are in the mesh or only
// being considered: it tells what they are worth with the vertex at another site, and finds a good one.
class Star
{
  struct Triangle
  {
    const Site* from;
    const Site* to;
    int hint;
  };

public:
  // What relocation makes small: a sum over the triangles of a power of what misses to the score 1. The
  // square makes the good ones better too; a high power looks at the worst alone.
  enum Objective { MEAN, WORST };

private:
  const Reference& m_reference;
  Objective m_objective;
  boost::container::small_vector<Triangle, 16> m_triangles;
  const Site* m_first = nullptr;        // the neighbour with the smallest number: turns with the input
  int m_first_index = (std::numeric_limits<int>::max)();

public:
  Star(const Reference& reference, const Objective objective) : m_reference(reference), m_objective(objective) {}

  Objective objective() const { return m_objective; }

  // adds the remeshed faces around all copies of v
  template <typename UserMesh>
  void add(const Working_mesh<UserMesh>& mesh, const typename Working_mesh<UserMesh>::vertex_descriptor v)
  {
    mesh.visit_copies(v, [&](const auto copy) { add(mesh, copy, Working_mesh<UserMesh>::Graph_traits::null_vertex()); });
  }

  // adds the remeshed faces around v, without those that have the vertex `skipped`
  template <typename UserMesh>
  void add(const Working_mesh<UserMesh>& mesh, const typename Working_mesh<UserMesh>::vertex_descriptor v,
           const typename Working_mesh<UserMesh>::vertex_descriptor skipped)
  {
    const auto& tm = mesh.tmesh();
    for(const auto h : CGAL::halfedges_around_target(v, tm))
    {
      if(source(h, tm) != skipped)
        look_at(mesh, source(h, tm));
      if(!mesh.is_border_or_outside(h) && source(h, tm) != skipped && target(next(h, tm), tm) != skipped)
        add_side(mesh.site(target(next(h, tm), tm)), mesh.site(source(h, tm)), mesh.hint(h));
    }
  }

  // adds a triangle to the left of a halfedge
  template <typename UserMesh>
  void add_side(const Working_mesh<UserMesh>& mesh, const typename Working_mesh<UserMesh>::halfedge_descriptor h)
  {
    look_at(mesh, source(h, mesh.tmesh()));
    look_at(mesh, target(h, mesh.tmesh()));
    add_side(mesh.site(source(h, mesh.tmesh())), mesh.site(target(h, mesh.tmesh())), mesh.hint(h));
  }

  void add_side(const Site& from, const Site& to, const int hint) { m_triangles.push_back({&from, &to, hint}); }

  Worth worth(const Site& site) const
  {
    Worth result;
    for(const Triangle& t : m_triangles)
      result.add(internal::worth(m_reference, site, *t.from, *t.to, t.hint));
    return result;
  }

  struct Badness
  {
    double sum = 0.;
    Worth worst;
  };

  Badness badness(const Site& site) const
  {
    Badness result;
    for(const Triangle& t : m_triangles)
    {
      const Worth w = internal::worth(m_reference, site, *t.from, *t.to, t.hint);
      result.worst.add(w);
      result.sum += miss(w.score);
    }
    return result;
  }

  // distance to the corners around
  double radius(const Site& site) const
  {
    double sum = 0.;
    for(const Triangle& t : m_triangles)
      sum += (t.from->point - site.point).norm();
    return m_triangles.empty() ? 0. : sum / double(m_triangles.size());
  }

  // A site on the surface with less badness and no worse triangle, found in the tangent plane at `start`
  // by a pattern of eight directions with steps that are halved. A sum over all triangles is smooth enough for a
  // shorter first step, and for four of the directions, those along the axes and those between them in turn. On the
  // surface the result has still to be compared.
  Site better_site(const Site& start) const
  {
    const Node_frame frame(start.point, start.normal, m_first->point, 1.);
    // of the radius: the last is small enough to settle near the optimum
    const double first_step = m_objective == MEAN ? 0.1 : 0.2;
    constexpr double last_step = 0.02;
    // sums closer than this are the same
    constexpr double least_decrease = 1. - score_margin;
    const double radius = this->radius(start);
    const Sides sides = find_sides(start);
    Vector best = start.point;
    Flat_badness least = flat_badness(sides, best, Flat_badness{(std::numeric_limits<double>::infinity)(),
                                                                -(std::numeric_limits<double>::infinity)()});
    const std::size_t stride = m_objective == MEAN ? 2 : 1;
    std::size_t first = 0;
    for(double step = first_step; step >= last_step; )
    {
      const Vector center = best;
      bool is_moved = false;
      for(std::size_t i = first; i < directions.size(); i += stride)
      {
        const std::array<double, 2>& direction = directions[i];
        const Vector candidate = center + step * radius * (direction[0] * frame.x_axis + direction[1] * frame.y_axis);
        const Flat_badness limit{least_decrease * least.sum, least.worst_score - score_rounding};
        const Flat_badness b = flat_badness(sides, candidate, limit);
        if(b.sum < limit.sum)
        {
          least = b;
          best = candidate;
          is_moved = true;
        }
      }
      if(is_moved)
        continue;
      step /= 2.;
      first = (first + 1) % stride;
    }
    return best == start.point ? start : m_reference.surface_site(best, start.location.face);
  }

private:
  // What is the same for all candidates in the tangent plane: the side opposite to them, and the model's normal.
  struct Side
  {
    Vector from, to, normal;
    double length;
  };
  typedef boost::container::small_vector<Side, 16> Sides;
  struct Flat_badness { double sum, worst_score; };

  static constexpr double diagonal = 0.70710678118654752440;       // 1 / sqrt(2)
  static constexpr std::array<std::array<double, 2>, 8> directions =
    {{ {{1., 0.}}, {{diagonal, diagonal}}, {{0., 1.}}, {{-diagonal, diagonal}},
       {{-1., 0.}}, {{-diagonal, -diagonal}}, {{0., -1.}}, {{diagonal, -diagonal}} }};

  double miss(const double score) const
  {
    const double square = CGAL::square(1. - score);
    return m_objective == MEAN ? square : CGAL::square(CGAL::square(square));
  }

  Sides find_sides(const Site& site) const
  {
    Sides result;
    for(const Triangle& t : m_triangles)
      result.push_back({t.from->point, t.to->point,
                        triangle_normal(m_reference, site, *t.from, *t.to, t.hint).normalized(),
                        (t.to->point - t.from->point).norm()});
    return result;
  }

  // as badness(), with an infinite sum where a limit is passed
  Flat_badness flat_badness(const Sides& sides, const Vector& p, const Flat_badness& limit) const
  {
    Flat_badness result{0., 1.};
    for(const Side& side : sides)
    {
      const Vector a = side.from - p, b = side.to - p;
      const Vector n = a.cross(b);
      const double double_area = n.norm(), cosine_area = n.dot(side.normal);
      double score = 0.;
      if(cosine_area > 0.)
      {
        const double la = a.norm(), lb = b.norm();
        score = 2. * std::sqrt(3.) * CGAL::square(cosine_area)
              / (double_area * (la + lb + side.length) * (std::max)({la, lb, side.length}));
      }
      else if(cosine_area < 0.)
        score = cosine_area / double_area;
      result.worst_score = (std::min)(result.worst_score, score);
      result.sum += miss(score);
      if(score < limit.worst_score || result.sum >= limit.sum)
        return {(std::numeric_limits<double>::infinity)(), score};
    }
    return result;
  }

  template <typename UserMesh>
  void look_at(const Working_mesh<UserMesh>& mesh, const typename Working_mesh<UserMesh>::vertex_descriptor v)
  {
    if(mesh.index(v) >= m_first_index)
      return;
    m_first_index = mesh.index(v);
    m_first = &mesh.data(v).site;
  }
};

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_TRANSFORMATION_STAR_H
