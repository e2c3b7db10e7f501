// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Names with a "%d", a "%03d" or a "%s" for a file per segment.

#ifndef PROTRUSION_SEGMENTATION_TOOLS_WRITING_PART_NAMES_H
#define PROTRUSION_SEGMENTATION_TOOLS_WRITING_PART_NAMES_H

#include <cstddef>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace tool
{

bool is_pattern(const std::string& name);

// Is the number, or name, there once, and in the name of the file, not in that of its folder?
bool is_valid_pattern(const std::string& name);

std::string name_of_part(const std::string& pattern, std::size_t segment);

// Of all segments. A "%s" becomes the name of the segment, or "segment_N" without one: each different, in characters that names
// of files, and of groups in OBJ, may have.
std::vector<std::string> names_of_parts(const std::string& pattern,
                                        std::size_t number_of_segments,
                                        const std::vector<std::string>& names_of_segments);

// Where a file is, or would be, whatever it is called: links are followed, also those of folders that are there.
std::filesystem::path place_of_file(const std::string& name);

// Is the file what the pattern gives for some number, by its name or by a link that is there?
bool gives_part(const std::string& pattern, const std::string& name);

// What is there of the files that the pattern gives, by their numbers.
std::map<std::size_t, std::string> parts_in_place(const std::string& pattern);

// Says which of them have numbers that no segment has, as those of an earlier run with more segments; empty if none.
std::string note_on_further_parts(const std::string& pattern, std::size_t number_of_segments);

// A name that both patterns give, for numbers that segments may have.
std::optional<std::string> common_part(const std::string& pattern, const std::string& other);

} // namespace tool

#endif // PROTRUSION_SEGMENTATION_TOOLS_WRITING_PART_NAMES_H
