// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "writing/borders.h"

#include "writing/shortest_digits.h"
#include "writing/vtp.h"

#include <CGAL/Protrusion_segmentation/segment_borders.h>

#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <iterator>
#include <limits>
#include <optional>
#include <string>

namespace tool
{
namespace
{

// A value for each line; one that is not known is no number.
template <typename Value>
void write_values(std::ostream& out, const std::string& name, const std::vector<Border>& borders, const Value& value)
{
  write_data_array(out, "type=\"Float64\" Name=\"" + name + "\"", [&]() {
    for (const Border& border : borders)
    {
      const std::optional<double> x = value(border);
      write_shortest(out, x.value_or(std::numeric_limits<double>::quiet_NaN()));
      out << "\n";
    }
  });
}

void write_cell_data_of_lines(std::ostream& out, const std::vector<Border>& borders)
{
  out << "<CellData Scalars=\"value\">\n";
  for (const std::size_t i : {0, 1})
    write_data_array(out, "type=\"UInt32\" Name=\"segment_" + std::to_string(i + 1) + "\"", [&]() {
      for (const Border& border : borders)
        out << border.segments[i] << "\n";
    });
  write_values(out, "length", borders, [](const Border& border) { return border.length; });
  write_values(out, "value", borders, [](const Border& border) { return border.value; });
  write_values(out, "probability", borders, [](const Border& border) { return border.probability; });
  out << "</CellData>\n";
}

} // namespace

std::vector<Border> find_borders(const Findings& findings)
{
  const Mesh& mesh = findings.mesh_of_borders();
  std::vector<CGAL::Protrusion_segmentation::Segment_border<Point>> lines;
  CGAL::Protrusion_segmentation::segment_borders(
    mesh,
    boost::make_iterator_property_map(findings.segments_at_borders().begin(),
                                      get(boost::face_index, mesh)),
    std::back_inserter(lines));
  const Recorder& record = findings.segmentation.record;
  std::vector<Border> borders;
  for (auto& line : lines)
  {
    const auto [s, t] = line.segments;
    borders.push_back({std::move(line), record.value(s, t), record.probability(s, t)});
  }
  return borders;
}

void write_borders(std::ostream& out, const std::vector<Border>& borders)
{
  std::size_t number_of_points = 0;
  for (const Border& border : borders)
    number_of_points += border.points.size();
  out << "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"0.1\">\n<PolyData>\n"
      << "<Piece NumberOfPoints=\"" << number_of_points << "\" NumberOfLines=\"" << borders.size() << "\">\n";
  write_cell_data_of_lines(out, borders);
  out << "<Points>\n";
  write_data_array(out, "type=\"Float64\" NumberOfComponents=\"3\"", [&]() {
    for (const Border& border : borders)
      for (const Point& point : border.points)
      {
        write_shortest(out, point);
        out << "\n";
      }
  });
  out << "</Points>\n<Lines>\n";
  write_data_array(out, "type=\"Int64\" Name=\"connectivity\"", [&]() {
    std::size_t first = 0;
    for (const Border& border : borders)
    {
      for (std::size_t i = 0; i < border.points.size(); ++i)
        out << first + i << " ";
      if (border.is_closed)
        out << first;
      out << "\n";
      first += border.points.size();
    }
  });
  write_data_array(out, "type=\"Int64\" Name=\"offsets\"", [&]() {
    std::size_t end = 0;
    for (const Border& border : borders)
      out << (end += border.points.size() + (border.is_closed ? 1 : 0)) << "\n";
  });
  out << "</Lines>\n</Piece>\n</PolyData>\n</VTKFile>\n";
}

} // namespace tool
