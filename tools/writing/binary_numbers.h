// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Numbers in binary files: little-endian, whatever the machine is.

#ifndef PROTRUSION_SEGMENTATION_TOOLS_WRITING_BINARY_NUMBERS_H
#define PROTRUSION_SEGMENTATION_TOOLS_WRITING_BINARY_NUMBERS_H

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <ostream>

namespace tool {

template <typename Bits>
void write_bits(std::ostream& out, Bits bits)
{
  std::array<char, sizeof(Bits)> bytes;
  for (std::size_t i = 0; i < sizeof(Bits); ++i)
    bytes[i] = static_cast<char>(bits >> 8 * i & 0xff);
  out.write(bytes.data(), bytes.size());
}

inline void write_double(std::ostream& out, double value)
{
  std::uint64_t bits;
  static_assert(sizeof(bits) == sizeof(value));
  std::memcpy(&bits, &value, sizeof(bits));
  write_bits(out, bits);
}

inline void write_float(std::ostream& out, double value)
{
  const auto single = static_cast<float>(value);
  std::uint32_t bits;
  static_assert(sizeof(bits) == sizeof(single));
  std::memcpy(&bits, &single, sizeof(bits));
  write_bits(out, bits);
}

} // namespace tool

#endif // PROTRUSION_SEGMENTATION_TOOLS_WRITING_BINARY_NUMBERS_H
