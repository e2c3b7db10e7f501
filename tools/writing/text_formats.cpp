// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "writing/formats.h"

#include "writing/palette.h"
#include "writing/shortest_digits.h"

#include <array>
#include <cstddef>
#include <vector>

namespace tool {

void write_OFF(std::ostream& out, const Output& output)
{
  const Polygon_soup& soup = output.surface.soup;
  const std::vector<std::size_t>& segments = output.surface.segments;
  out << "OFF\n" << soup.points.size() << " " << soup.polygons.size() << " 0\n";
  for (const Point& point : soup.points)
  {
    write_shortest(out, point);
    out << "\n";
  }
  const std::vector<CGAL::IO::Color> colors = segment_colors(segments);
  for (std::size_t i = 0; i < soup.polygons.size(); ++i)
  {
    out << soup.polygons[i].size();
    for (const std::size_t corner : soup.polygons[i])
      out << " " << corner;
    const CGAL::IO::Color& color = colors[segments[i]];
    out << " " << int(color.red()) << " " << int(color.green()) << " " << int(color.blue()) << "\n";
  }
}

void write_OBJ(std::ostream& out, const Output& output)
{
  const Polygon_soup& soup = output.surface.soup;
  if (!output.companion.empty())
    out << "mtllib " << output.companion << "\n";
  for (const Point& point : soup.points)
  {
    out << "v ";
    write_shortest(out, point);
    out << "\n";
  }
  const std::vector<std::string> names = words_of_segments(output.surface);
  const std::vector<std::vector<std::size_t>> faces = faces_of_segments(output.surface);
  for (std::size_t segment = 0; segment < faces.size(); ++segment)
  {
    if (faces[segment].empty())
      continue;
    out << "g " << names[segment] << "\n";
    if (!output.companion.empty())
      out << "usemtl " << names[segment] << "\n";
    for (const std::size_t face : faces[segment])
    {
      out << "f";
      for (const std::size_t corner : soup.polygons[face])
        out << " " << corner + 1;
      out << "\n";
    }
  }
}

void write_MTL(std::ostream& out, const Output& output)
{
  const std::vector<std::string> names = words_of_segments(output.surface);
  for (std::size_t segment = 0; segment < names.size(); ++segment)
  {
    const CGAL::IO::Color color = segment_color(segment);
    out << "newmtl " << names[segment] << "\nKd";
    for (const unsigned char byte : {color.red(), color.green(), color.blue()})
    {
      out << ' ';
      write_shortest(out, std::round(byte / 255. * 1e4) / 1e4); // read to a byte, it is that again
    }
    out << "\nKs 0 0 0\nd 1\n";
  }
}

} // namespace tool
