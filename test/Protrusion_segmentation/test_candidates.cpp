// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// After the cheapest candidates for cuts there are some that cross none of these: teeth of a gear are not hidden by halves of its ring.

#include "check.h"
#include "dual_graphs.h"
#include "node_sets.h"
#include "segmentations.h"
#include "test_meshes.h"

#include <CGAL/Protrusion_segmentation/internal/Cut_method/Candidates/candidates.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Graph/Graph_distances.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <set>
#include <vector>

using namespace CGAL::Protrusion_segmentation;
using namespace test_meshes;
using internal::Candidate;
using internal::Nodes;

std::vector<Candidate> candidates_of(const Seam_graph& graph, const internal::Cut_options& options)
{
  internal::Graph_partition partition(graph);
  const internal::Segment whole{all_nodes(graph), 1};
  partition.select(whole);
  internal::Level_set_sweep sweep(graph);
  std::vector<internal::Ordered_level_sets> orders;
  for (const Index tip : {Index(0), graph.number_of_nodes() / 2, graph.number_of_nodes() - 1})
  {
    Nodes order =
      internal::Graph_distances(graph)(Nodes(1, tip), [](Index, Index) { return true; }, graph.seam_lengths()).nodes;
    for (int direction = 0; direction < 2; ++direction)
    {
      orders.push_back({order, sweep(partition, order, 1)});
      std::reverse(order.begin(), order.end());
    }
  }
  const internal::Merged_regions regions = internal::Region_merger(graph)(partition, whole);
  return internal::Candidate_chooser(graph, options)(partition, whole, orders, regions, [](const Nodes&) { return true; });
}

// The least area of the four parts into which two sets of nodes divide the surface.
double least_part(const Seam_graph& graph, const Candidate& a, const Candidate& b)
{
  const std::set<Index> of_a(a.nodes.begin(), a.nodes.end()), of_b(b.nodes.begin(), b.nodes.end());
  double parts[2][2] = {};
  for (Index node = 0; node < graph.number_of_nodes(); ++node)
    parts[of_a.count(node)][of_b.count(node)] += graph.area[node];
  return (std::min)({parts[0][0], parts[0][1], parts[1][0], parts[1][1]});
}

// Returns how many there are that cross none before them.
std::size_t late_level_sets_cross_none(const Test_mesh& mesh)
{
  constexpr double rounding = 1e-12;
  const Seam_graph graph = seam_graph(mesh);
  internal::Cut_options options;
  options.crossing_level_sets = 3;
  const std::vector<Candidate> candidates = candidates_of(graph, options);
  const auto first_region =
    std::find_if(candidates.begin(), candidates.end(), [](const Candidate& c) { return c.is_region; });
  const std::size_t level_sets = first_region - candidates.begin();
  CGAL_CHECK(level_sets <= options.level_sets);
  CGAL_CHECK(candidates.size() - level_sets <= options.regions);
  for (std::size_t late = options.crossing_level_sets; late < level_sets; ++late)
    for (std::size_t i = 0; i < late; ++i)
      CGAL_CHECK(least_part(graph, candidates[i], candidates[late]) < internal::least_area_of_segment + rounding);
  return level_sets - (std::min)(level_sets, options.crossing_level_sets);
}

void teeth_are_segments(const Test_mesh& mesh)
{
  const std::size_t parts = number_of_parts(mesh);
  for (const Segmentation& found : {automatic_segmentation(mesh), given_segmentation(mesh, parts)})
  {
    CGAL_CHECK_EQUAL(found.number, parts);
    CGAL_CHECK(as_partition(found.labels) == as_partition(mesh.parts));
  }
}

int main()
{
  std::size_t late = 0;
  for (unsigned int seed = 0; seed < 40; ++seed)
    late += late_level_sets_cross_none(random_surface(seed));
  CGAL_CHECK(late > 0);
  for (std::size_t teeth = 8; teeth <= 16; ++teeth) // two of them had segments of several teeth
    teeth_are_segments(gear(teeth, 0.5, 1.3, 0.4));
  return check::result();
}
