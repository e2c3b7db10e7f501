// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_CANDIDATES_DISTANCE_ORDERS_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_CANDIDATES_DISTANCE_ORDERS_H

#include <CGAL/Protrusion_segmentation/Execution.h>
#include <CGAL/Protrusion_segmentation/Indexed_surface.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Graph/Graph_partition.h>
#include <CGAL/Protrusion_segmentation/internal/Distances/Any_distance.h>
#include <CGAL/Protrusion_segmentation/internal/Surface/extract_segment.h>
#include <CGAL/Protrusion_segmentation/internal/Tips/select_protrusion_tips.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL::Protrusion_segmentation::internal {

// Orders of the nodes of a segment, which are ascending, by their distances from its tips, in the distance of the user's choice. A node
// is as far as its faces are on average.
inline std::vector<Nodes> distance_orders(const Indexed_surface& surface,
                                          const Nodes& nodes,
                                          const std::vector<Indexed_surface::Index>& node_of_face,
                                          const Any_distance& distance,
                                          Execution& execution)
{
  using Index = Indexed_surface::Index;
  constexpr std::size_t number_of_tips = 6; // every one costs a distance computation on all faces
  std::vector<Index> faces;
  for (Index f = 0; f < surface.number_of_faces(); ++f)
    if (std::binary_search(nodes.begin(), nodes.end(), node_of_face[f]))
      faces.push_back(f);
  const Indexed_surface segment = Face_selector<Indexed_surface>(surface)(faces).to_surface();
  const auto distances = distance.on(segment, execution);
  std::vector<double> mean(nodes.empty() ? 0 : nodes.back() + 1);
  std::vector<Index> count(mean.size());
  std::vector<Nodes> orders;
  select_protrusion_tips(
    segment, *distances, number_of_tips, [](Index) { return true; },
    [&](Index, const std::vector<double>& from_tip)
    {
      mean.assign(mean.size(), 0);
      count.assign(count.size(), 0);
      for (Index f = 0; f < from_tip.size(); ++f)
      {
        const Index node = node_of_face[faces[f]];
        mean[node] += (from_tip[f] - mean[node]) / ++count[node];
      }
      orders.push_back(nodes);
      std::stable_sort(orders.back().begin(), orders.back().end(),
                       [&](Index a, Index b) { return mean[a] < mean[b]; });
    });
  execution.observer().distances_computed(distances->number_of_runs());
  return orders;
}

} // namespace CGAL::Protrusion_segmentation::internal

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_CANDIDATES_DISTANCE_ORDERS_H
