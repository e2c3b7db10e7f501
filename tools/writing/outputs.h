// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The files that segment_by_protrusions writes a segmented mesh to.

#ifndef PROTRUSION_SEGMENTATION_TOOLS_WRITING_OUTPUTS_H
#define PROTRUSION_SEGMENTATION_TOOLS_WRITING_OUTPUTS_H

#include "writing/Format_options.h"
#include "writing/Output_files.h"
#include "writing/Segmented_soup.h"

#include <cstddef>
#include <string>
#include <vector>

namespace tool {

// "extension: description" of every format, chosen by the extension of a name.
std::vector<std::string> output_formats();

// ".seg" and so on, of the same formats
std::vector<std::string> output_extensions();

// Does a file of this name hold a mesh, or only the labels of the faces of the file that was read?
bool holds_a_mesh(const std::string& name);

// Does a file of this name hold closed parts as objects of their own?
bool holds_parts(const std::string& name);

// The file that is written beside one of this name; empty if there is none.
std::string companion_of(const std::string& name, const Format_options& options);

// Empty, or how many edges have equal ends in the single precision of a format among the outputs: far from the origin.
std::string note_on_single_precision(const std::vector<std::string>& names, const Polygon_soup& soup);

// Throws std::invalid_argument if this is none of them, without its point.
void check_output_format(const std::string& format);

// Throws std::invalid_argument if no file can have this name: an unknown extension, or a "%d" where
// there can be none.
void check_output_name(const std::string& name);

// Throws std::invalid_argument if an option has a value that makes no sense.
void check_format_options(const Format_options& options);

// One file for each part, in one folder, which is made.
void add_parts(const std::vector<std::string>& names,
               const std::vector<Segmented_soup>& parts,
               const Format_options& options,
               Output_files& files);

// The whole in one file.
void add_output(const std::string& name,
                const Segmented_soup& segmented,
                const Format_options& options,
                Output_files& files);

// All parts as objects of one file.
void add_output_of_parts(const std::string& name,
                         const std::vector<Segmented_soup>& parts,
                         Output_files& files);

} // namespace tool

#endif // PROTRUSION_SEGMENTATION_TOOLS_WRITING_OUTPUTS_H
