// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXAMPLES_PROTRUSION_SEGMENTATION_TOOL_REPORT_H
#define CGAL_EXAMPLES_PROTRUSION_SEGMENTATION_TOOL_REPORT_H

#include "../include/tool_support.h"

#include <nlohmann/json.hpp>

#include <ostream>
#include <vector>

namespace tool
{

// Was three.js found when this program was built?
bool can_write_report();

// Writes a page that needs no other file: the mesh in three dimensions and what is known of each
// segment. `record` is what the JSON output holds, `segment_ids` in the order of the faces.
void write_report(std::ostream& out,
                  nlohmann::ordered_json record,
                  const Mesh& mesh,
                  const std::vector<std::size_t>& segment_ids);

} // namespace tool

#endif // CGAL_EXAMPLES_PROTRUSION_SEGMENTATION_TOOL_REPORT_H
