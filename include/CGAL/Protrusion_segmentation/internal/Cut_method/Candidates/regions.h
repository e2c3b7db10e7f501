// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_CANDIDATES_REGIONS_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_CANDIDATES_REGIONS_H

#include <CGAL/Protrusion_segmentation/internal/Cut_method/Cut_options.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Graph/Graph_partition.h>

#include <boost/container/flat_map.hpp>

#include <algorithm>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL::Protrusion_segmentation::internal {

// Connected nodes with a cheap border: `number_of_nodes` nodes in `Merged_regions::order` from `first` on.
struct Region
{
  double relative_cost = (std::numeric_limits<double>::infinity)();
  Dual_graph::Index first = 0;
  Dual_graph::Index number_of_nodes = 0;
};

struct Merged_regions
{
  Nodes order; // the nodes of the segment
  std::vector<Region> regions;  // the cheapest first
};

// Merges the nodes of a segment two by two, those with the largest affinity for the size of the smaller one first, until all
// are one. Merging crosses seams last, so the regions left then are bounded by seams, wherever the tips are: the fin of a
// fish, which is wide and low, is no level set of any distance. As in `Level_set_sweep`, the best region in each branch of the
// tree of mergers is kept.
class Region_merger
{
public:
  using Index = Dual_graph::Index;

  // The graph must outlive the object.
  explicit Region_merger(const Seam_graph& graph) : m_graph(graph), m_number(graph.number_of_nodes()) {}

  // Of the selected segment of a partition.
  Merged_regions operator()(const Graph_partition& partition, const Segment& segment)
  {
    m_segment_area = segment.area;
    m_result = {};
    add_clusters(partition, segment.nodes);
    while (!m_queue.empty())
    {
      const Pair pair = m_queue.top();
      m_queue.pop();
      if (!are_neighbors(pair.a, pair.b))
        continue; // one of them has become part of another cluster
      const double now = strength(pair.a, pair.b);
      if (now < pair.strength) // they have grown since
        m_queue.push({now, pair.a, pair.b});
      else
        merge(pair.a, pair.b);
    }
    return finish(segment.nodes);
  }

private:
  struct Cluster
  {
    double area, cost;                            // the latter of the cut around it
    boost::container::flat_map<Index, double> affinity; // to each of its neighbours
    Index last;                                   // of its nodes, a list that begins with the cluster's own number
    Index number_of_nodes;
    Region best; // since the last merger of two that count; `first` is a number
  };

  // of neighbours, the first with the lower number
  struct Pair
  {
    double strength;
    Index a, b;

    bool operator<(const Pair& other) const
    {
      return strength != other.strength ? strength < other.strength
                                        : std::make_pair(a, b) > std::make_pair(other.a, other.b);
    }
  };

  void add_clusters(const Graph_partition& partition, const Nodes& nodes)
  {
    for (Index i = 0; i < nodes.size(); ++i)
      m_number[nodes[i]] = i;
    m_clusters.resize((std::max)(m_clusters.size(), nodes.size())); // their affinities keep their memory
    m_next.assign(nodes.size(), no_node);
    for (Index i = 0; i < nodes.size(); ++i)
    {
      Cluster& cluster = m_clusters[i];
      cluster.area = m_graph.area[nodes[i]];
      cluster.cost = 0;
      cluster.last = i;
      cluster.number_of_nodes = 1;
      cluster.best = {};
      cluster.affinity.clear();
      cluster.affinity.reserve(m_graph.arcs(nodes[i]).size());
      for (Index arc : m_graph.arcs(nodes[i]))
        if (partition.is_selected(m_graph.target[arc]))
        {
          cluster.affinity[m_number[m_graph.target[arc]]] += m_graph.capacity[arc];
          cluster.cost += m_graph.capacity[arc];
        }
    }
    for (Index i = 0; i < nodes.size(); ++i)
      for (const auto& neighbor : m_clusters[i].affinity)
        if (i < neighbor.first)
          offer(i, neighbor.first);
  }

  bool are_neighbors(Index a, Index b) const { return m_clusters[a].affinity.count(b) > 0; }

  // While the smaller one grows, this becomes less, unless they get more border in common.
  double strength(Index a, Index b) const
  {
    constexpr double least_area = (std::numeric_limits<double>::min)(); // of what is collapsed to a point
    const double area = (std::min)(m_clusters[a].area, m_clusters[b].area);
    return cost_for_area(m_clusters[a].affinity.at(b), (std::max)(least_area, area));
  }
  void offer(Index a, Index b)
  {
    m_queue.push({strength(a, b), (std::min)(a, b), (std::max)(a, b)});
  }

  // The one with more neighbours takes the other one in, so that few have to be told.
  void merge(Index a, Index b)
  {
    if (m_clusters[a].affinity.size() < m_clusters[b].affinity.size())
      std::swap(a, b);
    Cluster& to = m_clusters[a];
    Cluster& from = m_clusters[b];
    const Region best = best_of_both(to, from);
    to.cost += from.cost - 2 * to.affinity[b];
    to.area += from.area;
    to.number_of_nodes += from.number_of_nodes;
    m_next[to.last] = b;
    to.last = from.last;
    to.best = best;
    const double cost = relative_cost(to.cost, to.area, m_segment_area);
    if (cost < to.best.relative_cost)
      to.best = {cost, a, to.number_of_nodes};
    move_affinities(a, b);
  }

  // Where two that count meet, two branches end.
  Region best_of_both(const Cluster& a, const Cluster& b)
  {
    const bool a_counts = a.area >= least_area_of_segment, b_counts = b.area >= least_area_of_segment;
    if (!a_counts || !b_counts)
      return a.area < b.area ? b.best : a.best;
    for (const Cluster* cluster : {&a, &b})
      add(cluster->best);
    return {};
  }

  void add(const Region& region)
  {
    if (region.relative_cost < (std::numeric_limits<double>::infinity)())
      m_result.regions.push_back(region);
  }

  void move_affinities(Index a, Index b)
  {
    boost::container::flat_map<Index, double>& affinities = m_clusters[b].affinity;
    affinities.erase(a);
    m_clusters[a].affinity.erase(b);
    for (const auto& [neighbor, affinity] : affinities)
    {
      m_clusters[a].affinity[neighbor] += affinity;
      m_clusters[neighbor].affinity.erase(b);
      m_clusters[neighbor].affinity[a] += affinity;
      offer(a, neighbor);
    }
    affinities.clear();
  }

  // Clusters have become nodes of one list, or of several if the segment is not connected.
  Merged_regions finish(const Nodes& nodes)
  {
    std::vector<Index> position(nodes.size(), no_node);
    std::vector<bool> is_first(nodes.size(), true);
    for (Index next : m_next)
      if (next != no_node)
        is_first[next] = false;
    for (Index i = 0; i < nodes.size(); ++i)
      if (is_first[i])
      {
        add(m_clusters[i].best);
        for (Index j = i; j != no_node; j = m_next[j])
        {
          position[j] = static_cast<Index>(m_result.order.size());
          m_result.order.push_back(nodes[j]);
        }
      }
    for (Region& region : m_result.regions)
      region.first = position[region.first];
    std::stable_sort(m_result.regions.begin(), m_result.regions.end(),
                     [](const Region& a, const Region& b) { return a.relative_cost < b.relative_cost; });
    return std::move(m_result);
  }

  static constexpr Index no_node = Indexed_surface::no_face();

  const Seam_graph& m_graph;
  double m_segment_area = 0;
  std::vector<Index> m_number;     // of every node of the graph in the segment
  std::vector<Cluster> m_clusters; // numbered by one of their nodes
  std::vector<Index> m_next;       // of every node, in the list of its cluster
  std::priority_queue<Pair> m_queue;
  Merged_regions m_result;
};

} // namespace CGAL::Protrusion_segmentation::internal

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_CANDIDATES_REGIONS_H
