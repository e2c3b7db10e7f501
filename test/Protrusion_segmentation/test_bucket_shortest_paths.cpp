// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Shortest paths by buckets on graphs of the Boost Graph Library: the distances of its own algorithm to the last bit, and
// predecessors that lie on a shortest path.

#include <boost/graph/dijkstra_shortest_paths.hpp> // first: it knows no pointers after headers with a `get()` of graphs

#include "check.h"
#include "indexed_surfaces.h"
#include "test_meshes.h"

#include <CGAL/Protrusion_segmentation/bucket_shortest_paths.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <boost/graph/adjacency_list.hpp>
#include <boost/property_map/function_property_map.hpp>

#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>

using namespace test_meshes;
using CGAL::Protrusion_segmentation::bucket_shortest_paths;

template <typename Number>
using Weight = boost::property<boost::edge_weight_t, Number>;
template <typename Direction, typename Number>
using List_graph = boost::adjacency_list<boost::vecS, boost::vecS, Direction, boost::no_property, Weight<Number>>;

// Are they Boost's distances, and the predecessors right, from one source or several?
template <typename Distance, typename Graph, typename WeightMap, typename Sources>
void check_paths(const Graph& graph, WeightMap weight, const Sources& sources)
{
  using Vertex = typename boost::graph_traits<Graph>::vertex_descriptor;
  const auto index = get(boost::vertex_index, graph);
  const std::size_t n = num_vertices(graph);
  const Vertex first = *sources.begin();
  std::vector<Distance> expected(n), found(n), of_one(n);
  std::vector<Vertex> predecessor(n), predecessor_of_boost(n);
  const auto map = [index](auto& values) { return boost::make_iterator_property_map(values.begin(), index); };
  boost::dijkstra_shortest_paths(graph, sources.begin(), sources.end(), map(predecessor_of_boost), map(expected), weight,
                                 index, std::less<Distance>(), boost::closed_plus<Distance>(),
                                 (std::numeric_limits<Distance>::max)(), Distance(), boost::default_dijkstra_visitor());
  bucket_shortest_paths(graph, sources.begin(), sources.end(),
                        boost::weight_map(weight).distance_map(map(found)).predecessor_map(map(predecessor)));
  CHECK(found == expected);

  const Distance infinity = (std::numeric_limits<Distance>::max)();
  for (const Vertex v : boost::make_iterator_range(vertices(graph)))
  {
    const Vertex p = predecessor[get(index, v)];
    const bool is_source = std::find(sources.begin(), sources.end(), v) != sources.end();
    if (is_source || found[get(index, v)] == infinity)
    {
      CHECK(p == v);
      continue;
    }
    bool is_on_path = false;
    for (const auto arc : boost::make_iterator_range(out_edges(p, graph)))
      is_on_path = is_on_path || (target(arc, graph) == v &&
                                  found[get(index, p)] + get(weight, arc) == found[get(index, v)]);
    CHECK(is_on_path);
  }

  // The call that it replaces.
  boost::dijkstra_shortest_paths(graph, first, boost::weight_map(weight).distance_map(map(expected)));
  bucket_shortest_paths(graph, first, boost::weight_map(weight).distance_map(map(of_one)));
  CHECK(of_one == expected);
}

// Pointers are property maps of vertices that are numbers, here as for Boost's.
void pointers_are_property_maps()
{
  using Graph = List_graph<boost::directedS, double>;
  Graph graph(3);
  boost::add_edge(0, 1, 2., graph);
  boost::add_edge(1, 2, 3., graph);
  std::vector<double> expected(3), found(3);
  std::vector<std::size_t> expected_predecessors(3), predecessors(3);
  boost::dijkstra_shortest_paths(graph, vertex(0, graph),
                                 boost::distance_map(&expected[0]).predecessor_map(&expected_predecessors[0]));
  bucket_shortest_paths(graph, vertex(0, graph), boost::distance_map(&found[0]).predecessor_map(&predecessors[0]));
  CHECK(found == expected);
  CHECK(predecessors == expected_predecessors);
}

template <typename Direction, typename Number>
List_graph<Direction, Number> random_graph(std::uint_fast32_t seed, Number largest)
{
  Random random(seed);
  const std::size_t n = 1 + std::size_t(random.real(0, 60));
  List_graph<Direction, Number> graph(n);
  const std::size_t arcs = std::size_t(random.real(0, 4 * double(n)));
  for (std::size_t i = 0; i < arcs; ++i)
    add_edge(std::size_t(random.real(0, double(n))), std::size_t(random.real(0, double(n))),
             Weight<Number>(Number(random.real(0, double(largest)))), graph);
  return graph;
}

// Loops, parallel edges, parts without a path to them, weights of 0 among them.
template <typename Direction, typename Number>
void equals_boost_on_random_graphs(Number largest)
{
  for (std::uint_fast32_t seed = 0; seed < 300; ++seed)
  {
    const auto graph = random_graph<Direction>(seed, largest);
    const std::size_t n = num_vertices(graph);
    const auto weight = get(boost::edge_weight, graph);
    check_paths<Number>(graph, weight, std::array<std::size_t, 1>{n / 2});
    check_paths<Number>(graph, weight, std::array<std::size_t, 3>{0, n / 3, n - 1});
  }
}

// A path with one arc that is longer than a ring of buckets, and one without lengths.
void equals_boost_where_buckets_are_of_no_use()
{
  for (const double longest : {0., 1., 1e3, 1e9, std::numeric_limits<double>::infinity()})
  {
    List_graph<boost::undirectedS, double> graph(4000);
    for (std::size_t v = 0; v + 1 < num_vertices(graph); ++v)
      add_edge(v, v + 1, longest == 0 || longest == 1 || v == 2000 ? longest : 1e-3, graph);
    check_paths<double>(graph, get(boost::edge_weight, graph), std::array<std::size_t, 1>{7});
  }
}

// Two vertices with so many arcs that they are scanned alone, to the same ones.
void equals_boost_where_vertices_have_many_arcs()
{
  for (std::uint_fast32_t seed = 0; seed < 5; ++seed)
  {
    Random random(seed);
    List_graph<boost::undirectedS, double> graph(3000);
    for (std::size_t v = 2; v < num_vertices(graph); ++v)
      for (const std::size_t hub : {0, 1})
        add_edge(hub, v, random.real(0, 1), graph);
    check_paths<double>(graph, get(boost::edge_weight, graph), std::array<std::size_t, 2>{0, 2999});
  }
}

// A face dual graph, and a surface mesh along its edges.
void equals_boost_on_meshes()
{
  const Indexed_surface surface = to_surface(bumpy_sphere(4, 1));
  const auto dual = surface.dual_graph();
  check_paths<double>(dual, get(&Indexed_surface::Arc::length, dual), std::array<Index, 2>{3, 1000});

  using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
  const Mesh mesh = to_graph<Mesh>(capsule_with_ball());
  const auto length = boost::make_function_property_map<Mesh::Edge_index>(
    [&mesh](Mesh::Edge_index e)
    {
      return std::sqrt(CGAL::squared_distance(mesh.point(mesh.vertex(e, 0)), mesh.point(mesh.vertex(e, 1))));
    });
  check_paths<double>(mesh, length, std::array<Mesh::Vertex_index, 1>{Mesh::Vertex_index(5)});
}

void parameters_are_those_of_boost()
{
  List_graph<boost::directedS, double> graph(3);
  add_edge(0, 1, 2., graph);
  std::vector<double> distances(3);
  const auto map = boost::make_iterator_property_map(distances.begin(), get(boost::vertex_index, graph));
  // the weights of the graph, and an infinity of one's own
  bucket_shortest_paths(graph, 0, boost::distance_map(map).distance_inf(-1 + 1e9));
  CHECK(distances == std::vector<double>({0, 2, -1 + 1e9}));
  const std::vector<std::size_t> nothing;
  bucket_shortest_paths(graph, nothing.begin(), nothing.end(), boost::distance_map(map));
  for (const double distance : distances)
    CHECK_EQUAL(distance, (std::numeric_limits<double>::max)());

  add_edge(1, 2, -1., graph);
  CHECK_THROWS(bucket_shortest_paths(graph, 0, boost::distance_map(map)), boost::negative_edge);
}

int main()
{
  pointers_are_property_maps();
  equals_boost_on_random_graphs<boost::directedS>(1.);
  equals_boost_on_random_graphs<boost::undirectedS>(1e-200);
  equals_boost_on_random_graphs<boost::directedS>(1000);
  equals_boost_on_random_graphs<boost::bidirectionalS>(3);
  equals_boost_where_buckets_are_of_no_use();
  equals_boost_where_vertices_have_many_arcs();
  equals_boost_on_meshes();
  parameters_are_those_of_boost();
  return check::result();
}
