// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_TIPS_SELECT_PROTRUSION_TIPS_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_TIPS_SELECT_PROTRUSION_TIPS_H

#include <CGAL/Protrusion_segmentation/Indexed_surface.h>
#include <CGAL/Protrusion_segmentation/internal/Distances/Any_distance.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Protrusion_segmentation {
namespace internal {

struct Tip_selection
{
  std::vector<Indexed_surface::Index> tips;
  std::size_t number_of_eliminated = 0;
};

// Section III.C: eq. (1), then eq. (2) until there are `count` plausible tips or no face is left at a
// distance from all tips. An implausible one is eliminated: it takes part in eq. (2) but does not count; so
// that a surface without plausible tips comes to an end, `count` eliminations end the selection.
// `visit(tip, distances from the tip)` is called for every tip, eliminated or not: one distance computation
// serves the selection and the histograms.
template <typename Plausible, typename Visit>
Tip_selection select_protrusion_tips(const Indexed_surface& surface,
                                     Distances_on_surface& distances,
                                     std::size_t count,
                                     Plausible is_plausible,
                                     Visit visit)
{
  using Index = Indexed_surface::Index;
  Tip_selection selection;
  Index face = count > 0 ? distances.face_of_largest_sum() : 0;
  std::vector<double> to_nearest_tip(surface.number_of_faces(), (std::numeric_limits<double>::max)());
  std::vector<double> from_tip;
  while (selection.tips.size() < count)
  {
    distances(face, from_tip);
    visit(face, from_tip);
    if (is_plausible(face))
      selection.tips.push_back(face);
    else if (++selection.number_of_eliminated == count)
      break;
    for (Index f = 0; f < surface.number_of_faces(); ++f)
      to_nearest_tip[f] = (std::min)(to_nearest_tip[f], from_tip[f]);
    face = static_cast<Index>(std::max_element(to_nearest_tip.begin(), to_nearest_tip.end()) -
                              to_nearest_tip.begin());
    if (to_nearest_tip[face] <= 0)
      break;
  }
  return selection;
}

// The same where every face is plausible.
inline std::vector<Indexed_surface::Index> select_protrusion_tips(const Indexed_surface& surface,
                                                                  Distances_on_surface& distances,
                                                                  std::size_t count)
{
  using Index = Indexed_surface::Index;
  return select_protrusion_tips(
           surface, distances, count, [](Index) { return true; },
           [](Index, const std::vector<double>&) {})
    .tips;
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

} // namespace internal
} // namespace Protrusion_segmentation
} // namespace CGAL

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_TIPS_SELECT_PROTRUSION_TIPS_H
