// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "report/report_data.h"

#include "report/base64.h"
#include "writing/json.h"
#include "writing/palette.h"
#include "writing/triangles.h"
#include "writing/unit_ball.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace tool {
namespace {

using Json = nlohmann::ordered_json;

std::uint32_t index(std::size_t i)
{
  return static_cast<std::uint32_t>(i);
}

// Whole numbers as bytes, as few for each as the largest one needs.
Json pack(const std::vector<std::uint32_t>& numbers, std::size_t number_of_bytes)
{
  if (number_of_bytes == 1)
    return base64(std::vector<std::uint8_t>(numbers.begin(), numbers.end()));
  if (number_of_bytes == 2)
    return base64(std::vector<std::uint16_t>(numbers.begin(), numbers.end()));
  return base64(numbers);
}

std::size_t bytes_for(std::size_t number_of_values)
{
  return number_of_values <= 0x100 ? 1 : number_of_values <= 0x10000 ? 2 : 4;
}

// Coordinates from -1 to 1 as whole numbers of 16 bits: finer than what a screen shows.
std::vector<std::uint16_t> to_16_bits(const std::vector<float>& coordinates)
{
  std::vector<std::uint16_t> result;
  result.reserve(coordinates.size());
  for (const float x : coordinates)
    result.push_back(static_cast<std::uint16_t>(std::lround((std::clamp(x, -1.f, 1.f) + 1) * 32767.5f)));
  return result;
}

// Two points and two segments for each edge between segments.
std::vector<std::uint32_t> borders(const Findings& findings)
{
  const Mesh& mesh = findings.mesh.mesh;
  const std::vector<std::size_t>& segment_ids = findings.segmentation.segment_ids;
  const auto point = [&](auto vertex) { return index(findings.mesh.point_of_vertex[vertex]); };
  std::vector<std::uint32_t> result;
  for (const auto e : edges(mesh))
  {
    const auto h = halfedge(e, mesh);
    if (is_border(e, mesh))
      continue;
    const std::size_t here = segment_ids[face(h, mesh)];
    const std::size_t there = segment_ids[face(opposite(h, mesh), mesh)];
    if (here != there)
      result.insert(result.end(),
                    {point(source(h, mesh)), point(target(h, mesh)), index(here), index(there)});
  }
  return result;
}

Json describe_mesh(const Findings& findings)
{
  const Polygon_soup& soup = findings.mesh.soup;
  std::vector<std::uint32_t> triangles, face_of_triangle, segments;
  for (const std::size_t segment : labels_of_file(findings.segmentation.segment_ids, findings.mesh))
    segments.push_back(index(segment));
  for (std::size_t face = 0; face < soup.polygons.size(); ++face)
    for_each_triangle(soup.polygons[face],
                      [&](auto a, auto b, auto c)
                      {
                        triangles.insert(triangles.end(), {index(a), index(b), index(c)});
                        face_of_triangle.push_back(index(face));
                      });
  const bool are_faces_triangles = std::all_of(soup.polygons.begin(), soup.polygons.end(),
                                               [](const Corners& p) { return p.size() == 3; });
  const std::size_t index_bytes = bytes_for(soup.points.size());
  const std::size_t segment_bytes = bytes_for(findings.segmentation.number_of_segments);
  const Ball ball = bounding_ball(soup.points);
  return {{"center", ball.center},
          {"radius", ball.radius},
          {"positions", base64(to_16_bits(positions_in_unit_ball(soup.points, ball)))},
          {"index_bytes", index_bytes},
          {"triangles", pack(triangles, index_bytes)},
          {"faces", are_faces_triangles ? Json(nullptr) : Json(base64(face_of_triangle))},
          {"segment_bytes", segment_bytes},
          {"segments", pack(segments, segment_bytes)},
          {"borders", base64(borders(findings))}};
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

} // namespace

std::string report_data(const Findings& findings)
{
  Json record = describe(findings);
  record.erase("borders"); // they are those of the mesh below
  record["colors"] = colors(findings.segmentation.number_of_segments);
  record["mesh"] = describe_mesh(findings);
  return record.dump(-1, ' ', false, Json::error_handler_t::replace);
}

} // namespace tool
