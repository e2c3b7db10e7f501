// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_SURFACE_DISJOINT_SETS_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_SURFACE_DISJOINT_SETS_H

#include <boost/pending/disjoint_sets.hpp>
#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Protrusion_segmentation {
namespace internal {

// Boost's disjoint sets of the numbers below `n`, each alone at first. Not `disjoint_sets_with_storage`: its pointers are
// no property maps any more if Boost's compressed sparse row graph, which users may need, was included before.
class Disjoint_sets
{
public:
  explicit Disjoint_sets(std::size_t n) : m_ranks(n), m_parents(n), m_sets(map_of(m_ranks), map_of(m_parents))
  {
    for (std::size_t i = 0; i < n; ++i)
      m_sets.make_set(i);
  }
  Disjoint_sets(const Disjoint_sets&) = delete;
  Disjoint_sets& operator=(const Disjoint_sets&) = delete;

  void union_set(std::size_t a, std::size_t b) { m_sets.union_set(a, b); }
  // the number that stands for the set of `a`
  std::size_t find_set(std::size_t a) { return m_sets.find_set(a); }

private:
  using Numbers = std::vector<std::size_t>;
  using Map = boost::iterator_property_map<Numbers::iterator, boost::typed_identity_property_map<std::size_t>>;

  static Map map_of(Numbers& numbers) { return Map(numbers.begin()); }

  Numbers m_ranks, m_parents;
  boost::disjoint_sets<Map, Map> m_sets;
};

} // namespace internal
} // namespace Protrusion_segmentation
} // namespace CGAL

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_SURFACE_DISJOINT_SETS_H
