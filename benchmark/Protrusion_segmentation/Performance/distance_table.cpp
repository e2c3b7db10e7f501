// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "measure.h"
#include "tables.h"

#include <CGAL/Protrusion_segmentation/Diffusion_distance.h>
#include <CGAL/Protrusion_segmentation/Heat_distance.h>
#include <CGAL/Protrusion_segmentation/Histogram_method.h>
#include <CGAL/protrusion_segmentation.h>
#include <CGAL/subdivision_method_3.h>

#include <functional>
#include <iostream>
#include <string>
#include <vector>

namespace {

namespace PS = CGAL::Protrusion_segmentation;
using Index = PS::Indexed_surface::Index;

// GD by the paper's procedure: the sums of eq. (1) from all pairs.
class All_pairs_distance
{
public:
  class On_surface : public PS::internal::Shortest_distances
  {
  public:
    On_surface(const PS::Indexed_surface& surface, PS::Execution& execution)
      : PS::internal::Shortest_distances(surface), m_surface(surface), m_execution(execution)
    {}

    Index face_of_largest_sum()
    {
      return PS::internal::largest_distance_sum_of_all_pairs(m_surface, *this, m_execution);
    }

  private:
    const PS::Indexed_surface& m_surface;
    PS::Execution& m_execution;
  };

  On_surface on(const PS::Indexed_surface& surface, PS::Execution& execution) const
  {
    return On_surface(surface, execution);
  }
};

struct Measurement
{
  double seconds;
  std::size_t runs;
};

template <typename Distance>
Measurement measure(const Model& model, const Distance& distance, std::size_t repetitions)
{
  Labels labels(model.mesh.number_of_faces());
  PS::Segmentation_record<Mesh> record;
  const double seconds =
    seconds_of(repetitions,
               [&]
               {
                 CGAL::segmentation_via_protrusion_tips(
                   model.mesh, CGAL::make_property_map(labels), model.number_of_segments,
                   PS::Histogram_method(distance), CGAL::parameters::visitor(std::ref(record)));
               });
  return {seconds, record.number_of_runs()};
}

// A line of the table: a distance, and the seconds that the paper gives for it.
struct Row
{
  std::string name;
  std::function<Measurement(const Model&, std::size_t)> measure; // with so many repetitions
  std::vector<double> published;
  bool is_for_large_meshes;
};

// `distance_for` makes the distance for a model.
template <typename Distance_for>
Row row_for(const std::string& name, Distance_for distance_for, const std::vector<double>& published,
            bool is_for_large_meshes)
{
  return {name,
          [distance_for](const Model& model, std::size_t repetitions)
          { return measure(model, distance_for(model), repetitions); },
          published, is_for_large_meshes};
}

// The same distance for all models.
template <typename Distance>
Row row(const std::string& name, const Distance& distance, const std::vector<double>& published,
        bool is_for_large_meshes)
{
  return row_for(name, [distance](const Model&) { return distance; }, published, is_for_large_meshes);
}

std::vector<Row> rows()
{
  return {row("GD", PS::Geodesic_distance(), {}, true),
          row("GD, all pairs", All_pairs_distance(), {12.9, 850.5}, false),
          row("LGD(1)", PS::Landmark_geodesic_distance(0.01), {0.44, 32.9}, true),
          row("LGD(5)", PS::Landmark_geodesic_distance(0.05), {0.96, 68.2}, false),
          row("LGD(10)", PS::Landmark_geodesic_distance(0.1), {1.67, 135.4}, false),
          row("DD(5)", PS::Diffusion_distance(5), {17.7, 105.4}, true),
          row("DD(10)", PS::Diffusion_distance(10), {18.3, 106.3}, true),
          row_for("DD(k)",
                  [](const Model& model) { return PS::Diffusion_distance(model.number_of_segments); },
                  {17.4, 105.8}, true),
          row("heat", PS::Heat_distance(), {}, true)};
}

// The last model is a large one, for which slow distances are left out and the paper has no seconds.
void print_rows(const std::vector<Model>& models, std::size_t repetitions)
{
  std::vector<std::string> header(1, "distance");
  for (const Model& model : models)
  {
    const bool is_large = &model == &models.back();
    header.push_back("model " + std::to_string(model.number) + (is_large ? " subdivided (" : " (") +
                     std::to_string(model.mesh.number_of_faces()) + " faces) [s]");
    header.push_back("runs");
    if (!is_large)
      header.push_back("paper [s]");
  }
  const Markdown_table table(header);
  for (const Row& row : rows())
  {
    std::vector<std::string> cells(1, row.name);
    for (std::size_t i = 0; i < models.size(); ++i)
    {
      const bool is_large = i + 1 == models.size();
      if (is_large && !row.is_for_large_meshes)
        continue;
      const bool is_slow = is_large || !row.is_for_large_meshes;
      const Measurement measurement = row.measure(models[i], is_slow ? 1 : repetitions);
      cells.insert(cells.end(), {number(measurement.seconds), std::to_string(measurement.runs)});
      if (!is_large)
        cells.push_back(row.published.empty() ? "" : number(row.published[i]));
    }
    table.row(cells);
  }
}

} // namespace

void print_distance_table(const Options& options, const Benchmark_folder& folder)
{
  std::cout << "## 1. The paper's method with each distance\n\n"
            << "Time of the whole segmentation and number of distance computations. Goal: GD faster than LGD(1).\n\n";
  std::vector<Model> models = {folder.read_model(125), folder.read_model(393), folder.read_model(options.large_model)};
  CGAL::Subdivision_method_3::Loop_subdivision(models.back().mesh,
                                               CGAL::parameters::number_of_iterations(1));
  print_rows(models, options.repetitions);
}
