// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_LABEL_CONFIDENCE_H
#define CGAL_PROTRUSION_SEGMENTATION_LABEL_CONFIDENCE_H

#include <CGAL/Protrusion_segmentation/Segmentation_record.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <limits>

namespace CGAL::Protrusion_segmentation {

/*!
\ingroup PkgProtrusionSegmentationRef

tells for every face how sure its label is: the confidence in the weakest border of its segment. Faces with the least
confidence are to be checked by hand first.

The confidence in a border is its probability if the method estimates it, as `Minimum_cut_method` does, and else its
value: `Histogram_method` gives prominences, which compare the borders of one mesh. Both sides of a border get its
confidence. So a body has the confidence of its weakest border, however sure its others are, and so has a protrusion that
others stick out of. `Segmentation_record::probability()` and `Segmentation_record::value()` tell which border it is.

\tparam FaceGraph a model of `FaceListGraph`
\tparam SegmentMap a model of `ReadablePropertyMap` with `boost::graph_traits<FaceGraph>::%face_descriptor` as key type
                   and an integral value type
\tparam ConfidenceMap a model of `WritablePropertyMap` with `boost::graph_traits<FaceGraph>::%face_descriptor` as key
                      type and `double` as value type

\param pmesh the mesh
\param segment_ids the segment of every face, as the call wrote it that the record was passed to
\param record what that call found
\param confidence for every face the least probability of a border of its segment, from 0 to 1, or, for a method
       without probabilities, the least value; infinity for a segment without a border

Throws nothing of its own.

Complexity: linear in the number of faces.
*/
template <typename FaceGraph, typename SegmentMap, typename ConfidenceMap>
void label_confidence(const FaceGraph& pmesh,
                      SegmentMap segment_ids,
                      const Segmentation_record<FaceGraph>& record,
                      ConfidenceMap confidence)
{
  for (const auto f : faces(pmesh))
  {
    const std::size_t segment = static_cast<std::size_t>(get(segment_ids, f));
    auto least = record.least_probability(segment);
    if (!least)
      least = record.least_value(segment);
    put(confidence, f, least.value_or((std::numeric_limits<double>::infinity)()));
  }
}

} // namespace CGAL::Protrusion_segmentation

#endif // CGAL_PROTRUSION_SEGMENTATION_LABEL_CONFIDENCE_H
