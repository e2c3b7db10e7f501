// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROTRUSION_SEGMENTATION_TOOLS_REPORT_BASE64_H
#define PROTRUSION_SEGMENTATION_TOOLS_REPORT_BASE64_H

#include <boost/archive/iterators/base64_from_binary.hpp>
#include <boost/archive/iterators/transform_width.hpp>

#include <cstddef>
#include <string>
#include <vector>

namespace tool
{

// The bytes of an array of numbers as text (RFC 4648, section 4).
template <typename T>
std::string base64(const std::vector<T>& numbers)
{
  namespace it = boost::archive::iterators;
  using Digit = it::base64_from_binary<it::transform_width<std::string::const_iterator, 6, 8>>;

  const std::string padding((3 - numbers.size() * sizeof(T) % 3) % 3, '=');
  // The iterators read whole groups of three bytes.
  std::string bytes(reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(T));
  bytes.append(padding.size(), '\0');
  std::string text(Digit(bytes.cbegin()), Digit(bytes.cend()));
  text.resize(text.size() - padding.size());
  return text + padding;
}

} // namespace tool

#endif // PROTRUSION_SEGMENTATION_TOOLS_REPORT_BASE64_H
