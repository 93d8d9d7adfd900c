// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

// What CGAL makes for each of its packages: users who define CGAL_LICENSE_WARNING or CGAL_LICENSE_ERROR, see
// <CGAL/license.h>, are told that a package with the GPL is used. In CGAL's tree a file of its own takes this place.

#ifndef CGAL_LICENSE_HERMITE_DIFFUSE_REMESHING_H
#define CGAL_LICENSE_HERMITE_DIFFUSE_REMESHING_H

#include <CGAL/config.h>
#include <CGAL/license.h>

#ifdef CGAL_LICENSE_ERROR
#error "The package Hermite Diffuse Remeshing has the licence GPL, version 3 or later: CGAL_LICENSE_ERROR refuses it."
#elif defined(CGAL_LICENSE_WARNING)
CGAL_pragma_warning("The package Hermite Diffuse Remeshing is used under its licence, the GPL, version 3 or later.")
#endif

#endif // CGAL_LICENSE_HERMITE_DIFFUSE_REMESHING_H
