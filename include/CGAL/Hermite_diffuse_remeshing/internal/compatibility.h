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

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_COMPATIBILITY_H
