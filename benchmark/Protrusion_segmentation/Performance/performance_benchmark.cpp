// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Measures the time and the memory of whole segmentations on the meshes of the Princeton Segmentation
// Benchmark and prints tables in Markdown:
//
//   performance_benchmark --folder FOLDER [--tables 1,3] [--models 2,4,10-50] [--methods NAME,...]
//                         [--repetitions N] [--threads 2,4,8] [--growth-model N] [--largest-growth FACES]
//                         [--gap-model N] [--gap-limit SECONDS]

#include "markdown_head.h"
#include "measure.h"
#include "protrusion_methods.h"
#include "tables.h"

#include <CGAL/version.h>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <iostream>
#include <sstream>
#include <stdexcept>
#include <thread>

namespace {

std::string processor()
{
  std::ifstream in("/proc/cpuinfo");
  for (std::string line; std::getline(in, line);)
    if (line.compare(0, 10, "model name") == 0)
      return line.substr(line.find(':') + 2);
  return "unknown processor";
}

void print_head(int argc, char** argv, const Options& options)
{
  write_head(std::cout, "#", "Performance", "performance_benchmark", argc, argv);
  std::cout << "Machine: " << processor() << ", " << std::thread::hardware_concurrency() << " threads; CGAL "
            << CGAL_VERSION_STR << ", compiler " << __VERSION__
            << ".\nProcessor time (table 4: wall clock), medians of " << options.repetitions << " repetitions.\n\n";
}

using Print_table = void (*)(const Options&, const Benchmark_folder&);

void print_tables(const Options& options)
{
  const Benchmark_folder folder(options.folder);
  const std::vector<Print_table> tables = {print_distance_table, print_peer_table,    print_growth_table,
                                           print_thread_table,   print_gap_table,     print_library_table,
                                           print_shape_table};
  for (const int table : options.tables)
  {
    tables.at(std::size_t(table - 1))(options, folder);
    std::cout << std::endl;
  }
}

} // namespace

std::vector<Segmentation_method> methods_to_measure(const Options& options)
{
  const std::vector<Segmentation_method> all = protrusion_methods();
  std::vector<Segmentation_method> result;
  std::istringstream in(options.methods);
  for (std::string name; std::getline(in, name, ',');)
  {
    const auto method = std::find_if(all.begin(), all.end(),
                                     [&](const Segmentation_method& m) { return m.name == name; });
    if (method == all.end())
      throw std::invalid_argument("there is no method '" + name + "'");
    result.push_back(*method);
  }
  return result;
}

int main(int argc, char** argv)
{
  Options options;
  CLI::App app("Time and memory of whole segmentations, as tables in Markdown");
  app.add_option("--folder", options.folder, "unpacked archive of the Princeton Segmentation Benchmark")
    ->required();
  app.add_option("--models", options.models, "models of tables 2 and 6, such as 2,4,10-50,60-400/8");
  app.add_option("--methods", options.methods, "methods of tables 2, 3 and 7");
  app.add_option("--tables", options.tables, "tables to print, of 1 to 7")
    ->delimiter(',')
    ->check(CLI::Range(1, 7));
  app.add_option("--repetitions", options.repetitions, "of each measurement")
    ->check(CLI::PositiveNumber);
  app.add_option("--growth-model", options.growth_model, "the model that tables 3 and 4 subdivide");
  app.add_option("--largest-growth", options.largest_growth, "the most faces in table 3");
  app.add_option("--threads", options.threads, "numbers of threads of table 4, such as 2,4,8")
    ->delimiter(',')
    ->check(CLI::PositiveNumber);
  app.add_option("--gap-model", options.gap_model, "the model of table 5, which is subdivided once");
  app.add_option("--gap-limit", options.gap_limit, "the seconds after which a call of table 5 is stopped")
    ->check(CLI::PositiveNumber);
  CLI11_PARSE(app, argc, argv);

  try
  {
    print_head(argc, argv, options);
    print_tables(options);
  }
  catch (const std::exception& exception)
  {
    std::cerr << "performance_benchmark: " << exception.what() << std::endl;
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
