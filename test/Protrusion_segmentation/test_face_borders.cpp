// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Borders that move on the faces.

#include "check.h"
#include "components.h"
#include "segments_of_graphs.h"
#include "test_meshes.h"

#include <CGAL/Protrusion_segmentation/internal/Cut_method/Result/Face_borders.h>

#include <cstddef>
#include <vector>

using namespace test_meshes;

double cost_of_borders(const Seam_graph& graph, const std::vector<Index>& labels)
{
  double cost = 0;
  for (Index f = 0; f < graph.number_of_nodes(); ++f)
    for (const Index arc : graph.arcs(f))
      cost += labels[f] != labels[graph.target[arc]] ? graph.capacity[arc] : 0;
  return cost;
}

void borders_on_faces_keep_the_segments_connected(const Test_mesh& mesh, std::size_t largest_number)
{
  Component_of_mesh of_mesh(mesh);
  const Seam_graph& graph = of_mesh.component.graphs().fine;
  for (std::size_t k = 2; k <= largest_number && of_mesh.component.best(k); ++k)
  {
    const std::vector<Index> labels = labels_of_faces(of_mesh.component, *of_mesh.component.best(k));
    check_segments(graph, labels, k);
    const std::vector<Index> moved = internal::Face_borders(graph, labels, k)(quiet_execution());
    check_segments(graph, moved, k);
    CGAL_CHECK(cost_of_borders(graph, moved) <= cost_of_borders(graph, labels) * (1 + 1e-6));
  }
}

double area_of(const Seam_graph& graph, const std::vector<Index>& labels, Index segment)
{
  double area = 0;
  for (Index f = 0; f < graph.number_of_nodes(); ++f)
    area += labels[f] == segment ? graph.area[f] : 0;
  return area;
}

// Two squares joined by a narrow bridge, in a sheet: the shortest border goes around each of them, but then one square would go
// to the other segment.
void a_segment_does_not_lose_a_half_that_hangs_on_a_bridge()
{
  constexpr std::size_t columns = 26, rows = 14;
  const Seam_graph graph = seam_graph(sheet(columns, rows, columns, rows));
  const auto is_between = [](std::size_t x, std::size_t first, std::size_t last) { return first <= x && x <= last; };
  std::vector<Index> labels;
  for (std::size_t y = 0; y < rows; ++y)
    for (std::size_t x = 0; x < columns; ++x)
      labels.push_back(is_between(y, 2, 11) && is_between(x, 1, 24) && (x < 11 || x > 14 || y == 6) ? 1 : 0);
  check_segments(graph, labels, 2);
  const std::vector<Index> moved = internal::Face_borders(graph, labels, 2)(quiet_execution());
  check_segments(graph, moved, 2);
  CGAL_CHECK(area_of(graph, moved, 1) > 0.75 * area_of(graph, labels, 1));
}

// Segments of the faces that are nearest to each of some faces.
void random_segments_stay_connected(std::uint_fast32_t seed)
{
  const Test_mesh mesh = random_surface(seed);
  const Seam_graph graph = seam_graph(mesh);
  const std::size_t number = 2 + seed % 5;
  if (number_of_components(mesh) > 1 || mesh.faces.size() < number)
    return;
  internal::Graph_distances distances(graph);
  const std::vector<std::size_t> centers = random_permutation(mesh.faces.size(), seed);
  std::vector<double> least(mesh.faces.size(), infinity);
  std::vector<Index> labels(mesh.faces.size());
  for (std::size_t s = 0; s < number; ++s)
  {
    const internal::Nodes_by_distance order = distances(
      {Index(centers[s])}, [](Index, Index) { return true; }, graph.lengths());
    for (std::size_t i = 0; i < order.nodes.size(); ++i)
      if (order.distances[i] < least[order.nodes[i]])
      {
        least[order.nodes[i]] = order.distances[i];
        labels[order.nodes[i]] = Index(s);
      }
  }
  check_segments(graph, labels, number);
  check_segments(graph, internal::Face_borders(graph, labels, number)(quiet_execution()), number);
}

int main()
{
  for (const Test_mesh& mesh : {star(5), creature(), torus(), bumpy_sphere(3, 1), sheet(20, 30)})
    borders_on_faces_keep_the_segments_connected(mesh, 10);
  for (std::uint_fast32_t seed = 0; seed < 100; ++seed)
    random_segments_stay_connected(seed);
  a_segment_does_not_lose_a_half_that_hangs_on_a_bridge();
  return check::result();
}
