// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Numbers in files and options, whatever the locale.

#ifndef PROTRUSION_SEGMENTATION_TOOLS_COMMAND_LINE_NUMBER_H
#define PROTRUSION_SEGMENTATION_TOOLS_COMMAND_LINE_NUMBER_H

#include <charconv>
#include <optional>
#include <string_view>
#include <system_error>

namespace tool
{

// Sets `value` to the number that the whole word is, or says why it is none: `invalid_argument` or `result_out_of_range`.
template <typename T>
std::errc parse_number(std::string_view word, T& value)
{
  if (word.size() > 1 && word[0] == '+' && word[1] != '-') // which std::from_chars() does not know
    word.remove_prefix(1);
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  return end == word.data() + word.size() ? error : std::errc::invalid_argument;
}

template <typename T>
std::optional<T> number(std::string_view word)
{
  T value{};
  return parse_number(word, value) == std::errc() ? std::optional<T>(value) : std::nullopt;
}

} // namespace tool

#endif // PROTRUSION_SEGMENTATION_TOOLS_COMMAND_LINE_NUMBER_H
