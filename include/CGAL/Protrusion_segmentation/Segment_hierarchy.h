// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_SEGMENT_HIERARCHY_H
#define CGAL_PROTRUSION_SEGMENTATION_SEGMENT_HIERARCHY_H

#include <CGAL/Protrusion_segmentation/internal/Mesh/write_segments.h>
#include <CGAL/Protrusion_segmentation/internal/Segments/Nested_segments.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <iterator>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Protrusion_segmentation {

/*!
\ingroup PkgProtrusionSegmentationRef

The nested protrusions of a surface (Figure 1 of the paper) as a tree, and with it the segmentations for every
number of segments.

The bodies of the connected components have the first numbers, one each; that of the largest component has the number 0. The
other segments are protrusions, each of which sticks out of its parent. The
segmentation with one segment less joins the last segment to its parent, which becomes the parent of what stuck out of it.

An object of this class is made by `CGAL::protrusion_hierarchy()` and keeps no reference to the mesh.
*/
class Segment_hierarchy
{
public:
  /// \return the number of connected components of the mesh that are not small, the least number of segments
  std::size_t minimum_number_of_segments() const { return m_number_of_components; }

  /// \return the largest number of segments
  std::size_t maximum_number_of_segments() const { return m_parents.size(); }

  /// \return the segment out of which `segment` sticks, which may have a higher number; `segment` itself if it is the
  ///         body of a component
  /// \param segment below `maximum_number_of_segments()`
  /// \throw std::out_of_range if there is no such segment
  std::size_t parent(std::size_t segment) const { return m_parents.at(segment); }

  /*!
  writes the segmentation with `number_of_segments` segments, in linear time.

  \tparam FaceGraph the type of the mesh for which the hierarchy was made
  \tparam SegmentMap a model of `WritablePropertyMap` with
                     `boost::graph_traits<FaceGraph>::%face_descriptor` as key type and an integer type as
                     value type that is wide enough for the ids
  \param pmesh the mesh for which the hierarchy was made, with the same faces in the same order
  \param number_of_segments from `minimum_number_of_segments()` to `maximum_number_of_segments()`
  \param segment_ids the segment of every face, from 0 to `number_of_segments` - 1
  \throw std::invalid_argument if `number_of_segments` is out of range, `pmesh` has another number of faces, or the value
         type of `segment_ids` is too narrow
  */
  template <typename FaceGraph, typename SegmentMap>
  void segment_ids(const FaceGraph& pmesh, std::size_t number_of_segments, SegmentMap segment_ids) const
  {
    if constexpr (std::conjunction_v<internal::Check_mesh<FaceGraph>,
                                     internal::Check_segment_map<FaceGraph, SegmentMap>>)
    {
      const std::vector<Index> ancestors = ancestors_below(number_of_segments);
      const auto number_of_faces = static_cast<std::size_t>(
        std::distance(faces(pmesh).begin(), faces(pmesh).end()));
      if (number_of_faces != m_labels.size())
        throw std::invalid_argument("pmesh has " + std::to_string(number_of_faces) +
                                    " faces, but the mesh of the hierarchy has " +
                                    std::to_string(m_labels.size()));
      std::vector<Index> labels;
      labels.reserve(m_labels.size());
      for (Index label : m_labels)
        labels.push_back(ancestors[label]);
      internal::write_segments(pmesh, labels, segment_ids);
    }
  }

#ifndef DOXYGEN_RUNNING
  Segment_hierarchy() = default;
  // `labels` are in the order of the mesh
  Segment_hierarchy(const internal::Nested_segments& segments, std::vector<Indexed_surface::Index> labels)
    : m_labels(std::move(labels)),
      m_number_of_components(segments.number_of_components())
  {
    for (std::size_t s = 0; s < segments.number_of_segments(); ++s)
      m_parents.push_back(segments.parent(s));
  }
#endif

private:
  using Index = Indexed_surface::Index;

  // for every segment the nearest ancestor, or itself, with a number below `number_of_segments`
  std::vector<Index> ancestors_below(std::size_t number_of_segments) const
  {
    if (number_of_segments < minimum_number_of_segments() ||
        number_of_segments > maximum_number_of_segments())
      throw std::invalid_argument("number_of_segments is " + std::to_string(number_of_segments) +
                                  ", but the hierarchy has " +
                                  std::to_string(minimum_number_of_segments()) + " to " +
                                  std::to_string(maximum_number_of_segments()) + " segments");
    std::vector<Index> ancestors;
    for (Index s = 0; s < m_parents.size(); ++s)
    {
      Index ancestor = s;
      while (ancestor >= number_of_segments)
        ancestor = m_parents[ancestor];
      ancestors.push_back(ancestor);
    }
    return ancestors;
  }

  std::vector<Index> m_labels;  // the segment of every face, in the order of the mesh
  std::vector<Index> m_parents; // of every segment
  std::size_t m_number_of_components = 0;
};

} // namespace CGAL::Protrusion_segmentation

#endif // CGAL_PROTRUSION_SEGMENTATION_SEGMENT_HIERARCHY_H
