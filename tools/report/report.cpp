// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "report/report.h"

#include "report/base64.h"
#include "report_page.h"
#include "writing/json.h"
#include "writing/palette.h"
#include "writing/triangles.h"
#include "writing/unit_ball.h"

#include <nlohmann/json.hpp>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace tool
{
namespace
{

using Json = nlohmann::ordered_json;

std::uint32_t index(std::size_t i) { return static_cast<std::uint32_t>(i); }

// Two vertices and two segments for each edge between segments.
std::vector<std::uint32_t> borders(const Mesh& mesh, const std::vector<std::size_t>& segment_ids)
{
  std::vector<std::uint32_t> result;
  for (const auto e : edges(mesh))
  {
    const auto h = halfedge(e, mesh);
    if (is_border(e, mesh))
      continue;
    const std::size_t here = segment_ids[face(h, mesh)];
    const std::size_t there = segment_ids[face(opposite(h, mesh), mesh)];
    if (here != there)
      result.insert(result.end(), {index(source(h, mesh)), index(target(h, mesh)), index(here),
                                   index(there)});
  }
  return result;
}

Json describe_mesh(const Mesh& mesh, const std::vector<std::size_t>& segment_ids)
{
  std::vector<std::uint32_t> triangles, face_of_triangle, segments;
  for (const Face f : faces(mesh))
  {
    segments.push_back(index(segment_ids[f]));
    for_each_triangle(mesh, f, [&](auto a, auto b, auto c) {
      triangles.insert(triangles.end(), {index(a), index(b), index(c)});
      face_of_triangle.push_back(index(f));
    });
  }
  return {{"positions", base64(positions_in_unit_ball(mesh, bounding_ball(mesh)))},
          {"triangles", base64(triangles)},
          {"faces", base64(face_of_triangle)},
          {"segments", base64(segments)},
          {"borders", base64(borders(mesh, segment_ids))}};
}

Json colors(std::size_t number_of_segments)
{
  Json result = Json::array();
  for (std::size_t s = 0; s < number_of_segments; ++s)
  {
    const CGAL::IO::Color color = segment_color(s);
    result.push_back({color.red(), color.green(), color.blue()});
  }
  return result;
}

// No text in a page may look like the end of a script.
std::string without_tags(std::string json)
{
  for (std::size_t i = json.find('<'); i != std::string::npos; i = json.find('<', i))
    json.replace(i, 1, "\\u003c");
  return json;
}

template <std::size_t n>
void write(std::ostream& out, const char* const (&pieces)[n])
{
  for (const char* piece : pieces)
    out << piece;
}

} // namespace

bool can_write_report() { return true; }

void write_report(std::ostream& out, const Mesh& mesh, const Findings& findings)
{
  Json record = describe(findings);
  record["colors"] = colors(findings.segmentation.number_of_segments);
  record["mesh"] = describe_mesh(mesh, findings.segmentation.segment_ids);
  write(out, report_page_begin);
  out << without_tags(record.dump(-1, ' ', false, Json::error_handler_t::replace));
  write(out, report_page_end);
}

} // namespace tool
