// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROTRUSION_SEGMENTATION_TOOLS_WRITING_SHORTEST_DIGITS_H
#define PROTRUSION_SEGMENTATION_TOOLS_WRITING_SHORTEST_DIGITS_H

#include "reading/Mesh.h"

#include <array>
#include <charconv>
#include <ostream>

namespace tool {

// The fewest digits that are read as the same number.
inline void write_shortest(std::ostream& out, double value)
{
  std::array<char, 32> text; // enough for any
  const auto [end, error] = std::to_chars(text.data(), text.data() + text.size(), value);
  out.write(text.data(), end - text.data());
}

inline void write_shortest(std::ostream& out, const Point& point)
{
  for (int c = 0; c < 3; ++c)
  {
    if (c > 0)
      out << ' ';
    write_shortest(out, point[c]);
  }
}

} // namespace tool

#endif // PROTRUSION_SEGMENTATION_TOOLS_WRITING_SHORTEST_DIGITS_H
