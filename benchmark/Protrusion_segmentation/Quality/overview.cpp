// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "comparison.h"
#include "markdown_cells.h"
#include "published.h"
#include "reports.h"

#include <algorithm>
#include <functional>

namespace {

// The first method is what the others are compared with.
constexpr std::size_t row_of_first = 1;

// As many as a page holds in one table; further ones are in the tables that follow.
constexpr std::size_t most_rows_of_overview = 10;

std::string mean_cell(const std::optional<Mean_with_interval>& mean)
{
  return mean
           ? error_cell(mean->mean) + " (" + error_cell(mean->low) + " to " + error_cell(mean->high) + ")"
           : "-";
}

std::string difference_cell(const Mean_with_interval& mean)
{
  return signed_error_cell(mean.mean) + " (" + signed_error_cell(mean.low) + " to " +
         signed_error_cell(mean.high) + ")";
}

// Better, equal, worse than the first method, and by how much.
void add_comparison(Cells& cells, const Results& results, std::size_t row, Score score)
{
  const auto compared = row == row_of_first ? std::nullopt
                                            : comparison(results, row, row_of_first, score);
  if (!compared)
  {
    cells.insert(cells.end(), {"-", "-", "-"});
    return;
  }
  cells.push_back(difference_cell(compared->difference));
  cells.push_back(compared->difference.excludes_zero() ? "yes" : "no");
  cells.push_back(std::to_string(compared->first_is_better) + " / " +
                  std::to_string(compared->both_are_equal) + " / " +
                  std::to_string(compared->second_is_better));
}

Cells headings_of_comparison(const Results& results)
{
  return {"minus " + results.row_name(row_of_first), "differ", "better / equal / worse"};
}

void write_overview_row(std::ostream& out, const Results& results, std::size_t row)
{
  const Scores mean = results.of_classes(row, results.classes());
  Cells cells = {results.row_name(row),
                 mean_cell(mean_with_interval(results, row, Score::rand_index_error))};
  add_comparison(cells, results, row, Score::rand_index_error);
  cells.push_back(error_cell(mean[Score::hamming_distance]));
  cells.push_back(error_cell(mean[Score::cut_discrepancy]));
  cells.push_back(cell(mean[Score::segments], 1));
  cells.push_back(cell(mean[Score::seconds], 2));
  write_row(out, cells);
}

void write_comparisons_of(std::ostream& out,
                          const Results& results,
                          Score score,
                          const std::string& title)
{
  out << "## Intervals of the " << title << "\n\n";
  Cells headings = {"method", "mean"};
  for (const std::string& heading : headings_of_comparison(results))
    headings.push_back(heading);
  write_headings(out, headings);
  for (std::size_t row = 0; row < results.number_of_rows(); ++row)
  {
    Cells cells = {results.row_name(row), mean_cell(mean_with_interval(results, row, score))};
    add_comparison(cells, results, row, score);
    write_row(out, cells);
  }
  out << "\n";
}

// The error of one of three methods that the paper compares.
using Error = std::function<Value(Score, const std::string& class_name, Published_method)>;

struct Cells_won
{
  std::size_t number = 0, of = 0;
};

// In how many of the cells of tables III to V the method in the place of the paper's is the best of the three.
Cells_won cells_won(const Results& results, const Error& error)
{
  Cells_won result;
  for (const Score score : {Score::cut_discrepancy, Score::hamming_distance, Score::rand_index_error})
    for (const std::string& name : results.classes())
    {
      const Value own = error(score, name, Published_method::protrusion);
      if (!own || !published_absolute(score, name, Published_method::protrusion))
        continue;
      ++result.of;
      bool is_best = true;
      for (const Published_method rival : {Published_method::randomized_cuts, Published_method::k_means})
        if (const Value other = error(score, name, rival))
          is_best = is_best && *own < *other;
      result.number += is_best ? 1 : 0;
    }
  return result;
}

std::optional<std::size_t> row_named(const Results& results, const std::string& name)
{
  for (std::size_t row = 1; row < results.number_of_rows(); ++row)
    if (results.row_name(row) == name)
      return row;
  return std::nullopt;
}

// With the method of a row in the place of the paper's, and the other two as they are measured.
Cells_won cells_won_by(const Results& results,
                       std::size_t row,
                       std::size_t randomized_cuts,
                       std::size_t k_means)
{
  return cells_won(
    results,
    [&](Score score, const std::string& name, Published_method method)
    {
      const std::size_t rows[] = {row, randomized_cuts, k_means}; // in the order of `Published_method`
      return results.of_class(rows[std::size_t(method)], name)[score];
    });
}

} // namespace

void write_overview(std::ostream& out, const Results& results)
{
  out
    << "## Overview\n\n"
    << results.models().size()
    << " models. In parentheses: where 95 % of the means are if models are drawn again\n"
    << "within their classes (bootstrap). The Rand index error is compared model by model with that of\n"
    << results.row_name(row_of_first)
    << ": two methods differ if the interval of the mean difference leaves out zero.\n\n";
  Cells headings = {"method", "Rand index error"};
  for (const std::string& heading : headings_of_comparison(results))
    headings.push_back(heading);
  headings.insert(headings.end(), {"Hamming distance", "cut discrepancy", "segments", "seconds"});
  write_headings(out, headings);
  for (std::size_t row = 0; row < (std::min)(most_rows_of_overview, results.number_of_rows()); ++row)
    write_overview_row(out, results, row);
  out << "\n";
}

void write_comparisons(std::ostream& out, const Results& results)
{
  write_comparisons_of(out, results, Score::rand_index_error, "Rand index error");
  write_comparisons_of(out, results, Score::hamming_distance, "Hamming distance");
  write_comparisons_of(out, results, Score::cut_discrepancy, "cut discrepancy");
}

void write_cells_won(std::ostream& out, const Results& results)
{
  const auto randomized_cuts = row_named(results, "Randomized-cuts"),
             k_means = row_named(results, "K-Means");
  if (!randomized_cuts || !k_means)
    return;
  const Cells_won first = cells_won_by(results, row_of_first, *randomized_cuts, *k_means);
  if (first.of == 0)
    return;
  out << "Of the " << first.of
      << " cells of the paper's tables III to V (metrics and classes), beside Randomized-cuts and "
      << "K-Means as measured\nhere, " << results.row_name(row_of_first) << " is best in "
      << first.number;
  if (const auto paper = row_named(results, "Paper-GD"))
    out << ", the paper's method as implemented here (Paper-GD) in "
        << cells_won_by(results, *paper, *randomized_cuts, *k_means).number;
  out << ";\nin the paper's tables its method is best in "
      << cells_won(results, published_absolute).number << ".\n\n";
}
