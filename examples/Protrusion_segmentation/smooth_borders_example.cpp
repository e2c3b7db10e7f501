// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Moves borders to smooth lines, and tells for each line how long it is and how sure the border is: the least sure first.

#include <CGAL/Protrusion_segmentation/segment_borders.h>
#include <CGAL/Protrusion_segmentation/smooth_segment_borders.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/protrusion_segmentation.h>

#include "read_or_make_mesh.h"

#include <algorithm>
#include <functional>
#include <iterator>
#include <vector>

using Point = CGAL::Simple_cartesian<double>::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Face = Mesh::Face_index;
using Border = CGAL::Protrusion_segmentation::Segment_border<Point>;

// smooth_borders_example [MESH]
int main(int argc, char* argv[])
{
  Mesh mesh;
  if (!read_or_make_mesh(argc, argv, mesh))
    return EXIT_FAILURE;

  const auto segments = mesh.add_property_map<Face, std::size_t>("f:segment").first;
  CGAL::Protrusion_segmentation::Segmentation_record<Mesh> record;
  CGAL::segmentation_via_protrusion_tips(mesh, segments, CGAL::parameters::visitor(std::ref(record)));

  Mesh smooth; // whose property maps take the faces that are added to it
  const auto smooth_segments = smooth.add_property_map<Face, std::size_t>("f:segment").first;
  const auto old_faces = smooth.add_property_map<Face, Face>("f:old_face").first;
  CGAL::Protrusion_segmentation::smooth_segment_borders(mesh, segments, smooth, smooth_segments,
                                                        old_faces);
  std::cout << mesh.number_of_faces() << " faces become " << smooth.number_of_faces() << std::endl;

  std::vector<Border> borders;
  CGAL::Protrusion_segmentation::segment_borders(smooth, smooth_segments, std::back_inserter(borders));
  const auto value = [&](const Border& border) { return record.value(border.segments[0], border.segments[1]).value(); };
  std::sort(borders.begin(), borders.end(),
            [&](const Border& a, const Border& b) { return value(a) < value(b); });
  for (const Border& border : borders)
    std::cout << border.segments[0] << " and " << border.segments[1] << ": " << border.points.size()
              << " points, length " << border.length << ", value " << value(border) << std::endl;
  return EXIT_SUCCESS;
}
