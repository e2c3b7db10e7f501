// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Fits the weights of the clues of cuts to people's segmentations, in the loop: what is made small is the mean Rand index
// error of the whole method with those weights, not an error of single cuts. Prints the weights that it comes to, how far
// they lie apart if models are drawn again, and, class by class, what weights bring that were fitted to the other classes.

#include "Benchmark_folder.h"
#include "Candidate_pool.h"
#include "Model_classes.h"
#include "bootstrap.h"
#include "markdown_head.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <exception>
#include <iomanip>
#include <iostream>
#include <map>
#include <memory>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

using CGAL::Protrusion_segmentation::internal::Cut_weights;

// The first step is about what changes the log odds of typical cuts by a fifth.
struct Named_weight
{
  const char* name;
  double Cut_weights::*weight;
  double first_step;
};

constexpr std::array<Named_weight, 19> named_weights = {
  {{"bias", &Cut_weights::bias, 0.5},
   {"concave_share", &Cut_weights::concave_share, 1},
   {"relative_length", &Cut_weights::relative_length, 0.5},
   {"least_relative_length", &Cut_weights::least_relative_length, 0.1},
   {"segment_size", &Cut_weights::segment_size, 0.2},
   {"larger_widening", &Cut_weights::larger_widening, 0.4},
   {"smaller_widening", &Cut_weights::smaller_widening, 0.3},
   {"larger_shoulder", &Cut_weights::larger_shoulder, 1},
   {"least_larger_shoulder", &Cut_weights::least_larger_shoulder, 0.05},
   {"largest_larger_shoulder", &Cut_weights::largest_larger_shoulder, 0.1},
   {"smaller_shoulder", &Cut_weights::smaller_shoulder, 1},
   {"roundness", &Cut_weights::roundness, 0.3},
   {"neighbors", &Cut_weights::neighbors, 0.3},
   {"contrast", &Cut_weights::contrast, 0.3},
   {"mean_cost", &Cut_weights::mean_cost, 0.3},
   {"thickness", &Cut_weights::thickness, 0.3},
   {"surrounded", &Cut_weights::surrounded, 2},
   {"most_neighbors", &Cut_weights::most_neighbors, 0.2},
   {"pocket", &Cut_weights::pocket, 2},
   {"several_loops", &Cut_weights::several_loops, 0.5},
   {"flatness", &Cut_weights::flatness, 2},
   {"least_flatness", &Cut_weights::least_flatness, 0.1}}};

// Short cuts in concave seams of large segments: where a fit begins that is to know nothing of the models held back.
Cut_weights plain_weights()
{
  Cut_weights weights;
  for (const Named_weight& named : named_weights)
    weights.*named.weight = 0;
  weights.concave_share = 4;
  weights.relative_length = -2;
  weights.least_relative_length = -1;
  weights.least_larger_shoulder = 0;
  weights.largest_larger_shoulder = 1;
  weights.segment_size = 1;
  return weights;
}

// Models may come up more than once.
using Sample = std::vector<Candidate_pool*>;

class Fit
{
public:
  explicit Fit(std::size_t number_of_rounds) : m_number_of_rounds(number_of_rounds) {}

  // Mean over the classes.
  double error(const Sample& sample, const Cut_weights& weights) const
  {
    std::map<Candidate_pool*, double> error_of_pool;
    std::map<std::string, std::vector<double>> of_class;
    for (Candidate_pool* pool : sample)
    {
      const auto [found, is_new] = error_of_pool.emplace(pool, 0);
      if (is_new)
        found->second = pool->rand_index_error(weights);
      of_class[pool->class_name()].push_back(found->second);
    }
    Values_by_class values;
    for (const auto& item : of_class)
      values.push_back(item.second);
    return mean_of_classes(values);
  }

  // From plain weights on, one after the other goes a step up or down if that is better, and else takes half of the step in
  // the next round: there is no gradient, as the error jumps when another cut gets ahead.
  Cut_weights operator()(const Sample& sample) const
  {
    Cut_weights best = plain_weights();
    double least = error(sample, best);
    std::array<double, named_weights.size()> steps;
    std::transform(named_weights.begin(), named_weights.end(), steps.begin(),
                   [](const Named_weight& named) { return named.first_step; });
    for (std::size_t round = 0; round < m_number_of_rounds; ++round)
      for (std::size_t i = 0; i < named_weights.size(); ++i)
        if (!take_step(sample, named_weights[i], steps[i], best, least))
          steps[i] /= 2;
    return best;
  }

private:
  bool take_step(const Sample& sample,
                 const Named_weight& named,
                 double step,
                 Cut_weights& best,
                 double& least) const
  {
    constexpr double least_improvement = 1e-4; // less is a matter of few borders
    for (const double change : {step, -step})
    {
      Cut_weights other = best;
      other.*named.weight += change;
      const double found = error(sample, other);
      if (found < least - least_improvement)
      {
        best = other;
        least = found;
        return true;
      }
    }
    return false;
  }

  std::size_t m_number_of_rounds;
};

std::vector<std::unique_ptr<Candidate_pool>> read_pools(const Benchmark_folder& benchmark,
                                                        const std::vector<int>& models)
{
  std::vector<std::unique_ptr<Candidate_pool>> pools;
  for (const int number : models)
    try
    {
      pools.push_back(std::make_unique<Candidate_pool>(benchmark.read_model(number)));
    }
    catch (const std::exception& error)
    {
      std::cerr << "model " << number << " is left out: " << error.what() << std::endl;
    }
  if (pools.empty())
    throw std::runtime_error("there are no models to fit to");
  return pools;
}

std::map<std::string, Sample> by_class(const Sample& sample)
{
  std::map<std::string, Sample> result;
  for (Candidate_pool* pool : sample)
    result[pool->class_name()].push_back(pool);
  return result;
}

// As many models of each class, drawn with replacement.
Sample drawn_again(const Sample& sample, std::mt19937& random)
{
  Sample result;
  for (const auto& item : by_class(sample))
    for (std::size_t i = 0; i < item.second.size(); ++i)
      result.push_back(item.second[random() % item.second.size()]);
  return result;
}

// Of each weight, over the fits to samples; the spread is a standard deviation.
void print_weights(const Fit& fit, const Sample& all, std::size_t number_of_samples)
{
  const Cut_weights present, fitted = fit(all);
  std::vector<Cut_weights> of_samples;
  std::mt19937 random(0);
  for (std::size_t i = 0; i < number_of_samples; ++i)
    of_samples.push_back(fit(drawn_again(all, random)));
  std::cout << "## Weights\n\nThe fit makes the Rand index error with a number of segments small; the "
               "last two columns are of "
            << number_of_samples << " fits to models drawn again.\n\n"
            << "| weight | of the package | fitted | mean of samples | spread |\n|:--|--:|--:|--:|--:|\n";
  for (const Named_weight& named : named_weights)
  {
    double sum = 0, squares = 0;
    for (const Cut_weights& weights : of_samples)
    {
      sum += weights.*named.weight;
      squares += std::pow(weights.*named.weight, 2);
    }
    const double n = double(number_of_samples), mean = sum / n;
    std::cout << "| " << named.name << " | " << present.*named.weight << " | " << fitted.*named.weight
              << " | " << mean << " | " << std::sqrt((std::max)(0., squares / n - mean * mean)) << " |\n";
  }
  std::cout << "\nMean Rand index error: " << fit.error(all, present)
            << " with the weights of the package, " << fit.error(all, fitted)
            << " with the fitted ones.\n\n"
            << std::flush;
}

void print_other_classes(const Fit& fit, const Sample& all)
{
  std::cout
    << "## Classes that the fit has not seen\n\nEach class with weights fitted to the other classes.\n\n"
    << "| class | models | weights of the package | fitted to the other classes |\n|:--|--:|--:|--:|\n";
  double sum_of_present = 0, sum_of_fitted = 0;
  const std::map<std::string, Sample> classes = by_class(all);
  for (const auto& [name, models] : classes)
  {
    Sample others;
    for (Candidate_pool* pool : all)
      if (pool->class_name() != name)
        others.push_back(pool);
    const double present = fit.error(models, Cut_weights()), fitted = fit.error(models, fit(others));
    sum_of_present += present;
    sum_of_fitted += fitted;
    std::cout << "| " << name << " | " << models.size() << " | " << present << " | " << fitted << " |\n"
              << std::flush;
  }
  std::cout << "| **mean** | " << all.size() << " | " << sum_of_present / double(classes.size()) << " | "
            << sum_of_fitted / double(classes.size()) << " |\n";
}

} // namespace

int main(int argc, char** argv)
{
  CLI::App app("Fits the weights of the clues of cuts to people's segmentations.");
  std::string folder, models, classes;
  std::size_t rounds = 12, samples = 10;
  app.add_option("--folder", folder, "unpacked archive of the benchmark")->required();
  app.add_option("--models", models, "such as 2,4,10-50,60-400/8 (default: all that are there)");
  app.add_option("--classes", classes, "such as \"People=1-200,Rigged=201-300\" (default: Princeton's)");
  app.add_option("--rounds", rounds, "over all weights")
    ->check(CLI::PositiveNumber)
    ->capture_default_str();
  app.add_option("--samples", samples, "of the models, to see the spread")
    ->check(CLI::PositiveNumber)
    ->capture_default_str();
  CLI11_PARSE(app, argc, argv);
  try
  {
    const Benchmark_folder benchmark(folder, classes.empty() ? Model_classes() : Model_classes(classes));
    const auto pools = read_pools(benchmark, benchmark.models(models));
    Sample all;
    for (const auto& pool : pools)
      all.push_back(pool.get());
    const Fit fit(rounds);
    std::cout << std::fixed << std::setprecision(3);
    write_head(std::cout, "#", "Quality: weights of the clues", "fit_cut_weights", argc, argv);
    print_weights(fit, all, samples);
    print_other_classes(fit, all);
    return EXIT_SUCCESS;
  }
  catch (const std::exception& error)
  {
    std::cerr << "fit_cut_weights: " << error.what() << std::endl;
    return EXIT_FAILURE;
  }
}
