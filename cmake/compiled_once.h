// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Templates that most tests use. Where the methods are linked, compiled_once.cpp compiles them.

#ifndef CGAL_PROTRUSION_SEGMENTATION_COMPILED_ONCE_H
#define CGAL_PROTRUSION_SEGMENTATION_COMPILED_ONCE_H

#include <CGAL/Protrusion_segmentation/Geodesic_distance.h>
#include <CGAL/Protrusion_segmentation/Landmark_geodesic_distance.h>
#include <CGAL/Protrusion_segmentation/internal/Distances/Any_distance.h>

#ifndef CGAL_PROTRUSION_SEGMENTATION_EXTERN
#define CGAL_PROTRUSION_SEGMENTATION_EXTERN extern
#endif

namespace CGAL {
namespace Protrusion_segmentation {
namespace internal {

CGAL_PROTRUSION_SEGMENTATION_EXTERN template class Model_of_distances<Geodesic_distance>;
CGAL_PROTRUSION_SEGMENTATION_EXTERN template class Model_of_distances<Landmark_geodesic_distance>;

} // namespace internal
} // namespace Protrusion_segmentation
} // namespace CGAL

#endif // CGAL_PROTRUSION_SEGMENTATION_COMPILED_ONCE_H
