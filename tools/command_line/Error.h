// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROTRUSION_SEGMENTATION_TOOLS_COMMAND_LINE_ERROR_H
#define PROTRUSION_SEGMENTATION_TOOLS_COMMAND_LINE_ERROR_H

#include <stdexcept>
#include <string>

namespace tool
{

// The message names the file and the cause.
struct Error : std::runtime_error
{
  using std::runtime_error::runtime_error;
  Error(const std::string& file_name, const std::string& cause)
    : std::runtime_error(file_name + ": " + cause)
  { }
};

} // namespace tool

#endif // PROTRUSION_SEGMENTATION_TOOLS_COMMAND_LINE_ERROR_H
