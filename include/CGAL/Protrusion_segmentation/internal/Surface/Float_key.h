// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_SURFACE_FLOAT_KEY_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_SURFACE_FLOAT_KEY_H

#include <CGAL/assertions.h>

#include <cstdint>
#include <cstring>

namespace CGAL::Protrusion_segmentation::internal {

// A number and an index as one integer, which is compared and sorted in less time than a pair: by the number, then by
// the index. Numbers that are not negative are ordered as the bits of their representation.
using Float_key = std::uint64_t;

inline Float_key float_key(float number, std::uint32_t index)
{
  CGAL_assertion(number >= 0);
  std::uint32_t bits;
  std::memcpy(&bits, &number, sizeof(bits));
  return (static_cast<Float_key>(bits) << 32) | index;
}

inline float float_of(Float_key key)
{
  const std::uint32_t bits = static_cast<std::uint32_t>(key >> 32);
  float number;
  std::memcpy(&number, &bits, sizeof(number));
  return number;
}

inline std::uint32_t index_of(Float_key key)
{
  return static_cast<std::uint32_t>(key);
}

} // namespace CGAL::Protrusion_segmentation::internal

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_SURFACE_FLOAT_KEY_H
