// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The same shape, other triangles: does it get the same segments?
//
// invariance_benchmark --folder FOLDER [--every N] [--methods LIST] [--changes NAME...]

#include "changes_of_mesh.h"
#include "markdown_head.h"
#include "named_methods.h"
#include "peers.h"
#include "protrusion_methods.h"
#include "read_mesh.h"
#include "sdf_methods.h"

#include <CGAL/Protrusion_segmentation/internal/Metrics/overlap_errors.h>
#include <CGAL/boost/graph/helpers.h>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

struct Options
{
  std::string folder;
  std::size_t every = 1;
  std::string methods = "Minimum-cut-automatic,Minimum-cut,Paper-GD-automatic,Paper-GD,SDF-5-0.26";
  std::vector<std::string> changes; // all if empty
};

std::vector<Segmentation_method> chosen_methods(const std::string& list)
{
  std::vector<Segmentation_method> all = protrusion_methods();
  for (const Segmentation_method& method : sdf_methods())
    all.push_back(method);
  return named_methods(all, list);
}

std::vector<Change_of_mesh> chosen_changes(const std::vector<std::string>& names)
{
  const std::vector<Change_of_mesh> all = all_changes_of_mesh();
  if (names.empty())
    return all;
  std::vector<Change_of_mesh> result;
  for (const std::string& name : names)
  {
    const auto change = std::find_if(all.begin(), all.end(), [&](const Change_of_mesh& c) { return c.name == name; });
    if (change == all.end())
      throw std::invalid_argument("--changes: there is no change \"" + name + "\"");
    result.push_back(*change);
  }
  return result;
}

std::vector<std::string> files_in(const std::string& folder)
{
  std::vector<std::string> files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
    if (entry.is_regular_file() && entry.path().extension() == ".off")
      files.push_back(entry.path().string());
  std::sort(files.begin(), files.end());
  return files;
}

std::size_t number_of(const Labels& labels)
{
  return *std::max_element(labels.begin(), labels.end()) + 1;
}

// The share of the pairs of faces that are in one segment by one labelling and in two by the other.
double disagreement(const Labels& first, const Labels& second)
{
  namespace internal = CGAL::Protrusion_segmentation::internal;
  const std::vector<double> areas(first.size(), 1); // which make no difference
  return internal::rand_index_error(internal::Segment_overlap(first, second, areas));
}

// What one method does with all meshes after one change.
struct Tally
{
  std::size_t number_of_meshes = 0;
  std::size_t same_number = 0;
  std::size_t same_segments = 0;
  double disagreement = 0;

  // `expected`: of the mesh as it was, `labels`: of the changed one
  void add(const Labels& expected, const Labels& labels, const Change_of_mesh& change, const Changed_mesh& changed)
  {
    Labels before, after;
    for (std::size_t f = 0; f < labels.size(); ++f)
      if (changed.origins[f] != no_origin)
      {
        before.push_back(changed.copies[f] * number_of(expected) + expected[changed.origins[f]]);
        after.push_back(labels[f]);
      }
    const double d = ::disagreement(before, after);
    ++number_of_meshes;
    same_number += number_of(labels) == change.number_of_segments(number_of(expected));
    same_segments += d == 0;
    disagreement += d;
  }
};

using Tallies = std::vector<std::vector<Tally>>; // by change and method

// The number of segments that is asked for is the one that the first method finds by itself.
void measure(const Mesh& mesh,
             const std::vector<Change_of_mesh>& changes,
             const std::vector<Segmentation_method>& methods,
             Tallies& tallies)
{
  const std::size_t k = number_of(methods.front().segment(mesh, 2, 0));
  std::vector<Labels> expected;
  for (const Segmentation_method& method : methods)
    expected.push_back(method.segment(mesh, k, 0));
  for (std::size_t c = 0; c < changes.size(); ++c)
  {
    const Changed_mesh changed = changes[c].apply(mesh);
    for (std::size_t m = 0; m < methods.size(); ++m)
      try
      {
        tallies[c][m].add(expected[m], methods[m].segment(changed.mesh, changes[c].number_of_segments(k), 0),
                          changes[c], changed);
      }
      catch (const std::exception& exception)
      {
        std::cerr << methods[m].name << ", " << changes[c].name << ": " << exception.what() << std::endl;
      }
  }
}

void write_table(const std::vector<Change_of_mesh>& changes,
                 const std::vector<Segmentation_method>& methods,
                 const Tallies& tallies)
{
  std::cout << "| change |";
  for (const Segmentation_method& method : methods)
    std::cout << " " << method.name << " |";
  std::cout << " goal |\n|---|---|";
  for (std::size_t m = 0; m < methods.size(); ++m)
    std::cout << "---|";
  std::cout << "\n";
  for (std::size_t c = 0; c < changes.size(); ++c)
  {
    std::cout << "| " << changes[c].name << " |";
    for (const Tally& tally : tallies[c])
    {
      const double n = double((std::max)(tally.number_of_meshes, std::size_t(1)));
      char cell[64];
      std::snprintf(cell, sizeof(cell), " %.0f %.0f %.3f |", 100 * double(tally.same_number) / n,
                    100 * double(tally.same_segments) / n, tally.disagreement / n);
      std::cout << cell;
    }
    std::cout << " " << changes[c].goal << " |\n";
  }
}

// Empty, after a line that says why, if it is left out.
Mesh triangle_mesh(const std::string& file)
{
  try
  {
    Mesh mesh = read_mesh(file).mesh;
    if (CGAL::is_triangle_mesh(mesh))
      return mesh;
    std::cerr << file << ": left out, since it is no mesh of triangles" << std::endl;
  }
  catch (const std::runtime_error& error)
  {
    std::cerr << error.what() << ": left out" << std::endl;
  }
  return Mesh();
}

void run(const Options& options, int argc, char** argv)
{
  if (options.every == 0)
    throw std::invalid_argument("--every is 0");
  const std::vector<Segmentation_method> methods = chosen_methods(options.methods);
  const std::vector<Change_of_mesh> changes = chosen_changes(options.changes);
  Tallies tallies(changes.size(), std::vector<Tally>(methods.size()));
  const std::vector<std::string> files = files_in(options.folder);
  std::size_t number_of_meshes = 0;
  for (std::size_t i = 0; i < files.size(); i += options.every)
  {
    const Mesh mesh = triangle_mesh(files[i]);
    if (mesh.is_empty())
      continue;
    std::cerr << files[i] << std::endl;
    measure(mesh, changes, methods, tallies);
    ++number_of_meshes;
  }
  write_head(std::cout, "#", "Invariance", "invariance_benchmark", argc, argv);
  std::cout << number_of_meshes
            << " meshes. In each cell: in how many percent the number of segments is the expected one, in how many all "
               "faces are\ndivided alike, and the mean share of pairs of faces that are not. Goals: the expected number "
               "in 90 percent, a share of at\nmost the last column.\n\n";
  write_table(changes, methods, tallies);
}

int main(int argc, char** argv)
{
  Options options;
  CLI::App app("Measures whether other meshes of the same shape get the same segments.", "invariance_benchmark");
  app.add_option("--folder", options.folder, "a folder of .off files")->required();
  app.add_option("--every", options.every, "take every N-th file only")->capture_default_str();
  app.add_option("--methods", options.methods, "names from the quality benchmark; the first one sets the number of "
                                               "segments for those that are given one")
    ->capture_default_str();
  app.add_option("--changes", options.changes, "rows of the table, by their names; all if there are none");
  CLI11_PARSE(app, argc, argv);
  try
  {
    run(options, argc, argv);
  }
  catch (const std::exception& exception)
  {
    std::cerr << "invariance_benchmark: " << exception.what() << std::endl;
    return 1;
  }
  return 0;
}
