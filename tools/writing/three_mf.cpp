// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// By the 3MF Core Specification 1.3 (triangle sets are its section 4.1.5), as XML in an archive: lib3mf 1.8, which reads it here,
// knows neither triangle sets nor the attributes of slicers.

#include "writing/formats.h"

#include "writing/Zip_archive.h"
#include "writing/escaped.h"
#include "writing/palette.h"
#include "writing/shortest_digits.h"
#include "writing/triangles.h"

#include <array>
#include <cstddef>
#include <iomanip>
#include <sstream>
#include <string>
#include <vector>

namespace tool {
namespace {

const char* const content_types =
  R"(<?xml version="1.0" encoding="UTF-8"?>
<Types xmlns="http://schemas.openxmlformats.org/package/2006/content-types">
<Default Extension="rels" ContentType="application/vnd.openxmlformats-package.relationships+xml"/>
<Default Extension="model" ContentType="application/vnd.ms-package.3dmanufacturing-3dmodel+xml"/>
</Types>
)";
const char* const relationships =
  R"(<?xml version="1.0" encoding="UTF-8"?>
<Relationships xmlns="http://schemas.openxmlformats.org/package/2006/relationships">
<Relationship Target="/3D/3dmodel.model" Id="rel0" Type="http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"/>
</Relationships>
)";
const char* const begin_of_model =
  R"(<?xml version="1.0" encoding="UTF-8"?>
<model unit="millimeter" xml:lang="en-US" xmlns="http://schemas.microsoft.com/3dmanufacturing/core/2015/02" xmlns:t="http://schemas.microsoft.com/3dmanufacturing/trianglesets/2021/07" xmlns:slic3rpe="http://schemas.slic3r.org/3mf/2017/06">
<metadata name="Application">segment_by_protrusions</metadata>
<resources>
)";

constexpr std::size_t id_of_materials = 1;

// How slicers write that a whole triangle is painted with a filament, from 1. They know 16 of them; further segments get the
// first ones again.
std::string painting(std::size_t segment)
{
  constexpr std::size_t number_of_filaments = 16;
  const std::size_t filament = segment % number_of_filaments + 1;
  if (filament <= 2)
    return filament == 1 ? "4" : "8";
  return std::string(1, "0123456789ABCD"[filament - 3]) + "C";
}

void write_materials(std::ostream& out, const std::vector<std::string>& names)
{
  out << "<basematerials id=\"" << id_of_materials << "\">\n";
  for (std::size_t segment = 0; segment < names.size(); ++segment)
  {
    const CGAL::IO::Color color = segment_color(segment);
    out << "<base name=\"" << escaped_in_XML(names[segment]) << "\" displaycolor=\"#" << std::hex
        << std::uppercase << std::setfill('0');
    for (const unsigned char byte : {color.red(), color.green(), color.blue()})
      out << std::setw(2) << int(byte);
    out << std::dec << "\"/>\n";
  }
  out << "</basematerials>\n";
}

void write_vertices(std::ostream& out, const Polygon_soup& soup)
{
  out << "<vertices>\n";
  for (const Point& point : soup.points)
  {
    const char* separator = "<vertex x=\"";
    for (int c = 0; c < 3; ++c)
    {
      out << separator;
      write_shortest(out, point[c]);
      separator = c == 0 ? "\" y=\"" : "\" z=\"";
    }
    out << "\"/>\n";
  }
  out << "</vertices>\n";
}

// The format has no triangles of less than three vertices.
template <typename Add>
void for_each_proper_triangle(const Corners& polygon, const Add& add)
{
  for_each_triangle(polygon,
                    [&](auto a, auto b, auto c)
                    {
                      if (a != b && b != c && c != a)
                        add(a, b, c);
                    });
}

// `attributes(i)` are those of the triangles of face i.
template <typename Attributes>
void write_triangles(std::ostream& out, const Polygon_soup& soup, const Attributes& attributes)
{
  out << "<triangles>\n";
  for (std::size_t i = 0; i < soup.polygons.size(); ++i)
    for_each_proper_triangle(soup.polygons[i],
                             [&](auto a, auto b, auto c)
                             {
                               out << "<triangle v1=\"" << a << "\" v2=\"" << b << "\" v3=\"" << c << '"'
                                   << attributes(i) << "/>\n";
                             });
  out << "</triangles>\n";
}

// The first and the last triangle of each run of a segment.
using Ranges = std::vector<std::array<std::size_t, 2>>;
std::vector<Ranges> ranges_of_segments(const Segmented_soup& segmented)
{
  std::vector<Ranges> result(end_of_segments(segmented));
  std::size_t next = 0;
  for (std::size_t i = 0; i < segmented.segments.size(); ++i)
    for_each_proper_triangle(segmented.soup.polygons[i],
                             [&](auto, auto, auto)
                             {
                               Ranges& ranges = result[segmented.segments[i]];
                               if (ranges.empty() || ranges.back()[1] + 1 != next)
                                 ranges.push_back({next, next});
                               ranges.back()[1] = next++;
                             });
  return result;
}

void write_triangle_sets(std::ostream& out,
                         const Segmented_soup& segmented,
                         const std::vector<std::string>& words)
{
  out << "<t:trianglesets>\n";
  const std::vector<Ranges> ranges = ranges_of_segments(segmented);
  for (std::size_t segment = 0; segment < ranges.size(); ++segment)
  {
    if (ranges[segment].empty())
      continue;
    out << "<t:triangleset name=\"" << escaped_in_XML(segmented.name_of(segment)) << "\" identifier=\""
        << escaped_in_XML(words[segment]) << "\">\n";
    for (const auto& [first, last] : ranges[segment])
      out << "<t:refrange startindex=\"" << first << "\" endindex=\"" << last << "\"/>\n";
    out << "</t:triangleset>\n";
  }
  out << "</t:trianglesets>\n";
}

std::vector<std::string> names_of_segments(const Segmented_soup& segmented, std::size_t number)
{
  std::vector<std::string> result;
  for (std::size_t segment = 0; segment < number; ++segment)
    result.push_back(segmented.name_of(segment));
  return result;
}

void begin_object(std::ostream& out, std::size_t id, std::size_t segment, const std::string& name)
{
  out << "<object id=\"" << id << "\" type=\"model\" name=\"" << escaped_in_XML(name) << "\" pid=\""
      << id_of_materials << "\" pindex=\"" << segment << "\">\n<mesh>\n";
}

void write_archive(std::ostream& out, const std::string& resources, std::size_t id_of_object)
{
  Zip_archive archive(out);
  archive.add("[Content_Types].xml", content_types);
  archive.add("_rels/.rels", relationships);
  archive.add("3D/3dmodel.model", begin_of_model + resources +
                                    "</resources>\n<build>\n<item objectid=\"" +
                                    std::to_string(id_of_object) + "\"/>\n</build>\n</model>\n");
  archive.finish();
}

} // namespace

void write_3MF(std::ostream& out, const Output& output)
{
  constexpr std::size_t id_of_object = id_of_materials + 1;
  const Segmented_soup& segmented = output.surface;
  std::ostringstream resources;
  const std::size_t number = end_of_segments(segmented);
  write_materials(resources, names_of_segments(segmented, number));
  begin_object(resources, id_of_object, 0, "mesh");
  write_vertices(resources, segmented.soup);
  std::vector<std::string> attributes;
  for (std::size_t segment = 0; segment < number; ++segment)
    attributes.push_back(" pid=\"" + std::to_string(id_of_materials) + "\" p1=\"" +
                         std::to_string(segment) + "\" paint_color=\"" + painting(segment) +
                         "\" slic3rpe:mmu_segmentation=\"" + painting(segment) + "\"");
  write_triangles(resources, segmented.soup,
                  [&](std::size_t face) { return attributes[segmented.segments[face]]; });
  write_triangle_sets(resources, segmented, words_of_segments(segmented));
  resources << "</mesh>\n</object>\n";
  write_archive(out, resources.str(), id_of_object);
}

void write_parts_in_3MF(std::ostream& out, const std::vector<Segmented_soup>& parts)
{
  const std::size_t first_id = id_of_materials + 1, id_of_whole = first_id + parts.size();
  std::ostringstream resources;
  write_materials(resources, names_of_segments(parts.front(), parts.size()));
  for (std::size_t segment = 0; segment < parts.size(); ++segment)
  {
    begin_object(resources, first_id + segment, segment, parts[segment].name_of(segment));
    write_vertices(resources, parts[segment].soup);
    write_triangles(resources, parts[segment].soup, [](std::size_t) { return ""; });
    resources << "</mesh>\n</object>\n";
  }
  resources << "<object id=\"" << id_of_whole << "\" type=\"model\" name=\"mesh\">\n<components>\n";
  for (std::size_t segment = 0; segment < parts.size(); ++segment)
    resources << "<component objectid=\"" << first_id + segment << "\"/>\n";
  resources << "</components>\n</object>\n";
  write_archive(out, resources.str(), id_of_whole);
}

} // namespace tool
