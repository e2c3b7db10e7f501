// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "reading/read_segmentation.h"

#include "command_line/Error.h"

#include <CGAL/IO/SEG.h>

namespace tool
{

Segment_ids read_segmentation(const std::string& file_name, Input_mesh& input)
{
  // There is a line for each face of the file, also for those that have no place in the mesh.
  Mesh faces_of_file;
  const auto v = faces_of_file.add_vertex();
  for (std::size_t i = 0; i < input.label_giver.size(); ++i)
    faces_of_file.add_face(v, faces_of_file.add_vertex(), faces_of_file.add_vertex());
  const Segment_ids ids = faces_of_file.add_property_map<Face, std::size_t>().first;
  const std::string problem = CGAL::Protrusion_segmentation::internal::read_segments(file_name, faces_of_file,
                                                                                     ids);
  if (!problem.empty())
    throw Error(file_name, problem);
  const Segment_ids result = input.mesh.add_property_map<Face, std::size_t>().first;
  for (const Face f : faces(input.mesh))
    result[f] = ids[Face(static_cast<Mesh::size_type>(input.face_in_file[f]))];
  return result;
}

} // namespace tool
