// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_CUT_LOCAL_CONNECTIVITY_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_CUT_LOCAL_CONNECTIVITY_H

#include <CGAL/Protrusion_segmentation/Indexed_surface.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Graph/Graph_partition.h>
#include <CGAL/Protrusion_segmentation/internal/Surface/Disjoint_sets.h>

#include <cstddef>
#include <vector>

namespace CGAL::Protrusion_segmentation::internal {

// Finds out that a side of a cut is connected without a walk over all of it, when some nodes have just changed sides.
//
// What was connected still is if the nodes around those that left are connected with each other, and with those that
// came: a path over nodes that left has a way around them. From all of these a front advances at the same time, until
// fronts have met so often that they are one, which takes a few steps where a border has moved.
class Local_connectivity
{
public:
  using Index = Graph_partition::Index;

  // The partition must outlive the object.
  explicit Local_connectivity(const Graph_partition& partition)
    : m_partition(partition), m_front(partition.graph().number_of_nodes(), none)
  {}

  // Whether a side of the selected segment, connected before the nodes `changed` went from it to the other one or came from there,
  // is seen to be connected. False says nothing.
  bool is_connected(bool inner, const Nodes& changed)
  {
    const bool has_old_node = begin(inner, changed);
    std::size_t number_of_fronts = m_queue.size();
    m_met.reset(m_queue.size());
    for (std::size_t k = 0; k < m_queue.size() && number_of_fronts > 1; ++k)
      for (Index arc : m_partition.graph().arcs(m_queue[k]))
      {
        const Index j = m_partition.graph().target[arc];
        if (!m_partition.is_on_side(j, inner))
          continue;
        if (m_front[j] == none)
          add(j, m_front[m_queue[k]]);
        else
          number_of_fronts -= join(m_front[j], m_front[m_queue[k]]);
      }
    for (Index i : m_queue)
      m_front[i] = none;
    return has_old_node && number_of_fronts == 1;
  }

private:
  static constexpr Index none = Indexed_surface::no_face();

  void add(Index node, Index front)
  {
    m_front[node] = front;
    m_queue.push_back(node);
  }

  // A front begins at every node of the side that changed, or is next to one that did. Returns whether a node was on the
  // side before.
  bool begin(bool inner, const Nodes& changed)
  {
    m_queue.clear();
    for (Index i : changed)
      if (m_partition.is_on_side(i, inner))
        add(i, static_cast<Index>(m_queue.size()));
    const std::size_t number_of_new = m_queue.size();
    for (Index i : changed)
      for (Index arc : m_partition.graph().arcs(i))
      {
        const Index j = m_partition.graph().target[arc];
        if (m_partition.is_on_side(j, inner) && m_front[j] == none)
          add(j, static_cast<Index>(m_queue.size()));
      }
    return m_queue.size() > number_of_new;
  }

  // Returns whether they were two.
  bool join(Index a, Index b)
  {
    a = m_met.find_set(a);
    b = m_met.find_set(b);
    if (a != b)
      m_met.link(a, b);
    return a != b;
  }

  const Graph_partition& m_partition;
  std::vector<Index> m_front; // that reached a node
  Nodes m_queue;
  Disjoint_sets m_met; // the fronts that have
};

} // namespace CGAL::Protrusion_segmentation::internal

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_CUT_LOCAL_CONNECTIVITY_H
