// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// For programs of the package and its Python module: `internal/inline.h` says more.

#define CGAL_PROTRUSION_SEGMENTATION_INLINE

#include <CGAL/Protrusion_segmentation/Heat_distance.h>
