// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// evaluate_segmentation MESH SEGMENTATION REFERENCE...
//
// Scores a segmentation against one or more references, for example those made by humans: as a
// table for people, as JSON for programs. All scores but the last are those of the program of the Princeton Segmentation
// Benchmark, so that they can stand beside published ones; the last is that of learned methods.

#include "command_line/Error.h"
#include "command_line/Help_formatter.h"
#include "command_line/tool_main.h"
#include "rand_index_error_of_benchmark.h"
#include "reading/read_labels.h"
#include "reading/read_mesh.h"
#include "writing/write_output.h"

#include <CGAL/segmentation_metrics.h>

#include <boost/property_map/property_map.hpp>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <iomanip>
#include <iostream>
#include <optional>
#include <sstream>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

using Metrics = CGAL::Protrusion_segmentation::Segmentation_metrics;
using Json = nlohmann::ordered_json;

struct Command_line
{
  std::string mesh;
  std::string segmentation;
  std::vector<std::string> references;
  std::string json; // "-" is the standard output
};

// One column of the table and one entry of the JSON objects.
struct Score
{
  const char* name;
  const char* heading;
  std::optional<double> value;
};

std::vector<Score> scores(const Metrics& metrics)
{
  const auto& hamming = metrics.hamming_distance;
  const auto& consistency = metrics.consistency_error;
  return {{"rand_index_error", "RI", metrics.rand_index_error},
          {"hamming_distance", "HD", hamming.distance},
          {"missing_rate", "Rm", hamming.missing_rate},
          {"false_alarm_rate", "Rf", hamming.false_alarm_rate},
          {"cut_discrepancy", "CD", metrics.cut_discrepancy},
          {"global_consistency_error", "GCE", consistency.global},
          {"local_consistency_error", "LCE", consistency.local},
          {"global_consistency_error_by_area", "GCEa", consistency.global_by_area},
          {"local_consistency_error_by_area", "LCEa", consistency.local_by_area},
          {"mean_best_intersection_over_union", "IoU", metrics.mean_best_intersection_over_union}};
}

std::string row(const std::vector<Score>& scores, const std::string& reference)
{
  std::ostringstream out;
  for (const Score& score : scores)
  {
    out << std::setw(8);
    if (score.value)
      out << std::fixed << std::setprecision(4) << *score.value;
    else
      out << "-";
  }
  out << "  " << reference << "\n";
  return out.str();
}

// Means over the references where a score has a value, as the benchmark takes them.
std::vector<Score> mean_scores(const std::vector<Metrics>& metrics)
{
  std::vector<Score> means = scores(metrics.front());
  for (std::size_t s = 0; s < means.size(); ++s)
  {
    double sum = 0;
    int count = 0;
    for (const Metrics& m : metrics)
      if (const std::optional<double> value = scores(m)[s].value)
      {
        sum += *value;
        ++count;
      }
    means[s].value = count > 0 ? std::optional<double>(sum / count) : std::nullopt;
  }
  return means;
}

Json as_json(const std::vector<Score>& scores)
{
  Json object = Json::object();
  for (const Score& score : scores)
    object[score.name] = score.value ? Json(*score.value) : Json(nullptr);
  return object;
}

Json as_json(const std::vector<std::string>& references, const std::vector<Metrics>& metrics)
{
  Json array = Json::array();
  for (std::size_t i = 0; i < references.size(); ++i)
  {
    Json object = {{"reference", references[i]}};
    object.update(as_json(scores(metrics[i])));
    array.push_back(object);
  }
  return {{"references", array}, {"mean", as_json(mean_scores(metrics))}};
}

void print_table(const std::vector<std::string>& references, const std::vector<Metrics>& metrics)
{
  std::string headings;
  for (const Score& score : scores(metrics.front()))
    headings += std::string(8 - std::string(score.heading).size(), ' ') + score.heading;
  std::cout << headings << "  reference\n";
  for (std::size_t i = 0; i < references.size(); ++i)
    std::cout << row(scores(metrics[i]), references[i]);
  if (references.size() > 1)
    std::cout << row(mean_scores(metrics), "mean");
  std::cout << "Smaller is better. RI Rand index error, HD Hamming distance, Rm missing rate,\n"
               "Rf false-alarm rate, CD cut discrepancy (- where a side has no border),\n"
               "GCE and LCE global and local consistency error, GCEa and LCEa by area.\n"
               "All as the program of the Princeton Segmentation Benchmark computes them.\n"
               "IoU mean best intersection over union, by faces, as learned methods are measured:\n"
               "larger is better; faces of the reference with a negative label are in no part.\n";
}

using Labels = std::vector<std::int64_t>;

Metrics metrics_of_benchmark(const tool::Mesh& mesh, const Labels& segments, const Labels& reference)
{
  const auto map = [&](const Labels& labels)
  { return boost::make_iterator_property_map(labels.begin(), get(boost::face_index, mesh)); };
  Metrics metrics = CGAL::Protrusion_segmentation::segmentation_metrics(mesh, map(segments), map(reference));
  metrics.rand_index_error = rand_index_error_of_benchmark(metrics.rand_index_error,
                                                           mesh.number_of_faces());
  return metrics;
}

// Folders become the .seg and .npy files in them, as the benchmark's archive has one for each mesh.
std::vector<std::string> files_of(const std::vector<std::string>& references)
{
  namespace fs = std::filesystem;
  std::vector<std::string> result;
  for (const std::string& reference : references)
  {
    std::error_code ignored;
    if (!fs::is_directory(reference, ignored))
    {
      result.push_back(reference);
      continue;
    }
    const std::size_t begin = result.size();
    for (const fs::directory_entry& entry : fs::directory_iterator(reference, ignored))
      if (entry.path().extension() == ".seg" || entry.path().extension() == ".npy")
        result.push_back(entry.path().string());
    if (result.size() == begin)
      throw tool::Error(reference, "has no .seg or .npy files in it");
    std::sort(result.begin() + std::ptrdiff_t(begin), result.end(),
              [](const std::string& a, const std::string& b)
              { return std::make_pair(a.size(), a) < std::make_pair(b.size(), b); }); // 2 before 10
  }
  return result;
}

// No file that is read may be replaced.
void check_output(const std::string& json, const std::vector<std::string>& inputs)
{
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(json, ignored))
    return;
  for (const std::string& input : inputs)
    if (std::filesystem::equivalent(json, input, ignored))
      throw tool::Error(json, "would replace a file that is read");
}

void evaluate(const Command_line& command_line)
{
  const std::vector<std::string> references = files_of(command_line.references);
  std::vector<std::string> inputs = references;
  inputs.insert(inputs.end(), {command_line.mesh, command_line.segmentation});
  check_output(command_line.json, inputs);
  tool::Input_mesh input = tool::read_input_mesh(command_line.mesh);
  const Labels segments = tool::read_some_labels(command_line.segmentation, input);
  std::vector<Metrics> metrics;
  for (const std::string& reference : references)
    metrics.push_back(
      metrics_of_benchmark(input.mesh, segments, tool::read_some_labels(reference, input)));

  const auto write_json = [&](std::ostream& out)
  {
    // A name that is no UTF-8 must not keep the scores from being written.
    out << as_json(references, metrics).dump(2, ' ', false, Json::error_handler_t::replace) << "\n";
  };
  if (command_line.json.empty())
    print_table(references, metrics);
  else if (command_line.json == "-")
    write_json(std::cout);
  else
    tool::write_output(command_line.json, write_json);
  tool::finish_standard_output();
}

void add_options(CLI::App& app, Command_line& command_line)
{
  app
    .add_option("MESH", command_line.mesh,
                "a mesh.\nFormats: " + tool::known_formats() + "; each also compressed by gzip (.gz).")
    ->required()
    ->type_name("");
  app
    .add_option("SEGMENTATION", command_line.segmentation,
                "the segmentation to score, with a label for each face of the mesh.\n"
                "Formats: .seg (one a line), .npy (a vector), .json (an array, or an object such as {\"0\": 3, "
                "\"1\": 3}), face data \"segment\" or \"label\" of .ply or .vtp.")
    ->required()
    ->type_name("");
  app
    .add_option("REFERENCE", command_line.references,
                "segmentations to compare it with, or folders of .seg and .npy files")
    ->required()
    ->type_name("");
  app
    .add_option("--json", command_line.json, "write JSON in place of the table; - is the standard output")
    ->type_name("FILE")
    ->group("Output");
  tool::complete_help(
    app, "[OPTION...] MESH SEGMENTATION REFERENCE...", "Input",
    {{"evaluate_segmentation horse.obj mine.seg a.seg b.seg", "a table with a row for each reference"},
     {"evaluate_segmentation 1.off mine.seg MeshsegBenchmark-1.0/data/seg/Benchmark/1",
      "all references of the benchmark"},
     {"evaluate_segmentation horse.obj mine.seg a.seg --json scores.json", "the same as JSON"},
     {"evaluate_segmentation horse.glb face2label.json true.npy", "files of learned methods"}});
}

int main(int argc, char** argv)
{
  Command_line command_line;
  CLI::App app("Scores a segmentation of a mesh against reference segmentations.",
               "evaluate_segmentation");
  add_options(app, command_line);
  return tool::main(app, argc, argv, [&]() { evaluate(command_line); });
}
