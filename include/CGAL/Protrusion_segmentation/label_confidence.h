// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_LABEL_CONFIDENCE_H
#define CGAL_PROTRUSION_SEGMENTATION_LABEL_CONFIDENCE_H

#include <CGAL/Protrusion_segmentation/Border_values.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <cstddef>

namespace CGAL {
namespace Protrusion_segmentation {

/*!
\ingroup PkgProtrusionSegmentationRef

tells for every face how sure its label is: the value of the weakest border of its segment. What has the least confidence is
what to check by hand first.

Both sides of a doubtful border get its low value. So a body has the confidence of its weakest border, however sure its
other borders are, and so has a protrusion from which another one sticks out.
`Protrusion_segmentation::Border_values::value()` tells which border it is.

\tparam FaceGraph a model of `FaceListGraph`
\tparam SegmentMap a model of `ReadablePropertyMap` with `boost::graph_traits<FaceGraph>::%face_descriptor` as key type
                   and an integral value type
\tparam ConfidenceMap a model of `WritablePropertyMap` with `boost::graph_traits<FaceGraph>::%face_descriptor` as key
                      type and `double` as value type

\param pmesh the mesh
\param segment_ids the segment of every face, as written by a function of this package
\param borders the values of the borders, made from the protrusions that a visitor was told of
\param confidence for every face the value of the weakest border of its segment, in the unit of
       `Protrusion_segmentation::Border_values`; infinity where a component is one segment

Complexity: linear in the number of faces.
*/
template <typename FaceGraph, typename SegmentMap, typename ConfidenceMap>
void label_confidence(const FaceGraph& pmesh,
                      SegmentMap segment_ids,
                      const Border_values& borders,
                      ConfidenceMap confidence)
{
  for (const auto f : faces(pmesh))
    put(confidence, f, borders.least_value(static_cast<std::size_t>(get(segment_ids, f))));
}

} // namespace Protrusion_segmentation
} // namespace CGAL

#endif // CGAL_PROTRUSION_SEGMENTATION_LABEL_CONFIDENCE_H
