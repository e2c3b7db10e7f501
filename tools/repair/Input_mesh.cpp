// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "repair/Input_mesh.h"

#include "reading/Format_error.h"

#include <CGAL/Protrusion_segmentation/polygon_soup_to_manifold_mesh.h>

#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace tool
{
namespace
{

std::string counted(std::size_t count, const std::string& one, const std::string& more)
{
  return std::to_string(count) + " " + (count == 1 ? one : more);
}

auto make_mesh(const Polygon_soup& soup, Mesh& mesh)
{
  try
  {
    return CGAL::polygon_soup_to_manifold_mesh(soup.points, soup.polygons, mesh);
  }
  catch (const std::invalid_argument&) // whoever read the soup found all else, and named it in the words of the format
  {
    throw Format_error("has degenerate faces only: none has three different corners");
  }
}

} // namespace

Input_mesh make_input_mesh(Polygon_soup soup)
{
  Input_mesh input;
  input.soup = std::move(soup);
  auto result = make_mesh(input.soup, input.mesh);
  input.label_giver.assign(result.face_of_polygon.begin(), result.face_of_polygon.end());
  input.face_in_file = std::move(result.polygon_of_face);
  input.point_of_vertex = std::move(result.point_of_vertex);
  input.repairs = result.repairs;
  return input;
}

std::string describe(const Repairs& repairs)
{
  std::vector<std::string> parts;
  if (repairs.degenerate_polygons > 0)
    parts.push_back(counted(repairs.degenerate_polygons, "degenerate face has", "degenerate faces have") +
                    " the label of a neighbour");
  if (repairs.duplicate_polygons > 0)
    parts.push_back(counted(repairs.duplicate_polygons, "duplicate face has", "duplicate faces have") +
                    " that of the first");
  if (repairs.non_manifold_edges > 0)
    parts.push_back(counted(repairs.non_manifold_edges, "edge is", "edges are") + " of more than two faces");
  if (repairs.reversed_polygons > 0)
    parts.push_back(counted(repairs.reversed_polygons, "face was", "faces were") + " turned over");
  if (repairs.specks > 0)
    parts.push_back(counted(repairs.specks, "speck has", "specks have") + " the label of a neighbour");
  if (!parts.empty())
    parts.push_back(counted(repairs.components, "component is", "components are") + " left");
  std::string line;
  for (const std::string& part : parts)
    line += (line.empty() ? "" : "; ") + part;
  return line;
}

} // namespace tool
