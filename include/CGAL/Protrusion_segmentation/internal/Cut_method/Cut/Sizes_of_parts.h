// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_CUT_SIZES_OF_PARTS_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_CUT_SIZES_OF_PARTS_H

#include <CGAL/Protrusion_segmentation/internal/Cut_method/Cut/Cut.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Cut/Cut_weights.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Graph/Dual_graph.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Graph/Graph_partition.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL::Protrusion_segmentation::internal {

// The sizes of the parts that cuts of one segment separate. A part is the smaller side of a cut in the whole component, with what
// earlier cuts took off that side: a leg without its foot is still like the other leg, and the hips between two legs
// are no part.
class Sizes_of_parts
{
public:
  using Index = Dual_graph::Index;

  // Selects the segment. The graph of the partition, the weights and the segment must outlive the object. Linear time.
  Sizes_of_parts(Graph_partition& partition, const Cut_weights& weights, const Segment& segment)
    : m_graph(partition.graph()),
      m_weights(weights),
      m_segment(segment),
      m_total(segment.area),
      m_piece(m_graph.number_of_nodes(), no_piece)
  {
    partition.select(segment);
    const auto is_rest = [&](Index i) { return !partition.is_selected(i); };
    for (Index i : segment.nodes)
      for (Index arc : m_graph.arcs(i))
      {
        const Index j = m_graph.target[arc];
        if (is_rest(j) && m_piece[j] == no_piece)
          add_piece(partition.connected_nodes(j, is_rest));
        count(arc, m_contacts);
      }
  }

  // Measures the parts of some cuts of the segment.
  void operator()(std::vector<Cut>& cuts) const
  {
    std::vector<Nodes> parts; // as far as they lie in the segment
    for (Cut& cut : cuts)
      parts.push_back(measure(cut) ? cut.inner : other_side(m_segment, cut.inner));
    for (std::size_t i = 0; i < cuts.size(); ++i)
      for (std::size_t j = 0; j < cuts.size(); ++j)
        if (cuts[j].log_odds > cuts[i].log_odds && are_nearly_equal(cuts[i].size.area, cuts[j].size.area) &&
            !are_disjoint(parts[i], parts[j]))
          cuts[i].size.is_repeated = true;
  }

private:
  static constexpr Index no_piece = (std::numeric_limits<Index>::max)(); // in the segment

  // What differs by more says nothing for each other.
  bool are_nearly_equal(double log_area, double other) const
  {
    constexpr double largest_difference = 3; // in deviations of parts that are alike
    return std::abs(log_area - other) < largest_difference * m_weights.deviation_of_like_part;
  }

  // Whether the part is on the inner side.
  bool measure(Cut& cut) const
  {
    std::vector<std::size_t> contacts(m_areas.size(), 0);
    for (Index i : cut.inner)
      for (Index arc : m_graph.arcs(i))
        count(arc, contacts);
    const auto is_next_to = [&](bool inner, std::size_t p) { return contacts[p] == (inner ? m_contacts[p] : 0); };
    const double inner_area = m_graph.area_of(cut.inner);
    double inside = inner_area, outside = m_segment.area - inner_area;
    for (std::size_t p = 0; p < m_areas.size(); ++p)
    {
      inside += is_next_to(true, p) ? m_areas[p] : 0;
      outside += is_next_to(false, p) ? m_areas[p] : 0;
    }
    const bool is_inner = inside <= outside;
    const double log_area = std::log((std::min)(inside, outside));
    bool is_repeated = false; // by an earlier cut that is beyond this one, or before it
    for (std::size_t p = 0; p < m_areas.size(); ++p)
    {
      const double rest = m_total - m_areas[p];
      is_repeated = is_repeated || (is_next_to(m_areas[p] <= rest ? is_inner : !is_inner, p) &&
                                    are_nearly_equal(std::log((std::min)(m_areas[p], rest)), log_area));
    }
    cut.size = {log_area, cut.clues.relative_length + std::log(inner_area) / 2, cut.clues.thickness, is_repeated};
    return is_inner;
  }

  void add_piece(const Nodes& nodes)
  {
    for (Index i : nodes)
      m_piece[i] = static_cast<Index>(m_areas.size());
    m_areas.push_back(m_graph.area_of(nodes));
    m_total += m_areas.back();
    m_contacts.push_back(0);
  }

  void count(Index arc, std::vector<std::size_t>& contacts) const
  {
    if (const Index piece = m_piece[m_graph.target[arc]]; piece != no_piece)
      ++contacts[piece];
  }

  const Dual_graph& m_graph;
  const Cut_weights& m_weights;
  const Segment& m_segment;
  double m_total;                      // area of all that the segment is connected to
  std::vector<Index> m_piece;          // of every node
  std::vector<double> m_areas;         // of the pieces of the rest,
  std::vector<std::size_t> m_contacts; // and the arcs to each from the segment
};

} // namespace CGAL::Protrusion_segmentation::internal

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_CUT_SIZES_OF_PARTS_H
