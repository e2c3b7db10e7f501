// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_TIPS_SELECT_PROTRUSION_TIPS_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_TIPS_SELECT_PROTRUSION_TIPS_H

#include <CGAL/Protrusion_segmentation/Execution.h>
#include <CGAL/Protrusion_segmentation/Indexed_surface.h>
#include <CGAL/Protrusion_segmentation/internal/Distances/Any_distance.h>
#include <CGAL/Protrusion_segmentation/internal/Segments/Nested_segments.h>
#include <CGAL/Protrusion_segmentation/internal/Surface/extract_segment.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <queue>
#include <vector>

namespace CGAL::Protrusion_segmentation::internal {

// Section III.C: eq. (1), then eq. (2) until there are `count` plausible tips or no face is left at a
// distance from all tips. An implausible one is eliminated: it takes part in eq. (2) but does not count; so
// that a surface without plausible tips comes to an end, `count` eliminations end the selection.
// `visit(tip, distances from the tip)` is called for every tip, eliminated or not: one distance computation
// serves the selection and the histograms.
template <typename Plausible, typename Visit>
void select_protrusion_tips(const Indexed_surface& surface,
                            Distances_on_surface& distances,
                            std::size_t count,
                            Plausible is_plausible,
                            Visit visit)
{
  using Index = Indexed_surface::Index;
  Index face = count > 0 ? distances.face_of_largest_sum() : 0;
  std::vector<double> to_nearest_tip(surface.number_of_faces(), (std::numeric_limits<double>::max)());
  std::vector<double> from_tip;
  std::size_t number_of_plausible = 0, number_of_eliminated = 0;
  while (number_of_plausible < count)
  {
    distances(face, from_tip);
    visit(face, from_tip);
    if (is_plausible(face))
      ++number_of_plausible;
    else if (++number_of_eliminated == count)
      break;
    for (Index f = 0; f < surface.number_of_faces(); ++f)
      to_nearest_tip[f] = (std::min)(to_nearest_tip[f], from_tip[f]);
    face = static_cast<Index>(std::max_element(to_nearest_tip.begin(), to_nearest_tip.end()) -
                              to_nearest_tip.begin());
    if (to_nearest_tip[face] <= 0)
      break;
  }
}

// A tip's protrusion holds no other tip. Where fewer tips than that are picked, further ones, as far as can be from all
// others, are added that make no segments: a foot and what its protrusion shall not swallow, the other feet, the head
// and the tail.
constexpr std::size_t least_number_of_tips = 6;

// Picked tips without those that mean the same protrusion as an earlier one: the same face again, or a face that
// shares a vertex with it. No border fits between them.
inline std::vector<Indexed_surface::Index> distinct_tips(const Indexed_surface& surface,
                                                         const std::vector<Indexed_surface::Index>& tips)
{
  using Index = Indexed_surface::Index;
  std::vector<bool> is_taken(surface.number_of_vertices(), false);
  std::vector<Index> result;
  for (Index tip : tips)
  {
    bool is_new = true;
    for (Index c = surface.first_corner(tip); c < surface.first_corner(tip + 1); ++c)
      is_new = is_new && !is_taken[surface.vertex(c)];
    if (!is_new)
      continue;
    result.push_back(tip);
    for (Index c = surface.first_corner(tip); c < surface.first_corner(tip + 1); ++c)
      is_taken[surface.vertex(c)] = true;
  }
  return result;
}

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
  Face_selector<Indexed_surface> select(surface);
  const Stage_scope stage(execution.observer(), Stage::TIPS);
  std::vector<Index> tips;
  for (std::size_t c = 0; c < shares.size(); ++c)
  {
    if (shares[c] == 0)
      continue;
    const double begin = static_cast<double>(tips.size()) / static_cast<double>(number_of_tips);
    const double end = begin + static_cast<double>(shares[c]) / static_cast<double>(number_of_tips);
    const Execution::Subtask subtask(execution, begin, end);
    const Nested_segments::Faces& faces = components.faces(c);
    const Indexed_surface component = select(faces).to_surface();
    const auto distances = distance.on(component, execution);
    select_protrusion_tips(
      component, *distances, shares[c], [](Index) { return true; },
      [&](Index tip, const std::vector<double>&)
      {
        tips.push_back(faces[tip]);
        execution.observer().tip_selected(faces[tip]);
      });
    execution.observer().distances_computed(distances->number_of_runs());
  }
  return tips;
}

} // namespace CGAL::Protrusion_segmentation::internal

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_TIPS_SELECT_PROTRUSION_TIPS_H
