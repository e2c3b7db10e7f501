// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROTRUSION_SEGMENTATION_TOOLS_READING_LOWER_CASE_EXTENSION_H
#define PROTRUSION_SEGMENTATION_TOOLS_READING_LOWER_CASE_EXTENSION_H

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <string>

namespace tool
{

inline std::string lower_case_extension(const std::string& file_name)
{
  std::string extension = std::filesystem::path(file_name).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return char(std::tolower(c)); });
  return extension;
}

} // namespace tool

#endif // PROTRUSION_SEGMENTATION_TOOLS_READING_LOWER_CASE_EXTENSION_H
