// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_DISTANCE_QUEUE_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_DISTANCE_QUEUE_H

#include <CGAL/Protrusion_segmentation/internal/Surface/Float_key.h>

#include <algorithm>
#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Protrusion_segmentation {
namespace internal {

// The nodes that Dijkstra's algorithm has reached, the nearest first, equally near ones in the order of their numbers. A
// node may be in it several times. Comparing distances takes most of the time.
class Distance_queue
{
public:
  bool empty() const { return m_heap.empty(); }
  void clear() { m_heap.clear(); }

  void push(std::uint32_t node, float distance)
  {
    m_heap.push_back(float_key(distance, node));
    std::push_heap(m_heap.begin(), m_heap.end(), std::greater<>());
  }

  std::pair<std::uint32_t, float> pop()
  {
    std::pop_heap(m_heap.begin(), m_heap.end(), std::greater<>());
    const Float_key nearest = m_heap.back();
    m_heap.pop_back();
    return {index_of(nearest), float_of(nearest)};
  }

private:
  std::vector<Float_key> m_heap;
};

} // namespace internal
} // namespace Protrusion_segmentation
} // namespace CGAL

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_DISTANCE_QUEUE_H
