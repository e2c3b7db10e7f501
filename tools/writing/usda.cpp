// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// By the schemas UsdGeom and UsdShade of Universal Scene Description.

#include "writing/formats.h"

#include "writing/palette.h"
#include "writing/shortest_digits.h"

#include <cctype>
#include <cstddef>
#include <string>
#include <vector>

namespace tool {
namespace {

// Different words of ASCII letters, digits and '_', as names of prims have to be.
std::vector<std::string> identifiers(const Segmented_soup& segmented)
{
  std::vector<std::string> result = words_of_segments(segmented);
  for (std::size_t segment = 0; segment < result.size(); ++segment)
  {
    std::string& word = result[segment];
    for (char& c : word)
      if (std::isalnum(static_cast<unsigned char>(c)) == 0 || static_cast<unsigned char>(c) >= 0x80)
        c = '_';
    if (std::isdigit(static_cast<unsigned char>(word.front())) != 0)
      word.insert(0, "_");
    while (std::find(result.begin(), result.begin() + std::ptrdiff_t(segment), word) !=
           result.begin() + std::ptrdiff_t(segment))
      word += "_" + std::to_string(segment);
  }
  return result;
}

std::string in_quotes(const std::string& text)
{
  std::string result = "\"";
  for (const char c : text)
    result += c == '"' || c == '\\'                 ? std::string("\\") + c
              : static_cast<unsigned char>(c) < ' ' ? " "
                                                    : std::string(1, c);
  return result + '"';
}

template <typename Range, typename Write>
void write_list(std::ostream& out, const Range& range, const Write& write)
{
  out << "[";
  const char* separator = "";
  for (const auto& element : range)
  {
    out << separator;
    write(element);
    separator = ", ";
  }
  out << "]";
}

void write_triple(std::ostream& out, double x, double y, double z)
{
  const char* separator = "(";
  for (const double number : {x, y, z})
  {
    out << separator;
    write_shortest(out, number);
    separator = ", ";
  }
  out << ")";
}

void write_color(std::ostream& out, std::size_t segment)
{
  const CGAL::IO::Color color = segment_color(segment);
  write_triple(out, decode_sRGB(color.red()), decode_sRGB(color.green()), decode_sRGB(color.blue()));
}

void write_geometry(std::ostream& out, const Polygon_soup& soup)
{
  out << "        uniform token subdivisionScheme = \"none\"\n        point3f[] points = ";
  write_list(out, soup.points, [&](const Point& p) { write_triple(out, p.x(), p.y(), p.z()); });
  out << "\n        int[] faceVertexCounts = ";
  write_list(out, soup.polygons, [&](const Corners& polygon) { out << polygon.size(); });
  out << "\n        int[] faceVertexIndices = ";
  const char* separator = "[";
  for (const Corners& polygon : soup.polygons)
    for (const std::size_t corner : polygon)
    {
      out << separator << corner;
      separator = ", ";
    }
  out << "]\n";
}

void write_segments_of_faces(std::ostream& out, const std::vector<std::size_t>& segments)
{
  out << "        int[] primvars:segment = ";
  write_list(out, segments, [&](std::size_t segment) { out << segment; });
  out << " (\n            interpolation = \"uniform\"\n        )\n"
      << "        color3f[] primvars:displayColor = ";
  write_list(out, segments, [&](std::size_t segment) { write_color(out, segment); });
  out << " (\n            interpolation = \"uniform\"\n        )\n";
}

void write_subset(std::ostream& out,
                  const std::string& identifier,
                  const std::string& name,
                  const std::vector<std::size_t>& faces)
{
  out << "\n        def GeomSubset \"" << identifier
      << "\" (\n            prepend apiSchemas = [\"MaterialBindingAPI\"]\n            displayName = "
      << in_quotes(name) << "\n        )\n        {\n            uniform token elementType = \"face\"\n"
      << "            uniform token familyName = \"materialBind\"\n            int[] indices = ";
  write_list(out, faces, [&](std::size_t face) { out << face; });
  out << "\n            rel material:binding = </model/materials/" << identifier << ">\n        }\n";
}

void write_material(std::ostream& out, const std::string& identifier, std::size_t segment)
{
  out << "        def Material \"" << identifier
      << "\"\n        {\n            token outputs:surface.connect = </model/materials/" << identifier
      << "/shader.outputs:surface>\n\n            def Shader \"shader\"\n            {\n"
      << "                uniform token info:id = \"UsdPreviewSurface\"\n"
      << "                color3f inputs:diffuseColor = ";
  write_color(out, segment);
  out << "\n                float inputs:roughness = 0.8\n                token outputs:surface\n"
      << "            }\n        }\n";
}

} // namespace

void write_USDA(std::ostream& out, const Output& output)
{
  const Segmented_soup& segmented = output.surface;
  const std::vector<std::string> words = identifiers(segmented);
  const std::vector<std::vector<std::size_t>> faces = faces_of_segments(segmented);
  out << "#usda 1.0\n(\n    defaultPrim = \"model\"\n    upAxis = \""
      << (output.options.up == "z" ? "Z" : "Y") << "\"\n)\n\ndef Xform \"model\"\n{\n"
      << "    def Mesh \"mesh\" (\n        prepend apiSchemas = [\"MaterialBindingAPI\"]\n    )\n    {\n";
  write_geometry(out, segmented.soup);
  write_segments_of_faces(out, segmented.segments);
  out << "        uniform token subsetFamily:materialBind:familyType = \"partition\"\n";
  for (std::size_t segment = 0; segment < words.size(); ++segment)
    if (!faces[segment].empty())
      write_subset(out, words[segment], segmented.name_of(segment), faces[segment]);
  out << "    }\n\n    def Scope \"materials\"\n    {\n";
  for (std::size_t segment = 0; segment < words.size(); ++segment)
    if (!faces[segment].empty())
      write_material(out, words[segment], segment);
  out << "    }\n}\n";
}

} // namespace tool
