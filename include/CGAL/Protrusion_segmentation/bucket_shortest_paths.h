// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_BUCKET_SHORTEST_PATHS_H
#define CGAL_PROTRUSION_SEGMENTATION_BUCKET_SHORTEST_PATHS_H

#include <CGAL/Protrusion_segmentation/internal/Distances/Bucket_ring.h>

#include <boost/graph/dijkstra_shortest_paths.hpp>
#include <boost/graph/exception.hpp>
#include <boost/graph/graph_traits.hpp>
#include <boost/graph/named_function_params.hpp>
#include <boost/property_map/property_map.hpp>
#include <boost/range/iterator_range.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <limits>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Protrusion_segmentation {

#ifndef DOXYGEN_RUNNING
namespace internal {

// Whether a call has a parameter of Boost's.
template <typename Tag, typename Parameters>
constexpr bool has_boost_parameter()
{
  return !std::is_same<typename boost::lookup_named_param_def<Tag, Parameters, boost::param_not_found>::type,
                       boost::param_not_found>::value;
}

// Shortest paths on a graph by a ring of buckets; by Boost's algorithm where that is of no use.
template <typename Graph, typename WeightMap, typename DistanceMap, typename PredecessorMap, typename IndexMap>
class Bucket_shortest_paths
{
public:
  using Vertex = typename boost::graph_traits<Graph>::vertex_descriptor;
  using Distance = typename boost::property_traits<DistanceMap>::value_type;

  Bucket_shortest_paths(const Graph& graph,
                        WeightMap weight,
                        DistanceMap distance,
                        PredecessorMap predecessor,
                        IndexMap index,
                        Distance infinity)
    : m_graph(graph),
      m_weight(weight),
      m_distance(distance),
      m_predecessor(predecessor),
      m_index(index),
      m_infinity(infinity)
  {}

  template <typename VertexIterator>
  void operator()(VertexIterator begin, VertexIterator end)
  {
    using boost::get; // of pointers as property maps, which CGAL::get() hides
    using boost::put;
    Ring ring = start();
    if (!ring.is_usable())
      return run_boost(begin, end);
    for (VertexIterator source = begin; source != end; ++source)
    {
      put(m_distance, *source, Distance());
      ring.push_source(*source);
    }
    ring.scan_all([this](const Vertex& v) { return get(m_distance, v); },
                  [this](const Vertex& v, typename Ring::Offer* place) { return offer_paths(v, place); },
                  [this](const typename Ring::Offer& path)
                  {
                    put(m_distance, path.vertex, path.distance);
                    put(m_predecessor, path.vertex, path.before);
                  },
                  [] {});
  }

private:
  using Ring = Bucket_ring<Vertex, Distance>;

  // Gives every vertex its first values, and measures the arcs.
  Ring start()
  {
    using boost::get;
    using boost::put;
    Arc_lengths lengths;
    std::vector<double> of_vertex;
    for (const Vertex v : boost::make_iterator_range(vertices(m_graph)))
    {
      put(m_distance, v, m_infinity);
      put(m_predecessor, v, v);
      of_vertex.clear();
      for (const auto arc : boost::make_iterator_range(out_edges(v, m_graph)))
      {
        of_vertex.push_back(static_cast<double>(get(m_weight, arc)));
        if (of_vertex.back() < 0)
          boost::throw_exception(boost::negative_edge());
      }
      lengths.add_vertex(of_vertex);
    }
    return Ring(lengths);
  }

  typename Ring::Offer* offer_paths(const Vertex& v, typename Ring::Offer* end) const
  {
    using boost::get;
    const Distance to_v = get(m_distance, v);
    for (const auto arc : boost::make_iterator_range(out_edges(v, m_graph)))
    {
      const Vertex neighbor = target(arc, m_graph);
      const Distance distance = to_v + get(m_weight, arc);
      *end = {distance, neighbor, v};
      end += distance < get(m_distance, neighbor);
    }
    return end;
  }

  template <typename VertexIterator>
  void run_boost(VertexIterator begin, VertexIterator end)
  {
    boost::dijkstra_shortest_paths(m_graph, begin, end, m_predecessor, m_distance, m_weight, m_index,
                                   std::less<Distance>(), boost::closed_plus<Distance>(m_infinity), m_infinity,
                                   Distance(), boost::make_dijkstra_visitor(boost::null_visitor()));
  }

  const Graph& m_graph;
  WeightMap m_weight;
  DistanceMap m_distance;
  PredecessorMap m_predecessor;
  IndexMap m_index;
  Distance m_infinity;
};

} // namespace internal
#endif

/*!
\ingroup PkgProtrusionSegmentationRef

computes the shortest paths from some vertices of a graph to all, as `boost::dijkstra_shortest_paths()` does, which it
replaces by its name alone: the named parameters are those of the Boost Graph Library, separated by dots. The distances are
the same to the last bit; where several shortest paths have the same length, another one may be told.

A ring of buckets, each as wide as the mean weight, takes the place of Boost's heap: on the face dual graphs of this
package that takes about a fifth of the time. Where a weight is more than 1024 times the mean, all are 0, or one is
infinite, Boost's algorithm does the work.

With \f$n\f$ vertices and \f$m\f$ arcs it takes \f$O(n + m)\f$ time if no vertex has to be visited again for a shorter path
inside of a bucket, which is rare where weights are alike, and memory in proportion to \f$n\f$.

\tparam Graph a model of `boost::VertexListGraph` and `boost::IncidenceGraph`, directed or not
\tparam VertexIterator a model of `ForwardIterator` with vertex descriptors as value type

\param graph the graph
\param begin the first source
\param end the end of the sources
\param parameters those of the Boost Graph Library, of which the first is needed:
- `distance_map(m)`: a model of `boost::ReadWritePropertyMap` from vertices to an arithmetic type; gets the length of the
  shortest path to every vertex
- `weight_map(m)`: a model of `boost::ReadablePropertyMap` from edges to numbers from 0; default `get(boost::edge_weight, graph)`
- `predecessor_map(m)`: a model of `boost::WritablePropertyMap` from vertices to vertices; gets the vertex before every vertex
  on its path, or itself for a source and where no path leads
- `vertex_index_map(m)`: default `get(boost::vertex_index, graph)`
- `distance_inf(d)`: the distance where no path leads; default the largest number

\throw boost::negative_edge if a weight is negative
*/
#ifdef DOXYGEN_RUNNING
template <typename Graph, typename VertexIterator, typename BoostNamedParameters>
void bucket_shortest_paths(const Graph& graph,
                           VertexIterator begin,
                           VertexIterator end,
                           const BoostNamedParameters& parameters);
#else
template <typename Graph, typename VertexIterator, typename P, typename T, typename R>
void bucket_shortest_paths(const Graph& graph,
                           VertexIterator begin,
                           VertexIterator end,
                           const boost::bgl_named_params<P, T, R>& parameters)
{
  using Parameters = boost::bgl_named_params<P, T, R>;
  static_assert(internal::has_boost_parameter<boost::vertex_distance_t, Parameters>(),
                "bucket_shortest_paths() needs a distance_map().");
  static_assert(!internal::has_boost_parameter<boost::distance_compare_t, Parameters>() &&
                  !internal::has_boost_parameter<boost::distance_combine_t, Parameters>() &&
                  !internal::has_boost_parameter<boost::distance_zero_t, Parameters>() &&
                  !internal::has_boost_parameter<boost::graph_visitor_t, Parameters>(),
                "bucket_shortest_paths() adds weights from 0 on and has no visitor.");
  const auto distance = get_param(parameters, boost::vertex_distance);
  const auto weight = choose_const_pmap(get_param(parameters, boost::edge_weight), graph, boost::edge_weight);
  const auto index = choose_const_pmap(get_param(parameters, boost::vertex_index), graph, boost::vertex_index);
  const auto predecessor =
    boost::choose_param(get_param(parameters, boost::vertex_predecessor), boost::dummy_property_map());
  using Distance = typename boost::property_traits<std::decay_t<decltype(distance)>>::value_type;
  const Distance infinity =
    boost::choose_param(get_param(parameters, boost::distance_inf_t()), (std::numeric_limits<Distance>::max)());
  internal::Bucket_shortest_paths<Graph, std::decay_t<decltype(weight)>, std::decay_t<decltype(distance)>,
                                  std::decay_t<decltype(predecessor)>, std::decay_t<decltype(index)>>(
    graph, weight, distance, predecessor, index, infinity)(begin, end);
}
#endif

/*!
\ingroup PkgProtrusionSegmentationRef

computes the shortest paths from one vertex, as above: `bucket_shortest_paths(graph, source, parameters)` in place of
`boost::dijkstra_shortest_paths(graph, source, parameters)`.

\param graph a model of `boost::VertexListGraph` and `boost::IncidenceGraph`
\param source a vertex of it
\param parameters named parameters of the Boost Graph Library
*/
#ifdef DOXYGEN_RUNNING
template <typename Graph, typename BoostNamedParameters>
void bucket_shortest_paths(const Graph& graph,
                           typename boost::graph_traits<Graph>::vertex_descriptor source,
                           const BoostNamedParameters& parameters);
#else
template <typename Graph, typename P, typename T, typename R>
void bucket_shortest_paths(const Graph& graph,
                           typename boost::graph_traits<Graph>::vertex_descriptor source,
                           const boost::bgl_named_params<P, T, R>& parameters)
{
  const std::array<decltype(source), 1> sources = {source};
  bucket_shortest_paths(graph, sources.begin(), sources.end(), parameters);
}
#endif

} // namespace Protrusion_segmentation
} // namespace CGAL

#endif // CGAL_PROTRUSION_SEGMENTATION_BUCKET_SHORTEST_PATHS_H
