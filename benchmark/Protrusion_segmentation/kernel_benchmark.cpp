// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The inner loops on meshes built in code, with Google Benchmark:
//
//   kernel_benchmark [--benchmark_filter=REGEX] [--benchmark_repetitions=N]

#include "Performance/sphere.h"

#include <CGAL/Protrusion_segmentation/Landmark_geodesic_distance.h>
#include <CGAL/Protrusion_segmentation/internal/Distances/Largest_sum/largest_distance_sum.h>
#include <CGAL/Protrusion_segmentation/internal/Distances/Shortest_distances.h>
#include <CGAL/Protrusion_segmentation/internal/Histogram_method/histograms.h>
#include <CGAL/Protrusion_segmentation/internal/Mesh/read_surface.h>
#include <CGAL/Protrusion_segmentation/internal/Surface/Surface_arrays.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <benchmark/benchmark.h>

#include <boost/graph/dijkstra_shortest_paths_no_color_map.hpp>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace {

namespace PS = CGAL::Protrusion_segmentation;
using Index = PS::Indexed_surface::Index;
using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

// A sphere of 20 * 4^level faces with six bumps.
Mesh bumpy_sphere(int level)
{
  return sphere<Mesh>(static_cast<unsigned>(level),
                      [](const auto& direction)
                      {
                        double largest = 0;
                        for (int axis = 0; axis < 3; ++axis)
                          largest = (std::max)(largest, std::abs(direction[axis]));
                        return 1 + std::pow(largest, 40);
                      });
}

PS::Indexed_surface surface(const benchmark::State& state)
{
  PS::internal::Arrays_of_mesh arrays = PS::internal::read_surface(bumpy_sphere(int(state.range(0))),
                                                                   CGAL::parameters::default_values());
  return std::move(arrays.surface).to_surface();
}

void count_faces(benchmark::State& state, const PS::Indexed_surface& surface)
{
  state.SetItemsProcessed(state.iterations() * surface.number_of_faces());
}

void read_surface(benchmark::State& state)
{
  const Mesh mesh = bumpy_sphere(int(state.range(0)));
  for (auto _ : state)
    benchmark::DoNotOptimize(
      PS::internal::read_surface(mesh, CGAL::parameters::default_values()));
  state.SetItemsProcessed(state.iterations() * std::int64_t(mesh.number_of_faces()));
}

void shortest_distances(benchmark::State& state)
{
  const PS::Indexed_surface input = surface(state);
  PS::internal::Shortest_distances shortest(input);
  std::vector<double> distances;
  for (auto _ : state)
    shortest(0, distances);
  count_faces(state, input);
}

void shortest_distances_of_boost(benchmark::State& state)
{
  const PS::Indexed_surface input = surface(state);
  const auto& graph = input.dual_graph();
  std::vector<double> distances(input.number_of_faces());
  for (auto _ : state)
    boost::dijkstra_shortest_paths_no_color_map(
      graph, Index(0),
      boost::weight_map(get(&PS::Indexed_surface::Arc::length, graph))
        .distance_map(boost::make_iterator_property_map(distances.begin(),
                                                        get(boost::vertex_index, graph))));
  count_faces(state, input);
}

void face_of_largest_sum(benchmark::State& state)
{
  const PS::Indexed_surface input = surface(state);
  std::size_t runs = 0;
  PS::Execution execution;
  for (auto _ : state)
  {
    PS::internal::Shortest_distances shortest(input);
    benchmark::DoNotOptimize(PS::internal::largest_distance_sum(input, shortest, execution));
    runs = shortest.number_of_runs();
  }
  state.counters["runs"] = double(runs);
}

void landmark_distances(benchmark::State& state)
{
  const PS::Indexed_surface input = surface(state);
  PS::Execution execution;
  for (auto _ : state)
    benchmark::DoNotOptimize(PS::Landmark_geodesic_distance(0.01).on(input, execution));
}

void sections_of_a_tip(benchmark::State& state)
{
  const PS::Indexed_surface input = surface(state);
  PS::internal::Shortest_distances shortest(input);
  std::vector<double> distances;
  shortest(0, distances);
  const PS::internal::Slots tip_slots(distances);
  PS::internal::Plane_section section(input);
  PS::Execution execution;
  for (auto _ : state)
    benchmark::DoNotOptimize(
      PS::internal::sectional_diameter_histogram(input, distances, tip_slots, section, execution));
  count_faces(state, input);
}

BENCHMARK(read_surface)->DenseRange(4, 6)->Unit(benchmark::kMillisecond);
BENCHMARK(shortest_distances)->DenseRange(4, 7)->Unit(benchmark::kMillisecond);
BENCHMARK(shortest_distances_of_boost)->DenseRange(4, 7)->Unit(benchmark::kMillisecond);
BENCHMARK(face_of_largest_sum)->DenseRange(4, 6)->Unit(benchmark::kMillisecond);
BENCHMARK(landmark_distances)->DenseRange(4, 5)->Unit(benchmark::kMillisecond);
BENCHMARK(sections_of_a_tip)->DenseRange(4, 6)->Unit(benchmark::kMillisecond);

} // namespace

BENCHMARK_MAIN();
