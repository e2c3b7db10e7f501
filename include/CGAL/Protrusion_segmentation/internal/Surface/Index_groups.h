// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_SURFACE_INDEX_GROUPS_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_SURFACE_INDEX_GROUPS_H

#include <CGAL/Protrusion_segmentation/Indexed_surface.h>

#include <boost/range/iterator_range.hpp>

#include <cstddef>
#include <numeric>
#include <vector>

namespace CGAL::Protrusion_segmentation::internal {

// The indices 0, 1, 2 ... of things by the number of the group that each is in, ascending in each group. Sorted
// by counting, in linear time.
class Index_groups
{
public:
  using Index = Indexed_surface::Index;

  Index_groups(const std::vector<Index>& group_of, std::size_t number_of_groups)
    : m_first(number_of_groups + 1, 0), m_indices(group_of.size())
  {
    for (Index group : group_of)
      ++m_first[group + 1];
    std::partial_sum(m_first.begin(), m_first.end(), m_first.begin());
    std::vector<Index> position(m_first.begin(), m_first.end() - 1);
    for (Index i = 0; i < group_of.size(); ++i)
      m_indices[position[group_of[i]]++] = i;
  }

  Index number_of_groups() const { return static_cast<Index>(m_first.size() - 1); }
  Index size(std::size_t group) const { return m_first[group + 1] - m_first[group]; }
  boost::iterator_range<const Index*> operator[](std::size_t group) const
  {
    return {m_indices.data() + m_first[group], m_indices.data() + m_first[group + 1]};
  }

private:
  std::vector<Index> m_first;   // of every group, and the end
  std::vector<Index> m_indices; // group by group
};

} // namespace CGAL::Protrusion_segmentation::internal

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_SURFACE_INDEX_GROUPS_H
