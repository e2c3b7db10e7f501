// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "comparison.h"
#include "markdown_cells.h"
#include "published.h"
#include "reports.h"

#include <algorithm>
#include <iterator>

namespace {

// The first method is what the others are compared with.
constexpr std::size_t row_of_first = 1;

std::string interval_cell(const std::optional<Mean_with_interval>& mean)
{
  return mean ? error_cell(mean->low) + "-" + error_cell(mean->high) : "-";
}

// By how much the first method is better, and on how many models the row's is better, equal and worse.
void add_comparison(Cells& cells, const Results& results, std::size_t row)
{
  const auto compared = row == row_of_first
                          ? std::nullopt
                          : comparison(results, row, row_of_first, Score::rand_index_error);
  if (!compared)
  {
    cells.insert(cells.end(), {"-", "-"});
    return;
  }
  const Mean_with_interval& difference = compared->difference;
  cells.push_back(signed_error_cell(difference.mean) + " [" + signed_error_cell(difference.low) + ", " +
                  signed_error_cell(difference.high) + "]");
  cells.push_back(std::to_string(compared->first_is_better) + "/" +
                  std::to_string(compared->both_are_equal) + "/" +
                  std::to_string(compared->second_is_better));
}

void write_row_of_means(std::ostream& out, const Results& results, std::size_t row)
{
  const Scores mean = results.of_classes(row, results.classes());
  Cells cells = {results.row_name(row), error_cell(mean[Score::rand_index_error]),
                 interval_cell(mean_with_interval(results, row, Score::rand_index_error)),
                 error_cell(mean[Score::hamming_distance]), error_cell(mean[Score::cut_discrepancy])};
  add_comparison(cells, results, row);
  const auto of_method = [row](std::size_t number) { return row == 0 ? "-" : std::to_string(number); };
  cells.insert(cells.end(), {cell(mean[Score::segments], 1),
                             of_method(results.models_with_the_segments_asked_for(row)),
                             std::to_string(results.models_without_cut_discrepancy(row)),
                             of_method(results.failures(row)), cell(mean[Score::seconds], 2)});
  write_row(out, cells);
}

std::vector<std::string> classes_of_paper(const Results& results)
{
  std::vector<std::string> classes;
  for (const std::string& name : results.classes())
    if (std::count(published_classes().begin(), published_classes().end(), name) > 0)
      classes.push_back(name);
  return classes;
}

std::vector<Published_method> columns_of_paper(const Results& results)
{
  if (classes_of_paper(results).empty())
    return {};
  return {std::begin(published_methods), std::end(published_methods)};
}

// Means over classes, of the methods and of the paper's if it has these classes.
void write_class_row(std::ostream& out,
                     const Results& results,
                     const std::string& title,
                     Score score,
                     const std::vector<std::string>& classes)
{
  Cells cells = {title};
  for (std::size_t row = 0; row < results.number_of_rows(); ++row)
    cells.push_back(error_cell(results.of_classes(row, classes)[score]));
  for (const Published_method method : columns_of_paper(results))
  {
    Value sum = 0;
    for (const std::string& name : classes)
    {
      const Value error = published_absolute(score, name, method);
      sum = sum && error ? Value(*sum + *error) : std::nullopt;
    }
    cells.push_back(sum ? error_cell(*sum / double(classes.size())) : "-");
  }
  write_row(out, cells);
}

} // namespace

void write_means(std::ostream& out, const Results& results)
{
  out << "## Means\n\n"
      << results.models().size()
      << " models. RI: Rand index error, HD: Hamming distance, CD: cut discrepancy; smaller is better. "
         "Means over "
         "the classes, each a mean\nover its models, with 95 % intervals by the bootstrap. Two methods "
         "differ "
         "where the interval of their difference leaves out 0.\n\n";
  write_headings(out, {"method", "RI", "95 %", "HD", "CD", "RI minus " + results.row_name(row_of_first),
                       "better/equal/worse", "segments", "number reached", "CD undefined", "failed",
                       "seconds"});
  for (std::size_t row = 0; row < results.number_of_rows(); ++row)
    write_row_of_means(out, results, row);
}

void write_by_class(std::ostream& out, const Results& results)
{
  const std::vector<std::string> of_paper = classes_of_paper(results);
  out << "\n## Rand index error by class\n\n";
  if (!of_paper.empty())
    out << "The paper publishes errors relative to people's; here they are absolute, by the errors of "
           "people that "
           "the benchmark publishes.\n\n";
  Cells headings = {"class"};
  for (std::size_t row = 0; row < results.number_of_rows(); ++row)
    headings.push_back(results.row_name(row));
  for (const Published_method method : columns_of_paper(results))
    headings.push_back("paper: " + published_name(method));
  write_headings(out, headings);
  for (const std::string& name : results.classes())
    write_class_row(out, results, name, Score::rand_index_error, {name});
  write_class_row(out, results, "**mean of all**", Score::rand_index_error, results.classes());
  if (of_paper.empty())
    return;
  write_class_row(out, results, "**mean of the paper's " + std::to_string(of_paper.size()) + "**",
                  Score::rand_index_error, of_paper);
  write_class_row(out, results, "**the same, HD**", Score::hamming_distance, of_paper);
  write_class_row(out, results, "**the same, CD**", Score::cut_discrepancy, of_paper);
}
