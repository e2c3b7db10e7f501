// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Fits the weights of the clues of cuts to people's segmentations and to shapes whose parts are known, in the loop: what is
// made small is an error of the whole method with those weights, not one of single cuts. Prints the weights that it comes to,
// how far they lie apart if models are drawn again, and, class by class, what weights bring that were fitted to the others.

#include "Benchmark_folder.h"
#include "Candidate_pool.h"
#include "bootstrap.h"
#include "for_each_in_threads.h"
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
#include <utility>
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

constexpr std::array<Named_weight, 21> named_weights = {
  {{"bias", &Cut_weights::bias, 0.5},
   {"concave_share", &Cut_weights::concave_share, 1},
   {"relative_length", &Cut_weights::relative_length, 0.5},
   {"least_relative_length", &Cut_weights::least_relative_length, 0.1},
   {"segment_size", &Cut_weights::segment_size, 0.2},
   {"widening", &Cut_weights::widening, 0.4},
   {"larger_shoulder", &Cut_weights::larger_shoulder, 1},
   {"least_larger_shoulder", &Cut_weights::least_larger_shoulder, 0.05},
   {"largest_larger_shoulder", &Cut_weights::largest_larger_shoulder, 0.1},
   {"smaller_shoulder", &Cut_weights::smaller_shoulder, 1},
   {"roundness", &Cut_weights::roundness, 0.3},
   {"neighbors", &Cut_weights::neighbors, 0.3},
   {"mean_cost", &Cut_weights::mean_cost, 0.3},
   {"thickness", &Cut_weights::thickness, 0.3},
   {"surrounded", &Cut_weights::surrounded, 2},
   {"most_neighbors", &Cut_weights::most_neighbors, 0.2},
   {"pocket", &Cut_weights::pocket, 2},
   {"several_loops", &Cut_weights::several_loops, 0.5},
   {"flatness", &Cut_weights::flatness, 2},
   {"least_flatness", &Cut_weights::least_flatness, 0.1},
   {"like_part", &Cut_weights::like_part, 0.5}}};

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

// What is made small, of one model: the mean of the Rand index errors with the number of segments and without it, and more
// if that number is not found where it is known.
double error_of(const Candidate_pool::Errors& errors, bool has_known_parts)
{
  constexpr double wrong_number = 0.05; // a further segment of a shape with few adds as much to the Rand index error
  return (errors.with_number + errors.automatic) / 2 + (has_known_parts && !errors.is_number_found ? wrong_number : 0);
}

class Fit
{
public:
  Fit(std::size_t number_of_rounds, std::size_t number_of_threads, const Cut_weights& start)
    : m_number_of_rounds(number_of_rounds), m_number_of_threads(number_of_threads), m_start(start)
  {}

  // Mean over the folders of the means over their classes.
  double error(const Sample& sample, const Cut_weights& weights) const
  {
    const std::map<Candidate_pool*, double> errors = errors_of_pools(sample, weights);
    std::map<std::size_t, std::map<std::string, std::vector<double>>> of_folders;
    for (Candidate_pool* pool : sample)
      of_folders[pool->folder()][pool->class_name()].push_back(errors.at(pool));
    double sum = 0;
    for (const auto& of_folder : of_folders)
    {
      Values_by_class values;
      for (const auto& item : of_folder.second)
        values.push_back(item.second);
      sum += mean_of_classes(values);
    }
    return sum / double(of_folders.size());
  }

  // From the start on, one after the other goes a step up or down if that is better, and else takes half of the step in
  // the next round: there is no gradient, as the error jumps when another cut gets ahead.
  Cut_weights operator()(const Sample& sample) const
  {
    Cut_weights best = m_start;
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
  std::map<Candidate_pool*, double> errors_of_pools(const Sample& sample, const Cut_weights& weights) const
  {
    std::map<Candidate_pool*, double> errors;
    for (Candidate_pool* pool : sample)
      errors.emplace(pool, 0);
    std::vector<std::pair<Candidate_pool* const, double>*> items;
    for (auto& item : errors)
      items.push_back(&item);
    for_each_in_threads(items.size(), m_number_of_threads,
                        [&](std::size_t i)
                        {
                          auto& [pool, error] = *items[i];
                          error = error_of(pool->errors(weights), pool->has_known_parts());
                        });
    return errors;
  }

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
        std::cerr << named.name << ' ' << best.*named.weight << " -> " << other.*named.weight << ": " << least << " -> "
                  << found << std::endl;
        best = other;
        least = found;
        return true;
      }
    }
    return false;
  }

  std::size_t m_number_of_rounds, m_number_of_threads;
  Cut_weights m_start;
};

// `models`: of each folder, if there are as many lists
std::vector<std::unique_ptr<Candidate_pool>> read_pools(const std::vector<std::string>& folders,
                                                        const std::vector<std::string>& models)
{
  std::vector<std::unique_ptr<Candidate_pool>> pools;
  for (std::size_t i = 0; i < folders.size(); ++i)
  {
    const Benchmark_folder benchmark(folders[i]);
    for (const int number : benchmark.models(i < models.size() ? models[i] : ""))
      try
      {
        pools.push_back(std::make_unique<Candidate_pool>(benchmark.read_model(number), i));
      }
      catch (const std::exception& error)
      {
        std::cerr << "model " << number << " is left out: " << error.what() << std::endl;
      }
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
  std::cout << "## Weights\n\nThe fit makes the mean error with a number of segments and without one small; the "
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
    const double n = (std::max)(1., double(number_of_samples)), mean = sum / n;
    std::cout << "| " << named.name << " | " << present.*named.weight << " | " << fitted.*named.weight
              << " | " << mean << " | " << std::sqrt((std::max)(0., squares / n - mean * mean)) << " |\n";
  }
  std::cout << "\nMean error: " << fit.error(all, present)
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
  CLI::App app("Fits the weights of the clues of cuts to people's segmentations and to shapes whose parts are known.");
  std::vector<std::string> folders, models;
  std::size_t rounds = 12, samples = 10, threads = 1;
  bool goes_on = false;
  app.add_option("--folder", folders, "unpacked archives of benchmarks, or folders of make_random_shapes, that count alike")
    ->required();
  app.add_option("--models", models, "of each folder, such as 2,4,10-50,60-400/8 (default: all that are there)");
  app.add_flag("--from-package", goes_on, "begin with the weights of the package");
  app.add_option("--threads", threads, "models side by side")->check(CLI::PositiveNumber)->capture_default_str();
  app.add_option("--rounds", rounds, "over all weights")
    ->check(CLI::PositiveNumber)
    ->capture_default_str();
  app.add_option("--samples", samples, "of the models, to see the spread")
    ->check(CLI::NonNegativeNumber)
    ->capture_default_str();
  CLI11_PARSE(app, argc, argv);
  try
  {
    const auto pools = read_pools(folders, models);
    Sample all;
    for (const auto& pool : pools)
      all.push_back(pool.get());
    const Fit fit(rounds, threads, goes_on ? Cut_weights() : plain_weights());
    std::cout << std::fixed << std::setprecision(3);
    write_head(std::cout, "#", "Quality: weights of the clues", "fit_cut_weights", argc, argv);
    print_weights(fit, all, samples);
    if (samples > 0)
      print_other_classes(fit, all);
    return EXIT_SUCCESS;
  }
  catch (const std::exception& error)
  {
    std::cerr << "fit_cut_weights: " << error.what() << std::endl;
    return EXIT_FAILURE;
  }
}
