// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "reading/read_segmentation.h"

#include "command_line/Error.h"

#include <CGAL/IO/SEG.h>

namespace tool
{

Segment_ids read_segmentation(const std::string& file_name, Mesh& mesh)
{
  const Segment_ids segment_ids = mesh.add_property_map<Face, std::size_t>().first;
  const std::string problem =
      CGAL::Protrusion_segmentation::internal::read_segments(file_name, mesh, segment_ids);
  if (!problem.empty())
    throw Error(file_name, problem);
  return segment_ids;
}

} // namespace tool
