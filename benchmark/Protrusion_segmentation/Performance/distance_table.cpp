// SPDX-License-Identifier: GPL-3.0-or-later

#include "measure.h"
#include "tables.h"

#include <CGAL/Protrusion_segmentation/Diffusion_distance.h>
#include <CGAL/Protrusion_segmentation/Heat_distance.h>
#include <CGAL/protrusion_segmentation.h>

#include <functional>
#include <iostream>

namespace {

namespace PS = CGAL::Protrusion_segmentation;
using Index = PS::Surface_part::Index;

// GD by the paper's procedure: the sums of eq. (1) from all pairs.
class All_pairs_distance
{
public:
  class On_part : public PS::internal::Shortest_distances
  {
  public:
    explicit On_part(const PS::Surface_part& part)
      : PS::internal::Shortest_distances(part), m_part(part)
    {}

    Index face_of_largest_sum()
    {
      return PS::internal::largest_distance_sum_of_all_pairs(m_part, *this);
    }

  private:
    const PS::Surface_part& m_part;
  };

  On_part on(const PS::Surface_part& part, unsigned int) const { return On_part(part); }
};

struct Run_counter : PS::Default_visitor
{
  std::size_t runs = 0;
  void distances_computed(std::size_t number_of_runs) { runs += number_of_runs; }
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
  Run_counter counter;
  const double seconds =
    seconds_of(repetitions,
               [&]
               {
                 counter.runs = 0;
                 CGAL::segmentation_via_protrusion_tips(
                   model.mesh, CGAL::make_property_map(labels), model.number_of_segments, distance,
                   PS::Histogram_border(), CGAL::parameters::visitor(std::ref(counter)));
               });
  return {seconds, counter.runs};
}

// A line for a distance, with the seconds that the paper gives for it. `distance_for` makes it for a model.
template <typename Distance_for>
void print_row(const Markdown_table& table, const std::vector<Model>& models, const std::string& name,
               Distance_for distance_for, const std::vector<double>& published,
               const std::vector<double>& ours, std::size_t repetitions)
{
  std::vector<std::string> cells(1, name);
  for(std::size_t i = 0; i < models.size(); ++i)
  {
    const Measurement measurement = measure(models[i], distance_for(models[i]), repetitions);
    cells.push_back(number(measurement.seconds));
    cells.push_back(std::to_string(measurement.runs));
    cells.push_back(number(measurement.seconds / ours[i]));
    cells.push_back(published.empty() ? "" : number(published[i]));
  }
  table.row(cells);
}

// The same distance for all models.
template <typename Distance>
auto always(const Distance& distance)
{
  return [distance](const Model&) { return distance; };
}

} // namespace

void print_distance_table(const Options& options, const Benchmark_folder& folder)
{
  std::cout << "## 1. The paper's method with each distance (Table II)\n\n"
            << "Seconds of the whole segmentation, and distance computations. Goal: the exact face "
               "of eq. (1) in less time than LGD(1).\n\n";
  std::vector<Model> models;
  std::vector<std::string> header(1, "distance");
  std::vector<double> ours;
  for(const int number : {125, 393})
  {
    models.push_back(folder.read_model(number));
    const std::string name = "model " + std::to_string(number) + " (" +
                             std::to_string(models.back().mesh.number_of_faces()) + " faces)";
    header.insert(header.end(), {name + " [s]", "runs", "ratio to ours", "paper [s]"});
    ours.push_back(measure(models.back(), PS::Geodesic_distance(), options.repetitions).seconds);
  }
  const Markdown_table table(header);
  const std::size_t n = options.repetitions;
  print_row(table, models, "GD, all pairs", always(All_pairs_distance()), {12.9, 850.5}, ours, 1);
  print_row(table, models, "LGD(1)", always(PS::Landmark_geodesic_distance(0.01)), {0.44, 32.9}, ours, n);
  print_row(table, models, "LGD(5)", always(PS::Landmark_geodesic_distance(0.05)), {0.96, 68.2}, ours, n);
  print_row(table, models, "LGD(10)", always(PS::Landmark_geodesic_distance(0.1)), {1.67, 135.4}, ours, n);
  print_row(table, models, "GD, ours", always(PS::Geodesic_distance()), {}, ours, n);
  print_row(table, models, "DD(5)", always(PS::Diffusion_distance(5)), {17.7, 105.4}, ours, n);
  print_row(table, models, "DD(10)", always(PS::Diffusion_distance(10)), {18.3, 106.3}, ours, n);
  print_row(table, models, "DD(k)",
            [](const Model& model) { return PS::Diffusion_distance(model.number_of_segments); },
            {17.4, 105.8}, ours, n);
  print_row(table, models, "heat", always(PS::Heat_distance()), {}, ours, n);
}
