// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "writing/binary_numbers.h"
#include "writing/formats.h"

#include <cstddef>
#include <cstdint>
#include <string>

namespace tool {

void write_SEG(std::ostream& out, const Output& output)
{
  for (const std::size_t segment : output.surface.segments)
    out << segment << "\n";
}

void write_NPY(std::ostream& out, const Output& output)
{
  constexpr std::size_t begin_of_header = 10, alignment = 64; // numpy.lib.format, "Format Version 1.0"
  std::string header = "{'descr': '<i4', 'fortran_order': False, 'shape': (" +
                       std::to_string(output.surface.segments.size()) + ",), }";
  header.append(alignment - 1 - (begin_of_header + header.size()) % alignment, ' ') += '\n';
  out << "\x93NUMPY";
  write_bits(out, std::uint16_t(1)); // major version 1, minor version 0
  write_bits(out, static_cast<std::uint16_t>(header.size()));
  out << header;
  for (const std::size_t segment : output.surface.segments)
    write_bits(out, static_cast<std::uint32_t>(segment));
}

} // namespace tool
