// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Stopwatch_visitor.h"
#include "measure.h"
#include "tables.h"

#include <CGAL/Protrusion_segmentation/Diffusion_distance.h>
#include <CGAL/Protrusion_segmentation/Exact_geodesic_distance.h>
#include <CGAL/Protrusion_segmentation/Heat_distance.h>
#include <CGAL/Protrusion_segmentation/Histogram_method.h>
#include <CGAL/protrusion_segmentation.h>
#include <CGAL/subdivision_method_3.h>

#include <functional>
#include <iostream>
#include <string>

namespace {

namespace PS = CGAL::Protrusion_segmentation;

template <typename Method>
void print_row(const Markdown_table& table,
               const std::string& name,
               const Model& model,
               const Method& method,
               const Options& options)
{
  Labels labels(model.mesh.number_of_faces());
  Stopwatch_visitor stopwatch(options.gap_limit);
  bool is_stopped = false;
  try
  {
    CGAL::segmentation_via_protrusion_tips(model.mesh, CGAL::make_property_map(labels), model.number_of_segments,
                                           method, CGAL::parameters::visitor(std::ref(stopwatch)));
  }
  catch (const PS::Segmentation_stopped&)
  {
    is_stopped = true;
  }
  stopwatch.end();
  table.row({name, (is_stopped ? "stopped after " : "") + number(stopwatch.seconds()),
             std::to_string(stopwatch.number_of_questions()), number(stopwatch.longest_gap()),
             stopwatch.stage_of_longest_gap()});
}

// Both methods with a distance.
template <typename Distance>
void print_rows(const Markdown_table& table,
                const std::string& name,
                const Model& model,
                const Distance& distance,
                const Options& options)
{
  print_row(table, "Minimum-cut-" + name, model, PS::Minimum_cut_method(distance), options);
  print_row(table, "Paper-" + name, model, PS::Histogram_method(distance), options);
}

} // namespace

void print_gap_table(const Options& options, const Benchmark_folder& folder)
{
  Model model = folder.read_model(options.gap_model);
  CGAL::Subdivision_method_3::Loop_subdivision(model.mesh, CGAL::parameters::number_of_iterations(1));
  std::cout << "## 5. How often a visitor is asked whether to stop\n\nModel " << options.gap_model
            << ", subdivided once to " << model.mesh.number_of_faces() << " faces; stopped after "
            << options.gap_limit << " seconds. Goal: a longest gap of 0.25 seconds.\n\n";
  const Markdown_table table({"method and distance", "whole [s]", "questions", "longest gap [s]", "stage"});
  print_row(table, "Minimum-cut", model, PS::Minimum_cut_method(), options);
  print_rows(table, "GD", model, PS::Geodesic_distance(), options);
  print_rows(table, "LGD(1)", model, PS::Landmark_geodesic_distance(0.01), options);
  print_rows(table, "DD(10)", model, PS::Diffusion_distance(10), options);
  print_rows(table, "heat", model, PS::Heat_distance(), options);
  print_rows(table, "exact", model, PS::Exact_geodesic_distance(), options);
}
