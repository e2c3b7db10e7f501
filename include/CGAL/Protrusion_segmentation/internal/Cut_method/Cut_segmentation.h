// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_CUT_SEGMENTATION_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_CUT_SEGMENTATION_H

#include <CGAL/Protrusion_segmentation/Execution.h>
#include <CGAL/Protrusion_segmentation/Indexed_surface.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Component_cuts.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Component_segments.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Cut_policy.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/evident_number.h>
#include <CGAL/Protrusion_segmentation/internal/Distances/Any_distance.h>
#include <CGAL/Protrusion_segmentation/internal/Execution/Next_segment.h>
#include <CGAL/Protrusion_segmentation/internal/Segments/Nested_segments.h>
#include <CGAL/Protrusion_segmentation/internal/Surface/Canonical_surface.h>
#include <CGAL/Protrusion_segmentation/internal/Surface/extract_segment.h>
#include <CGAL/Protrusion_segmentation/internal/Tips/distinct_tips.h>

#include <algorithm>
#include <cstddef>
#include <deque>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Protrusion_segmentation {
namespace internal {

// Segments a surface by cuts. Every connected component is a surface of its own, with its own unit of length, so that
// it gets the same segments whatever lies beside it; with a number of segments given, each further one goes to the
// component where it gains most.
class Cut_segmentation
{
public:
  using Index = Indexed_surface::Index;

  // Without a distance, tips and level sets are those of the coarse graph itself. The arguments must outlive the
  // object, which segments once.
  Cut_segmentation(const Indexed_surface& surface,
                   const std::optional<Any_distance>& distance,
                   Execution& execution,
                   const Cut_policy& policy = default_cut_policy())
    : m_surface(surface), m_distance(distance), m_execution(execution), m_policy(policy), m_components(surface)
  {}

  Nested_segments with_number_of_segments(std::size_t k)
  {
    if (k <= m_components.number_of_components())
      return std::move(m_components); // there is nothing to be cut
    prepare();
    const Execution::Subtask subtask(m_execution, preparation_share, 1);
    std::vector<std::size_t> numbers(m_cuts.size(), 1);
    for (std::size_t n = m_cuts.size(); n < k; ++n)
    {
      const Next_segment progress(m_execution, n, k);
      std::optional<std::size_t> best;
      for (std::size_t c = 0; c < m_cuts.size(); ++c)
        if (m_cuts[c]->best(numbers[c] + 1) && (!best || gain(c, numbers[c]) > gain(*best, numbers[*best])))
          best = c;
      if (!best)
        break;
      ++numbers[*best];
    }
    for (std::size_t c = 0; c < m_cuts.size(); ++c)
      m_sets[c] = *m_cuts[c]->best(numbers[c]);
    return finish();
  }

  Nested_segments with_evident_protrusions()
  {
    prepare();
    const Execution::Subtask subtask(m_execution, preparation_share, 1);
    for (std::size_t c = 0; c < m_cuts.size(); ++c)
    {
      const Next_segment progress(m_execution, c, m_cuts.size());
      m_sets[c] = *m_cuts[c]->best(evident_number_of_segments(c));
    }
    return finish();
  }

  Nested_segments from_tips(const std::vector<Index>& given_tips)
  {
    prepare();
    const Execution::Subtask subtask(m_execution, preparation_share, 1);
    std::vector<std::vector<Index>> tips(m_cuts.size());
    for (Index tip : distinct_tips(m_surface, given_tips))
    {
      const Nested_segments::Faces& faces = m_components.faces(m_components.labels()[tip]);
      const auto position = std::lower_bound(faces.begin(), faces.end(), tip) - faces.begin();
      tips[m_components.labels()[tip]].push_back(static_cast<Index>(position));
    }
    for (std::size_t c = 0; c < m_cuts.size(); ++c)
    {
      const Next_segment progress(m_execution, c, m_cuts.size());
      m_sets[c] = m_cuts[c]->cuts_of_tips(m_surfaces.empty() ? tips[c] : m_surfaces[c].faces_at(tips[c]));
    }
    return finish();
  }

private:
  // Of the whole time, normals and coarse graphs take about that share.
  static constexpr double preparation_share = 0.5;

  void prepare()
  {
    const std::size_t n = m_components.number_of_components();
    std::optional<Face_selector<Indexed_surface>> select; // as large as the surface, which may be the only component
    if (n > 1)
      select.emplace(m_surface);
    for (std::size_t c = 0; c < n; ++c)
    {
      const Execution::Subtask subtask(m_execution, preparation_share * static_cast<double>(c) / static_cast<double>(n),
                                       preparation_share * static_cast<double>(c + 1) / static_cast<double>(n));
      if (n > 1)
        m_surfaces.push_back(surface_of_its_own((*select)(m_components.faces(c))));
      m_cuts.push_back(std::make_unique<Component_cuts>(n > 1 ? m_surfaces.back().surface() : m_surface, m_distance,
                                                        m_execution, m_policy));
    }
    m_sets.resize(n);
  }

  // What one segment more brings to a component.
  double gain(std::size_t c, std::size_t number)
  {
    return m_cuts[c]->best(number + 1)->value - m_cuts[c]->best(number)->value;
  }

  std::size_t evident_number_of_segments(std::size_t c)
  {
    return internal::evident_number_of_segments(
      [&](std::size_t number)
      {
        const Next_segment progress(m_execution, number, std::nullopt);
        return m_cuts[c]->best(number + 1, least_evident_value) ? std::optional<double>(gain(c, number)) : std::nullopt;
      });
  }

  // In the coordinates and the order of faces that a component has in a mesh of its own: sums are rounded alike then,
  // and ties decided alike.
  Canonical_surface surface_of_its_own(Surface_arrays arrays) const
  {
    return Canonical_surface(std::move(arrays), m_execution.is_parallel());
  }

  // The face of the whole surface for a face of a component.
  Index face_of_surface(std::size_t c, std::size_t face) const
  {
    return m_components.faces(c)[m_surfaces.empty() ? face : m_surfaces[c].positions()[face]];
  }

  // Puts the components together again: bodies first, then the protrusions of one component after the other.
  Nested_segments finish()
  {
    std::vector<Index> labels(m_surface.number_of_faces()), parents;
    for (Index c = 0; c < m_cuts.size(); ++c)
      parents.push_back(c);
    std::vector<Protrusion<Index>> protrusions;
    for (Index c = 0; c < m_cuts.size(); ++c)
    {
      const Stage_scope stage(m_execution.observer(), Stage::LABELS);
      const Component_segments segments(*m_cuts[c], m_sets[c], m_policy, m_execution);
      const Index first = static_cast<Index>(parents.size()) - 1; // plus the number of a protrusion
      const auto id = [first, c](std::size_t s) { return s == 0 ? c : static_cast<Index>(first + s); };
      for (std::size_t f = 0; f < segments.labels().size(); ++f)
        labels[face_of_surface(c, f)] = id(segments.labels()[f]);
      for (std::size_t s = 1; s < segments.number_of_segments(); ++s)
        parents.push_back(id(segments.parents()[s]));
      if (m_execution.observer().looks_at_protrusions())
        add_protrusions(c, segments, id, protrusions);
    }
    report(protrusions);
    return Nested_segments(std::move(labels), std::move(parents), m_cuts.size());
  }

  // Those of a component, in terms of the whole surface; `id(s)` is the number that a segment of the component has there.
  template <typename Id>
  void add_protrusions(Index c, const Component_segments& segments, Id id, std::vector<Protrusion<Index>>& protrusions) const
  {
    const double unit = m_surfaces.empty() ? 1 : m_surfaces[c].unit();
    for (Protrusion<Index>& protrusion : segments.protrusions())
    {
      protrusion.tip = face_of_surface(c, protrusion.tip);
      protrusion.border_distance *= unit;
      protrusion.border_length *= unit;
      protrusion.area *= unit * unit;
      protrusion.segment = id(protrusion.segment);
      protrusion.parent = id(protrusion.parent);
      protrusions.push_back(std::move(protrusion));
    }
  }

  void report(const std::vector<Protrusion<Index>>& protrusions)
  {
    for (const auto& cuts : m_cuts)
      m_execution.observer().distances_computed(cuts->number_of_runs());
    for (const Protrusion<Index>& protrusion : protrusions)
    {
      m_execution.observer().tip_selected(protrusion.tip);
      m_execution.observer().protrusion_found(protrusion);
    }
  }

  const Indexed_surface& m_surface;
  const std::optional<Any_distance>& m_distance;
  Execution& m_execution;
  const Cut_policy& m_policy;
  Nested_segments m_components;
  std::deque<Canonical_surface> m_surfaces;           // of the components, if there are several
  std::vector<std::unique_ptr<Component_cuts>> m_cuts; // of the components
  std::vector<Cut_set> m_sets;                        // of the components, as chosen
};

} // namespace internal
} // namespace Protrusion_segmentation
} // namespace CGAL

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_CUT_SEGMENTATION_H
