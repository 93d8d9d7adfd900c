// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_INTERPOLATE_ATTRIBUTE_H
#define CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_INTERPOLATE_ATTRIBUTE_H

#include <CGAL/Hermite_diffuse_remeshing/internal/Indexed_triangles.h>

#include <CGAL/IO/Color.h>
#include <CGAL/boost/graph/helpers.h>

#include <boost/graph/graph_traits.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <type_traits>

namespace CGAL {
namespace Hermite_diffuse_remeshing {
namespace internal {

// The linear function in a triangle with given values at the corners. A value at a corner is returned as it is.
template <typename Value>
struct Linear_interpolation
{
  static_assert(!std::is_integral<Value>::value,
                "integers are labels, which have no values in between: transfer them with transfer_vertex_labels()");

  // points, vectors and numbers alike
  Value operator()(const Value& a, const Value& b, const Value& c, const Barycentric& l) const
  {
    if(l[0] >= 1.)
      return a;
    if(l[1] >= 1.)
      return b;
    if(l[2] >= 1.)
      return c;
    return Value(a + l[1] * (b - a) + l[2] * (c - a));
  }
};

template <typename Value, std::size_t N>
struct Linear_interpolation<std::array<Value, N> >
{
  std::array<Value, N> operator()(const std::array<Value, N>& a, const std::array<Value, N>& b,
                                  const std::array<Value, N>& c, const Barycentric& l) const
  {
    std::array<Value, N> result;
    for(std::size_t i = 0; i < N; ++i)
      result[i] = Linear_interpolation<Value>()(a[i], b[i], c[i], l);
    return result;
  }
};

// channel by channel, rounded
template <>
struct Linear_interpolation<CGAL::IO::Color>
{
  CGAL::IO::Color operator()(const CGAL::IO::Color& a, const CGAL::IO::Color& b, const CGAL::IO::Color& c,
                             const Barycentric& l) const
  {
    std::array<unsigned char, 4> channels;
    for(std::size_t i = 0; i < channels.size(); ++i)
      channels[i] = static_cast<unsigned char>(std::lround(Linear_interpolation<double>()(a[i], b[i], c[i], l)));
    return CGAL::IO::Color(channels[0], channels[1], channels[2], channels[3]);
  }
};

// do the values at an end of an edge differ between its two faces?
template <typename TriangleMesh, typename CornerMap>
bool is_seam(const typename boost::graph_traits<TriangleMesh>::halfedge_descriptor h, const TriangleMesh& tmesh,
             const CornerMap& values)
{
  const auto o = opposite(h, tmesh);
  return !CGAL::is_border(h, tmesh) && !CGAL::is_border(o, tmesh)
      && !(get(values, h) == get(values, prev(o, tmesh)) && get(values, prev(h, tmesh)) == get(values, o));
}

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_INTERPOLATE_ATTRIBUTE_H
