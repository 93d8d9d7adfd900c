// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_COMPATIBILITY_H
#define CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_COMPATIBILITY_H

// Named parameters that CGAL has got with functions of later versions than the oldest that is supported: 5.6 and 6.0
#if __has_include(<CGAL/Polygon_mesh_processing/region_growing.h>)
#define CGAL_HDR_HAS_MAXIMUM_DISTANCE
#endif
#if __has_include(<CGAL/Polygon_mesh_processing/interpolated_corrected_curvatures.h>)
#define CGAL_HDR_HAS_CURVATURE_PARAMETERS
#endif

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_COMPATIBILITY_H
