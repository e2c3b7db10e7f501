// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "measure.h"
#include "tables.h"

#include <CGAL/Protrusion_segmentation/internal/Distances/Shortest_distances.h>
#include <CGAL/Protrusion_segmentation/internal/Mesh/read_surface.h>
#include <CGAL/Protrusion_segmentation/internal/Surface/Canonical_surface.h>
#include <CGAL/subdivision_method_3.h>

#include <iostream>
#include <string>
#include <vector>

namespace {

namespace PS = CGAL::Protrusion_segmentation;

// Nanoseconds a face of one computation of shortest distances, on faces in the order that the package works in;
// the median of ten.
double nanoseconds_per_run(const Mesh& mesh)
{
  const PS::internal::Canonical_surface canonical(
    PS::internal::read_arrays(mesh, CGAL::parameters::default_values()));
  const PS::Indexed_surface& surface = canonical.surface();
  PS::internal::Shortest_distances shortest_distances(surface);
  std::vector<double> distances;
  PS::Indexed_surface::Index source = 0;
  const PS::Indexed_surface::Index n = surface.number_of_faces();
  return 1e9 / n *
         seconds_of(10,
                    [&]
                    {
                      shortest_distances(source, distances);
                      source += n / 10;
                    });
}

void add_goals(std::vector<std::string>& cells, const std::string& method)
{
  if (method == "Minimum-cut")
    cells.insert(cells.end(), {"12", "3", "200"});
  else if (method == "Paper-GD")
    cells.insert(cells.end(), {"40", "10", "200"});
  else
    cells.insert(cells.end(), 3, "");
}

} // namespace

void print_growth_table(const Options& options, const Benchmark_folder& folder)
{
  std::cout << "## 3. Time and memory by size\n\nModel " << options.growth_model
            << ", subdivided by Loop's rule. Memory: growth of the process during the call, above the mesh.\n\n";
  Model model = folder.read_model(options.growth_model);
  const std::vector<Segmentation_method> methods = methods_to_measure(options);
  std::vector<std::string> header = {"faces", "Dijkstra run [ns / face]", "times the first"};
  for (const Segmentation_method& method : methods)
    header.insert(header.end(), {method.name + " [s]", "[us / face]", "[bytes / face]"});
  const Markdown_table table(header);
  double first = 0;
  for (; model.mesh.number_of_faces() <= options.largest_growth;
      CGAL::Subdivision_method_3::Loop_subdivision(model.mesh,
                                                   CGAL::parameters::number_of_iterations(1)))
  {
    const double n = double(model.mesh.number_of_faces());
    const double per_run = nanoseconds_per_run(model.mesh);
    first = first > 0 ? first : per_run;
    std::vector<std::string> cells = {number(n, 0), number(per_run), number(per_run / first)};
    for (const Segmentation_method& method : methods)
    {
      double seconds = 0;
      const double bytes = peak_bytes_of(
        [&]
        {
          seconds = seconds_of(1, [&] { method.segment(model.mesh, model.number_of_segments, 0); });
        });
      cells.insert(cells.end(), {number(seconds), number(1e6 * seconds / n), number(bytes / n)});
    }
    table.row(cells);
  }
  std::vector<std::string> goals = {"goal, 4 million", "", "1.5"};
  for (const Segmentation_method& method : methods)
    add_goals(goals, method.name);
  table.row(goals);
}
