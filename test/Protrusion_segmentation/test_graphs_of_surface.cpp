// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The coarse graph of a surface, which cuts are searched on.

#include "check.h"
#include "checks_of_graphs.h"
#include "dual_graphs.h"
#include "segments_of_graphs.h"
#include "test_meshes.h"

#include <CGAL/Protrusion_segmentation/internal/Cut_method/Graph/Graphs_of_surface.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

using namespace test_meshes;
using namespace CGAL::Protrusion_segmentation;
using internal::Graphs_of_surface;

Graphs_of_surface graphs_of(const Indexed_surface& surface)
{
  return Graphs_of_surface(surface, default_options(), quiet_execution());
}

// Disks lie closer where there are more faces to put them at: the number of nodes grows by ever less, towards a limit.
void a_large_surface_has_as_many_nodes()
{
  std::vector<Index> number;
  for (const int subdivisions : {5, 6, 7}) // up to 327,680 faces
  {
    const Graphs_of_surface graphs = graphs_of(to_surface(icosphere(subdivisions)));
    number.push_back(graphs.coarse.number_of_nodes());
    check_segments(graphs.fine, graphs.node_of_face, graphs.coarse.number_of_nodes());
  }
  CGAL_CHECK(number[0] > 1200 && number[1] < 1700);
  CGAL_CHECK(number[2] >= number[1] && number[2] - number[1] < 0.6 * (number[1] - number[0]));
}

void a_small_surface_stays_as_it_is()
{
  const Graphs_of_surface graphs = graphs_of(to_surface(icosphere(2)));
  CGAL_CHECK_EQUAL(graphs.coarse.number_of_nodes(), icosphere(2).faces.size());
  CGAL_CHECK(graphs.node_of_face == all_nodes(graphs.fine));
}

// A box whose edges have further vertices: two of its faces share several edges each.
Test_mesh box_with_divided_edges(std::size_t number)
{
  const Test_mesh cube = box(1, 1, 1);
  Test_mesh result;
  result.points = cube.points;
  std::map<Edge, std::vector<std::size_t>> inside; // of every edge, from its lower to its higher vertex
  for (const Face& face : cube.faces)
  {
    Face divided;
    for (std::size_t i = 0; i < face.size(); ++i)
    {
      const std::size_t a = face[i], b = face[(i + 1) % face.size()];
      const auto [found, is_new] = inside.emplace(Edge(std::minmax(a, b)), std::vector<std::size_t>());
      for (std::size_t k = 1; is_new && k <= number; ++k)
      {
        const double t = double(k * k) / double((number + 1) * (number + 1)); // at different distances
        found->second.push_back(result.points.size());
        result.add_point((1 - t) * cube.points[(std::min)(a, b)] + t * cube.points[(std::max)(a, b)]);
      }
      divided.push_back(a);
      if (a < b)
        divided.insert(divided.end(), found->second.begin(), found->second.end());
      else
        divided.insert(divided.end(), found->second.rbegin(), found->second.rend());
    }
    result.add_face(divided);
  }
  return result;
}

// One arc each way between any two neighbours, with the same weights.
void check_single_arcs(const Volume_graph& graph)
{
  std::map<std::pair<Index, Index>, Index> arcs;
  for (Index i = 0; i < graph.number_of_nodes(); ++i)
    for (const Index arc : graph.arcs(i))
      CGAL_CHECK(arcs.emplace(std::make_pair(i, graph.target[arc]), arc).second);
  for (const auto& [ends, arc] : arcs)
  {
    const auto back = arcs.find({ends.second, ends.first});
    CGAL_CHECK(back != arcs.end());
    if (back == arcs.end())
      continue;
    CGAL_CHECK_EQUAL(graph.border_length[arc], graph.border_length[back->second]);
    CGAL_CHECK_EQUAL(graph.length_in_seam(arc), graph.length_in_seam(back->second));
    CGAL_CHECK_EQUAL(graph.capacity[arc], graph.capacity[back->second]);
    CGAL_CHECK_EQUAL(graph.length[arc], graph.length[back->second]);
    CGAL_CHECK_CLOSE(graph.curvature[arc], graph.curvature[back->second],
                1e-5 * (1 + std::abs(graph.curvature[arc])));
  }
}

// Vertices with two faces are usual in polygons.
void faces_may_share_several_edges()
{
  for (const std::size_t number : {0, 1, 2, 5})
  {
    const Graphs_of_surface graphs = graphs_of(to_surface(box_with_divided_edges(number)));
    CGAL_CHECK_EQUAL(graphs.coarse.number_of_nodes(), 6u);
    CGAL_CHECK_EQUAL(graphs.coarse.target.size(), 24u);
    check_single_arcs(graphs.coarse);
    for (const float length : graphs.coarse.border_length)
      CGAL_CHECK_CLOSE(length, 1 / std::sqrt(6.), 1e-6);
  }
}

void neighbours_have_one_arc_each_way(const Test_mesh& mesh)
{
  const Graphs_of_surface graphs = graphs_of(to_surface(mesh));
  check_single_arcs(graphs.coarse);
  check_symmetry(graphs.coarse);
  check_segments(graphs.fine, graphs.node_of_face, graphs.coarse.number_of_nodes());
}

int main()
{
  faces_may_share_several_edges();
  for (const Test_mesh& mesh : {tetrahedron(), football(), sheet(10, 10), star(4), torus(), icosphere(5)})
    neighbours_have_one_arc_each_way(mesh);
  for (std::uint_fast32_t seed = 0; seed < 20; ++seed)
    neighbours_have_one_arc_each_way(random_surface(seed));
  a_large_surface_has_as_many_nodes();
  a_small_surface_stays_as_it_is();
  return check::result();
}
