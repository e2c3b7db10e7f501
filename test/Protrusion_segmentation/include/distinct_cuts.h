// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Cuts by their parts alone, without a graph.

#ifndef CGAL_TEST_PROTRUSION_SEGMENTATION_DISTINCT_CUTS_H
#define CGAL_TEST_PROTRUSION_SEGMENTATION_DISTINCT_CUTS_H

#include <CGAL/Protrusion_segmentation/internal/Cut_method/Cut/Cut.h>

#include <utility>

namespace test_meshes {

// A cut that is distinct.
inline CGAL::Protrusion_segmentation::internal::Cut
cut_of(CGAL::Protrusion_segmentation::internal::Nodes inner,
       double log_odds,
       CGAL::Protrusion_segmentation::internal::Size_of_part size)
{
  CGAL::Protrusion_segmentation::internal::Cut cut;
  cut.inner = std::move(inner);
  cut.log_odds = log_odds;
  cut.size = size;
  cut.clues.widening = 1;
  return cut;
}

} // namespace test_meshes

#endif // CGAL_TEST_PROTRUSION_SEGMENTATION_DISTINCT_CUTS_H
