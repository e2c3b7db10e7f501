// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Integers as options: decimal ones only. CLI11 itself takes 010 for octal.

#ifndef PROTRUSION_SEGMENTATION_TOOLS_COMMAND_LINE_INTEGER_OPTION_H
#define PROTRUSION_SEGMENTATION_TOOLS_COMMAND_LINE_INTEGER_OPTION_H

#include "command_line/number.h"

#include <CLI/CLI.hpp>

#include <cstddef>
#include <limits>
#include <string>
#include <system_error>

namespace tool
{

// For `CLI::Option::transform()`: refuses all but integers from `least` to `most`, in words that fit any of them, and
// takes leading zeros away.
inline CLI::Validator integer(const std::string& what, std::size_t least,
                              std::size_t most = (std::numeric_limits<std::size_t>::max)())
{
  const bool is_bounded = most < (std::numeric_limits<std::size_t>::max)();
  const std::string range = "an integer from " + std::to_string(least) +
                            (is_bounded ? " to " + std::to_string(most) : "");
  const auto problem_with = [=](std::string& text) -> std::string
  {
    std::size_t value = 0;
    const std::errc error = parse_number(text, value);
    if (error == std::errc::result_out_of_range && !is_bounded)
      return "'" + text + "' is more than any computer can count";
    if (error != std::errc() || value < least || value > most)
      return "'" + text + "' is no " + what + ", " + range;
    text = std::to_string(value);
    return "";
  };
  return CLI::Validator(problem_with, "");
}

} // namespace tool

#endif // PROTRUSION_SEGMENTATION_TOOLS_COMMAND_LINE_INTEGER_OPTION_H
