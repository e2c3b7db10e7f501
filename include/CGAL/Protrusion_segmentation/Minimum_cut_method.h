// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_MINIMUM_CUT_METHOD_H
#define CGAL_PROTRUSION_SEGMENTATION_MINIMUM_CUT_METHOD_H

#include <CGAL/Protrusion_segmentation/Indexed_surface.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Cut_segmentation.h>

#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL {
namespace Protrusion_segmentation {

/*!
\ingroup PkgProtrusionSegmentationBorders

Borders along concave seams: the default border method.

A cut costs its length, little where it runs along a concave seam. Candidates are those level sets of the
distances from protrusion tips that cost least for the area that they cut off. Where the minimum cut in a band
around a candidate is better, it takes its place. The value of a cut is estimated from how much of it lies in a concave seam, its length, how suddenly the
surface widens behind it and the areas on both sides. The best cut of all segments splits its segment; so the
segmentations for different numbers of segments are nested. Without a number of segments, the method stops
when no cut has an evident value.

Cuts are searched on a coarse graph of some two thousand nodes, so that the time for a cut hardly depends on
the number of faces. Parts of less than 0.25 % of the area of the surface are not cut off: with a large number
of segments there may be fewer than asked for.

\cgalModels{ProtrusionBorder}
*/
class Minimum_cut_method
{
public:
#ifndef DOXYGEN_RUNNING
  template <typename Distance, typename Visitor>
  internal::Nested_segments segment(const Indexed_surface& surface,
                                   const Distance& distance,
                                   std::optional<std::size_t> number_of_segments,
                                   internal::Monitor<Visitor>& monitor) const
  {
    internal::Cut_segmentation<Distance, Visitor> segmentation(surface, distance, monitor);
    return number_of_segments ? segmentation.with_number_of_segments(*number_of_segments)
                              : segmentation.with_evident_protrusions();
  }
  template <typename Distance, typename Visitor>
  internal::Nested_segments segment_from_tips(const Indexed_surface& surface,
                                             const Distance& distance,
                                             const std::vector<Indexed_surface::Index>& tips,
                                             internal::Monitor<Visitor>& monitor) const
  {
    return internal::Cut_segmentation<Distance, Visitor>(surface, distance, monitor).from_tips(tips);
  }
#endif
};

} // namespace Protrusion_segmentation
} // namespace CGAL

#endif // CGAL_PROTRUSION_SEGMENTATION_MINIMUM_CUT_METHOD_H
