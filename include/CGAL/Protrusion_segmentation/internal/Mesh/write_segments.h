// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_MESH_WRITE_SEGMENTS_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_MESH_WRITE_SEGMENTS_H

#include <CGAL/Protrusion_segmentation/Indexed_surface.h>
#include <CGAL/Protrusion_segmentation/internal/Mesh/named_parameters.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/properties.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

namespace CGAL::Protrusion_segmentation::internal {

// Throws if the type cannot hold all labels: two segments would become one.
template <typename Id>
void check_type_of_ids(const std::vector<Indexed_surface::Index>& labels)
{
  using Index = Indexed_surface::Index;
  using Limits = std::numeric_limits<Id>;
  if constexpr (Limits::is_integer && Limits::digits < std::numeric_limits<Index>::digits)
  {
    const auto largest = std::max_element(labels.begin(), labels.end());
    if (largest != labels.end() && *largest > static_cast<Index>((Limits::max)()))
      throw std::invalid_argument("segment_ids: its value type holds numbers up to " +
                                  std::to_string((Limits::max)()) + ", but there is a segment " +
                                  std::to_string(*largest));
  }
}

// Writes the segment of every face; `labels` are in the order of the mesh.
template <typename FaceGraph, typename SegmentMap>
void write_segments(const FaceGraph& mesh,
                    const std::vector<Indexed_surface::Index>& labels,
                    SegmentMap& segment_ids)
{
  using Id = typename boost::property_traits<SegmentMap>::value_type;
  check_type_of_ids<Id>(labels);
  std::size_t i = 0;
  for (const auto f : faces(mesh))
    put(segment_ids, f, static_cast<Id>(labels[i++]));
}

// Marks the edges between different segments, if the caller wants them.
template <typename FaceGraph, typename NamedParameters>
void write_borders(const FaceGraph& mesh,
                   const std::vector<Indexed_surface::Index>& labels,
                   const NamedParameters& np)
{
  if constexpr (has_edge_map<NamedParameters>)
  {
    auto borders = parameters::get_parameter(np, internal_np::edge_is_constrained);
    auto label = get(CGAL::dynamic_face_property_t<Indexed_surface::Index>(), mesh);
    write_segments(mesh, labels, label);
    const auto null_face = boost::graph_traits<FaceGraph>::null_face();
    for (const auto e : edges(mesh))
    {
      const auto f = face(halfedge(e, mesh), mesh);
      const auto g = face(opposite(halfedge(e, mesh), mesh), mesh);
      put(borders, e, f != null_face && g != null_face && get(label, f) != get(label, g));
    }
  }
}

} // namespace CGAL::Protrusion_segmentation::internal

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_MESH_WRITE_SEGMENTS_H
