// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_SEGMENTS_SEGMENT_TREE_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_SEGMENTS_SEGMENT_TREE_H

#include <CGAL/Protrusion_segmentation/Indexed_surface.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <map>
#include <numeric>
#include <queue>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL::Protrusion_segmentation::internal {

// What sticks out of what, among the segments of a connected surface: the shortest paths from the body to all others.
//
// A step between two neighbours has length 1 if their border is the longest one of either; it is longer over a shorter border.
// So arms that touch each other stick out of the body that they touch, unless their borders with it are only short.
//
// The body is the segment from which the area is nearest. So what lies beyond a border, a protrusion with all that sticks out of
// it, never has more than half of the area: else the area would be nearer from there.
class Segment_tree
{
public:
  using Index = Indexed_surface::Index;
  using Lengths = std::map<std::pair<Index, Index>, double>; // of all borders, the lower segment first

  // `areas`: of every segment
  Segment_tree(const std::vector<double>& areas, const Lengths& lengths) : m_steps(areas.size())
  {
    find_steps(lengths);
    double least = std::numeric_limits<double>::infinity();
    for (Index s = 0; s < areas.size(); ++s)
    {
      const Paths paths = paths_from(s);
      const double sum = std::inner_product(areas.begin(), areas.end(), paths.distances.begin(), 0.);
      if (sum < least * (1 - rounding))
      {
        least = sum;
        m_body = s;
      }
    }
    const Paths paths = paths_from(m_body);
    m_parents = paths.parents;
    m_areas = areas;
    for (std::size_t i = paths.order.size(); i-- > 1;)
      m_areas[m_parents[paths.order[i]]] += m_areas[paths.order[i]];
  }

  Index body() const { return m_body; }
  // the segment that a segment sticks out of; the body is its own
  Index parent(Index segment) const { return m_parents[segment]; }
  // of a segment with all that sticks out of it
  double area_beyond(Index segment) const { return m_areas[segment]; }

private:
  static constexpr double rounding = 1e-9; // sums that differ by less are equal

  struct Step
  {
    Index target;
    double length;
  };

  struct Paths
  {
    std::vector<double> distances;
    std::vector<Index> parents;
    std::vector<Index> order; // the nearest first
  };

  // The length of a step is the root of how many times shorter the border is than the longest one: where a border is more than
  // four times shorter, two steps lead around it.
  void find_steps(const Lengths& lengths)
  {
    std::vector<double> longest(m_steps.size(), 0);
    for (const auto& [border, length] : lengths)
      for (Index s : {border.first, border.second})
        longest[s] = (std::max)(longest[s], length);
    for (const auto& [border, length] : lengths)
    {
      const auto [s, t] = border;
      const double step = std::sqrt((std::min)(longest[s], longest[t]) /
                                    (std::max)(length, (std::numeric_limits<double>::min)()));
      m_steps[s].push_back({t, step});
      m_steps[t].push_back({s, step});
    }
  }

  Paths paths_from(Index body) const
  {
    Paths result;
    result.distances.assign(m_steps.size(), std::numeric_limits<double>::infinity());
    result.parents.resize(m_steps.size());
    using Offer = std::tuple<double, Index, Index>; // distance, segment, parent
    std::priority_queue<Offer, std::vector<Offer>, std::greater<>> offers;
    offers.emplace(0, body, body);
    while (!offers.empty())
    {
      const auto [distance, s, parent] = offers.top();
      offers.pop();
      if (result.distances[s] <= distance)
        continue;
      result.distances[s] = distance;
      result.parents[s] = parent;
      result.order.push_back(s);
      for (const Step& step : m_steps[s])
        offers.emplace(distance + step.length, step.target, s);
    }
    CGAL_assertion(result.order.size() == m_steps.size()); // the surface is connected
    return result;
  }

  std::vector<std::vector<Step>> m_steps; // of every segment
  Index m_body = 0;
  std::vector<Index> m_parents;
  std::vector<double> m_areas; // beyond the border to the parent
};

} // namespace CGAL::Protrusion_segmentation::internal

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_SEGMENTS_SEGMENT_TREE_H
