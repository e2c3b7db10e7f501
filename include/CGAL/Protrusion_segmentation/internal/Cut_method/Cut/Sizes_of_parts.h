// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_CUT_SIZES_OF_PARTS_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_CUT_SIZES_OF_PARTS_H

#include <CGAL/Protrusion_segmentation/internal/Cut_method/Cut/Cut.h>
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

  // The arguments must outlive the object. Linear time.
  Sizes_of_parts(const Dual_graph& graph, const Segment& segment)
    : m_graph(graph), m_segment(segment), m_total(segment.area), m_piece(graph.number_of_nodes(), no_piece)
  {
    for (Index i : segment.nodes)
      m_piece[i] = in_segment;
    for (Index i : segment.nodes)
      for (Index arc : graph.arcs(i))
      {
        if (m_piece[graph.target[arc]] == no_piece)
          add_piece(graph.target[arc]);
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
  static constexpr Index no_piece = (std::numeric_limits<Index>::max)(), in_segment = no_piece - 1;

  static bool are_nearly_equal(double log_area, double other)
  {
    constexpr double largest_difference = 0.45; // three deviations of parts that are alike
    return std::abs(log_area - other) < largest_difference;
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

  // Makes the nodes outside of the segment that are connected to one a piece.
  void add_piece(Index seed)
  {
    const Index piece = static_cast<Index>(m_areas.size());
    Nodes nodes(1, seed);
    m_piece[seed] = piece;
    for (std::size_t k = 0; k < nodes.size(); ++k)
      for (Index arc : m_graph.arcs(nodes[k]))
        if (const Index j = m_graph.target[arc]; m_piece[j] == no_piece)
        {
          m_piece[j] = piece;
          nodes.push_back(j);
        }
    m_areas.push_back(m_graph.area_of(nodes));
    m_total += m_areas.back();
    m_contacts.push_back(0);
  }

  void count(Index arc, std::vector<std::size_t>& contacts) const
  {
    if (const Index piece = m_piece[m_graph.target[arc]]; piece != in_segment)
      ++contacts[piece];
  }

  const Dual_graph& m_graph;
  const Segment& m_segment;
  double m_total;                      // area of all that the segment is connected to
  std::vector<Index> m_piece;          // of every node
  std::vector<double> m_areas;         // of the pieces of the rest,
  std::vector<std::size_t> m_contacts; // and the arcs to each from the segment
};

} // namespace CGAL::Protrusion_segmentation::internal

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_CUT_SIZES_OF_PARTS_H
