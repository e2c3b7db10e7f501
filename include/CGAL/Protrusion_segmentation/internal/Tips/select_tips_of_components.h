// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_TIPS_SELECT_TIPS_OF_COMPONENTS_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_TIPS_SELECT_TIPS_OF_COMPONENTS_H

#include <CGAL/Protrusion_segmentation/Execution.h>
#include <CGAL/Protrusion_segmentation/Indexed_surface.h>
#include <CGAL/Protrusion_segmentation/internal/Distances/Any_distance.h>
#include <CGAL/Protrusion_segmentation/internal/Segments/Nested_segments.h>
#include <CGAL/Protrusion_segmentation/internal/Surface/extract_segment.h>
#include <CGAL/Protrusion_segmentation/internal/Tips/select_protrusion_tips.h>

#include <cstddef>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL {
namespace Protrusion_segmentation {
namespace internal {

// How many of `number_of_tips` each component gets: one after the other to the component with the largest
// area per tip, the new one counted, the first among equals; never more than it has faces.
inline std::vector<std::size_t> share_out_tips(std::size_t number_of_tips,
                                               const std::vector<double>& areas,
                                               const std::vector<std::size_t>& face_counts)
{
  struct Offer
  {
    double area_per_tip;
    std::size_t component;

    bool operator<(const Offer& other) const
    {
      return area_per_tip != other.area_per_tip ? area_per_tip < other.area_per_tip
                                                : component > other.component;
    }
  };
  std::vector<std::size_t> shares(areas.size(), 0);
  std::priority_queue<Offer> offers;
  for (std::size_t c = 0; c < areas.size(); ++c)
    offers.push({areas[c], c});
  while (number_of_tips > 0 && !offers.empty())
  {
    const std::size_t c = offers.top().component;
    offers.pop();
    ++shares[c];
    --number_of_tips;
    if (shares[c] < face_counts[c])
      offers.push({areas[c] / static_cast<double>(shares[c] + 1), c});
  }
  return shares;
}

// Tips of a surface of any number of components: those of one component after the other.
inline std::vector<Indexed_surface::Index> select_tips_of_components(const Indexed_surface& surface,
                                                                     const Any_distance& distance,
                                                                     std::size_t number_of_tips,
                                                                     Execution& execution)
{
  using Index = Indexed_surface::Index;
  const Nested_segments components(surface);
  std::vector<double> areas;
  std::vector<std::size_t> face_counts;
  for (std::size_t c = 0; c < components.number_of_components(); ++c)
  {
    areas.push_back(components.area(surface, c));
    face_counts.push_back(components.faces(c).size());
  }
  const std::vector<std::size_t> shares = share_out_tips(number_of_tips, areas, face_counts);
  Segment_extractor extract(surface);
  std::vector<Index> tips;
  for (std::size_t c = 0; c < shares.size(); ++c)
  {
    if (shares[c] == 0)
      continue;
    const double begin = static_cast<double>(tips.size()) / static_cast<double>(number_of_tips);
    const double end = begin + static_cast<double>(shares[c]) / static_cast<double>(number_of_tips);
    const Execution::Subtask subtask(execution, begin, end);
    const Extracted_segment component = extract(components.faces(c));
    const auto distances = distance.on(component.surface, execution);
    for (Index tip : select_protrusion_tips(component.surface, *distances, shares[c]))
      tips.push_back(component.faces[tip]);
    execution.observer().distances_computed(distances->number_of_runs());
  }
  return tips;
}

} // namespace internal
} // namespace Protrusion_segmentation
} // namespace CGAL

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_TIPS_SELECT_TIPS_OF_COMPONENTS_H
