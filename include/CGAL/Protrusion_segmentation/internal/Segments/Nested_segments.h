// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_SEGMENTS_NESTED_SEGMENTS_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_SEGMENTS_NESTED_SEGMENTS_H

#include <CGAL/Protrusion_segmentation/Indexed_surface.h>
#include <CGAL/Protrusion_segmentation/internal/Surface/connected_faces.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Protrusion_segmentation {
namespace internal {

// The segments of a surface and where each was cut from.
//
// It begins with one segment per connected component; every cut splits one segment in two, of which the
// protrusion gets the next id and the rest keeps the old one. So a segment's parent has a lower id, and the
// segmentation as it was with any smaller number of segments is found by giving the faces of the newest
// segments back to their parents, one after the other.
struct Nested_segments
{
  using Index = Indexed_surface::Index;

  std::vector<Index> labels;  // the segment of every face
  std::vector<Index> parents; // of every segment; a connected component is its own parent
  std::size_t number_of_components = 0;

  explicit Nested_segments(const Indexed_surface& surface)
  {
    labels = label_components(surface, std::vector<Index>(surface.number_of_faces(), 0)).component;
    for (Index f = 0; f < labels.size(); ++f)
      if (labels[f] == parents.size())
        parents.push_back(labels[f]);
    number_of_components = parents.size();
  }

  std::size_t number_of_segments() const { return parents.size(); }

  Index add_segment(Index parent)
  {
    parents.push_back(parent);
    return static_cast<Index>(parents.size() - 1);
  }

  std::vector<Index> faces_of(Index segment) const
  {
    std::vector<Index> faces;
    for (Index f = 0; f < labels.size(); ++f)
      if (labels[f] == segment)
        faces.push_back(f);
    return faces;
  }
};

} // namespace internal
} // namespace Protrusion_segmentation
} // namespace CGAL

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_SEGMENTS_NESTED_SEGMENTS_H
