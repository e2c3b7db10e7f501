// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The methods and the distances that need a library are `inline`, as all else. A program that is linked with
// CGAL::Protrusion_segmentation_compiled defines CGAL_PROTRUSION_SEGMENTATION_COMPILED and sees only the declarations of the
// methods. The sources of that library define CGAL_PROTRUSION_SEGMENTATION_INLINE as nothing, and those of the methods
// CGAL_PROTRUSION_SEGMENTATION_COMPILED_SURFACES, since canonical surfaces are compiled apart. The package's own tests
// compile those distances once, too, with CGAL_PROTRUSION_SEGMENTATION_COMPILED_DISTANCES.

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_INLINE_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_INLINE_H

#ifndef CGAL_PROTRUSION_SEGMENTATION_INLINE
#define CGAL_PROTRUSION_SEGMENTATION_INLINE inline
#endif

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_INLINE_H
