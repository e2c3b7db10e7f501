// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

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
      out << results.row_name(row) << "," << model.model << "," << class_of_model(model.model)
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
