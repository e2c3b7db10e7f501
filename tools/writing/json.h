// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROTRUSION_SEGMENTATION_TOOLS_WRITING_JSON_H
#define PROTRUSION_SEGMENTATION_TOOLS_WRITING_JSON_H

#include "segmentation/Findings.h"

#include <nlohmann/json_fwd.hpp>

#include <ostream>
#include <vector>

namespace tool
{

// Of what segmentation.schema.json describes. It grows when a key changes its meaning or goes.
constexpr int json_format_version = 2;

// What segment_by_protrusions found, for other programs.
nlohmann::ordered_json describe(const Findings& findings);

// What was asked of it; with the same answer a second run would find the same.
nlohmann::ordered_json describe(const Segmentation_options& options);

nlohmann::ordered_json describe(const CGAL::Protrusion_segmentation::Connector_options& options);

// Whether caps have connectors, where and of what size.
nlohmann::ordered_json describe(const std::vector<Connector>& connectors);

void write_json(std::ostream& out, const nlohmann::ordered_json& json);

} // namespace tool

#endif // PROTRUSION_SEGMENTATION_TOOLS_WRITING_JSON_H
