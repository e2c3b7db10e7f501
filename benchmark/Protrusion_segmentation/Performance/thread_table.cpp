// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "measure.h"
#include "tables.h"

#include <CGAL/Protrusion_segmentation/Histogram_method.h>
#include <CGAL/Protrusion_segmentation/internal/Mesh/read_surface.h>
#include <CGAL/Protrusion_segmentation/internal/Surface/Canonical_surface.h>
#include <CGAL/protrusion_segmentation.h>
#include <CGAL/subdivision_method_3.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#endif

#include <functional>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

namespace PS = CGAL::Protrusion_segmentation;

#ifdef CGAL_LINKED_WITH_TBB

// A line for `call(tag)`: one thread against each number of threads.
template <typename Call>
void print_row(const Markdown_table& table,
               const std::string& name,
               const char* goal,
               const Options& options,
               Call call)
{
  const double one =
    seconds_of(options.repetitions, [&] { call(CGAL::Sequential_tag()); }, Clock::WALL);
  std::vector<std::string> cells = {name, number(1e3 * one)};
  for (const std::size_t threads : options.threads)
  {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    cells.push_back(
      number(one / seconds_of(options.repetitions, [&] { call(CGAL::Parallel_tag()); }, Clock::WALL)));
  }
  cells.push_back(goal);
  table.row(cells);
}

// A whole segmentation; the labels have to be the same.
template <typename Method>
void print_whole_row(const Markdown_table& table,
                     const std::string& name,
                     const char* goal,
                     const Options& options,
                     const Model& model,
                     const Method& method)
{
  Labels sequential(model.mesh.number_of_faces()), parallel(sequential);
  print_row(table, name, goal, options,
            [&](auto tag)
            {
              Labels& labels = PS::internal::is_parallel<decltype(tag)>() ? parallel : sequential;
              CGAL::segmentation_via_protrusion_tips<decltype(tag)>(model.mesh, CGAL::make_property_map(labels),
                                                                    model.number_of_segments, method);
            });
  if (parallel != sequential)
    throw std::runtime_error(name + ": other labels with several threads");
}

void print_rows(const Options& options, const Benchmark_folder& folder, const Markdown_table& table)
{
  const Model model = folder.read_model(393);
  const PS::internal::Canonical_surface canonical(
    PS::internal::read_arrays(model.mesh, CGAL::parameters::default_values()));
  const PS::Indexed_surface& surface = canonical.surface();
  print_row(table, "distances from the landmarks of LGD(5)", "1.8", options,
            [&](auto tag)
            {
              PS::Execution execution(0, PS::internal::is_parallel<decltype(tag)>());
              PS::Landmark_geodesic_distance(0.05).on(surface, execution);
            });

  PS::internal::Shortest_distances shortest_distances(surface);
  std::vector<double> distances;
  shortest_distances(0, distances);
  const PS::internal::Slots tip_slots(distances);
  PS::internal::Plane_section section(surface);
  print_row(table, "sections of 20 tips", "1.8", options,
            [&](auto tag)
            {
              PS::Execution execution(0, PS::internal::is_parallel<decltype(tag)>());
              for (int i = 0; i < 20; ++i)
                PS::internal::sectional_diameter_histogram(surface, distances, tip_slots, section, execution);
            });

  print_whole_row(table, "the paper's method with LGD(5)", "1.8", options, model,
                  PS::Histogram_method(PS::Landmark_geodesic_distance(0.05)));
  print_whole_row(table, "the paper's method with GD", "1.5", options, model, PS::Histogram_method());
  print_whole_row(table, "the default method", "1.7", options, model, PS::Minimum_cut_method());

  Model large = folder.read_model(options.growth_model);
  while (large.mesh.number_of_faces() < 1000000)
  {
    CGAL::Subdivision_method_3::Loop_subdivision(large.mesh, CGAL::parameters::number_of_iterations(1));
    print_whole_row(table, "the default method on " + std::to_string(large.mesh.number_of_faces()) + " faces", "1.7", options, large,
                    PS::Minimum_cut_method());
  }
  print_whole_row(table, "the paper's method with GD on " + std::to_string(large.mesh.number_of_faces()) + " faces", "1.5", options,
                  large, PS::Histogram_method());
}

#else

void print_rows(const Options&, const Benchmark_folder&, const Markdown_table& table)
{
  table.row({"compiled without TBB"});
}

#endif

} // namespace

void print_thread_table(const Options& options, const Benchmark_folder& folder)
{
  std::cout << "## 4. Threads\n\nModel 393, and model " << options.growth_model
            << " subdivided by Loop's rule. Columns: how many times faster than with one thread.\n\n";
  std::vector<std::string> header = {"part", "1 thread [ms]"};
  for (const std::size_t threads : options.threads)
    header.push_back(std::to_string(threads) + " threads");
  header.push_back("goal, 2 threads");
  print_rows(options, folder, Markdown_table(header));
}
