// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_COMPATIBILITY_H
#define CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_COMPATIBILITY_H

#include <CGAL/version.h>

// isotropic_remeshing() takes a model of PMPSizingField
#if CGAL_VERSION_NR >= 1060001000
#define CGAL_HDR_HAS_PMP_SIZING_FIELD
#endif

#if CGAL_VERSION_NR >= 1060001000
#include <CGAL/AABB_traits_3.h>
#else
#include <CGAL/AABB_traits.h>
#endif
#include <CGAL/AABB_tree.h>

namespace CGAL {
namespace Hermite_diffuse_remeshing {
namespace internal {

#if CGAL_VERSION_NR >= 1060001000
template <typename GeomTraits, typename Primitive>
using AABB_traits = CGAL::AABB_traits_3<GeomTraits, Primitive>;
#else
template <typename GeomTraits, typename Primitive>
using AABB_traits = CGAL::AABB_traits<GeomTraits, Primitive>;
#endif

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_COMPATIBILITY_H
