// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROTRUSION_SEGMENTATION_TOOLS_READING_FORMAT_ERROR_H
#define PROTRUSION_SEGMENTATION_TOOLS_READING_FORMAT_ERROR_H

#include <cstddef>
#include <stdexcept>
#include <string>

namespace tool
{

// What is wrong with the content of a file; whoever knows its name makes an `Error` of it.
struct Format_error : std::runtime_error
{
  using std::runtime_error::runtime_error;
  Format_error(std::size_t line, const std::string& cause)
    : std::runtime_error("line " + std::to_string(line) + ": " + cause)
  { }
};

} // namespace tool

#endif // PROTRUSION_SEGMENTATION_TOOLS_READING_FORMAT_ERROR_H
