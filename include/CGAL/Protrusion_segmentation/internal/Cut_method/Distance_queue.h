// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_DISTANCE_QUEUE_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_DISTANCE_QUEUE_H

#include <CGAL/Protrusion_segmentation/internal/Surface/Float_key.h>

#include <boost/heap/d_ary_heap.hpp>

#include <cstdint>
#include <functional>
#include <utility>

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

  void push(std::uint32_t node, float distance) { m_heap.push(float_key(distance, node)); }

  std::pair<std::uint32_t, float> pop()
  {
    const Float_key nearest = m_heap.top();
    m_heap.pop();
    return {index_of(nearest), float_of(nearest)};
  }

private:
  boost::heap::d_ary_heap<Float_key, boost::heap::arity<4>, boost::heap::compare<std::greater<>>> m_heap;
};

} // namespace internal
} // namespace Protrusion_segmentation
} // namespace CGAL

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_DISTANCE_QUEUE_H
