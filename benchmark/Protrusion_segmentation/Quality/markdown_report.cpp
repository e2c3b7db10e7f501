// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "markdown_cells.h"
#include "published.h"
#include "reports.h"

#include <algorithm>
#include <iterator>

namespace {

std::string relative_cell(const Value& value) { return cell(value, 2, true); }

Value relative(const Value& error, const Value& human)
{
  return error && human && *human > 0 ? Value(*error / *human - 1) : std::nullopt;
}

void write_averages(std::ostream& out, const Results& results)
{
  out << "## Means\n\nModels: " << results.models().size()
      << ". Means over the classes, each a mean over its models, each a mean over its human\n"
         "segmentations; humans against each other. GCE and LCE by area. Smaller is better.\n\n";
  Cells headings = {"method"};
  headings.insert(headings.end(), score_names.begin(), score_names.end());
  headings.insert(headings.end(), {"CD undefined", "asked-for number reached", "failed"});
  write_headings(out, headings);
  for(std::size_t row = 0; row < results.number_of_rows(); ++row)
  {
    const Scores mean = results.of_classes(row, results.classes());
    Cells cells = {results.row_name(row)};
    for(std::size_t i = 0; i < number_of_scores; ++i)
      cells.push_back(Score(i) == Score::segments ? cell(mean[Score(i)], 1)
                      : Score(i) == Score::seconds ? cell(mean[Score(i)], 2)
                                                   : error_cell(mean[Score(i)]));
    cells.push_back(std::to_string(results.models_without_cut_discrepancy(row)));
    cells.push_back(row == 0 ? "-"
                             : std::to_string(results.models_with_the_segments_asked_for(row)));
    cells.push_back(row == 0 ? "-" : std::to_string(results.failures(row)));
    write_row(out, cells);
  }
  out << "\n";
}

// Whether any of the classes is in the paper's tables.
bool has_published(const Results& results)
{
  for(const std::string& name : results.classes())
    if(std::count(published_classes().begin(), published_classes().end(), name) > 0)
      return true;
  return false;
}

std::vector<Published_method> columns_of_paper(const Results& results)
{
  if(!has_published(results))
    return {};
  return {std::begin(published_methods), std::end(published_methods)};
}

Cells headings_by_class(const Results& results)
{
  Cells headings = {"class"};
  for(std::size_t row = 0; row < results.number_of_rows(); ++row)
    headings.push_back(results.row_name(row));
  for(const Published_method method : columns_of_paper(results))
    headings.push_back("paper: " + published_name(method));
  return headings;
}

void write_absolute_table(std::ostream& out, const Results& results, Score score)
{
  write_headings(out, headings_by_class(results));
  for(const std::string& name : results.classes())
  {
    Cells cells = {name};
    for(std::size_t row = 0; row < results.number_of_rows(); ++row)
      cells.push_back(error_cell(results.of_class(row, name)[score]));
    for(const Published_method method : columns_of_paper(results))
      cells.push_back(error_cell(published_absolute(score, name, method)));
    write_row(out, cells);
  }
}

void write_relative_table(std::ostream& out, const Results& results, Score score)
{
  write_headings(out, headings_by_class(results));
  for(const std::string& name : results.classes())
  {
    const Value human = results.of_class(0, name)[score];
    Cells cells = {name};
    for(std::size_t row = 0; row < results.number_of_rows(); ++row)
      cells.push_back(relative_cell(relative(results.of_class(row, name)[score], human)));
    for(const Published_method method : columns_of_paper(results))
      cells.push_back(relative_cell(published_relative(score, name, method)));
    write_row(out, cells);
  }
}

// A mean row at the end of a table of absolute errors.
void write_mean_row(std::ostream& out, const Results& results, Score score,
                    const std::string& title, const std::vector<std::string>& classes,
                    bool with_published)
{
  Cells cells = {"**" + title + "**"};
  for(std::size_t row = 0; row < results.number_of_rows(); ++row)
    cells.push_back(error_cell(results.of_classes(row, classes)[score]));
  for(const Published_method method : columns_of_paper(results))
  {
    double sum = 0;
    for(const std::string& name : classes)
      sum += published_absolute(score, name, method).value_or(0);
    cells.push_back(with_published ? error_cell(sum / double(classes.size())) : "-");
  }
  write_row(out, cells);
}

void write_by_class(std::ostream& out, const Results& results, Score score,
                    const std::string& title)
{
  out << "## " << title << "\n\nAbsolute:\n\n";
  write_absolute_table(out, results, score);
  write_mean_row(out, results, score, "mean of all", results.classes(), false);
  std::vector<std::string> common;
  for(const std::string& name : results.classes())
    if(std::count(published_classes().begin(), published_classes().end(), name) > 0)
      common.push_back(name);
  if(!common.empty())
    write_mean_row(out, results, score,
                   "mean of the paper's " + std::to_string(common.size()), common, true);
  out << "\n";
  if(!results.of_classes(0, results.classes())[score])
    return; // one human a model
  out << "Relative to the humans, (error - human) / human:\n\n";
  write_relative_table(out, results, score);
  out << "\n";
}

void write_single_model(std::ostream& out, const Results& results, int model)
{
  out << "## Model " << model << "\n\n";
  write_headings(out, {"method", "HD", "RI", "CD", "segments"});
  for(const Published_model_scores& scores : published_model_scores())
    if(scores.model == model)
      write_row(out, {std::string("paper: ") + scores.method, error_cell(scores.hamming_distance),
                      error_cell(scores.rand_index_error), error_cell(scores.cut_discrepancy),
                      "-"});
  for(std::size_t row = 0; row < results.number_of_rows(); ++row)
  {
    const Scores scores = *results.of_model(row, model);
    write_row(out, {results.row_name(row), error_cell(scores[Score::hamming_distance]),
                    error_cell(scores[Score::rand_index_error]),
                    error_cell(scores[Score::cut_discrepancy]),
                    cell(scores[Score::segments], row == 0 ? 1 : 0)});
  }
  out << "\n";
}

} // namespace

void write_markdown(std::ostream& out, const Results& results)
{
  write_overview(out, results);
  write_cells_won(out, results);
  write_averages(out, results);
  write_comparisons(out, results);
  write_by_class(out, results, Score::rand_index_error, "Rand index error (the paper's Table V)");
  write_by_class(out, results, Score::hamming_distance, "Hamming distance (the paper's Table IV)");
  write_by_class(out, results, Score::cut_discrepancy, "Cut discrepancy (the paper's Table III)");
  for(const int model : {123, 148}) // Tables VI and VII
    if(results.of_model(0, model))
      write_single_model(out, results, model);
}
