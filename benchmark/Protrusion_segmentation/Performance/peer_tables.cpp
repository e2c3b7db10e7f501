// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "measure.h"
#include "tables.h"

#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/mesh_segmentation.h>

#include <functional>
#include <iostream>
#include <map>
#include <stdexcept>

namespace {

// What the methods are measured against, in seconds for a model.
using Reference = std::function<double(const Model& model)>;

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

// A line for each model, then their mean and median: the milliseconds of the reference and of each method,
// and the ratio that `ratio(reference, method)` makes of them.
void print_comparison(const Options& options, const Benchmark_folder& folder, const std::string& name,
                      const std::string& ratio_name, const Reference& reference,
                      const std::function<double(double, double)>& ratio)
{
  const std::vector<Segmentation_method> methods = methods_to_measure(options);
  std::vector<std::string> header = {"model", "faces", name + " [ms]"};
  for (const Segmentation_method& method : methods)
    header.insert(header.end(), {method.name + " [ms]", ratio_name});
  const Markdown_table table(header);

  std::vector<std::vector<double>> columns(header.size());
  for (const int number_of_model : folder.models(options.models))
  {
    const Model model = folder.read_model(number_of_model);
    std::vector<double> values = {double(number_of_model), double(model.mesh.number_of_faces()),
                                  reference(model) * 1e3};
    for (const Segmentation_method& method : methods)
    {
      values.push_back(1e3 * seconds_of(options.repetitions, [&]
                                        { method.segment(model.mesh, model.number_of_segments, 0); }));
      values.push_back(ratio(values[2], values.back()));
    }
    std::vector<std::string> cells = {std::to_string(number_of_model), number(values[1], 0)};
    for (std::size_t i = 0; i < values.size(); ++i)
    {
      columns[i].push_back(values[i]);
      if (i >= 2)
        cells.push_back(number(values[i]));
    }
    table.row(cells);
  }
  for (const auto& statistic : std::map<std::string, double (*)(const std::vector<double>&)>{
        {"mean", mean}, {"median", [](const std::vector<double>& v) { return median(v); }}})
  {
    std::vector<std::string> cells(1, "**" + statistic.first + "**");
    for (std::size_t i = 1; i < columns.size(); ++i)
      cells.push_back(number(statistic.second(columns[i])));
    table.row(cells);
  }
}

} // namespace

void print_peer_table(const Options& options, const Benchmark_folder& folder)
{
  std::cout << "## 2. Against CGAL's segmentation by shape diameters\n\n"
            << "`sdf_values()` and `segmentation_from_sdf_values()` at their defaults. Goals: the paper's "
               "method (Paper-GD) 50 times faster, the default one 25 times.\n\n";
  print_comparison(
    options, folder, "shape diameters", "times faster",
    [&](const Model& model) { return seconds_of_shape_diameters(model, options.repetitions); },
    [](double reference, double method) { return reference / method; });
}

void print_reading_table(const Options& options, const Benchmark_folder& folder)
{
  std::cout << "## 3. Against reading the file\n\n"
            << "`CGAL::IO::read_polygon_mesh()` of the OFF file. Goal: the paper's method (Paper-GD) within "
               "2 times.\n\n";
  print_comparison(
    options, folder, "reading", "times reading",
    [&](const Model& model)
    {
      return seconds_of_reading(options.folder + "/off/" + std::to_string(model.number) + ".off",
                                options.repetitions);
    },
    [](double reference, double method) { return method / reference; });
}
