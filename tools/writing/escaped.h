// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROTRUSION_SEGMENTATION_TOOLS_WRITING_ESCAPED_H
#define PROTRUSION_SEGMENTATION_TOOLS_WRITING_ESCAPED_H

#include <string>

namespace tool {

// As a value in quotes.
inline std::string escaped_in_XML(const std::string& text)
{
  std::string result;
  for (const char c : text)
    switch (c)
    {
    case '&':
      result += "&amp;";
      break;
    case '<':
      result += "&lt;";
      break;
    case '>':
      result += "&gt;";
      break;
    case '"':
      result += "&quot;";
      break;
    default:
      result += static_cast<unsigned char>(c) < ' ' ? ' ' : c;
    }
  return result;
}

} // namespace tool

#endif // PROTRUSION_SEGMENTATION_TOOLS_WRITING_ESCAPED_H
