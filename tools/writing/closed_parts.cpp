// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "writing/closed_parts.h"

#include <CGAL/Protrusion_segmentation/closed_segments.h>
#include <CGAL/Protrusion_segmentation/faired_closed_segments.h>

#include <boost/property_map/property_map.hpp>

#include <iterator>
#include <utility>

namespace tool {

std::vector<Polygon_soup> closed_parts(const Mesh& mesh,
                                       const std::vector<std::size_t>& segment_of_face,
                                       const CGAL::Protrusion_segmentation::Segmentation_record<Mesh>& record,
                                       bool are_caps_faired)
{
  namespace segmentation = CGAL::Protrusion_segmentation;

  const auto segments = boost::make_iterator_property_map(segment_of_face.begin(),
                                                          get(boost::face_index, mesh));
  std::vector<segmentation::Closed_segment<Point>> closed;
  if (are_caps_faired)
    segmentation::faired_closed_segments(mesh, segments, record, std::back_inserter(closed));
  else
    segmentation::closed_segments(mesh, segments, record, std::back_inserter(closed));
  std::vector<Polygon_soup> parts;
  for (segmentation::Closed_segment<Point>& part : closed)
    parts.push_back({std::move(part.points), std::move(part.polygons)});
  return parts;
}

} // namespace tool
