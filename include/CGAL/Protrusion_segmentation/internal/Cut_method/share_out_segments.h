// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_SHARE_OUT_SEGMENTS_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_SHARE_OUT_SEGMENTS_H

#include <CGAL/Protrusion_segmentation/Execution.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Component.h>
#include <CGAL/Protrusion_segmentation/internal/Execution/Next_segment.h>

#include <cstddef>
#include <functional>
#include <optional>
#include <queue>
#include <tuple>
#include <vector>

namespace CGAL::Protrusion_segmentation::internal {

// Of each component, `k` in all if there are as many: first those that are found without a number, then others, each time the
// one that gains most; of equals that of the first component.
inline std::vector<std::size_t> share_out_segments(const std::vector<Component*>& components, std::size_t k, Execution& execution)
{
  std::vector<std::size_t> numbers(components.size(), 1), automatic(components.size(), 0);
  using Offer = std::tuple<bool, double, std::size_t>; // whether it is a further one, minus the gain, the component
  std::priority_queue<Offer, std::vector<Offer>, std::greater<>> offers;
  const auto offer = [&](std::size_t c)
  {
    if (const std::optional<double> gain = components[c]->gain_of_next(numbers[c]))
      offers.emplace(numbers[c] >= automatic[c], -*gain, c);
  };
  for (std::size_t c = 0; c < components.size(); ++c)
  {
    const Next_segment progress(execution, c, k);
    if (components.size() > 1)
      automatic[c] = components[c]->automatic_number();
    offer(c);
  }
  for (std::size_t n = components.size(); n < k && !offers.empty(); ++n)
  {
    const Next_segment progress(execution, n, k);
    const std::size_t c = std::get<2>(offers.top());
    offers.pop();
    ++numbers[c];
    if (n + 1 < k)
      offer(c);
  }
  return numbers;
}

} // namespace CGAL::Protrusion_segmentation::internal

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_SHARE_OUT_SEGMENTS_H
