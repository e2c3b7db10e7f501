// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// For CGAL::Protrusion_segmentation_compiled: `internal/inline.h` says more.

#define CGAL_PROTRUSION_SEGMENTATION_INLINE
#define CGAL_PROTRUSION_SEGMENTATION_COMPILED_SURFACES

#include <CGAL/Protrusion_segmentation/Histogram_method.h>
