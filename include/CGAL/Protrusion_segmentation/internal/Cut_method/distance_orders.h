// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_DISTANCE_ORDERS_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_DISTANCE_ORDERS_H

#include <CGAL/Protrusion_segmentation/Execution.h>
#include <CGAL/Protrusion_segmentation/Indexed_surface.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Graph_partition.h>
#include <CGAL/Protrusion_segmentation/internal/Distances/Any_distance.h>
#include <CGAL/Protrusion_segmentation/internal/Surface/extract_segment.h>
#include <CGAL/Protrusion_segmentation/internal/Tips/select_protrusion_tips.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Protrusion_segmentation {
namespace internal {

// The distance of every node of a segment from those of its faces: their mean. A node none of whose faces is
// left in the segment is as far as the nearest of its neighbours; no node is left at the distance of the tip.
inline std::vector<double> distances_of_nodes(const Graph_partition& partition,
                                              const Graph_partition::Nodes& nodes,
                                              const std::vector<double>& of_faces,
                                              const std::vector<Indexed_surface::Index>& faces,
                                              const std::vector<Indexed_surface::Index>& node_of_face)
{
  using Index = Indexed_surface::Index;
  constexpr double unknown = (std::numeric_limits<double>::infinity)();
  std::vector<double> mean(partition.graph().number_of_nodes(), unknown);
  std::vector<Index> count(partition.graph().number_of_nodes(), 0);
  for (Index f = 0; f < of_faces.size(); ++f)
  {
    double& of_node = mean[node_of_face[faces[f]]];
    if (++count[node_of_face[faces[f]]] == 1)
      of_node = 0;
    of_node += (of_faces[f] - of_node) / count[node_of_face[faces[f]]];
  }
  for (bool changes = true; changes;)
  {
    changes = false;
    for (Index i : nodes)
      if (mean[i] == unknown)
      {
        for (Index arc : partition.graph().arcs(i))
          if (partition.segment(partition.graph().target[arc]) == partition.segment(i))
            mean[i] = (std::min)(mean[i], mean[partition.graph().target[arc]]);
        changes = changes || mean[i] < unknown;
      }
  }
  return mean;
}

// The nodes of a segment by their distances from its tips, in the distance of the user's choice.
inline std::vector<Graph_partition::Nodes> distance_orders(const Graph_partition& partition,
                                                           const Graph_partition::Nodes& nodes,
                                                           const std::vector<Indexed_surface::Index>& node_of_face,
                                                           const Extracted_segment& segment,
                                                           const Any_distance& distance,
                                                           Execution& execution)
{
  using Index = Indexed_surface::Index;
  constexpr std::size_t number_of_tips = 6; // every one costs a distance computation on all faces
  const auto distances = distance.on(segment.surface, execution);
  std::vector<Graph_partition::Nodes> orders;
  select_protrusion_tips(
    segment.surface, *distances, number_of_tips, [](Index) { return true; },
    [&](Index, const std::vector<double>& from_tip)
    {
      const std::vector<double> of_nodes =
        distances_of_nodes(partition, nodes, from_tip, segment.faces, node_of_face);
      orders.push_back(nodes);
      std::stable_sort(orders.back().begin(), orders.back().end(),
                       [&](Index a, Index b) { return of_nodes[a] < of_nodes[b]; });
    });
  execution.observer().distances_computed(distances->number_of_runs());
  return orders;
}

} // namespace internal
} // namespace Protrusion_segmentation
} // namespace CGAL

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_DISTANCE_ORDERS_H
