// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Opens a window with the mesh, coloured by its segments. Compiled where CGAL is found with Qt.

#include <CGAL/IO/Color.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/draw_surface_mesh.h>
#include <CGAL/protrusion_segmentation.h>

#include "read_or_make_mesh.h"

#include <cmath>

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
  if (qEnvironmentVariableIsSet("CGAL_TEST_SUITE")) // as CGAL::draw() does: nobody looks
    return;
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

// protrusion_draw_example [MESH]
int main(int argc, char* argv[])
{
  Mesh mesh;
  if (!read_or_make_mesh(argc, argv, mesh))
    return EXIT_FAILURE;

  auto segments = mesh.add_property_map<Face, std::size_t>("f:segment").first;
  CGAL::segmentation_via_protrusion_tips(mesh, segments);
  draw_segments(mesh, segments);
  return EXIT_SUCCESS;
}
