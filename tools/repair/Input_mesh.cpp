// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "repair/Input_mesh.h"

#include "repair/Edge_pairs.h"
#include "repair/Face_choice.h"
#include "repair/Joined_faces.h"
#include "repair/Specks.h"

#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>

#include <algorithm>
#include <array>
#include <memory>
#include <stdexcept>

namespace tool
{
namespace
{

void build_mesh(const Joined_faces& joined, Input_mesh& input)
{
  const std::vector<Polygon>& faces = joined.choice.polygons;
  std::vector<std::array<std::size_t, 3>> corners; // point, vertex, side
  for (std::size_t face = 0; face < faces.size(); ++face)
    for (std::size_t i = 0; i < faces[face].size(); ++i)
    {
      const std::size_t side = joined.pairs.first_side(face) + i;
      corners.push_back({faces[face][i], joined.fans.vertex_at(side), side});
    }
  std::sort(corners.begin(), corners.end()); // the vertices are in the order of their points in the file

  std::vector<std::size_t> number(corners.size(), Edge_pairs::none);
  std::vector<Point> points;
  for (const auto& [point, vertex, side] : corners)
    if (number[vertex] == Edge_pairs::none)
    {
      number[vertex] = points.size();
      points.push_back(input.soup.points[point]);
      input.point_of_vertex.push_back(point);
    }
  std::vector<Polygon> polygons;
  for (std::size_t face = 0; face < faces.size(); ++face)
  {
    Polygon polygon(faces[face].size());
    for (std::size_t i = 0; i < polygon.size(); ++i)
      polygon[i] = number[joined.fans.vertex_at(joined.pairs.first_side(face) + i)];
    if (joined.is_turned[face])
      std::reverse(polygon.begin() + 1, polygon.end());
    polygons.push_back(polygon);
  }
  CGAL::Polygon_mesh_processing::polygon_soup_to_polygon_mesh(points, polygons, input.mesh);
  if (input.mesh.number_of_faces() != polygons.size() || !input.mesh.is_valid(false))
    throw std::logic_error("the faces do not make up a surface mesh");
}

std::size_t number_of_components(const Edge_pairs& pairs)
{
  const std::vector<std::size_t> component = pairs.components();
  std::size_t count = 0;
  for (std::size_t face = 0; face < component.size(); ++face)
    count += component[face] == face ? 1 : 0; // it is named after one of its faces
  return count;
}

std::string counted(std::size_t count, const std::string& one, const std::string& more)
{
  return std::to_string(count) + " " + (count == 1 ? one : more);
}

} // namespace

Input_mesh make_input_mesh(Polygon_soup soup)
{
  Input_mesh input;
  input.soup = std::move(soup);
  const std::vector<std::size_t> place_of = places(input.soup.points);
  std::vector<bool> is_left_out(input.soup.polygons.size(), false);
  auto joined = std::make_unique<Joined_faces>(input.soup, place_of, is_left_out);
  Repairs& repairs = input.repairs;
  repairs.degenerate_faces = joined->choice.degenerate_faces;
  repairs.duplicate_faces = joined->choice.duplicate_faces;
  repairs.non_manifold_edges = joined->pairs.number_of_non_manifold_edges();
  repairs.specks = Specks(input.soup, place_of, *joined).leave_out(is_left_out);
  if (repairs.specks > 0) // then the rest goes together anew
    joined = std::make_unique<Joined_faces>(input.soup, place_of, is_left_out);
  repairs.reversed_faces = std::size_t(std::count(joined->is_turned.begin(), joined->is_turned.end(), true));
  repairs.components = number_of_components(joined->pairs);
  build_mesh(*joined, input);
  input.label_giver = joined->choice.label_giver;
  input.face_in_file = joined->choice.kept;
  return input;
}

std::string describe(const Repairs& repairs)
{
  std::vector<std::string> parts;
  if (repairs.degenerate_faces > 0)
    parts.push_back(counted(repairs.degenerate_faces, "degenerate face has", "degenerate faces have") +
                    " the label of a neighbour");
  if (repairs.duplicate_faces > 0)
    parts.push_back(counted(repairs.duplicate_faces, "duplicate face has", "duplicate faces have") +
                    " that of the first");
  if (repairs.non_manifold_edges > 0)
    parts.push_back(counted(repairs.non_manifold_edges, "edge is", "edges are") + " of more than two faces");
  if (repairs.reversed_faces > 0)
    parts.push_back(counted(repairs.reversed_faces, "face was", "faces were") + " turned over");
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
