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

namespace CGAL::Protrusion_segmentation {

/*!
\ingroup PkgProtrusionSegmentationMethods

The default method: borders are minimum cuts along concave seams.

The cost of a cut is its length, reduced where it runs along a concave seam. There are two kinds of candidates: level sets of
the distances from protrusion tips, and regions that are better connected inside than to their surroundings, such as
the fin of a fish. A candidate is replaced by the minimum cut in a band around it if that is better. Clues give the evidence
for a cut: the share of its length in a concave seam, its length, how suddenly the surface widens behind it, and others.
The evidence and the areas of both sides give the value of the cut. Each time the cut with the largest value is made, or several
sure ones of a segment at once if their values have a larger sum than those of as many single ones. In the end, the borders
between neighboring segments become minimum cuts on the faces.

If no number of segments is given, segmentation stops at the largest drop in the gain of a further cut. Hills, scales and
pockets, which face in one direction as a whole, hardly count. A cut is distinct if the surface widens
beside it or if it lies in a deep seam. A surface is one segment if distinct cuts have at most a quarter of the sum of the
values. So springs, rings and knots are whole.

A flat component, whose faces all have the same normal, is segmented by its outline.

Every connected component is segmented by itself, in its own unit of length. If a number of segments is given, each
further segment goes to the component where it gains most.

From given tips, each cuts off the protrusion with the best border around this tip and no other one, with no more than
half of the area of the component. If there are fewer than six tips on a component, further ones are selected as far as
possible from all others, in the method's own distance. They limit the protrusions of the given tips and get no segments of
their own.

By default, tips and level sets come from a distance that the method measures on its coarse graph, in which paths across
concave seams are longer than on the surface. With a distance of choice, they come from that distance on the faces, but for the
borders of given tips.
Segments of less than 0.25 % of the area of a component are not cut off: a component has at most 400 segments.

With `CGAL::Parallel_tag`, several threads search for cuts if the distance is the method's own; the labels are the same.

Complexity: linear in the number of faces. Cuts are searched on a coarse graph of some 1,400 nodes, so that the time
of the search does not depend on the number of faces. Each given tip takes a minimum cut of the coarse graph.
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

} // namespace CGAL::Protrusion_segmentation

#if !defined(DOXYGEN_RUNNING) && !defined(CGAL_PROTRUSION_SEGMENTATION_COMPILED)

#include <CGAL/Protrusion_segmentation/internal/Cut_method/Cut_segmentation.h>

namespace CGAL::Protrusion_segmentation {

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

} // namespace CGAL::Protrusion_segmentation

#endif

#endif // CGAL_PROTRUSION_SEGMENTATION_MINIMUM_CUT_METHOD_H
