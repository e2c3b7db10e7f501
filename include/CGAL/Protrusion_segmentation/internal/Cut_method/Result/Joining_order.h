// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_RESULT_JOINING_ORDER_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_RESULT_JOINING_ORDER_H

#include <CGAL/Protrusion_segmentation/internal/Segments/Segment_tree.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL::Protrusion_segmentation::internal {

// The order in which the segments of a tree are given to their parents, one after the other, so that what is left is always near
// another segmentation into as many segments: at each step, the one with the least Rand index error; or the one whose border is
// worth least.
class Joining_order
{
public:
  using Index = Segment_tree::Index;
  using Overlaps = std::vector<
    std::vector<double>>; // areas that segments have in common with those of the other segmentation

  // `values`: of the border of each segment to its parent; `order`: that without other segmentations, the body first
  Joining_order(const Segment_tree& tree, std::vector<double> values, std::vector<Index> order)
    : m_tree(tree),
      m_values(std::move(values)),
      m_left(std::move(order)),
      m_is_joined(m_left.size(), false)
  {}

  std::size_t number_left() const { return m_left.size(); }

  void join_last() { join(m_left.size() - 1); }
  void join_least_valuable() { join(least_valuable()); }

  // Of the borders that are left then.
  double value_without_least_valuable() const
  {
    const std::size_t least = least_valuable();
    double sum = 0;
    for (std::size_t i = 1; i < m_left.size(); ++i)
      sum += i == least ? 0 : m_values[m_left[i]];
    return sum;
  }

  // `overlaps`: of all segments
  void join_for(const Overlaps& overlaps)
  {
    Overlaps of_left = overlaps; // with all that was given to them
    for (Index s = 0; s < overlaps.size(); ++s)
      if (m_is_joined[s])
        for (std::size_t j = 0; j < overlaps[s].size(); ++j)
          of_left[receiver(s)][j] += overlaps[s][j];
    constexpr double rounding = 1e-9; // of areas, which are shares of that of the surface
    std::size_t best = m_left.size() - 1;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = m_left.size(); i-- > 1;)
      if (const double error = error_of_joining(of_left[m_left[i]],
                                                of_left[receiver(m_tree.parent(m_left[i]))]);
          error < least - rounding)
      {
        best = i;
        least = error;
      }
    join(best);
  }

  // the body first, those that are joined first last
  std::vector<Index> operator()() const
  {
    std::vector<Index> result = m_left;
    result.insert(result.end(), m_joined.rbegin(), m_joined.rend());
    return result;
  }

private:
  // What it adds to the error, apart from a factor: pairs in both segments that are together then, and should, count less than
  // those that should not.
  static double error_of_joining(const std::vector<double>& segment, const std::vector<double>& parent)
  {
    return std::accumulate(segment.begin(), segment.end(), 0.) *
             std::accumulate(parent.begin(), parent.end(), 0.) -
           2 * std::inner_product(segment.begin(), segment.end(), parent.begin(), 0.);
  }

  // The last one of equals. The body stays.
  std::size_t least_valuable() const
  {
    std::size_t least = m_left.size() - 1;
    for (std::size_t i = m_left.size() - 1; i-- > 1;)
      if (m_values[m_left[i]] < m_values[m_left[least]])
        least = i;
    return least;
  }

  Index receiver(Index segment) const
  {
    while (m_is_joined[segment])
      segment = m_tree.parent(segment);
    return segment;
  }

  void join(std::size_t place)
  {
    m_joined.push_back(m_left[place]);
    m_is_joined[m_left[place]] = true;
    m_left.erase(m_left.begin() + static_cast<std::ptrdiff_t>(place));
  }

  const Segment_tree& m_tree;
  std::vector<double> m_values;
  std::vector<Index> m_left;
  std::vector<Index> m_joined; // in the order in which they were
  std::vector<bool> m_is_joined;
};

} // namespace CGAL::Protrusion_segmentation::internal

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_RESULT_JOINING_ORDER_H
