// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_COMPONENT_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_COMPONENT_H

#include <CGAL/Protrusion_segmentation/Execution.h>
#include <CGAL/Protrusion_segmentation/Indexed_surface.h>
#include <CGAL/Protrusion_segmentation/Protrusion.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Beam/Beam_search.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Beam/Segment_search.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Beam/cuts_of_tips.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Cut_options.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Graph/Graphs_of_surface.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Result/Component_segments.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Result/describe_protrusions.h>
#include <CGAL/Protrusion_segmentation/internal/Distances/Any_distance.h>
#include <CGAL/Protrusion_segmentation/internal/Execution/Next_segment.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL::Protrusion_segmentation::internal {

// A connected surface with all that is needed to search its cuts.
class Component
{
public:
  using Index = Indexed_surface::Index;

  // The arguments must outlive the object.
  Component(const Indexed_surface& surface,
            const std::optional<Any_distance>& distance,
            const Cut_options& options,
            Execution& execution)
    : m_surface(surface),
      m_options(options),
      m_execution(execution),
      m_graphs(surface, options, execution),
      m_search(surface, m_graphs, distance, options, execution),
      m_beam(m_graphs.coarse, m_search, options)
  {}
  Component(const Component&) = delete;
  Component& operator=(const Component&) = delete;

  const Graphs_of_surface& graphs() const { return m_graphs; }
  const Segment_memo& memo() const { return m_beam.memo(); }
  std::size_t number_of_runs() const { return m_search.number_of_runs(); }

  // The best cuts into a number of segments; none if there are not as many.
  const Cut_set* best(std::size_t number_of_segments) { return m_beam.best(number_of_segments); }

  // The best sets into fewer segments.
  std::vector<const Cut_set*> coarser_than(const Cut_set& set)
  {
    std::vector<const Cut_set*> result;
    for (std::size_t number = set.segments.size(); number-- > 2;) // first the largest one, which moves the others in memory
      if (const Cut_set* coarser = m_beam.best(number))
        result.push_back(coarser);
    return result;
  }

  // What segment `number_of_segments` + 1 gains; nothing if there is none.
  std::optional<double> gain(std::size_t number_of_segments)
  {
    return m_beam.best(number_of_segments + 1)
             ? std::optional<double>(m_beam.gain(number_of_segments + 1))
             : std::nullopt;
  }

  std::size_t automatic_number()
  {
    return m_beam.automatic_number([this](std::size_t n) { return Next_segment(m_execution, n, std::nullopt); });
  }

  // The cuts of protrusions of picked tips. Where they are those of the best segmentation into some number of segments and a few
  // more, that is kept, and only the others get cuts. So the tips of a result give that result.
  Cut_set cuts_of_tips(const std::vector<Index>& faces)
  {
    constexpr std::size_t most_others = 10; // each takes another look at a segmentation
    for (std::size_t number = faces.size() + 1; number > 1 && number + most_others > faces.size();
         --number)
    {
      const Cut_set* set = m_beam.best(number);
      if (!set)
        continue;
      const std::vector<Index> tips = tips_of(*set);
      std::vector<Index> tips_first = faces;
      const auto end = std::stable_partition(
        tips_first.begin(), tips_first.end(),
        [&](Index f) { return std::find(tips.begin(), tips.end(), f) != tips.end(); });
      if (static_cast<std::size_t>(end - tips_first.begin()) == tips.size())
        return Tip_cuts(m_graphs, m_search, m_beam.memo(), m_execution)(*m_beam.best(1), *set,
                                                                        tips_first);
    }
    const Cut_set& whole = *m_beam.best(1);
    return Tip_cuts(m_graphs, m_search, m_beam.memo(), m_execution)(whole, whole, faces);
  }

private:
  std::vector<Index> tips_of(const Cut_set& set)
  {
    const Component_segments segments(m_graphs, memo(), set, m_options, m_execution);
    std::vector<Index> tips;
    for (const Protrusion<Index>& protrusion :
         Protrusion_describer(m_surface, m_graphs, segments, m_execution.is_parallel())())
      tips.push_back(protrusion.tip);
    return tips;
  }

  const Indexed_surface& m_surface;
  const Cut_options& m_options;
  Execution& m_execution;
  Graphs_of_surface m_graphs;
  Segment_search m_search;
  Beam_search m_beam;
};

} // namespace CGAL::Protrusion_segmentation::internal

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_COMPONENT_H
