// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "writing/json.h"

#include "writing/Json_object.h"

#include <vector>

namespace tool {
namespace {

using Status = CGAL::Protrusion_segmentation::Connector_status;

const char* name_of(Status status)
{
  switch (status)
  {
  case Status::PLACED:
    return "placed";
  case Status::CAP_TOO_SMALL:
    return "cap too small";
  case Status::CAP_NOT_FLAT:
    return "cap not flat";
  default:
    return "no room";
  }
}

std::vector<double> coordinates_of(const Point& point)
{
  return {point.x(), point.y(), point.z()};
}

} // namespace

Json describe(const std::vector<Connector>& connectors)
{
  Json array = Json::array();
  for (const Connector& connector : connectors)
  {
    const bool is_placed = connector.status == Status::PLACED;
    array.push_back(Json_object()
                      .add("segment", connector.segment)
                      .add("parent", connector.parent)
                      .add("status", name_of(connector.status))
                      .add("cap_radius", connector.cap_radius)
                      .add_if(is_placed, "peg_segment",
                              connector.is_peg_on_segment ? connector.segment : connector.parent)
                      .add_if(is_placed, "base", coordinates_of(connector.base))
                      .add_if(is_placed, "end", coordinates_of(connector.end))
                      .add_if(is_placed, "radius", connector.radius)
                      .add_if(is_placed, "depth", connector.depth)
                      .add_if(is_placed, "tolerance", connector.tolerance)
                      .take());
  }
  return array;
}

Json describe(const CGAL::Protrusion_segmentation::Connector_options& options)
{
  return Json_object()
    .add("sides", options.number_of_sides)
    .add("radius", options.radius)
    .add("depth", options.depth)
    .add("chamfer", options.chamfer)
    .add_optional("tolerance", options.tolerance)
    .add_optional("smallest_radius", options.smallest_radius)
    .take();
}

} // namespace tool
