// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROTRUSION_SEGMENTATION_PYTHON_SOURCE_PARTS_H
#define PROTRUSION_SEGMENTATION_PYTHON_SOURCE_PARTS_H

#include "mesh_of_arrays.h"

#include <CGAL/Protrusion_segmentation/Closed_segment.h>
#include <CGAL/Protrusion_segmentation/Connector.h>
#include <CGAL/Protrusion_segmentation/Connector_options.h>
#include <CGAL/Protrusion_segmentation/Segmentation_record.h>
#include <CGAL/Protrusion_segmentation/Skeleton_joint.h>

#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace python {

// What Python keeps of a segmentation: of all faces given their segments, of each segment its parent, itself for a body, and the face
// given at its tip.
struct Tree_of_arrays
{
  std::vector<std::int64_t> labels, parents, tips;
};

// The same in C++.
struct Segmented_mesh
{
  tool::Input_mesh input;
  std::vector<std::size_t> segment_of_face; // of the mesh
  CGAL::Protrusion_segmentation::Segmentation_record<tool::Mesh> record;

  auto segments() const
  {
    return boost::make_iterator_property_map(segment_of_face.begin(), get(boost::face_index, input.mesh));
  }
};

// Throws std::invalid_argument if the arrays do not fit together.
Segmented_mesh segmented_mesh(const Arrays& arrays, const Tree_of_arrays& tree);

using Part = CGAL::Protrusion_segmentation::Closed_segment<tool::Point>;
struct Connected_parts
{
  std::vector<Part> parts;
  std::vector<CGAL::Protrusion_segmentation::Connector<tool::Point>> connectors;
};
using Joint = CGAL::Protrusion_segmentation::Skeleton_joint<tool::Point>;

std::vector<Part> close_segments(const Arrays& arrays, const Tree_of_arrays& tree);
std::vector<Part> close_segments_by_faired_caps(const Arrays& arrays, const Tree_of_arrays& tree);
Connected_parts close_segments_with_connectors(
  const Arrays& arrays,
  const Tree_of_arrays& tree,
  const CGAL::Protrusion_segmentation::Connector_options& options);
std::vector<Joint> find_skeleton(const Arrays& arrays,
                                 const Tree_of_arrays& tree,
                                 int number_of_inner_joints);

} // namespace python

#endif // PROTRUSION_SEGMENTATION_PYTHON_SOURCE_PARTS_H
