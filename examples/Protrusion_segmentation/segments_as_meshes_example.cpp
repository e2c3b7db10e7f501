// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Makes a mesh of its own of every segment, closed where it was cut off. Where three segments meet, their caps do not fit
// together, and volumes do not add up to the whole.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/border.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/repair.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/Face_filtered_graph.h>
#include <CGAL/boost/graph/copy_face_graph.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/centroid.h>
#include <CGAL/protrusion_segmentation.h>

#include "read_or_make_mesh.h"

#include <iterator>
#include <vector>

namespace PMP = CGAL::Polygon_mesh_processing;

using Mesh = CGAL::Surface_mesh<CGAL::Exact_predicates_inexact_constructions_kernel::Point_3>;
using Face = Mesh::Face_index;
using Segments = Mesh::Property_map<Face, std::size_t>;

// A segment may touch itself at a vertex, of which a mesh then needs two.
Mesh mesh_of_segment(const Mesh& mesh, std::size_t segment, Segments segments)
{
  Mesh part;
  CGAL::copy_face_graph(CGAL::Face_filtered_graph<Mesh>(mesh, segment, segments), part);
  PMP::duplicate_non_manifold_vertices(part);
  return part;
}

// The cap is a fan of triangles around a vertex in the middle of the hole. Of the functions of Polygon Mesh Processing,
// `triangulate_hole()` needs no further vertex, and `triangulate_refine_and_fair_hole()` makes smooth caps.
void close_hole(Mesh& part, Mesh::Halfedge_index hole)
{
  std::vector<Mesh::Point> points;
  for (const auto v : vertices_around_face(hole, part))
    points.push_back(part.point(v));
  CGAL::Euler::fill_hole(hole, part);
  const auto to_middle = CGAL::Euler::add_center_vertex(hole, part);
  part.point(target(to_middle, part)) = CGAL::centroid(points.begin(), points.end());
}

// segments_as_meshes_example [MESH]
int main(int argc, char* argv[])
{
  Mesh mesh;
  if (!read_or_make_mesh(argc, argv, mesh))
    return EXIT_FAILURE;

  const Segments segments = mesh.add_property_map<Face, std::size_t>("f:segment").first;
  const std::size_t number_of_segments = CGAL::segmentation_via_protrusion_tips(mesh, segments);
  for (std::size_t s = 0; s < number_of_segments; ++s)
  {
    Mesh part = mesh_of_segment(mesh, s, segments);
    std::vector<Mesh::Halfedge_index> holes;
    PMP::extract_boundary_cycles(part, std::back_inserter(holes));
    for (const auto hole : holes)
      close_hole(part, hole);
    std::cout << "segment " << s << ": " << part.number_of_faces() << " faces";
    PMP::triangulate_faces(part);
    if (CGAL::is_closed(part))
      std::cout << ", closed, volume " << PMP::volume(part);
    std::cout << std::endl; // CGAL::IO::write_polygon_mesh("segment_" + std::to_string(s) + ".ply", part) writes it
  }
  return EXIT_SUCCESS;
}
