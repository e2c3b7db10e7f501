// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_SEGMENTATION_STOPPED_H
#define CGAL_PROTRUSION_SEGMENTATION_SEGMENTATION_STOPPED_H

namespace CGAL::Protrusion_segmentation {

/*!
\ingroup PkgProtrusionSegmentationRef

The exception that ends a call if its visitor stops it: if `go_further()` of the visitor returns `false`.
The call has written nothing then. Only callers whose visitor stops a call have to catch it.

It does not derive from `std::exception`, so that a distance that handles exceptions of its own lets it
pass.
*/
struct Segmentation_stopped
{};

} // namespace CGAL::Protrusion_segmentation

#endif // CGAL_PROTRUSION_SEGMENTATION_SEGMENTATION_STOPPED_H
