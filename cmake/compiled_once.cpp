// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What most tests use beside the methods: templates, and the meshes that they segment.

#define CGAL_PROTRUSION_SEGMENTATION_INLINE
#define CGAL_PROTRUSION_SEGMENTATION_EXTERN

#include "compiled_once.h"

#include "test_meshes.h"
