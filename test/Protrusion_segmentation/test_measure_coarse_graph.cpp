// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The lengths and costs of borders between nodes of a coarse graph, as if the borders were straight.

#include "check.h"
#include "dual_graphs.h"
#include "test_meshes.h"

#include <CGAL/Protrusion_segmentation/internal/Cut_method/Graph/measure_coarse_graph.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Graph/contract_graph.h>

#include <cmath>
#include <cstddef>
#include <numeric>
#include <random>
#include <vector>

using namespace test_meshes;
using namespace CGAL::Protrusion_segmentation;

// Lengths are stored in single precision.
constexpr double precision = 1e-5;
// of their length, what borders keep at least
constexpr double least_share = 0.8;

struct Borders
{
  Seam_graph ragged, straight;
};

// Of the sets of faces with equal numbers, from 0 to below `count`.
Borders borders(const Test_mesh& mesh, const std::vector<Index>& node, Index count)
{
  const Indexed_surface surface = to_surface(mesh);
  const Seam_graph fine = seam_graph(surface);
  Borders result;
  result.ragged = internal::contract(fine, centres(surface), {node, count}, false).graph;
  result.straight = result.ragged;
  internal::Border_straightener(surface, fine, node, result.straight)(internal::Index_groups(node, count),
                                                                      false);
  return result;
}

template <typename Region>
Borders borders_of_region(const Test_mesh& mesh, Region region)
{
  std::vector<Index> node;
  for (const Face& face : mesh.faces)
    node.push_back(region(centroid(mesh, face)) ? 1 : 0);
  return borders(mesh, node, 2);
}

double length_on_mesh(const Test_mesh& mesh, float length)
{
  return length * std::sqrt(to_surface(mesh).area());
}

// Squares in a plane, the last row of which stands upright.
Test_mesh nearly_flat_sheet(int n)
{
  Test_mesh mesh = sheet(n, n);
  for (Point& p : mesh.points)
    if (p[1] == n)
      p = {p[0], n - 1., 1};
  return mesh;
}

// A border that climbs one square in every four.
void a_staircase_has_the_length_of_its_chord()
{
  const int n = 32;
  const Test_mesh mesh = nearly_flat_sheet(n);
  const Borders found = borders_of_region(mesh,
                                          [](const Point& p) { return p[1] < 8 + std::floor(p[0] / 4); });
  CGAL_CHECK_CLOSE(length_on_mesh(mesh, found.ragged.border_length[0]), n + n / 4 - 1, precision * n);
  CGAL_CHECK_CLOSE(length_on_mesh(mesh, found.straight.border_length[0]), std::hypot(n, n / 4 - 1),
              precision * n);
  // no seam, but ridges of the roof over the sheet; a unit of length costs what it did
  CGAL_CHECK(found.straight.capacity[0] <= found.straight.border_length[0]);
  CGAL_CHECK_CLOSE(found.straight.capacity[0] / found.straight.border_length[0],
                   found.ragged.capacity[0] / found.ragged.border_length[0], 0.01);
  CGAL_CHECK_EQUAL(found.straight.concave_length[0], 0);
}

void the_length_does_not_depend_on_the_size_of_faces()
{
  for (int n : {16, 32, 64, 128})
  {
    const Test_mesh mesh = sheet(n, n, 1. / n, 1. / n);
    const Borders found = borders_of_region(mesh, [](const Point& p) { return p[1] < 0.3 + p[0] / 4; });
    CGAL_CHECK_CLOSE(length_on_mesh(mesh, found.straight.border_length[0]), std::hypot(1, 0.25), 0.02);
    CGAL_CHECK(length_on_mesh(mesh, found.ragged.border_length[0]) > 1.17);
  }
}

void straight_borders_stay()
{
  const Test_mesh mesh = box(12, 2, 2);
  const Borders found = borders_of_region(sheet(9, 5), [](const Point& p) { return p[0] < 4; });
  CGAL_CHECK_CLOSE(found.straight.border_length[0], found.ragged.border_length[0], precision);
  std::vector<Index> node(mesh.faces.size());
  std::iota(node.begin(), node.end(), Index(0));
  const Borders faces = borders(mesh, node, Index(node.size()));
  for (std::size_t arc = 0; arc < faces.ragged.target.size(); ++arc)
  {
    CGAL_CHECK_CLOSE(faces.straight.border_length[arc], faces.ragged.border_length[arc], precision);
    CGAL_CHECK_CLOSE(faces.straight.capacity[arc], faces.ragged.capacity[arc], precision);
    CGAL_CHECK_CLOSE(faces.straight.concave_length[arc], faces.ragged.concave_length[arc], precision);
  }
}

// Around a node there is no chord.
void a_closed_border_keeps_most_of_its_length()
{
  const Borders found = borders_of_region(
    sheet(9, 9), [](const Point& p) { return std::abs(p[0] - 4.5) < 2 && std::abs(p[1] - 4.5) < 2; });
  CGAL_CHECK_CLOSE(found.straight.border_length[0], found.ragged.border_length[0] * least_share, precision);
}

// A bent sheet whose border follows the seam, but for a detour over the flat: the steps to the flat and back count for
// nothing, what runs beside the seam does.
void steps_beside_a_seam_do_not_count()
{
  const int n = 40;
  Test_mesh mesh = sheet(n, n);
  for (Point& p : mesh.points)
    if (p[0] > n / 2)
      p = {n / 2, p[1], p[0] - n / 2}; // bent by a right angle
  const auto is_left_of_border = [&](const Point& p)
  { return p[2] == 0 && !(p[0] > n / 2 - 5 && p[1] > 10 && p[1] < 20); };
  const Borders found = borders_of_region(mesh, is_left_of_border);
  const double length = length_on_mesh(mesh, found.straight.border_length[0]);
  const double concave = length_on_mesh(mesh, found.straight.concave_length[0]);
  CGAL_CHECK_CLOSE(length_on_mesh(mesh, found.ragged.border_length[0]), n + 10, precision * n);
  CGAL_CHECK_CLOSE(length, n, precision * n);
  // an open sheet has no inside: the seam is concave or not, by the sign of the volume, but it lies on three quarters
  CGAL_CHECK(concave == 0 || (concave > 0.74 * n && concave < 0.9 * n));
}

// Of any nodes of any surface: the same for both directions, no longer than before, and no shorter than allowed.
void weights_are_consistent(const Test_mesh& mesh, std::uint_fast32_t seed)
{
  std::mt19937 random(seed);
  const Index count = 8;
  std::vector<Index> node;
  for (std::size_t f = 0; f < mesh.faces.size(); ++f)
    node.push_back(f < count ? Index(f) : Index(random() % count));
  const Borders found = borders(mesh, node, count);
  for (Index i = 0; i < count; ++i)
    for (Index arc : found.straight.arcs(i))
    {
      const Seam_graph& graph = found.straight;
      const Index back = graph.arc_between(graph.target[arc], i);
      CGAL_CHECK(graph.border_length[arc] == graph.border_length[back]);
      CGAL_CHECK(graph.capacity[arc] == graph.capacity[back]);
      CGAL_CHECK(graph.concave_length[arc] == graph.concave_length[back]);
      CGAL_CHECK(graph.border_length[arc] <= found.ragged.border_length[arc] * (1 + precision));
      CGAL_CHECK(graph.border_length[arc] >= found.ragged.border_length[arc] * (least_share - precision));
      CGAL_CHECK(graph.concave_length[arc] <= graph.border_length[arc] * (1 + precision));
      CGAL_CHECK(graph.capacity[arc] <= graph.border_length[arc] * (1 + precision));
    }
}

int main()
{
  a_staircase_has_the_length_of_its_chord();
  the_length_does_not_depend_on_the_size_of_faces();
  straight_borders_stay();
  a_closed_border_keeps_most_of_its_length();
  steps_beside_a_seam_do_not_count();
  for (std::uint_fast32_t seed = 0; seed < 30; ++seed)
    weights_are_consistent(random_surface(seed), seed);
  return check::result();
}
