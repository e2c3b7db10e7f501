// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_SURFACE_DISJOINT_SETS_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_SURFACE_DISJOINT_SETS_H

#include <CGAL/Protrusion_segmentation/Indexed_surface.h>

#include <boost/pending/disjoint_sets.hpp>
#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <vector>

namespace CGAL::Protrusion_segmentation::internal {

// Boost's disjoint sets of the numbers below `n`, each alone at first. Not `disjoint_sets_with_storage`: its pointers are
// no property maps any more if Boost's compressed sparse row graph, which users may need, was included before.
class Disjoint_sets
{
public:
  using Index = Indexed_surface::Index;

  explicit Disjoint_sets(std::size_t n = 0) { reset(n); }

  void reset(std::size_t n)
  {
    m_ranks.resize(n);
    m_parents.resize(n);
    for (std::size_t i = 0; i < n; ++i)
      make_set(static_cast<Index>(i));
  }

  // `a` is alone again. None that is used afterwards may be in its set.
  void make_set(Index a) { sets().make_set(a); }
  void union_set(Index a, Index b) { sets().union_set(a, b); }
  // The same for two representatives. Returns that of both.
  Index link(Index a, Index b)
  {
    sets().link(a, b);
    return find_set(a);
  }
  // the representative of the set of `a`
  Index find_set(Index a) { return sets().find_set(a); }

private:
  template <typename Number>
  using Map = boost::iterator_property_map<typename std::vector<Number>::iterator,
                                           boost::typed_identity_property_map<std::size_t>>;
  using Rank = unsigned char; // at most the binary logarithm of `n`
  using Sets = boost::disjoint_sets<Map<Rank>, Map<Index>, boost::find_with_path_halving>;

  Sets sets() { return Sets(Map<Rank>(m_ranks.begin()), Map<Index>(m_parents.begin())); }

  std::vector<Rank> m_ranks;
  std::vector<Index> m_parents;
};

} // namespace CGAL::Protrusion_segmentation::internal

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_SURFACE_DISJOINT_SETS_H
