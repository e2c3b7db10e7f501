// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Measures segmentation methods, ours and peers, against the human segmentations of the Princeton
// Segmentation Benchmark:
//
//   princeton_benchmark --folder FOLDER [--models 2,4,10-50] [--methods K-Means,Voronoi]
//                       [--segmentations NAME=FOLDER] [--threads N] [--seed N] [--output FOLDER] [--sheets]
//
// prints tables in Markdown, and writes CSV files to the output folder, with --sheets also a page of pictures for each
// method.

#include "Benchmark_folder.h"
#include "Model_evaluator.h"
#include "Results.h"
#include "Segmentation_folder.h"
#include "contact_sheet.h"
#include "contestants.h"
#include "for_each_in_threads.h"
#include "markdown_head.h"
#include "methods.h"
#include "reports.h"

#include <CLI/CLI.hpp>

#include <exception>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iostream>
#include <mutex>
#include <stdexcept>
#include <string>
#include <vector>

struct Options
{
  std::string title = "Quality";
  std::string folder;
  std::string models;
  std::string methods;
  std::vector<std::string> segmentations; // NAME=FOLDER
  std::string classes;
  std::string output;
  std::string segmentations_output;
  unsigned int threads = 1;
  unsigned int seed = 0;
  bool by_class = false;
  bool sheets = false;
  bool list_methods = false;
};

Model_result run_contestant(const Contestant& contestant, const Model& model,
                            const Model_evaluator& evaluator, const Options& options)
{
  Model_result result;
  Timed_labels timed;
  try
  {
    timed = contestant.segment(model, options.seed);
  }
  catch(const std::exception& exception)
  {
    result.failure = std::string(" failed: ") + exception.what();
    timed.labels.assign(model.mesh.number_of_faces(), 0);
  }
  if(result.failure.empty() && !options.segmentations_output.empty())
    add_to_segmentation_folder(options.segmentations_output + "/" + contestant.name, model.number, model.faces,
                               timed.labels, timed.seconds);
  result.scores = evaluator.scores(timed.labels);
  result.scores[Score::seconds] = timed.seconds;
  result.labels = std::move(timed.labels);
  return result;
}

Model_results run_model(const Model& model, const std::vector<Contestant>& contestants, const Options& options)
{
  const Model_evaluator evaluator(model);
  Model_results results;
  results.model = model.number;
  results.class_name = model.class_name;
  results.number_of_segments = model.number_of_segments;
  results.humans = evaluator.human_scores();
  results.typical_human = evaluator.most_typical_human();
  for(const Contestant& contestant : contestants)
    results.methods.push_back(run_contestant(contestant, model, evaluator, options));
  return results;
}

// Runs the models in parallel, each method on one thread; the results do not depend on it.
class Runner
{
public:
  Runner(const Benchmark_folder& folder, const std::vector<Contestant>& contestants,
         const Options& options)
    : m_folder(folder), m_contestants(contestants), m_options(options)
    , m_models(folder.models(options.models)), m_results(m_models.size())
  {
    if(m_models.empty())
      throw std::invalid_argument("none of the models is in the folder");
  }

  std::vector<Model_results> run()
  {
    for_each_in_threads(m_models.size(), (std::max)(1u, m_options.threads),
                        [this](std::size_t i)
                        {
                          const std::string problem = run_model(i);
                          const std::lock_guard<std::mutex> lock(m_mutex);
                          std::cerr << "model " << m_models[i] << " (" << ++m_number_done << " of "
                                    << m_models.size() << ")" << problem << std::endl;
                        });
    std::vector<Model_results> results;
    for(Model_results& of_model : m_results)
      if(of_model.model != 0) // else it could not be read
        results.push_back(std::move(of_model));
    if(results.empty())
      throw std::runtime_error("none of the models can be read");
    if(results.size() < m_models.size())
      std::cerr << m_models.size() - results.size() << " of " << m_models.size()
                << " models are left out" << std::endl;
    return results;
  }

private:
  // Why it is left out; empty if it is not.
  std::string run_model(std::size_t i)
  {
    Model model;
    try
    {
      model = m_folder.read_model(m_models[i]);
    }
    catch(const std::exception& error)
    {
      return std::string(" is left out: ") + error.what();
    }
    m_results[i] = ::run_model(model, m_contestants, m_options);
    return "";
  }

  const Benchmark_folder& m_folder;
  const std::vector<Contestant>& m_contestants;
  const Options& m_options;
  std::vector<int> m_models;
  std::vector<Model_results> m_results;
  std::size_t m_number_done = 0;
  std::mutex m_mutex;
};

void write_output(const std::string& folder, const std::string& name,
                  const std::function<void(std::ostream&)>& write)
{
  const std::string file = (std::filesystem::path(folder) / name).string();
  std::ofstream out(file);
  write(out);
  out.close();
  if(!out)
    throw std::runtime_error(file + ": cannot be written");
}

void write_outputs(const Options& options, const Benchmark_folder& folder, const Results& results)
{
  std::filesystem::create_directories(options.output);
  write_output(options.output, "models.csv",
               [&](std::ostream& out) { write_models_csv(out, results); });
  write_output(options.output, "classes.csv",
               [&](std::ostream& out) { write_classes_csv(out, results); });
  write_output(options.output, "differences.csv",
               [&](std::ostream& out) { write_differences_csv(out, results); });
  if(options.sheets)
  {
    write_output(options.output, "all_methods.html", [&](std::ostream& out)
                 { write_comparison_sheet(out, folder, results); });
    for(std::size_t i = 0; i < results.methods().size(); ++i)
      write_output(options.output, results.methods()[i] + ".html", [&](std::ostream& out)
                   { write_contact_sheet(out, folder, results, i); });
  }
}

void run(const Options& options, int argc, char** argv)
{
  const std::vector<Contestant> contestants = chosen_contestants(options.methods, options.segmentations);
  std::vector<std::string> names;
  for(const Contestant& contestant : contestants)
    names.push_back(contestant.name);

  const Benchmark_folder folder(options.folder, options.classes);
  const Results results(names, Runner(folder, contestants, options).run());
  write_head(std::cout, "#", options.title, "princeton_benchmark", argc, argv);
  write_means(std::cout, results);
  if(options.by_class)
    write_by_class(std::cout, results);
  if(!options.output.empty())
    write_outputs(options, folder, results);
}

int main(int argc, char** argv)
{
  Options options;
  CLI::App app("Measures segmentation methods on the Princeton Segmentation Benchmark.",
               "princeton_benchmark");
  app.add_option("--folder", options.folder, "unpacked archive of the benchmark");
  app.add_option("--title", options.title, "heading of what is printed");
  app.add_option("--models", options.models, "such as 2,4,10-50,60-400/8 (default: all that are there)");
  app.add_option("--methods", options.methods, "such as K-Means,Voronoi (default: all but the slowest)");
  app.add_option("--segmentations", options.segmentations,
                 "NAME=FOLDER: <model>.seg files that any program made, as a further method; repeatable")
    ->allow_extra_args(false);
  app.add_option("--classes", options.classes,
                 "of the models, such as People=1-200,Animals=201-300 (default: Princeton's)");
  app.add_option("--threads", options.threads, "models at a time (default: 1)");
  app.add_option("--seed", options.seed, "of what is random (default: 0)");
  app.add_option("--output", options.output, "folder for models.csv, classes.csv, differences.csv");
  app.add_option("--write-segmentations", options.segmentations_output,
                 "folder for a folder of each method's segmentations and times, as --segmentations reads them");
  app.add_flag("--by-class", options.by_class, "print a table of the classes as well");
  app.add_flag("--sheets", options.sheets, "write a page of pictures for each method as well");
  app.add_flag("--list-methods", options.list_methods, "print the names of the methods");
  CLI11_PARSE(app, argc, argv);

  try
  {
    if(options.list_methods)
      for(const Segmentation_method& method : all_methods())
        std::cout << method.name << "\n";
    else if(options.folder.empty())
      throw std::invalid_argument("--folder is missing");
    else
      run(options, argc, argv);
  }
  catch(const std::exception& exception)
  {
    std::cerr << "princeton_benchmark: " << exception.what() << std::endl;
    return 1;
  }
  return 0;
}
