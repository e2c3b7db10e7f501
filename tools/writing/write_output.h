// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROTRUSION_SEGMENTATION_TOOLS_WRITING_WRITE_OUTPUT_H
#define PROTRUSION_SEGMENTATION_TOOLS_WRITING_WRITE_OUTPUT_H

#include <functional>
#include <ostream>
#include <string>

namespace tool
{

// Writes a file so that it appears only when it is complete; or throws an `Error`.
void write_output(const std::string& file_name, const std::function<void(std::ostream&)>& write);

// Flushes the standard output; throws an `Error` if not everything got there.
void finish_standard_output();

} // namespace tool

#endif // PROTRUSION_SEGMENTATION_TOOLS_WRITING_WRITE_OUTPUT_H
