// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Are the probabilities of borders what they say? Segments the models of a benchmark, with and without the number of
// segments given, and compares the probability of each border with the share of pairs of faces, one on each side, that
// people put into different segments. Prints a table, and what the probabilities would have to become: the logistic
// function of bias + slope * log odds. Both are 0 and 1 if nothing is left to do.

#include "Benchmark_folder.h"
#include "markdown_head.h"

#include <CGAL/protrusion_segmentation.h>

#include <CLI/CLI.hpp>
#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <exception>
#include <iomanip>
#include <iostream>
#include <map>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

using Protrusion = CGAL::Protrusion_segmentation::Protrusion<Face>;

struct Border
{
  int model;
  std::string class_name;
  double probability; // as the method tells it
  double apart;       // share of the pairs of faces that people put apart
};

using Borders = std::vector<Border>;

double log_odds(double probability)
{
  constexpr double least = 1e-9;
  const double p = (std::min)((std::max)(probability, least), 1 - least);
  return std::log(p / (1 - p));
}

double logistic(double x)
{
  return 1 / (1 + std::exp(-x));
}

// Of all pairs of a face of segment `s` and one of segment `t`.
double share_apart(const Labels& labels, std::size_t s, std::size_t t, const Labels& human)
{
  std::map<std::size_t, std::pair<double, double>> faces; // of each segment of the human: in s, in t
  std::pair<double, double> all = {0, 0};
  for (std::size_t f = 0; f < labels.size(); ++f)
    if (labels[f] == s || labels[f] == t)
    {
      ++(labels[f] == s ? faces[human[f]].first : faces[human[f]].second);
      ++(labels[f] == s ? all.first : all.second);
    }
  double together = 0;
  for (const auto& segment : faces)
    together += segment.second.first * segment.second.second;
  return 1 - together / (all.first * all.second);
}

// With the number of segments given, or not.
void add_borders(const Model& model, bool with_number, Borders& borders)
{
  Labels labels(model.mesh.number_of_faces());
  CGAL::Protrusion_segmentation::Segmentation_record<Mesh> record;
  const auto map = CGAL::make_property_map(labels);
  const auto visitor = CGAL::parameters::visitor(std::ref(record));
  if (with_number)
    CGAL::segmentation_via_protrusion_tips(model.mesh, map, model.number_of_segments, visitor);
  else
    CGAL::segmentation_via_protrusion_tips(model.mesh, map, visitor);
  for (const Protrusion& protrusion : record.protrusions())
  {
    double apart = 0;
    for (const Labels& human : model.humans)
      apart += share_apart(labels, protrusion.segment, protrusion.parent, human);
    borders.push_back({model.number, model.class_name, protrusion.probability.value(),
                       apart / double(model.humans.size())});
  }
}

// None if the model cannot be read.
void add_borders_of_model(const Benchmark_folder& benchmark, int number, Borders& borders)
{
  Model model;
  try
  {
    model = benchmark.read_model(number);
  }
  catch (const std::runtime_error& error)
  {
    std::cerr << "model " << number << " is left out: " << error.what() << std::endl;
    return;
  }
  for (const bool with_number : {true, false})
    add_borders(model, with_number, borders);
}

using Coefficients = Eigen::Vector2d; // bias and slope

double likelihood(const Borders& borders, const Coefficients& coefficients)
{
  double sum = 0;
  for (const Border& border : borders)
  {
    const double x = coefficients[0] + coefficients[1] * log_odds(border.probability);
    sum -= border.apart * std::log1p(std::exp(-x)) + (1 - border.apart) * std::log1p(std::exp(x));
  }
  return sum;
}

// The coefficients of largest likelihood, by Newton's method with halved steps: the logarithm is concave.
Coefficients fit(const Borders& borders)
{
  constexpr int number_of_steps = 50;
  Coefficients best(0, 0);
  double largest = likelihood(borders, best);
  for (int step = 0; step < number_of_steps; ++step)
  {
    Eigen::Vector2d gradient(0, 0);
    Eigen::Matrix2d curvature = Eigen::Matrix2d::Zero();
    for (const Border& border : borders)
    {
      const Eigen::Vector2d x(1, log_odds(border.probability));
      const double p = logistic(best.dot(x));
      gradient += (border.apart - p) * x;
      curvature += p * (1 - p) * x * x.transpose();
    }
    Eigen::Vector2d change = curvature.ldlt().solve(gradient);
    while (change.norm() > 1e-9 && !(likelihood(borders, best + change) > largest))
      change /= 2;
    if (!(change.norm() > 1e-9))
      break;
    best += change;
    largest = likelihood(borders, best);
  }
  return best;
}

double corrected(const Border& border, const Coefficients& coefficients)
{
  return logistic(coefficients[0] + coefficients[1] * log_odds(border.probability));
}

template <typename Probability>
double mean_squared_error(const Borders& borders, Probability probability)
{
  double sum = 0;
  for (const Border& border : borders)
    sum += std::pow(probability(border) - border.apart, 2);
  return sum / double(borders.size());
}

// Every class by the coefficients that were fitted to the others.
double error_on_other_classes(const Borders& borders)
{
  std::map<std::string, Coefficients> of_others;
  for (const Border& border : borders)
    if (of_others.find(border.class_name) == of_others.end())
    {
      Borders others;
      std::copy_if(borders.begin(), borders.end(), std::back_inserter(others),
                   [&](const Border& other) { return other.class_name != border.class_name; });
      of_others[border.class_name] = fit(others);
    }
  return mean_squared_error(borders, [&](const Border& border)
                            { return corrected(border, of_others.at(border.class_name)); });
}

// Standard deviations of the coefficients over samples of the models, drawn with replacement.
Coefficients spread(const Borders& borders)
{
  constexpr int number_of_samples = 200;
  std::map<int, Borders> of_model;
  for (const Border& border : borders)
    of_model[border.model].push_back(border);
  std::vector<const Borders*> models;
  for (const auto& model : of_model)
    models.push_back(&model.second);
  std::mt19937 random(0);
  Eigen::Array2d sum(0, 0), squares(0, 0);
  for (int sample = 0; sample < number_of_samples; ++sample)
  {
    Borders drawn;
    for (std::size_t i = 0; i < models.size(); ++i)
    {
      const Borders& model = *models[random() % models.size()];
      drawn.insert(drawn.end(), model.begin(), model.end());
    }
    const Eigen::Array2d coefficients = fit(drawn).array();
    sum += coefficients;
    squares += coefficients.square();
  }
  return (squares / number_of_samples - (sum / number_of_samples).square()).sqrt().matrix();
}

void print_table(const Borders& borders)
{
  constexpr int number_of_rows = 10;
  std::cout << "| probability | borders | mean probability | put apart by people |\n|:--|--:|--:|--:|\n";
  for (int row = 0; row < number_of_rows; ++row)
  {
    double number = 0, probability = 0, apart = 0;
    for (const Border& border : borders)
      if ((std::min)(int(border.probability * number_of_rows), number_of_rows - 1) == row)
      {
        ++number;
        probability += border.probability;
        apart += border.apart;
      }
    if (number > 0)
      std::cout << "| ." << row << " to " << (row + 1 < number_of_rows ? "." + std::to_string(row + 1) : "1") << " | "
                << std::size_t(number) << " | " << probability / number << " | " << apart / number << " |\n";
  }
}

void print_fit(const Borders& borders)
{
  const Coefficients coefficients = fit(borders), deviation = spread(borders);
  double mean = 0;
  for (const Border& border : borders)
    mean += border.apart / double(borders.size());
  std::cout << "\nFitted bias " << coefficients[0] << " (standard deviation " << deviation[0] << "), slope "
            << coefficients[1] << " (" << deviation[1] << "). Mean squared error "
            << mean_squared_error(borders, [](const Border& border) { return border.probability; })
            << ", corrected by a fit to the\nother classes " << error_on_other_classes(borders)
            << ", of one probability for all borders "
            << mean_squared_error(borders, [mean](const Border&) { return mean; }) << ".\n";
}

} // namespace

int main(int argc, char** argv)
{
  CLI::App app("Compares the probabilities of borders with what people do.");
  std::string title = "Probabilities of borders", folder, models, classes;
  app.add_option("--folder", folder, "unpacked archive of the benchmark")->required();
  app.add_option("--title", title, "heading of what is printed");
  app.add_option("--models", models, "such as 2,4,10-50,60-400/8 (default: all that are there)");
  app.add_option("--classes", classes, "such as \"People=1-200,Rigged=201-300\" (default: Princeton's)");
  CLI11_PARSE(app, argc, argv);
  try
  {
    const Benchmark_folder benchmark(folder, classes);
    Borders borders;
    for (const int number : benchmark.models(models))
      add_borders_of_model(benchmark, number, borders);
    std::cout << std::fixed << std::setprecision(3);
    write_head(std::cout, "##", title, "border_probabilities", argc, argv);
    print_table(borders);
    print_fit(borders);
    return EXIT_SUCCESS;
  }
  catch (const std::exception& error)
  {
    std::cerr << "border_probabilities: " << error.what() << std::endl;
    return EXIT_FAILURE;
  }
}
