// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// No more work than before: what takes the methods their time is counted and compared with data/operation_counts.txt.
// After a change that is meant to take more or less, `test_operation_counts --write`, called in this folder,
// writes the file anew.

#include "check.h"
#include "dual_graphs.h"
#include "indexed_surfaces.h"
#include "test_meshes.h"

#include <CGAL/Protrusion_segmentation/Histogram_method.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Component.h>
#include <CGAL/Protrusion_segmentation/internal/Distances/Largest_sum/largest_distance_sum.h>
#include <CGAL/Protrusion_segmentation/internal/Distances/Shortest_distances.h>

#include <cmath>
#include <cstddef>
#include <fstream>
#include <map>
#include <optional>
#include <string>

using namespace test_meshes;
namespace internal = CGAL::Protrusion_segmentation::internal;

constexpr const char* counts_file = "data/operation_counts.txt";
constexpr std::size_t usual_number_of_segments = 6;

using Counts = std::map<std::string, std::size_t>; // of "mesh method operation"

std::map<std::string, Test_mesh> meshes()
{
  return {{"star", star(5, 1, 0.2, 0.04, 0.2)},
          {"creature", creature(0.1)},
          {"hands", body_with_hands(3, 0.12)},
          {"dumbbell", dumbbell()},
          {"bumps", bumpy_sphere(4, 1)},
          {"sphere", jittered(icosphere(4), 0.5, 1)},
          {"random", jittered(random_surface(3), 0.5, 3)}};
}

// Stages ask whether to go further before every step.
struct Step_counter : internal::Observer
{
  bool go_further() override
  {
    ++steps;
    return true;
  }

  void distances_computed(std::size_t number_of_runs) override { runs += number_of_runs; }

  std::size_t steps = 0, runs = 0;
};

// Of the default method with the number of segments that it finds, before borders are moved on the faces.
void count_minimum_cuts(const std::string& mesh, const Indexed_surface& surface, Counts& counts)
{
  Step_counter counter;
  Execution execution(counter, 0, false);
  seam_graph(surface, execution); // iterations of diffusion and disks
  counts[mesh + " cut steps_of_seams"] = counter.steps;
  const internal::Cut_options options;
  const std::optional<internal::Any_distance> distance;
  internal::Component component(surface, distance, options, quiet_execution());
  component.automatic_number();
  std::size_t segments = 0, nodes = 0;
  for (Index id = 0; id < component.memo().number_of_segments(); ++id)
    if (component.memo()[id].is_searched)
    {
      ++segments;
      nodes += component.memo()[id].segment.nodes.size();
    }
  counts[mesh + " cut searched_segments"] = segments;
  counts[mesh + " cut searched_nodes"] = nodes;
  counts[mesh + " cut runs_from_tips"] = component.number_of_runs();
  std::size_t reached = 0, in_bands = 0;
  component.search().for_each_workspace(
    [&](const internal::Search_workspace& workspace)
    {
      reached += workspace.distances.number_of_nodes();
      in_bands += workspace.cutter.minimum_cut().number_of_nodes();
    });
  counts[mesh + " cut reached_nodes"] = reached;
  counts[mesh + " cut nodes_in_bands"] = in_bands;
}

// Of the paper's method: the search for the face of eq. (1), and all of it.
void count_histograms(const std::string& mesh, const Indexed_surface& surface, Counts& counts)
{
  internal::Shortest_distances distances(surface);
  internal::Largest_distance_sum<internal::Shortest_distances> search(surface, distances,
                                                                      quiet_execution());
  search(surface.number_of_faces());
  counts[mesh + " paper runs_of_largest_sum"] = distances.number_of_runs();
  counts[mesh + " paper faces_scanned_for_largest_sum"] = distances.number_of_scanned_faces();
  Step_counter counter;
  Execution execution(counter, 0, false);
  CGAL::Protrusion_segmentation::Histogram_method().segment(surface, usual_number_of_segments, execution);
  counts[mesh + " paper runs"] = counter.runs;
  counts[mesh + " paper steps"] = counter.steps;
}

Counts counts()
{
  Counts result;
  for (const auto& [name, mesh] : meshes())
  {
    const Indexed_surface surface = to_surface(with_rounded_points(mesh));
    count_minimum_cuts(name, surface, result);
    count_histograms(name, surface, result);
  }
  return result;
}

void compare_with_counts_of_file()
{
  constexpr double largest_growth = 0.02;
  Counts expected;
  std::ifstream in(counts_file);
  std::size_t value;
  for (std::string mesh, method, operation; in >> mesh >> method >> operation >> value;)
    expected[mesh + " " + method + " " + operation] = value;
  const Counts found = counts();
  CGAL_CHECK_EQUAL(found.size(), expected.size());
  for (const auto& [name, count] : found)
  {
    const double most = std::ceil((1 + largest_growth) * static_cast<double>(expected[name]));
    const std::string failure = name + " " + std::to_string(count) + " instead of " +
                                std::to_string(expected[name]);
    CGAL_CHECK_EQUAL(static_cast<double>(count) <= most ? "" : failure, "");
  }
}

void write_counts()
{
  std::ofstream out(counts_file);
  for (const auto& [name, count] : counts())
    out << name << " " << count << "\n";
  CGAL_CHECK(out.good());
}

int main(int argc, char** argv)
{
  if (argc == 2 && std::string(argv[1]) == "--write")
    write_counts();
  else
  {
    compare_with_counts_of_file();
    if (check::counters().failures > 0)
      std::cerr << "If that is meant, call test_operation_counts --write in test/Protrusion_segmentation."
                << std::endl;
  }
  return check::result();
}
