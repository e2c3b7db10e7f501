// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_REPAIR_PARITY_SETS_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_REPAIR_PARITY_SETS_H

#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL::Protrusion_segmentation::internal {

// Disjoint sets of elements each of which is, or is not, turned over against the representative of its set.
class Parity_sets
{
public:
  explicit Parity_sets(std::size_t size) : m_parent(size), m_size(size, 1), m_is_turned(size, false)
  {
    std::iota(m_parent.begin(), m_parent.end(), std::size_t(0));
  }

  // The set of an element, and whether the element is turned over.
  std::pair<std::size_t, bool> find(std::size_t element)
  {
    std::size_t root = element;
    bool is_turned = false; // `element` against `root`
    for (; m_parent[root] != root; root = m_parent[root])
      is_turned = is_turned != m_is_turned[root];
    const std::pair<std::size_t, bool> result = {root, is_turned};
    while (m_parent[element] != root && element != root)
    {
      const bool next_is_turned = is_turned != m_is_turned[element];
      m_is_turned[element] = is_turned;
      is_turned = next_is_turned;
      element = std::exchange(m_parent[element], root);
    }
    return result;
  }

  // Sets `a` turned over against `b` or, if `is_turned` is false, not. Returns whether that fits; if not, nothing changes.
  bool unite(std::size_t a, std::size_t b, bool is_turned)
  {
    auto [root_a, a_is_turned] = find(a);
    auto [root_b, b_is_turned] = find(b);
    if (root_a == root_b)
      return (a_is_turned != b_is_turned) == is_turned;
    if (m_size[root_a] < m_size[root_b])
      std::swap(root_a, root_b);
    m_parent[root_b] = root_a;
    m_size[root_a] += m_size[root_b];
    m_is_turned[root_b] = (a_is_turned != b_is_turned) != is_turned;
    return true;
  }

private:
  std::vector<std::size_t> m_parent;
  std::vector<std::size_t> m_size;
  std::vector<bool> m_is_turned; // against the parent
};

} // namespace CGAL::Protrusion_segmentation::internal

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_REPAIR_PARITY_SETS_H
