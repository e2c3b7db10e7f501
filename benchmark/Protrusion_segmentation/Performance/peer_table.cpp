// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "measure.h"
#include "tables.h"

#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/mesh_segmentation.h>

#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

double seconds_of_shape_diameters(const Model& model, std::size_t repetitions)
{
  std::vector<double> diameters(model.mesh.number_of_faces());
  Labels labels(model.mesh.number_of_faces());
  return seconds_of(repetitions,
                    [&]
                    {
                      CGAL::sdf_values(model.mesh, CGAL::make_property_map(diameters));
                      CGAL::segmentation_from_sdf_values(model.mesh, CGAL::make_property_map(diameters),
                                                         CGAL::make_property_map(labels));
                    });
}

double seconds_of_reading(const std::string& path, std::size_t repetitions)
{
  return seconds_of(repetitions,
                    [&]
                    {
                      Mesh mesh;
                      if (!CGAL::IO::read_polygon_mesh(path, mesh))
                        throw std::runtime_error(path + ": no polygon mesh");
                    });
}

// What a method reaches at least.
struct Goals
{
  std::string times_faster, times_reading;
};

Goals goals_of(const std::string& method)
{
  return method == "Minimum-cut" ? Goals{"20", ""} : method == "Paper-GD" ? Goals{"45", "2"} : Goals();
}

// Milliseconds for each model.
using Times = std::vector<double>;

// Mean and median of `ratio(i)` over the models.
template <typename Ratio>
void add_statistics(std::vector<std::string>& cells, std::size_t number_of_models, Ratio ratio)
{
  std::vector<double> values;
  for (std::size_t i = 0; i < number_of_models; ++i)
    values.push_back(ratio(i));
  cells.insert(cells.end(), {number(mean(values)), number(median(values))});
}

std::vector<std::string> row_of_times(const std::string& name, const Times& times)
{
  std::vector<std::string> cells = {name};
  add_statistics(cells, times.size(), [&](std::size_t i) { return times[i]; });
  return cells;
}

} // namespace

void print_peer_table(const Options& options, const Benchmark_folder& folder)
{
  const std::vector<Segmentation_method> methods = methods_to_measure(options);
  Times faces, diameters, reading;
  std::vector<Times> of_methods(methods.size());
  for (const int number_of_model : folder.models(options.models))
  {
    const Model model = folder.read_model(number_of_model);
    faces.push_back(double(model.mesh.number_of_faces()));
    diameters.push_back(1e3 * seconds_of_shape_diameters(model, options.repetitions));
    reading.push_back(1e3 * seconds_of_reading(folder.mesh_file(number_of_model), options.repetitions));
    for (std::size_t m = 0; m < methods.size(); ++m)
      of_methods[m].push_back(
        1e3 * seconds_of(options.repetitions,
                         [&] { methods[m].segment(model.mesh, model.number_of_segments, 0); }));
  }
  std::cout
    << "## 2. Against CGAL's shape diameters and against reading the file\n\n"
    << faces.size() << " models, " << number(mean(faces), 0)
    << " faces on average. Shape diameters: `sdf_values()` and `segmentation_from_sdf_values()` at their "
       "defaults.\nReading: `CGAL::IO::read_polygon_mesh()`.\n\n";
  const Markdown_table table({"method", "mean [ms]", "median [ms]",
                              "times faster than shape diameters, mean", "median", "goal",
                              "times reading, mean", "median", "goal"});
  table.row(row_of_times("shape diameters", diameters));
  table.row(row_of_times("reading", reading));
  for (std::size_t m = 0; m < methods.size(); ++m)
  {
    const Times& times = of_methods[m];
    const Goals goals = goals_of(methods[m].name);
    std::vector<std::string> cells = row_of_times(methods[m].name, times);
    add_statistics(cells, times.size(), [&](std::size_t i) { return diameters[i] / times[i]; });
    cells.push_back(goals.times_faster);
    add_statistics(cells, times.size(), [&](std::size_t i) { return times[i] / reading[i]; });
    cells.push_back(goals.times_reading);
    table.row(cells);
  }
}
