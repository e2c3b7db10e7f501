// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "writing/closed_parts.h"

#include <CGAL/Protrusion_segmentation/closed_segments.h>
#include <CGAL/Protrusion_segmentation/closed_segments_with_connectors.h>
#include <CGAL/Protrusion_segmentation/faired_closed_segments.h>

#include <boost/property_map/property_map.hpp>

#include <iterator>
#include <utility>

namespace tool {
namespace {

namespace segmentation = CGAL::Protrusion_segmentation;

using Closed_segments = std::vector<segmentation::Closed_segment<Point>>;

auto map_of(const std::vector<std::size_t>& segment_of_face, const Mesh& mesh)
{
  return boost::make_iterator_property_map(segment_of_face.begin(), get(boost::face_index, mesh));
}

std::vector<Polygon_soup> soups_of(Closed_segments closed)
{
  std::vector<Polygon_soup> parts;
  for (segmentation::Closed_segment<Point>& part : closed)
    parts.push_back({std::move(part.points), polygons_of(part.polygons)});
  return parts;
}

} // namespace

std::vector<Polygon_soup> closed_parts(const Mesh& mesh,
                                       const std::vector<std::size_t>& segment_of_face,
                                       const Record& record,
                                       bool are_caps_faired)
{
  Closed_segments closed;
  if (are_caps_faired)
    segmentation::faired_closed_segments(mesh, map_of(segment_of_face, mesh), record,
                                         std::back_inserter(closed));
  else
    segmentation::closed_segments(mesh, map_of(segment_of_face, mesh), record, std::back_inserter(closed));
  return soups_of(std::move(closed));
}

std::vector<Polygon_soup> connected_parts(const Mesh& mesh,
                                          const std::vector<std::size_t>& segment_of_face,
                                          const Record& record,
                                          const segmentation::Connector_options& options,
                                          std::vector<segmentation::Connector<Point>>& connectors)
{
  Closed_segments closed;
  segmentation::closed_segments_with_connectors(mesh, map_of(segment_of_face, mesh), record, options,
                                                std::back_inserter(closed),
                                                std::back_inserter(connectors));
  return soups_of(std::move(closed));
}

} // namespace tool
