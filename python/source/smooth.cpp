// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "smooth.h"

#include <CGAL/Protrusion_segmentation/smooth_segment_borders.h>

#include <boost/property_map/property_map.hpp>

namespace python {

Smoothed smooth(const Arrays& arrays,
                const std::vector<std::int64_t>& labels,
                unsigned int number_of_iterations)
{
  const tool::Input_mesh input = mesh_of_arrays(arrays);
  const std::vector<std::int64_t> ids = labels_of_mesh(labels, input, "labels");
  Smoothed result;
  tool::Mesh mesh;
  const auto new_ids = mesh.add_property_map<tool::Face, std::int64_t>("f:segment").first;
  const auto old_faces = mesh.add_property_map<tool::Face, tool::Face>("f:old_face").first;
  result.number_of_fixed_segments = CGAL::Protrusion_segmentation::smooth_segment_borders(
    input.mesh, boost::make_iterator_property_map(ids.begin(), get(boost::face_index, input.mesh)), mesh,
    new_ids, old_faces, CGAL::parameters::number_of_iterations(number_of_iterations));
  for (const tool::Point& p : mesh.points())
    result.coordinates.insert(result.coordinates.end(), {p.x(), p.y(), p.z()});
  for (const tool::Face face : mesh.faces())
  {
    const std::size_t begin = result.corners.size();
    for (const auto vertex : vertices_around_face(mesh.halfedge(face), mesh))
      result.corners.push_back(static_cast<std::int64_t>(vertex));
    result.sizes.push_back(static_cast<std::int64_t>(result.corners.size() - begin));
    result.labels.push_back(new_ids[face]);
    result.old_faces.push_back(static_cast<std::int64_t>(input.face_in_file[old_faces[face]]));
  }
  return result;
}

} // namespace python
