// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROTRUSION_SEGMENTATION_TOOLS_WRITING_JSON_H
#define PROTRUSION_SEGMENTATION_TOOLS_WRITING_JSON_H

#include "segmentation/Findings.h"

#include <nlohmann/json_fwd.hpp>

#include <ostream>

namespace tool
{

// What segment_by_protrusions found, for other programs.
nlohmann::ordered_json describe(const Findings& findings);

void write_json(std::ostream& out, const Findings& findings);

} // namespace tool

#endif // PROTRUSION_SEGMENTATION_TOOLS_WRITING_JSON_H
