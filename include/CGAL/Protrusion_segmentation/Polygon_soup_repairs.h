// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_POLYGON_SOUP_REPAIRS_H
#define CGAL_PROTRUSION_SEGMENTATION_POLYGON_SOUP_REPAIRS_H

#include <cstddef>

namespace CGAL::Protrusion_segmentation {

/*!
\ingroup PkgProtrusionSegmentationRef

What `polygon_soup_to_manifold_mesh()` had to do so that polygons make up a surface.
*/
struct Polygon_soup_repairs
{
  /// polygons with fewer than three different corners, left out
  std::size_t degenerate_polygons = 0;
  /// polygons with the same corners as another one of the same surface, in the same or in reverse order, left out
  std::size_t duplicate_polygons = 0;
  /// edges of more than two polygons, duplicates not counted
  std::size_t non_manifold_edges = 0;
  /// edges of two polygons that were left apart, since no orientation of the surface fits both: a Moebius strip is cut
  /// open there
  std::size_t unorientable_edges = 0;
  /// polygons that were turned over to be oriented as their neighbors are
  std::size_t reversed_polygons = 0;
  /// small components, and single walls between two solids, that touch the rest, left out with all their polygons
  std::size_t small_components = 0;
  /// corners on borders that were not at the same place, but nearer than the tolerance, and became one with another one
  std::size_t joined_corners = 0;
  /// corners on borders that were set into an edge that they lie on: the polygon of the edge has a corner more
  std::size_t split_edges = 0;
  /// connected components of the mesh; no repair
  std::size_t components = 0;

  /// tells whether nothing had to be repaired.
  /// \return whether every polygon became a face as it is, joined to all that it shares edges with, and no edge has more
  ///         than two polygons
  bool is_nothing() const
  {
    return degenerate_polygons + duplicate_polygons + non_manifold_edges + unorientable_edges +
             reversed_polygons + small_components + joined_corners + split_edges ==
           0;
  }
};

} // namespace CGAL::Protrusion_segmentation

#endif // CGAL_PROTRUSION_SEGMENTATION_POLYGON_SOUP_REPAIRS_H
