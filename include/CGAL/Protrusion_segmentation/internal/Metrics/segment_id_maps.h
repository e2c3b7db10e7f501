// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a segmentation is for the metrics and the `.seg` files: a property map from the faces to integers.
// A map of another kind fails to compile with one line; the values of the checks are for `if constexpr`, so
// that nothing else is compiled then, which would only bury that line.

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_METRICS_SEGMENT_ID_MAPS_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_METRICS_SEGMENT_ID_MAPS_H

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <type_traits>

namespace CGAL::Protrusion_segmentation::internal {

// `Category` is the tag of Boost's property maps for what the map must be able to.
template <typename FaceGraph, typename Map, typename Category, typename = void>
struct Is_segment_id_map : std::false_type
{};

template <typename FaceGraph, typename Map, typename Category>
struct Is_segment_id_map<
  FaceGraph,
  Map,
  Category,
  std::enable_if_t<std::is_convertible_v<typename boost::property_traits<Map>::category, Category> &&
                   std::is_convertible_v<typename boost::graph_traits<FaceGraph>::face_descriptor,
                                         typename boost::property_traits<Map>::key_type> &&
                   std::is_integral_v<typename boost::property_traits<Map>::value_type>>> : std::true_type
{};

template <typename FaceGraph, typename SegmentIdMap>
struct Check_readable_segment_ids
  : Is_segment_id_map<FaceGraph, SegmentIdMap, boost::readable_property_map_tag>
{
  static_assert(Check_readable_segment_ids::value,
                "segment_ids must be a readable property map from faces to integers");
};

template <typename FaceGraph, typename SegmentIdMap>
struct Check_writable_segment_ids
  : Is_segment_id_map<FaceGraph, SegmentIdMap, boost::writable_property_map_tag>
{
  static_assert(Check_writable_segment_ids::value,
                "segment_ids must be a writable property map from faces to integers");
};

template <typename FaceGraph, typename ReferenceIdMap>
struct Check_reference_ids
  : Is_segment_id_map<FaceGraph, ReferenceIdMap, boost::readable_property_map_tag>
{
  static_assert(Check_reference_ids::value,
                "reference_ids must be a readable property map from faces to integers");
};

// Both are checked, so that there is a line for each that is wrong.
template <typename FaceGraph, typename SegmentIdMap, typename ReferenceIdMap>
constexpr bool are_comparable = Check_readable_segment_ids<FaceGraph, SegmentIdMap>::value&&
  Check_reference_ids<FaceGraph, ReferenceIdMap>::value;

} // namespace CGAL::Protrusion_segmentation::internal

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_METRICS_SEGMENT_ID_MAPS_H
