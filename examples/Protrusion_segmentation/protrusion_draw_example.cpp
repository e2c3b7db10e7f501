// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// protrusion_draw_example MESH [NUMBER_OF_SEGMENTS]
//
// Opens a window with the mesh, coloured by its segments. Compiled where CGAL is found with Qt.

#include <CGAL/IO/Color.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/draw_surface_mesh.h>
#include <CGAL/protrusion_segmentation.h>

#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <string>

using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
using Vertex = Mesh::Vertex_index;
using Edge = Mesh::Edge_index;
using Face = Mesh::Face_index;
using Segment_map = Mesh::Property_map<Face, std::size_t>;

// Colours of segments with near numbers lie far apart on the wheel of hues.
CGAL::IO::Color segment_color(std::size_t segment)
{
  CGAL::IO::Color color;
  return color.set_hsv(std::fmod(137.5 * static_cast<double>(segment), 360.), 60, 90);
}

#if __has_include(<CGAL/Graphics_scene_options.h>) // CGAL 6
void draw_segments(const Mesh& mesh, const Segment_map& segments)
{
  CGAL::Graphics_scene_options<Mesh, Vertex, Edge, Face> options;
  options.disable_edges();
  options.colored_face = [](const Mesh&, Face) { return true; };
  options.face_color = [&](const Mesh&, Face f) { return segment_color(segments[f]); };
  CGAL::draw(mesh, options, "Segments");
}
#else // CGAL::draw() of CGAL 5 takes no colours, but the window that it opens does.
void draw_segments(const Mesh& mesh, const Segment_map& segments)
{
  CGAL::Qt::init_ogl_context(4, 3);
  char name[] = "protrusion_draw_example";
  char* arguments[] = {name, nullptr};
  int number_of_arguments = 1;
  QApplication application(number_of_arguments, arguments);
  CGAL::SimpleFaceGraphViewerQt window(nullptr, mesh, "Segments", false,
                                       [&](const Mesh&, Face f)
                                       { return segment_color(segments[f]); });
  window.set_use_mono_color(false);
  window.set_draw_edges(false);
  window.show();
  application.exec();
}
#endif

int main(int argc, char* argv[])
{
  Mesh mesh;
  if ((argc != 2 && argc != 3) || !CGAL::IO::read_polygon_mesh(argv[1], mesh))
  {
    std::cerr << "protrusion_draw_example: needs the file of a mesh" << std::endl;
    return EXIT_FAILURE;
  }

  try
  {
    auto segments = mesh.add_property_map<Face, std::size_t>("f:segment").first;
    if (argc == 2)
      CGAL::segmentation_via_protrusion_tips(mesh, segments);
    else
      CGAL::segmentation_via_protrusion_tips(mesh, segments, std::stoul(argv[2]));
    draw_segments(mesh, segments);
    return EXIT_SUCCESS;
  }
  catch (const std::exception& error)
  {
    std::cerr << "protrusion_draw_example: " << error.what() << std::endl;
    return EXIT_FAILURE;
  }
}
