// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The distances that need a library, compiled once for the tests: `internal/inline.h` says more.

#define CGAL_PROTRUSION_SEGMENTATION_INLINE

#include <CGAL/Protrusion_segmentation/Diffusion_distance.h>
#include <CGAL/Protrusion_segmentation/Exact_geodesic_distance.h>
#include <CGAL/Protrusion_segmentation/Heat_distance.h>
