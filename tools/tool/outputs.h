// SPDX-License-Identifier: GPL-3.0-or-later
//
// The files that segment_by_protrusions writes a segmented mesh to.

#ifndef CGAL_EXAMPLES_PROTRUSION_SEGMENTATION_TOOL_OUTPUTS_H
#define CGAL_EXAMPLES_PROTRUSION_SEGMENTATION_TOOL_OUTPUTS_H

#include "../include/tool_support.h"
#include "Output_files.h"
#include "segment.h"

#include <string>
#include <vector>

namespace tool
{

// "name: description" of every format, chosen by the extension of a name.
std::vector<std::string> output_formats();

// Does the name have a "%d", for a file per segment?
bool is_pattern(const std::string& name);

// Throws std::invalid_argument if no file can have this name: an unknown extension, or a "%d" where
// there can be none.
void check_output_name(const std::string& name);

void add_output(const std::string& name,
                const Mesh& mesh,
                const Segmentation& segmentation,
                Output_files& files);

} // namespace tool

#endif // CGAL_EXAMPLES_PROTRUSION_SEGMENTATION_TOOL_OUTPUTS_H
