// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_SIZING_SAMPLE_PAIR_H
#define CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_SIZING_SAMPLE_PAIR_H

#include <boost/container_hash/hash.hpp>

#include <unordered_map>
#include <utility>

namespace CGAL {
namespace Hermite_diffuse_remeshing {
namespace internal {

// The samples of the sizes at the ends of a side of a cell, the smaller number first.
typedef std::pair<int, int> Sample_pair;

template <typename Value>
using Pair_map = std::unordered_map<Sample_pair, Value, boost::hash<Sample_pair> >;

inline Sample_pair ordered(const int a, const int b)
{
  return a < b ? Sample_pair(a, b) : Sample_pair(b, a);
}

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_SIZING_SAMPLE_PAIR_H
