// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_GRAPH_GRAPHS_OF_SURFACE_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_GRAPH_GRAPHS_OF_SURFACE_H

#include <CGAL/Protrusion_segmentation/Execution.h>
#include <CGAL/Protrusion_segmentation/Indexed_surface.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Cut_options.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Graph/Disk_clusters.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Graph/Dual_graph.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Graph/Seam_finder.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Graph/contract_graph.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Graph/make_dual_graph.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Graph/measure_coarse_graph.h>
#include <CGAL/Protrusion_segmentation/internal/Surface/Index_groups.h>

#include <numeric>
#include <utility>
#include <vector>

namespace CGAL::Protrusion_segmentation::internal {

// A connected surface as the default method sees it: its faces, and the coarse graph that cuts are searched on.
struct Graphs_of_surface
{
  using Index = Dual_graph::Index;

  Seam_graph fine;
  Volume_graph coarse;             // of 1,400 to 1,800 nodes, which do not straddle seams
  std::vector<Index> node_of_face; // of the coarse graph

  Graphs_of_surface(const Indexed_surface& surface, const Cut_options& options, Execution& execution)
  {
    const Stage_scope stage(execution.observer(), Stage::PREPARATION);
    const bool is_parallel = execution.is_parallel();
    const Centres centre = centres_of_faces(surface, is_parallel);
    Dual_graph_maker{surface}(fine, is_parallel);
    Seam_finder(surface, options, execution)(fine, centre);
    Contracted<Seam_graph> contracted = contract(fine, centre, disks(fine, centre, execution), is_parallel);
    static_cast<Seam_graph&>(coarse) = std::move(contracted.graph);
    coarse.centre = std::move(contracted.centre);
    node_of_face = std::move(contracted.node);
    const Index_groups faces_of_nodes(node_of_face, coarse.number_of_nodes());
    Border_straightener(surface, fine, node_of_face, coarse)(faces_of_nodes, is_parallel);
    measure_volumes(surface, node_of_face, faces_of_nodes, coarse, is_parallel);
    if (!surface.has_patches()) // where pieces touch there is a seam, however many there are
      coarse.weight_of_valleys = weight_of_valleys(roughness(coarse));
  }

private:
  // A graph of as few nodes is its own coarse graph; of a larger one disks are made, about as many. The structure of a shape of
  // up to some dozen parts shows in them; with more, details come to the fore.
  static constexpr Index largest_coarse_graph = 2000;
  // In units of the square root of the area: 1,400 to 1,800 disks. From .018 to .026 errors are the same within chance.
  static constexpr double radius_of_disks = 0.026;

  // The clusters of the nodes of a graph: itself if it is small.
  static Clusters disks(const Seam_graph& graph, const Centres& centre, Execution& execution)
  {
    if (graph.number_of_nodes() > largest_coarse_graph)
      return Disk_clusters(graph, centre, radius_of_disks)(2 * largest_coarse_graph, execution);
    Clusters single;
    single.number = graph.number_of_nodes();
    single.of_node.resize(single.number);
    std::iota(single.of_node.begin(), single.of_node.end(), Index(0));
    return single;
  }
};

} // namespace CGAL::Protrusion_segmentation::internal

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_GRAPH_GRAPHS_OF_SURFACE_H
