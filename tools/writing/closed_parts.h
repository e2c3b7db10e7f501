// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROTRUSION_SEGMENTATION_TOOLS_WRITING_CLOSED_PARTS_H
#define PROTRUSION_SEGMENTATION_TOOLS_WRITING_CLOSED_PARTS_H

#include "reading/Mesh.h"
#include "reading/Polygon_soup.h"

#include <CGAL/Protrusion_segmentation/Connector.h>
#include <CGAL/Protrusion_segmentation/Connector_options.h>
#include <CGAL/Protrusion_segmentation/Segmentation_record.h>

#include <cstddef>
#include <vector>

namespace tool {

using Record = CGAL::Protrusion_segmentation::Segmentation_record<Mesh>;

// For each segment its faces and the triangles that close it, by flat caps that two segments share or by a rounded one for each.
std::vector<Polygon_soup> closed_parts(const Mesh& mesh,
                                       const std::vector<std::size_t>& segment_of_face,
                                       const Record& record,
                                       bool are_caps_faired);

// By flat caps with pegs and sockets, of which `connectors` tells.
std::vector<Polygon_soup> connected_parts(
  const Mesh& mesh,
  const std::vector<std::size_t>& segment_of_face,
  const Record& record,
  const CGAL::Protrusion_segmentation::Connector_options& options,
  std::vector<CGAL::Protrusion_segmentation::Connector<Point>>& connectors);

} // namespace tool

#endif // PROTRUSION_SEGMENTATION_TOOLS_WRITING_CLOSED_PARTS_H
