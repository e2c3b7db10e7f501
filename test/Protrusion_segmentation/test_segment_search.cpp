// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The cuts of a segment of which the best are known.

#include "check.h"
#include "dual_graphs.h"
#include "node_sets.h"
#include "test_meshes.h"

#include <CGAL/Protrusion_segmentation/internal/Cut_method/Graph/Graphs_of_surface.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Search/Segment_search.h>

#include <algorithm>
#include <numeric>
#include <optional>
#include <vector>

using namespace test_meshes;
using namespace CGAL::Protrusion_segmentation;
using internal::Cut;
using internal::Nodes;

struct Search_of_mesh
{
  explicit Search_of_mesh(const Test_mesh& mesh)
    : surface(to_surface(mesh)),
      graphs(surface, default_options(), quiet_execution()),
      whole{all_nodes(graphs.coarse), 1},
      search(surface, graphs, distance, default_options(), quiet_execution())
  {}

  Indexed_surface surface;
  std::optional<internal::Any_distance> distance;
  internal::Graphs_of_surface graphs;
  internal::Segment whole;
  internal::Segment_search search;
};

// The area in each part of the faces of some nodes.
std::vector<double> areas_of_parts(const Search_of_mesh& of_mesh,
                                   const Test_mesh& mesh,
                                   const Nodes& nodes)
{
  std::vector<double> areas(number_of_parts(mesh), 0);
  for (std::size_t f = 0; f < mesh.faces.size(); ++f)
    if (std::binary_search(nodes.begin(), nodes.end(), of_mesh.graphs.node_of_face[f]))
      areas[mesh.parts[f]] += of_mesh.surface.area(Index(f));
  return areas;
}

void best_cuts_of_a_star_are_its_arms()
{
  const Test_mesh mesh = star(6);
  Search_of_mesh of_mesh(mesh);
  const std::vector<Cut> cuts = of_mesh.search(of_mesh.whole);
  // more than one, but not always all: the others are found in what remains
  constexpr std::size_t least_number = 3;
  CGAL_CHECK(cuts.size() >= least_number);
  for (std::size_t c = 0; c < cuts.size(); ++c)
  {
    CGAL_CHECK(c == 0 || cuts[c].value <= cuts[c - 1].value);
    if (c >= least_number)
      continue;
    CGAL_CHECK(cuts[c].value > 0);
    const std::vector<double> areas = areas_of_parts(of_mesh, mesh, cuts[c].inner);
    CGAL_CHECK(*std::max_element(areas.begin() + 1, areas.end()) >
          0.9 * std::accumulate(areas.begin(), areas.end(), 0.));
  }
}

// The same cuts whatever was searched before.
void segments_are_searched_independently()
{
  const Test_mesh mesh = star(5);
  Search_of_mesh of_mesh(mesh), other(mesh);
  const Cut first = of_mesh.search(of_mesh.whole).front();
  const internal::Segment rest = {internal::other_side(of_mesh.whole, first.inner),
                                  1 - of_mesh.graphs.coarse.area_of(first.inner)};
  const std::vector<Cut> found = of_mesh.search(rest), alone = other.search(rest);
  CGAL_CHECK(other.search(other.whole).front().inner == first.inner);
  CGAL_CHECK_EQUAL(found.size(), alone.size());
  for (std::size_t c = 0; c < (std::min)(found.size(), alone.size()); ++c)
  {
    CGAL_CHECK(found[c].inner == alone[c].inner);
    CGAL_CHECK_EQUAL(found[c].value, alone[c].value);
  }
}

// Both sides of every cut are connected, large enough, and different from those of other cuts.
void cuts_are_valid(const Test_mesh& mesh)
{
  Search_of_mesh of_mesh(mesh);
  const internal::Volume_graph& graph = of_mesh.graphs.coarse;
  internal::Graph_partition partition(graph);
  std::vector<Nodes> sides;
  const std::vector<Cut> cuts = of_mesh.search(of_mesh.whole);
  for (const Cut& cut : cuts)
  {
    const Nodes outer = internal::other_side(of_mesh.whole, cut.inner);
    CGAL_CHECK(!cut.inner.empty() && !outer.empty());
    CGAL_CHECK(are_connected(partition, cut.inner) && are_connected(partition, outer));
    CGAL_CHECK(internal::is_large_enough(graph.area_of(cut.inner), 1));
    CGAL_CHECK(std::find(sides.begin(), sides.end(), cut.inner) == sides.end());
    const double probability = internal::probability_of_border(cut.log_odds);
    CGAL_CHECK(probability > 0 && probability < 1);
    sides.push_back(cut.inner);
  }
}

int main()
{
  best_cuts_of_a_star_are_its_arms();
  segments_are_searched_independently();
  for (const Test_mesh& mesh :
       {star(5), creature(), torus(), bumpy_sphere(3, 1), sheet(20, 30), tetrahedron()})
    cuts_are_valid(mesh);
  return check::result();
}
