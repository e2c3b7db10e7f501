// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Segments polygons that do not make up a mesh, and tells how many of them each segment has. Every polygon gets a label.

#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/Protrusion_segmentation/polygon_soup_to_manifold_mesh.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/protrusion_segmentation.h>

#include "read_or_make_mesh.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <vector>

using Point = CGAL::Simple_cartesian<double>::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Points = std::vector<Point>;
using Polygons = std::vector<std::vector<std::size_t>>;

// Every face of a mesh with points of its own, some turned over, and some twice.
void take_apart(const Mesh& mesh, Points& points, Polygons& polygons)
{
  for (const Mesh::Face_index f : faces(mesh))
  {
    std::vector<std::size_t> polygon;
    for (const Mesh::Vertex_index v : vertices_around_face(mesh.halfedge(f), mesh))
    {
      polygon.push_back(points.size());
      points.push_back(mesh.point(v));
    }
    if (f % 7 == 0)
      std::reverse(polygon.begin(), polygon.end());
    polygons.push_back(polygon);
    if (f % 50 == 0)
      polygons.push_back(polygon);
  }
}

// segmentation_of_polygon_soup_example [FILE]
int main(int argc, char* argv[])
{
  Points points;
  Polygons polygons;
  Mesh whole;
  if (argc > 1)
  {
    if (!CGAL::IO::read_polygon_soup(argv[1], points, polygons))
    {
      std::cerr << argv[1] << " is no polygon soup that can be read" << std::endl;
      return EXIT_FAILURE;
    }
  }
  else
  {
    if (!read_or_make_mesh(argc, argv, whole))
      return EXIT_FAILURE;
    take_apart(whole, points, polygons);
  }

  Mesh mesh;
  const auto found = CGAL::Protrusion_segmentation::polygon_soup_to_manifold_mesh(points, polygons, mesh);
  std::cout << polygons.size() << " polygons: " << found.repairs.duplicate_polygons << " duplicates, "
            << found.repairs.reversed_polygons << " turned over; " << found.repairs.components << " component(s)"
            << std::endl;

  const auto segments = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:segment").first;
  CGAL::segmentation_via_protrusion_tips(mesh, segments);

  std::vector<std::size_t> labels; // of the polygons, in their order
  found.labels_of_polygons(segments, std::back_inserter(labels));
  std::map<std::size_t, std::size_t> polygons_of_segment;
  for (const std::size_t label : labels)
    ++polygons_of_segment[label];
  for (const auto& [segment, number] : polygons_of_segment)
    std::cout << "segment " << segment << ": " << number << " polygons" << std::endl;
  return EXIT_SUCCESS;
}
