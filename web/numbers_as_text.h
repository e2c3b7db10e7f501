// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// std::from_chars() and std::to_chars() of floating point numbers, which Emscripten's standard library lacks. Included before
// every file. Numbers are the same as with another library; of to_chars(), the notation of large whole numbers may differ.

#ifndef PROTRUSION_SEGMENTATION_WEB_NUMBERS_AS_TEXT_H
#define PROTRUSION_SEGMENTATION_WEB_NUMBERS_AS_TEXT_H

#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>
#include <system_error>
#include <type_traits>

namespace std {

template <typename T, enable_if_t<is_floating_point_v<T>, int> = 0>
from_chars_result from_chars(const char* first, const char* last, T& value)
{
  const bool is_begin_known = first != last && strchr("-.0123456789in", *first | 0x20) != nullptr;
  const string text(first, last);
  if (!is_begin_known || text.find_first_of("xX") != string::npos || text.compare(0, 2, "-+") == 0)
    return {first, errc::invalid_argument};
  char* end = nullptr;
  const double parsed = strtod(text.c_str(), &end); // there is no other locale than "C"
  if (end == text.c_str())
    return {first, errc::invalid_argument};
  const char* const behind = first + (end - text.c_str());
  const bool is_infinity_meant = text.find_first_of("nN") != string::npos;
  if (std::isinf(T(parsed)) && !is_infinity_meant)
    return {behind, errc::result_out_of_range};
  if (parsed == 0 && text.substr(0, text.find_first_of("eE")).find_first_of("123456789") != string::npos)
    return {behind, errc::result_out_of_range};
  value = T(parsed);
  return {behind, errc()};
}

template <typename T, enable_if_t<is_floating_point_v<T>, int> = 0>
to_chars_result to_chars(char* first, char* last, T value)
{
  constexpr int always_exact = 17, always_kept = 15; // digits of a double
  char text[40];
  int size = 0;
  for (int digits = always_kept; digits <= always_exact; ++digits)
  {
    size = snprintf(text, sizeof text, "%.*g", digits, double(value));
    if (strtod(text, nullptr) == double(value))
      break;
  }
  if (last - first < size)
    return {last, errc::value_too_large};
  memcpy(first, text, size_t(size));
  return {first + size, errc()};
}

} // namespace std

#endif // PROTRUSION_SEGMENTATION_WEB_NUMBERS_AS_TEXT_H
