// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the methods and the distances that need a library do is `inline`, as all else. The package's own tests, which are
// many, compile it once: all but one of their files define CGAL_PROTRUSION_SEGMENTATION_LINKED_METHODS and see no more than declarations; that one defines
// CGAL_PROTRUSION_SEGMENTATION_INLINE as nothing.

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_INLINE_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_INLINE_H

#ifndef CGAL_PROTRUSION_SEGMENTATION_INLINE
#define CGAL_PROTRUSION_SEGMENTATION_INLINE inline
#endif

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_INLINE_H
