// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "comparison.h"
#include "reports.h"

#include <iomanip>

namespace {

void write_score_names(std::ostream& out)
{
  for(const char* name : score_names)
    out << "," << name;
}

void write_scores(std::ostream& out, const Scores& scores)
{
  for(std::size_t i = 0; i < number_of_scores; ++i)
  {
    out << ",";
    if(const std::optional<double>& value = scores[Score(i)])
      out << std::setprecision(6) << *value;
  }
}

} // namespace

void write_models_csv(std::ostream& out, const Results& results)
{
  out << "method,model,class,segments_asked_for";
  write_score_names(out);
  out << ",failed\n";
  for(std::size_t row = 0; row < results.number_of_rows(); ++row)
    for(const Model_results& model : results.models())
    {
      out << results.row_name(row) << "," << model.model << "," << model.class_name
          << "," << model.number_of_segments;
      write_scores(out, Results::scores(model, row));
      out << "," << (row > 0 && !model.methods[row - 1].failure.empty() ? 1 : 0) << "\n";
    }
}

void write_classes_csv(std::ostream& out, const Results& results)
{
  out << "method,class";
  write_score_names(out);
  out << "\n";
  for(std::size_t row = 0; row < results.number_of_rows(); ++row)
  {
    for(const std::string& name : results.classes())
    {
      out << results.row_name(row) << "," << name;
      write_scores(out, results.of_class(row, name));
      out << "\n";
    }
    out << results.row_name(row) << ",Average";
    write_scores(out, results.of_classes(row, results.classes()));
    out << "\n";
  }
}

void write_differences_csv(std::ostream& out, const Results& results)
{
  out << "first,second,score,difference,low,high,differ,first_is_better,equal,second_is_better\n" << std::setprecision(6);
  for(const Score score : {Score::rand_index_error, Score::hamming_distance, Score::cut_discrepancy})
    for(std::size_t first = 0; first < results.number_of_rows(); ++first)
      for(std::size_t second = first + 1; second < results.number_of_rows(); ++second)
        if(const auto compared = comparison(results, first, second, score))
          out << results.row_name(first) << "," << results.row_name(second) << "," << score_names[std::size_t(score)]
              << "," << compared->difference.mean << "," << compared->difference.low << "," << compared->difference.high
              << "," << (compared->difference.excludes_zero() ? 1 : 0) << "," << compared->first_is_better << ","
              << compared->both_are_equal << "," << compared->second_is_better << "\n";
}
