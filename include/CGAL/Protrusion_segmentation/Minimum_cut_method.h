// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_MINIMUM_CUT_METHOD_H
#define CGAL_PROTRUSION_SEGMENTATION_MINIMUM_CUT_METHOD_H

#include <CGAL/Protrusion_segmentation/Execution.h>
#include <CGAL/Protrusion_segmentation/Indexed_surface.h>
#include <CGAL/Protrusion_segmentation/internal/Distances/Any_distance.h>
#include <CGAL/Protrusion_segmentation/internal/Segments/Nested_segments.h>
#include <CGAL/Protrusion_segmentation/internal/inline.h>

#include <cstddef>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Protrusion_segmentation {

/*!
\ingroup PkgProtrusionSegmentationMethods

The default method: borders along concave seams.

A cut costs its length, little where it runs along a concave seam. Candidates are those level sets of the
distances from protrusion tips that cost least for the area that they cut off, and regions that hang together more than
with what is around, as the fin of a fish, which is no level set. Where the minimum cut in a band
around a candidate is better, it takes its place. The value of a cut is estimated from a dozen clues: how much of it
lies in a concave seam, its length, how suddenly the surface widens behind it, how round it is and others, and from
the areas on both sides. The cuts are chosen together: the three best sets of cuts are kept while segments are added,
each tried with its four best further cuts, and the set with the largest sum of values wins. Without a number of
segments, the largest drop of what one more brings ends them, between cuts that are surely evident and cuts that are
not, and hills, scales and pockets, which face one way as a whole, hardly count. In the end, the borders between all
neighboring segments become minimum cuts once more, on the faces.

A flat component, whose faces all have the same normal, is segmented by its outline.

Every connected component is judged by itself, in its own unit of length; with a number of segments given, each
further segment goes to the component where it brings most.

From given tips, each cuts off the protrusion with the best border that has this tip, no other one, and no more than
half of the component's area. Where fewer than six tips are given on a component, further ones are selected as far as
possible from all others. They limit the protrusions of the given tips and get no segments of their own.

Cuts are searched on a coarse graph of some two thousand nodes, so that the time for a cut hardly depends on
the number of faces. By default tips and level sets are those of a distance that the method measures on that graph,
where ways across concave seams are longer than they are on the surface. With a distance of choice, they are those
of the distance on the faces. Segments of less than 0.25 % of the area of a component are not cut off: with a large
number of segments there may be fewer than asked for.

With `CGAL::Parallel_tag`, segments are searched for cuts by several threads, if the distance is the method's own; the
labels are the same.

Complexity: linear in the number of faces. Normals are averaged on groups of faces where these are small, and of all that
is searched on the coarse graph, the time does not depend on the number of faces. From given tips, each takes a minimum cut
of the coarse graph: with hundreds of tips they take longer than all else.
*/
class Minimum_cut_method
{
public:
  /// the method with its own distance
  Minimum_cut_method() = default;

  /// the method with a distance of choice.
  /// \tparam Distance a model of `ProtrusionDistance`
  /// \param distance is copied into the method
  template <typename Distance,
            typename = std::enable_if_t<!std::is_base_of<Minimum_cut_method, std::decay_t<Distance>>::value>>
  explicit Minimum_cut_method(Distance&& distance)
    : m_distance(std::decay_t<Distance>(std::forward<Distance>(distance)))
  {}

#ifndef DOXYGEN_RUNNING
  // as for `Histogram_method`
  internal::Nested_segments segment(const Indexed_surface& surface,
                                    std::optional<std::size_t> number_of_segments,
                                    Execution& execution) const;
  internal::Nested_segments segment_from_tips(const Indexed_surface& surface,
                                              const std::vector<Indexed_surface::Index>& tips,
                                              Execution& execution) const;
#endif

private:
  std::optional<internal::Any_distance> m_distance;
};

} // namespace Protrusion_segmentation
} // namespace CGAL

#if !defined(DOXYGEN_RUNNING) && !defined(CGAL_PROTRUSION_SEGMENTATION_LINKED_METHODS)

#include <CGAL/Protrusion_segmentation/internal/Cut_method/Cut_segmentation.h>

namespace CGAL {
namespace Protrusion_segmentation {

CGAL_PROTRUSION_SEGMENTATION_INLINE internal::Nested_segments
Minimum_cut_method::segment(const Indexed_surface& surface,
                            std::optional<std::size_t> number_of_segments,
                            Execution& execution) const
{
  internal::Cut_segmentation segmentation(surface, m_distance, execution);
  return number_of_segments ? segmentation.with_number_of_segments(*number_of_segments)
                            : segmentation.with_automatic_number();
}

CGAL_PROTRUSION_SEGMENTATION_INLINE internal::Nested_segments
Minimum_cut_method::segment_from_tips(const Indexed_surface& surface,
                                      const std::vector<Indexed_surface::Index>& tips,
                                      Execution& execution) const
{
  return internal::Cut_segmentation(surface, m_distance, execution).from_tips(tips);
}

} // namespace Protrusion_segmentation
} // namespace CGAL

#endif

#endif // CGAL_PROTRUSION_SEGMENTATION_MINIMUM_CUT_METHOD_H
