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
#include <boost/math/constants/constants.hpp>

#include <algorithm>
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

  // adds the remeshed faces around v, without those that have the vertex `skipped`
  template <typename UserMesh>
  void add(const Working_mesh<UserMesh>& mesh, const typename Working_mesh<UserMesh>::vertex_descriptor v,
           const typename Working_mesh<UserMesh>::vertex_descriptor skipped
             = Working_mesh<UserMesh>::Graph_traits::null_vertex())
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
    double sum = 0., worst_score = 1.;
  };

  Badness badness(const Site& site) const
  {
    Badness result;
    for(const Triangle& t : m_triangles)
    {
      const double score = internal::worth(m_reference, site, *t.from, *t.to, t.hint).score;
      result.worst_score = (std::min)(result.worst_score, score);
      const double miss = CGAL::square(1. - score);
      result.sum += m_objective == MEAN ? miss : CGAL::square(CGAL::square(miss));
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
  // by a pattern of eight directions with steps that are halved. On the surface the result has still to
  // be compared.
  Site better_site(const Site& start) const
  {
    const Node_frame frame(start.point, start.normal, m_first->point, 1.);
    constexpr int number_of_directions = 8;
    // of the radius: the last is small enough to settle near the optimum
    constexpr double first_step = 0.2, last_step = 0.02;
    // sums closer than this are the same
    constexpr double least_decrease = 1. - score_margin;
    const double radius = this->radius(start);
    Site best = start;
    Badness least = badness(start);
    for(double step = first_step; step >= last_step; )
    {
      const Site center = best;
      bool is_moved = false;
      for(int i = 0; i < number_of_directions; ++i)
      {
        const double angle = 2. * boost::math::constants::pi<double>() * i / number_of_directions;
        Site candidate = start;
        candidate.point = center.point + step * radius * (std::cos(angle) * frame.x_axis
                                                          + std::sin(angle) * frame.y_axis);
        const Badness b = badness(candidate);
        if(b.sum < least_decrease * least.sum && b.worst_score >= least.worst_score - score_rounding)
        {
          least = b;
          best = candidate;
          is_moved = true;
        }
      }
      if(!is_moved)
        step /= 2.;
    }
    return best.point == start.point ? start : m_reference.surface_site(best.point, start.location.face);
  }

private:
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
