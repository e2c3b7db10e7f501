// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// robustness_benchmark --folder FOLDER [--methods LIST] [--every N] [--limit SECONDS] [--segments K]
//                      [--maximum-faces N]
//
// Runs every mesh file of a folder through every method, each run in a process of its own, and tells of
// crashes, results that are no segmentation, refusals and their reasons, and runs that take too long.

#include "guarded_run.h"
#include "markdown_head.h"
#include "markdown_tables.h"
#include "named_methods.h"
#include "peers.h"
#include "protrusion_methods.h"
#include "read_mesh.h"
#include "sdf_methods.h"
#include "validation.h"

#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <limits>
#include <stdexcept>

namespace {

namespace fs = std::filesystem;

struct Options
{
  std::string title = "Robustness";
  std::string folder;
  std::string methods = "Minimum-cut,Minimum-cut-automatic,Minimum-cut-DD(10),Minimum-cut-heat,Paper-GD,"
                        "Paper-GD-automatic,Paper-LGD(5),Paper-DD(10),Paper-heat,SDF-5-0.26";
  std::size_t every = 1;
  std::size_t number_of_segments = 8;
  std::size_t maximum_number_of_faces = (std::numeric_limits<std::size_t>::max)();
  unsigned int limit = 60;
};

// All files in the folder and the folders in it, in the order of their names.
std::vector<fs::path> mesh_files(const Options& options)
{
  const std::vector<std::string> known = {".off", ".obj", ".ply", ".stl", ".ts"};
  std::vector<fs::path> all, result;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(options.folder))
    if (entry.is_regular_file() &&
        std::find(known.begin(), known.end(), entry.path().extension().string()) != known.end())
      all.push_back(entry.path());
  std::sort(all.begin(), all.end());
  for (std::size_t i = 0; i < all.size(); i += options.every)
    result.push_back(all[i]);
  return result;
}

Mesh read(const fs::path& file)
{
  try
  {
    return read_mesh(file.string()).mesh;
  }
  catch (const std::runtime_error& error) // the tables have the name already
  {
    throw std::runtime_error(std::string(error.what()).substr(file.string().size() + 2));
  }
}

std::string check_size(const Mesh& mesh, std::size_t maximum_number_of_faces)
{
  if (mesh.number_of_faces() > maximum_number_of_faces)
    throw std::length_error("left out: it has " + std::to_string(mesh.number_of_faces()) + " faces");
  return "";
}

// What is wrong with the result, or nothing.
std::string segment(const fs::path& file, const Segmentation_method& method, std::size_t number_of_segments)
{
  Mesh mesh = read(file);
  if (method.name.substr(0, 3) == "SDF") // which is for triangles only
    CGAL::Polygon_mesh_processing::triangulate_faces(mesh);
  const Labels labels =
    method.segment(mesh, (std::min)(number_of_segments, std::size_t(mesh.number_of_faces())), 0);
  const std::size_t number = 1 + *std::max_element(labels.begin(), labels.end());
  return validation::problem_with_segmentation(mesh, label_map(labels), number).value_or("");
}

// Those of this package and the peer, of the names in a list.
std::vector<Segmentation_method> chosen_methods(const std::string& list)
{
  std::vector<Segmentation_method> all = protrusion_methods();
  for (const Segmentation_method& method : sdf_methods())
    all.push_back(method);
  return named_methods(all, list);
}

std::vector<Run> run_all(const Options& options)
{
  const std::vector<Segmentation_method> methods = chosen_methods(options.methods);
  std::vector<Run> runs;
  for (const fs::path& file : mesh_files(options))
  {
    const std::string name = fs::relative(file, options.folder).string();
    const auto add = [&](const std::string& method, const std::function<std::string()>& call)
    {
      runs.push_back({method, name, guarded_run(call, options.limit)});
      return runs.back().outcome.result == Result::VALID;
    };
    std::cerr << name << std::endl;
    if (!add("reading", [&]() { return check_size(read(file), options.maximum_number_of_faces); }))
      continue;
    for (const Segmentation_method& method : methods)
      add(method.name, [&]() { return segment(file, method, options.number_of_segments); });
  }
  return runs;
}

} // namespace

int main(int argc, char** argv)
{
  Options options;
  CLI::App app("Looks for crashes, invalid results, refusals and hangs.", "robustness_benchmark");
  app.add_option("--folder", options.folder, "of mesh files")->required()->check(CLI::ExistingDirectory);
  app.add_option("--title", options.title, "heading of what is printed")->capture_default_str();
  app.add_option("--methods", options.methods, "names from the quality benchmark")->capture_default_str();
  app.add_option("--every", options.every, "take only each N-th file")
    ->check(CLI::PositiveNumber)
    ->capture_default_str();
  app.add_option("--segments", options.number_of_segments, "asked for, where the mesh has enough faces")
    ->check(CLI::PositiveNumber)
    ->capture_default_str();
  app.add_option("--maximum-faces", options.maximum_number_of_faces, "larger meshes are left out");
  app.add_option("--limit", options.limit, "seconds of processor time for each run")
    ->check(CLI::PositiveNumber)
    ->capture_default_str();
  CLI11_PARSE(app, argc, argv);
  try
  {
    const std::vector<Run> runs = run_all(options);
    write_problems(std::cerr, runs);
    write_head(std::cout, "##", options.title, "robustness_benchmark", argc, argv);
    write_table(std::cout, runs);
    return EXIT_SUCCESS;
  }
  catch (const std::exception& error)
  {
    std::cerr << "robustness_benchmark: " << error.what() << std::endl;
    return EXIT_FAILURE;
  }
}
