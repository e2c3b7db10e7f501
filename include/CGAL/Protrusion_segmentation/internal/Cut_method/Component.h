// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_COMPONENT_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_COMPONENT_H

#include <CGAL/Protrusion_segmentation/Execution.h>
#include <CGAL/Protrusion_segmentation/Indexed_surface.h>
#include <CGAL/Protrusion_segmentation/Protrusion.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Cut_options.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Graph/Graph_partition.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Graph/Graphs_of_surface.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Result/Component_segments.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Result/describe_protrusions.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Search/Greedy_search.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Search/Segment_search.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Search/cuts_of_tips.h>
#include <CGAL/Protrusion_segmentation/internal/Distances/Any_distance.h>
#include <CGAL/Protrusion_segmentation/internal/Execution/Next_segment.h>
#include <CGAL/Protrusion_segmentation/internal/Segments/subtree.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>
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
      m_divided(Face_divider(surface)()),
      m_graphs(searched_surface(), options, execution),
      m_search(searched_surface(), m_graphs, distance, options, execution),
      m_greedy(m_graphs.coarse, m_search, options)
  {
    if (!m_divided)
      return;
    Dual_graph_maker{surface}(m_undivided, execution.is_parallel());
    m_undivided.curvature.assign(m_undivided.target.size(), 0);
  }
  Component(const Component&) = delete;
  Component& operator=(const Component&) = delete;

  // of the pieces if there are long faces
  const Graphs_of_surface& graphs() const { return m_graphs; }
  const Seam_graph& graph_of_faces() const { return m_divided ? m_undivided : m_graphs.fine; }
  // the node of the coarse graph that a face, or its first piece, lies in
  Index node_at(Index face) const { return m_graphs.node_of_face[searched_face(face)]; }
  const Segment_memo& memo() const { return m_greedy.memo(); }
  const Segment_search& search() const { return m_search; }
  std::size_t number_of_runs() const { return m_search.number_of_runs(); }

  // The best cuts into a number of segments; none if there are not as many.
  const Cut_set* best(std::size_t number_of_segments)
  {
    return number_of_segments <= m_surface.number_of_faces() ? m_greedy.best(number_of_segments) : nullptr;
  }

  // The best cuts into a given number of segments, which there are. Many small parts, such as spines, hide the large ones from
  // the search until they are cut off: the most valuable cuts of the automatic segmentation may be worth more.
  Cut_set cuts_into(std::size_t number_of_segments)
  {
    if (number_of_segments > 1 && m_greedy.knew_more_sure_cuts_than(number_of_segments))
      if (const std::size_t automatic = automatic_number(); automatic > number_of_segments)
        if (Cut_set found = most_valuable_cuts(*m_greedy.best(automatic), number_of_segments - 1);
            found.segments.size() == number_of_segments && found.value > m_greedy.best(number_of_segments)->value)
          return found;
    return *m_greedy.best(number_of_segments);
  }

  // The segments of a set on the faces.
  Component_segments segments(const Cut_set& set) const
  {
    return Component_segments(faces_of_surface(), m_graphs, memo(), set, m_options, m_execution);
  }
  std::vector<Protrusion<Index>> describe(const Component_segments& segments) const
  {
    return Protrusion_describer(m_surface, graph_of_faces(), segments, m_execution.is_parallel())();
  }

  // What segment `number_of_segments` + 1 gains; nothing if there is none.
  std::optional<double> gain_of_next(std::size_t number_of_segments)
  {
    return best(number_of_segments + 1)
             ? std::optional<double>(m_greedy.gain_of_last(number_of_segments + 1))
             : std::nullopt;
  }

  std::size_t automatic_number()
  {
    const std::size_t number = m_greedy.automatic_number([this](std::size_t n) { return Next_segment(m_execution, n, std::nullopt); });
    return (std::min)(number, static_cast<std::size_t>(m_surface.number_of_faces()));
  }

  // The cuts of protrusions of picked tips. Tips that have a cut in a known segmentation keep it, and only the others get cuts.
  Cut_set cuts_of_tips(const std::vector<Index>& faces)
  {
    std::vector<Index> tips = faces;
    const Cut_set kept = known_cuts(tips);
    tips.resize((std::min)(tips.size(), static_cast<std::size_t>(m_surface.number_of_faces() - 1))); // the body has a face, too
    for (Index& tip : tips)
      tip = searched_face(tip);
    return Tip_cuts(m_graphs, m_search, m_greedy.memo(), m_execution)(*m_greedy.best(1), kept, tips);
  }

private:
  const Indexed_surface& searched_surface() const { return m_divided ? m_divided->surface : m_surface; }
  Faces_of_surface faces_of_surface() const { return {graph_of_faces(), m_divided ? &*m_divided : nullptr}; }
  Index searched_face(Index face) const { return m_divided ? m_divided->first_piece(face) : face; }

  // The cuts of a known segmentation if the tips of all its protrusions are picked, and at most a quarter more: the tips of a
  // result give that result. Else those of the automatic one. Puts the tips that have a cut first.
  Cut_set known_cuts(std::vector<Index>& tips)
  {
    for (std::size_t number = tips.size() + 1; number > 1 && 4 * (number - 1) >= 3 * tips.size(); --number)
      if (best(number))
      {
        const Cut_set found = cuts_into(number);
        const std::vector<Index> own = tips_of(found);
        std::vector<Index> tips_first = tips;
        const auto end = std::stable_partition(tips_first.begin(), tips_first.end(), [&](Index f)
                                               { return std::find(own.begin(), own.end(), f) != own.end(); });
        if (static_cast<std::size_t>(end - tips_first.begin()) == own.size())
        {
          tips = std::move(tips_first);
          return found;
        }
      }
    return tips.empty() ? *m_greedy.best(1) : cuts_of_automatic_segments(tips);
  }

  // The automatic segmentation, where the segments without tips belong to what they stick out of.
  Cut_set cuts_of_automatic_segments(std::vector<Index>& tips)
  {
    const Component_segments segments = this->segments(*m_greedy.best(automatic_number()));
    const std::vector<Protrusion<Index>> protrusions = describe(segments);
    const auto segment_of = [&](Index tip) // the end of a protrusion may lie in another one that sticks out of it
    {
      const auto found = std::find_if(protrusions.begin(), protrusions.end(), [&](const auto& p) { return p.tip == tip; });
      return found == protrusions.end() ? segments.labels()[tip] : static_cast<Index>(found->segment);
    };
    Cut_set result = *m_greedy.best(1);
    std::vector<Index> with_cut, others;
    std::vector<bool> has_tip(segments.number_of_segments(), false);
    has_tip[0] = true; // the body has no cut
    for (Index tip : tips)
    {
      const Index s = segment_of(tip);
      const bool has_cut = !has_tip[s] && cut_off(result, segments, s);
      (has_cut ? with_cut : others).push_back(tip);
      has_tip[s] = true;
    }
    tips = std::move(with_cut);
    tips.insert(tips.end(), others.begin(), others.end());
    return result;
  }

  // Of the cuts of a set, as many as can be made. Each cuts a part with all that sticks out of it off. Borders stay between nodes.
  Cut_set most_valuable_cuts(const Cut_set& set, std::size_t number_of_cuts)
  {
    Cut_options options = m_options;
    options.moves_borders_on_faces = false;
    const Component_segments segments(faces_of_surface(), m_graphs, memo(), set, options, m_execution);
    Cut_set result = *m_greedy.best(1);
    for (Index s = 1; s <= number_of_cuts; ++s) // the most valuable ones are first
      cut_off(result, segments, s);
    return result;
  }

  // Cuts a segment and all that sticks out of it, as far as they are there, off one of the set's. Both sides are made connected: long
  // faces join segments whose pieces do not touch. Returns whether something is left of the other.
  bool cut_off(Cut_set& set, const Component_segments& segments, Index segment)
  {
    const std::vector<bool> is_beyond = subtree(segment, segments.parents());
    std::vector<bool> is_inner(m_graphs.coarse.number_of_nodes(), false);
    for (Index s = 0; s < segments.number_of_segments(); ++s)
      if (is_beyond[s])
        for (Index node : memo()[segments.segments_of_memo()[s]].segment.nodes)
          is_inner[node] = true;
    const Index id = memo().segment_with(memo()[segments.segments_of_memo()[segment]].segment.nodes.front(), set);
    const Segment& from = memo()[id].segment;
    Nodes inner;
    for (Index node : from.nodes)
      if (is_inner[node])
        inner.push_back(node);
    if (inner.size() == from.nodes.size())
      return false;
    Graph_partition partition(m_graphs.coarse);
    partition.select(from);
    set = set.with(m_greedy.memo().made_cut(id, partition.connect_sides(from.nodes, inner), *segments.cut(segment)));
    return true;
  }

  std::vector<Index> tips_of(const Cut_set& set)
  {
    std::vector<Index> tips;
    for (const Protrusion<Index>& protrusion : describe(segments(set)))
      tips.push_back(protrusion.tip);
    return tips;
  }

  const Indexed_surface& m_surface;
  const Cut_options& m_options;
  Execution& m_execution;
  std::optional<Divided_surface> m_divided; // if there are long faces,
  Seam_graph m_undivided;                   // and the faces themselves then, without seams
  Graphs_of_surface m_graphs;               // of the pieces then
  Segment_search m_search;
  Greedy_search m_greedy;
};

} // namespace CGAL::Protrusion_segmentation::internal

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_COMPONENT_H
