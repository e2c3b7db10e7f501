// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_CUT_SEGMENTATION_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_CUT_SEGMENTATION_H

#include <CGAL/Protrusion_segmentation/Execution.h>
#include <CGAL/Protrusion_segmentation/Indexed_surface.h>
#include <CGAL/Protrusion_segmentation/Protrusion.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Component.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Cut_options.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Result/Component_segments.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Result/describe_protrusions.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Search/Segment_memo.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/share_out_segments.h>
#include <CGAL/Protrusion_segmentation/internal/Distances/Any_distance.h>
#include <CGAL/Protrusion_segmentation/internal/Execution/for_each_side_by_side.h>
#include <CGAL/Protrusion_segmentation/internal/Segments/Nested_segments.h>
#include <CGAL/Protrusion_segmentation/internal/Surface/Canonical_surface.h>
#include <CGAL/Protrusion_segmentation/internal/Surface/extract_segment.h>
#include <CGAL/Protrusion_segmentation/internal/Surface/is_convex.h>
#include <CGAL/Protrusion_segmentation/internal/Tips/select_protrusion_tips.h>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Protrusion_segmentation::internal {

// Segments a surface by cuts. Every connected component is a surface of its own, with its own unit of length, so that
// it gets the same segments whatever lies beside it; with a number of segments given, each further one goes to the
// component where it gains most.
class Cut_segmentation
{
public:
  using Index = Indexed_surface::Index;

  // Without a distance, tips and level sets are those of the coarse graph. The arguments must outlive the object, which
  // segments once.
  Cut_segmentation(const Indexed_surface& surface,
                   const std::optional<Any_distance>& distance,
                   Execution& execution,
                   const Cut_options& options = {})
    : m_surface(surface),
      m_distance(distance),
      m_execution(execution),
      m_options(options),
      m_looks_at_protrusions(execution.observer().looks_at_protrusions()),
      m_components(surface),
      m_labels(surface.number_of_faces())
  {
    if (m_components.number_of_components() > 1)
      m_select.emplace(surface);
  }

  // As many as there are if there are fewer.
  Nested_segments with_number_of_segments(std::size_t k)
  {
    const std::size_t n = m_components.number_of_components();
    if (k <= n)
      return std::move(m_components); // there is nothing to be cut
    std::vector<Loaded> loaded(n);
    for (std::size_t c = 0; c < n; ++c)
    {
      const Execution::Subtask subtask(m_execution, share(c, n) / 2, share(c + 1, n) / 2);
      loaded[c].load_surface(*this, c, m_execution);
      loaded[c].load_component(*this, m_execution);
    }
    const Execution::Subtask subtask(m_execution, 0.5, 1);
    std::vector<Component*> components;
    for (const Loaded& one : loaded)
      components.push_back(one.component.get());
    const std::vector<std::size_t> numbers = share_out_segments(components, k, m_execution);
    std::vector<Found> found;
    for (std::size_t c = 0; c < n; ++c)
    {
      found.push_back(find_segments(c, loaded[c], loaded[c].component->cuts_into(numbers[c]), m_execution));
      loaded[c] = Loaded(); // its memory is needed no more
    }
    return together(std::move(found));
  }

  Nested_segments with_automatic_number()
  {
    return each_by_itself([this](const Loaded& loaded, std::size_t) { return is_convex(loaded.surface(*this)); },
                          [](Loaded& loaded, std::size_t)
                          { return *loaded.component->best(loaded.component->automatic_number()); });
  }

  Nested_segments from_tips(const std::vector<Index>& given_tips)
  {
    std::vector<std::vector<Index>> tips(m_components.number_of_components());
    for (Index tip : distinct_tips(m_surface, given_tips))
    {
      const Nested_segments::Faces& faces = m_components.faces(m_components.labels()[tip]);
      const auto position = std::lower_bound(faces.begin(), faces.end(), tip) - faces.begin();
      tips[m_components.labels()[tip]].push_back(static_cast<Index>(position));
    }
    return each_by_itself([&](const Loaded&, std::size_t c) { return tips[c].empty(); },
                          [&](Loaded& loaded, std::size_t c)
                          { return loaded.component->cuts_of_tips(loaded.own ? loaded.own->faces_at(tips[c]) : tips[c]); });
  }

private:
  static double share(std::size_t i, std::size_t n) { return static_cast<double>(i) / static_cast<double>(n); }

  // A component while it is segmented.
  struct Loaded
  {
    // In the coordinates and the order of faces that it has in a mesh of its own, if there are several: sums are rounded
    // alike then, and ties decided alike.
    std::unique_ptr<Canonical_surface> own;
    std::unique_ptr<Component> component;

    const Indexed_surface& surface(const Cut_segmentation& all) const { return own ? own->surface() : all.m_surface; }
    void load_surface(Cut_segmentation& all, std::size_t c, Execution& execution)
    {
      if (all.m_select)
        own = std::make_unique<Canonical_surface>(all.select(c), execution.is_parallel());
    }
    void load_component(const Cut_segmentation& all, Execution& execution)
    {
      component = std::make_unique<Component>(surface(all), all.m_distance, all.m_options, execution);
    }
  };

  // What is kept of a component. Its segments have numbers of their own, faces are those of the whole surface.
  struct Found
  {
    std::vector<Index> parents = {0};
    std::vector<double> values = {}; // of the cuts of the protrusions: that of segment s + 1 is s
    std::vector<Protrusion<Index>> protrusions = {};
    std::size_t number_of_runs = 0;
  };

  Surface_arrays select(std::size_t c)
  {
    const std::lock_guard<std::mutex> lock(m_selecting);
    return (*m_select)(m_components.faces(c));
  }

  // Each component is finished before the next one, so that memory is that of the largest one: large ones first, which several
  // threads share, then small ones, each of which has a thread. `is_whole(loaded, c)`: whether a component needs no search;
  // `cuts(loaded, c)`: its cuts
  template <typename IsWhole, typename Cuts>
  Nested_segments each_by_itself(IsWhole is_whole, Cuts cuts)
  {
    const std::size_t n = m_components.number_of_components();
    std::vector<Found> found(n);
    std::vector<std::size_t> side_by_side;
    std::size_t done = 0;
    for (std::size_t c = 0; c < n; ++c)
      if (is_small(c))
        side_by_side.push_back(c);
      else
      {
        const Execution::Subtask subtask(m_execution, share(done, n), share(done + 1, n));
        found[c] = find_segments(c, is_whole, cuts, m_execution);
        ++done;
      }
    const Execution::Subtask subtask(m_execution, share(done, n), 1);
    for_each_side_by_side(side_by_side.size(), m_execution, [&](std::size_t i, Execution& execution)
                          { found[side_by_side[i]] = find_segments(side_by_side[i], is_whole, cuts, execution); });
    return together(std::move(found));
  }

  // Whether other components keep the other threads busy meanwhile. Distances of the user's are used by one thread at a time.
  bool is_small(std::size_t c) const
  {
    constexpr std::size_t least_number_beside = 16; // as many threads at least have work
    return m_execution.is_parallel() && !m_distance &&
           least_number_beside * m_components.faces(c).size() <= m_labels.size();
  }

  template <typename IsWhole, typename Cuts>
  Found find_segments(std::size_t c, IsWhole is_whole, Cuts cuts, Execution& execution)
  {
    Loaded loaded;
    {
      const Execution::Subtask preparation(execution, 0, 0.5);
      loaded.load_surface(*this, c, execution);
      if (is_whole(loaded, c))
        return {};
      loaded.load_component(*this, execution);
    }
    const Execution::Subtask search(execution, 0.5, 1);
    return find_segments(c, loaded, cuts(loaded, c), execution);
  }

  // Labels the faces of a component.
  Found find_segments(std::size_t c, const Loaded& loaded, const Cut_set& set, Execution& execution)
  {
    const Stage_scope stage(execution.observer(), Stage::LABELS);
    const Component_segments segments = loaded.component->segments(set);
    for (std::size_t f = 0; f < segments.labels().size(); ++f)
      m_labels[face_of_surface(c, loaded, f)] = segments.labels()[f];
    Found found = {segments.parents(), {}, {}, loaded.component->number_of_runs()};
    for (std::size_t s = 1; s < segments.number_of_segments(); ++s)
      found.values.push_back(segments.cut(s)->value);
    if (m_looks_at_protrusions && segments.number_of_segments() > 1)
      found.protrusions = protrusions(c, loaded, segments);
    return found;
  }

  // The face of the whole surface for a face of a component.
  Index face_of_surface(std::size_t c, const Loaded& loaded, std::size_t face) const
  {
    return m_components.faces(c)[loaded.own ? loaded.own->positions()[face] : face];
  }

  // Those of a component, on the whole surface.
  std::vector<Protrusion<Index>> protrusions(std::size_t c, const Loaded& loaded, const Component_segments& segments) const
  {
    const double unit = loaded.own ? loaded.own->unit() : 1;
    std::vector<Protrusion<Index>> result = loaded.component->describe(segments);
    for (Protrusion<Index>& protrusion : result)
    {
      protrusion.tip = face_of_surface(c, loaded, protrusion.tip);
      protrusion.border_distance *= unit;
      protrusion.border_length *= unit;
      protrusion.area *= unit * unit;
    }
    return result;
  }

  // Puts the components together again, whose segments still have their own numbers.
  Nested_segments together(std::vector<Found> found)
  {
    const std::vector<std::vector<Index>> ids = ids_of_segments(found);
    std::size_t number_of_segments = 0;
    for (const Found& one : found)
      number_of_segments += one.parents.size();
    std::vector<Index> parents(number_of_segments);
    std::vector<Protrusion<Index>> protrusions;
    for (std::size_t c = 0; c < ids.size(); ++c)
    {
      m_execution.observer().distances_computed(found[c].number_of_runs);
      for (Index f : m_components.faces(c))
        m_labels[f] = ids[c][m_labels[f]];
      for (std::size_t s = 0; s < ids[c].size(); ++s)
        parents[ids[c][s]] = ids[c][found[c].parents[s]];
      for (Protrusion<Index>& protrusion : found[c].protrusions)
      {
        protrusion.segment = ids[c][protrusion.segment];
        protrusion.parent = ids[c][protrusion.parent];
        protrusions.push_back(std::move(protrusion));
      }
    }
    std::sort(protrusions.begin(), protrusions.end(), [](const auto& a, const auto& b) { return a.segment < b.segment; });
    for (const Protrusion<Index>& protrusion : protrusions)
    {
      m_execution.observer().tip_selected(protrusion.tip);
      m_execution.observer().protrusion_found(protrusion);
    }
    return Nested_segments(std::move(m_labels), std::move(parents), ids.size());
  }

  // Of every component: the bodies first, then the protrusions of all, the most valuable ones first, as in each.
  static std::vector<std::vector<Index>> ids_of_segments(const std::vector<Found>& found)
  {
    std::vector<std::vector<Index>> ids(found.size());
    std::vector<std::pair<double, std::size_t>> values;
    for (std::size_t c = 0; c < found.size(); ++c)
    {
      ids[c].push_back(static_cast<Index>(c));
      for (double value : found[c].values)
        values.emplace_back(value, c);
    }
    std::stable_sort(values.begin(), values.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
    for (std::size_t i = 0; i < values.size(); ++i)
      ids[values[i].second].push_back(static_cast<Index>(found.size() + i));
    return ids;
  }

  const Indexed_surface& m_surface;
  const std::optional<Any_distance>& m_distance;
  Execution& m_execution;
  Cut_options m_options;
  bool m_looks_at_protrusions;
  Nested_segments m_components;
  std::optional<Face_selector<Indexed_surface>> m_select; // if there are several components;
  std::mutex m_selecting;                                 // it has work arrays
  std::vector<Index> m_labels; // of every face
};

} // namespace CGAL::Protrusion_segmentation::internal

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_CUT_SEGMENTATION_H
