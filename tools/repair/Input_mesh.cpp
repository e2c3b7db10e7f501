// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "repair/Input_mesh.h"

#include "repair/Edge_pairs.h"
#include "repair/Face_choice.h"
#include "repair/Parity_sets.h"
#include "repair/area_vector.h"

#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numeric>
#include <stdexcept>

namespace tool
{
namespace
{

// A component with less of the whole area is tiny.
constexpr double share_of_speck = .001;

// The corners of faces that become one vertex: those that meet where sides are joined. A vertex so has one fan of
// faces around it, whatever the file says.
class Vertices
{
public:
  Vertices(Edge_pairs& pairs, const std::vector<bool>& is_turned) : m_pairs(pairs), m_is_turned(is_turned)
  {
    do
      unite_corners();
    while (part_conflicts());
  }

  std::size_t vertex_at(std::size_t side) const { return m_vertex[side]; } // where the side starts in the file

private:
  void unite_corners()
  {
    Parity_sets sets(m_pairs.number_of_sides());
    for (std::size_t side = 0; side < m_pairs.number_of_sides(); ++side)
      if (const std::size_t other = m_pairs.partner(side); other != Edge_pairs::none && side < other)
      {
        const bool is_parallel = m_pairs.are_parallel(side, other);
        sets.unite(side, is_parallel ? other : m_pairs.next(other), false);
        sets.unite(m_pairs.next(side), is_parallel ? m_pairs.next(other) : other, false);
      }
    m_vertex.resize(m_pairs.number_of_sides());
    for (std::size_t side = 0; side < m_vertex.size(); ++side)
      m_vertex[side] = sets.find(side).first;
  }

  // No mesh has a face with a vertex twice, or two faces on the same side of an edge. Where it comes to that, one
  // corner is taken out of its fan.
  bool part_conflicts()
  {
    std::vector<std::size_t> corners = corners_in_conflict();
    for (const std::size_t side : corners)
    {
      m_pairs.part(side);
      m_pairs.part(m_pairs.previous(side));
    }
    return !corners.empty();
  }

  std::vector<std::size_t> corners_in_conflict() const
  {
    // What may be there once only: a face with a vertex, and an edge with a direction.
    std::vector<std::array<std::size_t, 3>> corners, edges;
    for (std::size_t side = 0; side < m_vertex.size(); ++side)
    {
      const std::size_t from = m_vertex[side], to = m_vertex[m_pairs.next(side)];
      const bool is_turned = m_is_turned[m_pairs.face(side)];
      corners.push_back({m_pairs.face(side), from, side});
      edges.push_back({is_turned ? to : from, is_turned ? from : to, side});
    }
    std::vector<std::size_t> result;
    for (auto* list : {&corners, &edges})
    {
      std::sort(list->begin(), list->end());
      for (std::size_t i = 1; i < list->size(); ++i)
        if ((*list)[i][0] == (*list)[i - 1][0] && (*list)[i][1] == (*list)[i - 1][1])
          result.push_back((*list)[i][2]);
    }
    return result;
  }

  Edge_pairs& m_pairs;
  const std::vector<bool>& m_is_turned;
  std::vector<std::size_t> m_vertex;
};

// The chosen faces and how they are joined.
struct Joined_faces
{
  Joined_faces(const Polygon_soup& soup, const std::vector<std::size_t>& places, const std::vector<bool>& is_left_out)
    : choice(choose_faces(soup, places, is_left_out)), pairs(soup.points, choice, places),
      is_turned(pairs.turned_faces()), vertices(pairs, is_turned)
  { }

  Face_choice choice;
  Edge_pairs pairs;
  std::vector<bool> is_turned;
  Vertices vertices;
};

// Looks for the components that are better labelled by their neighbours than segmented: tiny ones, and walls between two
// solids, which hang on crowded edges all around. They must touch what remains.
class Specks
{
public:
  Specks(const Polygon_soup& soup, const std::vector<std::size_t>& places, const Joined_faces& joined)
    : m_soup(soup), m_places(places), m_joined(joined), m_component(joined.pairs.components()),
      m_is_speck(m_component.size(), false)
  {
    find_tiny_ones();
    find_walls();
    keep_lonely_ones();
  }

  // Sets the faces of specks, in their number in the file; returns the number of specks.
  std::size_t leave_out(std::vector<bool>& is_left_out) const
  {
    std::size_t count = 0;
    for (std::size_t face = 0; face < m_component.size(); ++face)
      if (m_is_speck[m_component[face]])
      {
        is_left_out[m_joined.choice.kept[face]] = true;
        count += m_component[face] == face ? 1 : 0; // a component is named after one of its faces
      }
    return count;
  }

private:
  void find_tiny_ones()
  {
    std::vector<double> area(m_component.size(), 0);
    for (std::size_t face = 0; face < area.size(); ++face)
      area[m_component[face]] += std::sqrt(area_vector(m_soup.points, m_joined.choice.polygons[face]).squared_length());
    const double whole_area = std::accumulate(area.begin(), area.end(), 0.);
    for (std::size_t face = 0; face < area.size(); ++face)
      m_is_speck[face] = area[face] < share_of_speck * whole_area;
  }

  void find_walls()
  {
    const Edge_pairs& pairs = m_joined.pairs;
    std::vector<bool> is_wall(m_component.size(), true);
    for (std::size_t side = 0; side < pairs.number_of_sides(); ++side)
    {
      const std::size_t face = pairs.face(side);
      const bool is_free = pairs.partner(side) == Edge_pairs::none && !pairs.is_crowded(side);
      if (!m_joined.choice.has_double[face] || is_free)
        is_wall[m_component[face]] = false;
    }
    std::vector<bool> has_border(m_component.size(), false);
    for (std::size_t side = 0; side < pairs.number_of_sides(); ++side)
      if (pairs.partner(side) == Edge_pairs::none)
        has_border[m_component[pairs.face(side)]] = true;
    for (std::size_t face = 0; face < m_component.size(); ++face)
      m_is_speck[face] = m_is_speck[face] || (is_wall[face] && has_border[face]);
  }

  // Those that touch nothing but other specks, or nothing at all.
  void keep_lonely_ones()
  {
    Parity_sets clusters(m_places.size());
    for (const Polygon& polygon : m_joined.choice.polygons)
      for (const std::size_t corner : polygon)
        clusters.unite(m_places[polygon.front()], m_places[corner], false);
    const auto cluster_of = [&](std::size_t face) { return clusters.find(m_places[m_joined.choice.polygons[face].front()]).first; };
    std::vector<bool> has_more(m_places.size(), false);
    for (std::size_t face = 0; face < m_component.size(); ++face)
      if (!m_is_speck[m_component[face]])
        has_more[cluster_of(face)] = true;
    for (std::size_t face = 0; face < m_component.size(); ++face)
      if (!has_more[cluster_of(face)])
        m_is_speck[m_component[face]] = false;
  }

  const Polygon_soup& m_soup;
  const std::vector<std::size_t>& m_places;
  const Joined_faces& m_joined;
  std::vector<std::size_t> m_component; // of each chosen face
  std::vector<bool> m_is_speck;         // of each component
};

void build_mesh(const Joined_faces& joined, Input_mesh& input)
{
  const std::vector<Polygon>& faces = joined.choice.polygons;
  std::vector<std::array<std::size_t, 3>> corners; // point, vertex, side
  for (std::size_t face = 0; face < faces.size(); ++face)
    for (std::size_t i = 0; i < faces[face].size(); ++i)
    {
      const std::size_t side = joined.pairs.first_side(face) + i;
      corners.push_back({faces[face][i], joined.vertices.vertex_at(side), side});
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
      polygon[i] = number[joined.vertices.vertex_at(joined.pairs.first_side(face) + i)];
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
    parts.push_back(counted(repairs.degenerate_faces, "degenerate face has", "degenerate faces have") + " the label of a neighbour");
  if (repairs.duplicate_faces > 0)
    parts.push_back(counted(repairs.duplicate_faces, "duplicate face has", "duplicate faces have") + " that of the first");
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
