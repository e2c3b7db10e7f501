// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "segmentation/join_segments.h"

#include <cstddef>
#include <numeric>

namespace tool {

std::vector<std::size_t> join_segments(Segmentation& segmentation, const std::vector<bool>& is_joined)
{
  const std::vector<Protrusion> all = segmentation.record.protrusions();
  std::vector<std::size_t> ancestors(segmentation.number_of_segments), numbers(ancestors.size());
  std::iota(ancestors.begin(), ancestors.end(), std::size_t(0));
  for (const Protrusion& protrusion : all)
    if (is_joined[protrusion.segment])
      ancestors[protrusion.segment] = protrusion.parent;
  std::size_t number = 0;
  for (std::size_t s = 0; s < ancestors.size(); ++s)
  {
    if (ancestors[s] == s)
      numbers[s] = number++;
    while (ancestors[ancestors[s]] != ancestors[s])
      ancestors[s] = ancestors[ancestors[s]];
  }
  std::vector<std::size_t> result(ancestors.size());
  for (std::size_t s = 0; s < result.size(); ++s)
    result[s] = numbers[ancestors[s]];
  for (std::size_t& s : segmentation.segment_ids)
    s = result[s];
  segmentation.number_of_segments = number;
  std::vector<Protrusion> left;
  for (Protrusion protrusion : all)
    if (ancestors[protrusion.segment] == protrusion.segment)
    {
      protrusion.segment = result[protrusion.segment];
      protrusion.parent = result[protrusion.parent];
      left.push_back(protrusion);
    }
  segmentation.record.set_protrusions(left);
  return result;
}

} // namespace tool
