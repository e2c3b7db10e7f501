// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Flat faces that span a shape: they are divided for the search, and the labels of the pieces come back to them.

#include "check.h"
#include "checks_of_graphs.h"
#include "components.h"
#include "segmentations.h"
#include "segments_of_graphs.h"
#include "test_meshes.h"

#include <CGAL/Protrusion_segmentation/internal/Cut_method/Graph/Grid_cutter.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Graph/divide_long_faces.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Result/labels_of_faces.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

using namespace test_meshes;
using internal::Divided_surface;
using internal::Face_divider;

// A plate with arms around a regular polygon, half as wide as its sides: each arm is a rectangle above, one below and three beside.
// Part 0 is the body.
Test_mesh star_plate(std::size_t arms, double arm_length, double height)
{
  Test_mesh mesh;
  const double apothem = 0.5 / std::tan(pi / double(arms));
  const auto point = [&](std::size_t arm, double along, double across, double z)
  {
    const double angle = 2 * pi * double(arm) / double(arms), x = apothem + along;
    return Point{x * std::cos(angle) - across * std::sin(angle), x * std::sin(angle) + across * std::cos(angle), z};
  };
  Face below, above; // of every arm: the corner of the body before it, its right root, tips, and left root
  for (std::size_t arm = 0; arm < arms; ++arm)
    for (const auto& [along, across] : {std::pair(0., -0.5), {0., -0.25}, {arm_length, -0.25}, {arm_length, 0.25}, {0., 0.25}})
    {
      below.push_back(mesh.add_point(point(arm, along, across, 0)));
      above.push_back(mesh.add_point(point(arm, along, across, height)));
    }
  Face body_below, body_above;
  for (std::size_t i = 0; i < 5 * arms; ++i)
  {
    const std::size_t next = (i + 1) % (5 * arms), arm = i % 5 >= 1 && i % 5 <= 3 ? i / 5 + 1 : 0;
    mesh.add_face({below[i], below[next], above[next], above[i]}, arm);
    if (i % 5 == 1)
    {
      mesh.add_face({above[i], above[i + 1], above[i + 2], above[i + 3]}, arm);
      mesh.add_face({below[i + 3], below[i + 2], below[i + 1], below[i]}, arm);
    }
    if (i % 5 < 2 || i % 5 == 4)
    {
      body_above.push_back(above[i]);
      body_below.insert(body_below.begin(), below[i]);
    }
  }
  mesh.add_face(body_above);
  mesh.add_face(body_below);
  return mesh;
}

// Every polygon as triangles around one of its corners, chosen at random.
Test_mesh with_random_diagonals(const Test_mesh& mesh, std::uint_fast32_t seed)
{
  std::mt19937 random(seed);
  Test_mesh result;
  result.points = mesh.points;
  for (std::size_t f = 0; f < mesh.faces.size(); ++f)
  {
    Face face = mesh.faces[f];
    std::rotate(face.begin(), face.begin() + std::ptrdiff_t(random() % face.size()), face.end());
    for (std::size_t i = 1; i + 1 < face.size(); ++i)
      result.add_face({face[0], face[i], face[i + 1]}, mesh.parts[f]);
  }
  return result;
}

// The pieces cover their faces, and each knows the ones beside it.
void check_pieces(const Indexed_surface& surface, const Divided_surface& divided)
{
  const Indexed_surface& pieces = divided.surface;
  CGAL_CHECK_EQUAL(divided.face_of_piece.size(), pieces.number_of_faces());
  CGAL_CHECK(std::is_sorted(divided.face_of_piece.begin(), divided.face_of_piece.end()));
  std::vector<double> area(surface.number_of_faces(), 0);
  for (Index p = 0; p < pieces.number_of_faces(); ++p)
    area[divided.face_of_piece[p]] += pieces.area(p);
  for (Index f = 0; f < surface.number_of_faces(); ++f)
  {
    CGAL_CHECK_CLOSE(area[f], surface.area(f), 1e-9 * surface.area());
    CGAL_CHECK_EQUAL(divided.face_of_piece[divided.first_piece(f)], f);
  }
  std::multiset<std::pair<Index, Index>> arcs; // between pieces
  std::map<Edge, int> uses;
  for (Index p = 0; p < pieces.number_of_faces(); ++p)
    for (Index c = pieces.first_corner(p); c < pieces.first_corner(p + 1); ++c)
    {
      const Index q = pieces.neighbor(c);
      uses[std::minmax<std::size_t>(pieces.vertex(c), pieces.vertex(pieces.next_corner(p, c)))] += q == Indexed_surface::no_face() ? 2 : 1;
      if (q == Indexed_surface::no_face())
        continue;
      arcs.emplace(p, q);
      std::set<Index> beyond; // of the face that the piece is of
      const Index f = divided.face_of_piece[p];
      for (Index d = surface.first_corner(f); d < surface.first_corner(f + 1); ++d)
        beyond.insert(surface.neighbor(d));
      CGAL_CHECK(divided.face_of_piece[q] == f || beyond.count(divided.face_of_piece[q]) > 0);
    }
  for (const auto& [p, q] : arcs)
    CGAL_CHECK_EQUAL(arcs.count({p, q}), arcs.count({q, p}));
  for (const auto& [edge, number] : uses)
    CGAL_CHECK_EQUAL(number, 2);
}

double longest_edge(const Indexed_surface& surface)
{
  double result = 0;
  for (Index f = 0; f < surface.number_of_faces(); ++f)
    for (Index c = surface.first_corner(f); c < surface.first_corner(f + 1); ++c)
      result = (std::max)(result, surface.edge_length(f, c));
  return result / std::sqrt(surface.area());
}

void pieces_are_short_and_fit_together()
{
  for (const Test_mesh& mesh : {star_plate(5, 3, 0.3), box(1, 2, 3), l_prism(), sheet(2, 3), single_triangle(), tetrahedron()})
    for (const Test_mesh& other : {mesh, with_random_diagonals(mesh, 1), with_random_diagonals(mesh, 2)})
    {
      const Indexed_surface surface = to_surface(other);
      const std::optional<Divided_surface> divided = Face_divider(surface)();
      CGAL_CHECK(divided.has_value());
      if (!divided)
        continue;
      check_pieces(surface, *divided);
      if (surface.has_triangles_only())
        CGAL_CHECK(longest_edge(divided->surface) <= longest_edge(surface) / 2 + 1e-9);
    }
  const Indexed_surface of_many_faces = to_surface(with_random_diagonals(star_plate(12, 1, 0.3), 1));
  CGAL_CHECK(longest_edge(of_many_faces) > 0.2);
  CGAL_CHECK(longest_edge(Face_divider(of_many_faces)()->surface) <= 0.06);
}

// A bar with three fingers on both sides and many points along its outline: slivers above and below lead from the tip of a finger to
// that of the opposite one.
Test_mesh fingers_of_slivers(std::size_t columns, double length)
{
  constexpr double height = 0.4, distance = 1.2;
  Test_mesh mesh;
  Face low, high, low_above, high_above; // the lower and the upper outline
  for (std::size_t i = 0; i <= columns; ++i)
  {
    const double x = 1.7 * (2 * double(i) / double(columns) - 1);
    const bool is_in_finger = std::abs(x - distance * std::round(x / distance)) < 0.25;
    const double y = is_in_finger ? 0.6 + length : 0.6;
    low.push_back(mesh.add_point({x, -y, 0}));
    high.push_back(mesh.add_point({x, y, 0}));
    low_above.push_back(mesh.add_point({x, -y, height}));
    high_above.push_back(mesh.add_point({x, y, height}));
  }
  for (std::size_t i = 0; i < columns; ++i)
  {
    mesh.add_face({low[i], low[i + 1], low_above[i + 1], low_above[i]});
    mesh.add_face({high[i + 1], high[i], high_above[i], high_above[i + 1]});
    mesh.add_face({low_above[i], low_above[i + 1], high_above[i]});
    mesh.add_face({low_above[i + 1], high_above[i + 1], high_above[i]});
    mesh.add_face({low[i + 1], low[i], high[i]});
    mesh.add_face({low[i + 1], high[i], high[i + 1]});
  }
  mesh.add_face({low[0], low_above[0], high_above[0], high[0]});
  mesh.add_face({low.back(), high.back(), high_above.back(), low_above.back()});
  return mesh;
}

// Borders lead across the slivers. There were three segments.
void fingers_across_slivers_are_segments(std::size_t columns, double length)
{
  const Segmentation found = automatic_segmentation(fingers_of_slivers(columns, length));
  CGAL_CHECK_EQUAL(found.number, 7u);
  std::set<std::size_t> tips;
  for (const double x : {-1.2, 0., 1.2})
    for (const std::size_t side : {0, 1})
      tips.insert(found.labels[6 * std::size_t(std::floor(double(columns) * (x / 1.7 + 1) / 2)) + side]);
  CGAL_CHECK_EQUAL(tips.size(), 6u);
}

// Pieces of a triangle are as wide as a cell, or a quarter more at its corners on both sides, and have its area; its edges are cut in
// the same places by themselves. Some corners lie on planes.
void polygons_are_cut_by_a_grid(std::uint_fast32_t seed)
{
  using internal::Grid_cutter;
  using Point_3 = Grid_cutter::Point_3;
  constexpr double cell = 0.25;
  constexpr Index face = 7, beyond = 9;
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> coordinate(-1, 1);
  const auto number = [&] { return random() % 4 == 0 ? cell * (double(random() % 8) - 3.5) : coordinate(random); };
  std::vector<Point_3> points;
  for (int i = 0; i < 3; ++i)
  {
    const double x = number(), y = number(), z = number();
    points.emplace_back(x, y, z);
  }
  const auto area_vector = [&](const std::vector<Point_3>& at, const std::vector<Index>& corners)
  {
    Indexed_surface::Vector_3 result(0, 0, 0);
    for (std::size_t i = 2; i < corners.size(); ++i)
      result = result + CGAL::cross_product(at[corners[i - 1]] - at[corners[0]], at[corners[i]] - at[corners[0]]) / 2;
    return result;
  };
  const auto whole = area_vector(points, {0, 1, 2});
  Grid_cutter cutter(points, cell);
  Indexed_surface::Vector_3 sum(0, 0, 0);
  std::set<Index> on_edges;
  cutter.cut(face, {{0, beyond}, {1, beyond}, {2, beyond}}, [&](const Grid_cutter::Polygon& piece) {
    CGAL_CHECK(piece.size() >= 3);
    std::vector<Index> corners;
    for (std::size_t i = 0; i < piece.size(); ++i)
    {
      corners.push_back(piece[i].vertex);
      CGAL_CHECK(piece[i].beyond == face || piece[i].beyond == beyond);
      if (piece[i].beyond == beyond)
        on_edges.insert({piece[i].vertex, piece[(i + 1) % piece.size()].vertex});
    }
    sum = sum + area_vector(cutter.points(), corners);
    for (int axis = 0; axis < 3; ++axis)
    {
      const auto [lowest, highest] = std::minmax_element(corners.begin(), corners.end(), [&](Index v, Index w)
                                                         { return cutter.points()[v][axis] < cutter.points()[w][axis]; });
      CGAL_CHECK(cutter.points()[*highest][axis] - cutter.points()[*lowest][axis] <= (1.5 + 1e-5) * cell);
    }
  });
  CGAL_CHECK_CLOSE((sum - whole).squared_length(), 0., 1e-20);
  const std::size_t number_of_points = cutter.points().size();
  std::set<Index> by_themselves;
  for (const auto& [from, to] : {std::pair(0, 1), {2, 1}, {2, 0}})
    cutter.cut_edge(from, to, [&](Index vertex) { by_themselves.insert(vertex); });
  by_themselves.insert({0, 1, 2});
  CGAL_CHECK(by_themselves == on_edges);
  CGAL_CHECK_EQUAL(cutter.points().size(), number_of_points);
}

Test_mesh fan(std::size_t n)
{
  Test_mesh mesh;
  mesh.add_point({0, 0, 0});
  for (std::size_t i = 0; i < n; ++i)
    mesh.add_point({std::cos(2 * pi * double(i) / double(n)), std::sin(2 * pi * double(i) / double(n)), 0});
  for (std::size_t i = 0; i < n; ++i)
    mesh.add_face({0, 1 + i, 1 + (i + 1) % n});
  return mesh;
}

// Many long triangles get longer pieces, not millions of them. Where there are too many to divide, they stay.
void there_are_not_too_many_pieces()
{
  for (std::size_t n : {100, 1000, 8000})
  {
    const std::optional<Divided_surface> divided = Face_divider(to_surface(fan(n)))();
    CGAL_CHECK(divided.has_value());
    CGAL_CHECK(divided && divided->surface.number_of_faces() > 2 * n);
    CGAL_CHECK(divided && divided->surface.number_of_faces() < 60000);
  }
  CGAL_CHECK(!Face_divider(to_surface(fan(60000)))());
}

void short_faces_and_curved_surfaces_stay()
{
  CGAL_CHECK(!Face_divider(to_surface(sheet(40, 40)))());
  CGAL_CHECK(longest_edge(to_surface(icosphere(2))) > 0.08);
  CGAL_CHECK(!Face_divider(to_surface(icosphere(2)))());
}

// Whatever triangles the flat faces are made of.
void arms_of_a_plate_are_segments(std::size_t arms, double arm_length, double height)
{
  const Test_mesh mesh = star_plate(arms, arm_length, height);
  for (const Test_mesh& other : {mesh, with_random_diagonals(mesh, 1), with_random_diagonals(mesh, 2), with_random_diagonals(mesh, 3)})
  {
    const Segmentation found = automatic_segmentation(other);
    CGAL_CHECK_EQUAL(found.number, arms + 1);
    CGAL_CHECK(share_in_true_parts(other, found.labels) > 1 - 1e-9); // some triangles of the body have no area
  }
}

// As many segments as were asked for, up to one for each face; the tips of a result give it again.
void every_number_of_segments_can_be_had(const Test_mesh& mesh)
{
  using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
  const Mesh graph = to_graph<Mesh>(mesh);
  const std::size_t n = mesh.faces.size();
  for (std::size_t k = 1; k <= n; ++k)
  {
    const Segmentation found = checked(graph, [&](auto ids) { return CGAL::segmentation_via_protrusion_tips(graph, ids, k); });
    CGAL_CHECK_EQUAL(found.number, k);
  }
  std::vector<Mesh::Face_index> tips(graph.faces().begin(), graph.faces().end());
  const Segmentation found =
    checked(graph, [&](auto ids) { return CGAL::segmentation_from_protrusion_tips(graph, tips, ids); });
  CGAL_CHECK(found.number >= 1 && found.number <= n);
}

// Labels of pieces at random: the faces of each label are connected and there are some, and a face all of whose neighbours and pieces
// have one label has it, too.
void labels_of_faces_are_connected(std::uint_fast32_t seed)
{
  const Test_mesh mesh = random_surface(seed);
  if (number_of_components(mesh) > 1)
    return;
  const Seam_graph graph = seam_graph(mesh);
  std::mt19937 random(seed);
  const std::size_t number = 1 + random() % (std::min<std::size_t>)(8, mesh.faces.size());
  std::vector<Index> face_of_piece, labels;
  std::vector<double> areas;
  for (Index f = 0; f < mesh.faces.size(); ++f)
    for (std::size_t p = 0; p < 1 + random() % 3; ++p)
    {
      face_of_piece.push_back(f);
      areas.push_back(1 + double(random() % 5));
      labels.push_back(labels.size() < number ? Index(labels.size()) : Index(random() % number));
    }
  if (labels.size() < number)
    return;
  check_segments(graph, internal::Face_labeler(graph, face_of_piece, areas, labels)(number), number);
}

void whole_faces_keep_their_labels()
{
  const Test_mesh mesh = star(4);
  const Seam_graph graph = seam_graph(mesh);
  Component_of_mesh of_mesh(mesh);
  const std::vector<Index> labels = of_mesh.component.segments(*of_mesh.component.best(5)).labels();
  std::vector<Index> faces(labels.size());
  for (Index f = 0; f < faces.size(); ++f)
    faces[f] = f;
  CGAL_CHECK(internal::Face_labeler(graph, faces, graph.area, labels)(5) == labels);
}

int main()
{
  pieces_are_short_and_fit_together();
  for (std::uint_fast32_t seed = 0; seed < 500; ++seed)
    polygons_are_cut_by_a_grid(seed);
  there_are_not_too_many_pieces();
  short_faces_and_curved_surfaces_stay();
  arms_of_a_plate_are_segments(4, 1, 0.4);
  arms_of_a_plate_are_segments(5, 2, 0.4);
  arms_of_a_plate_are_segments(6, 2, 0.4);
  arms_of_a_plate_are_segments(7, 3, 0.4);
  for (const std::size_t columns : {50, 125, 300})
    for (const double length : {0.7, 1., 1.5})
      fingers_across_slivers_are_segments(columns, length);
  every_number_of_segments_can_be_had(star_plate(3, 2, 0.5));
  every_number_of_segments_can_be_had(tetrahedron());
  every_number_of_segments_can_be_had(with_random_diagonals(l_prism(), 1));
  for (std::uint_fast32_t seed = 0; seed < 200; ++seed)
    labels_of_faces_are_connected(seed);
  whole_faces_keep_their_labels();
  return check::result();
}
