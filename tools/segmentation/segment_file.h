// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// From a file to what is found in it.

#ifndef PROTRUSION_SEGMENTATION_TOOLS_SEGMENTATION_SEGMENT_FILE_H
#define PROTRUSION_SEGMENTATION_TOOLS_SEGMENTATION_SEGMENT_FILE_H

#include "segmentation/Findings.h"
#include "segmentation/Recorder.h"

#include <functional>
#include <string>

namespace tool
{

using Warn = std::function<void(const std::string&)>;

// Throws an `Error` for a file that cannot be read, or has too few faces. `progress` is told of all until the end of
// `write_findings()`; `warn` is called before what may take long.
Findings segment_file(const std::string& input, const Segmentation_options& options,
                      const Recorder::Progress& progress, const Warn& warn);

// Empty, or that there are fewer segments than were asked for.
std::string note_on_missing_segments(const Findings& findings);

// "faces, segments, seconds"
std::string summary(const Findings& findings);

} // namespace tool

#endif // PROTRUSION_SEGMENTATION_TOOLS_SEGMENTATION_SEGMENT_FILE_H
