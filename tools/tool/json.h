// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXAMPLES_PROTRUSION_SEGMENTATION_TOOL_JSON_H
#define CGAL_EXAMPLES_PROTRUSION_SEGMENTATION_TOOL_JSON_H

#include "segment.h"

#include <nlohmann/json.hpp>

#include <ostream>
#include <string>

namespace tool
{

// What segment_by_protrusions found, for other programs. `note` is empty or says why there are not
// as many segments as were asked for.
nlohmann::ordered_json describe(const std::string& input,
                                const Segmentation_options& options,
                                const Segmentation& segmentation,
                                const std::string& note);

void write_json(std::ostream& out, const nlohmann::ordered_json& record);

} // namespace tool

#endif // CGAL_EXAMPLES_PROTRUSION_SEGMENTATION_TOOL_JSON_H
