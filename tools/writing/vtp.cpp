// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "writing/vtp.h"

#include "writing/formats.h"
#include "writing/palette.h"
#include "writing/shortest_digits.h"

#include <cstddef>
#include <vector>

namespace tool {
namespace {

// A cell for each face, in their order, with the segment, the old face if there is one, and the colour.
void write_cell_data(std::ostream& out, const Output& output)
{
  const std::vector<std::size_t>& segments = output.surface.segments;
  const std::vector<std::size_t>& old_faces = output.surface.old_faces;
  const std::string& name = output.options.array_name;
  out << "<CellData Scalars=\"" << name << "\">\n";
  write_data_array(out, "type=\"UInt32\" Name=\"" + name + "\"",
                   [&]()
                   {
                     for (const std::size_t segment : segments)
                       out << segment << "\n";
                   });
  if (!old_faces.empty())
    write_data_array(out, "type=\"UInt32\" Name=\"old_face\"",
                     [&]()
                     {
                       for (const std::size_t face : old_faces)
                         out << face << "\n";
                     });
  write_data_array(out, "type=\"UInt8\" Name=\"color\" NumberOfComponents=\"3\"",
                   [&]()
                   {
                     const std::vector<CGAL::IO::Color> colors = segment_colors(segments);
                     for (const std::size_t segment : segments)
                     {
                       const CGAL::IO::Color& color = colors[segment];
                       out << int(color.red()) << " " << int(color.green()) << " " << int(color.blue())
                           << "\n";
                     }
                   });
  out << "</CellData>\n";
}

void write_polygons(std::ostream& out, const Polygon_soup& soup)
{
  out << "<Points>\n";
  write_data_array(out, "type=\"Float64\" NumberOfComponents=\"3\"",
                   [&]()
                   {
                     for (const Point& point : soup.points)
                     {
                       write_shortest(out, point);
                       out << "\n";
                     }
                   });
  out << "</Points>\n<Polys>\n";
  write_data_array(out, "type=\"Int64\" Name=\"connectivity\"",
                   [&]()
                   {
                     for (const Corners& polygon : soup.polygons)
                     {
                       for (const std::size_t corner : polygon)
                         out << corner << " ";
                       out << "\n";
                     }
                   });
  write_data_array(out, "type=\"Int64\" Name=\"offsets\"",
                   [&]()
                   {
                     std::size_t end = 0;
                     for (const Corners& polygon : soup.polygons)
                       out << (end += polygon.size()) << "\n";
                   });
  out << "</Polys>\n";
}

} // namespace

void write_VTP(std::ostream& out, const Output& output)
{
  const Polygon_soup& soup = output.surface.soup;
  out << "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"0.1\">\n<PolyData>\n"
      << "<Piece NumberOfPoints=\"" << soup.points.size() << "\" NumberOfPolys=\"" << soup.polygons.size()
      << "\">\n";
  write_cell_data(out, output);
  write_polygons(out, soup);
  out << "</Piece>\n</PolyData>\n</VTKFile>\n";
}

} // namespace tool
