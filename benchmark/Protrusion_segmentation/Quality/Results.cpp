// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Results.h"

#include <algorithm>

std::vector<std::string> Results::classes() const
{
  std::vector<std::string> result;
  for(const Model_results& m : m_models)
    if(std::find(result.begin(), result.end(), m.class_name) == result.end())
      result.push_back(m.class_name);
  return result;
}

Scores Results::of_class(std::size_t row, const std::string& class_name) const
{
  Mean_scores mean;
  for(const Model_results& model : m_models)
    if(model.class_name == class_name)
      mean.add(scores(model, row));
  return mean.value();
}

Scores Results::of_classes(std::size_t row, const std::vector<std::string>& class_names) const
{
  Mean_scores mean;
  for(const std::string& name : class_names)
    mean.add(of_class(row, name));
  return mean.value();
}

std::size_t Results::models_without_cut_discrepancy(std::size_t row) const
{
  return std::size_t(std::count_if(m_models.begin(), m_models.end(), [&](const Model_results& m)
                                   { return !scores(m, row)[Score::cut_discrepancy]; }));
}

std::size_t Results::models_with_the_segments_asked_for(std::size_t row) const
{
  return std::size_t(std::count_if(m_models.begin(), m_models.end(), [&](const Model_results& m)
  {
    return scores(m, row)[Score::segments] == double(m.number_of_segments);
  }));
}

std::size_t Results::failures(std::size_t row) const
{
  if(row == 0)
    return 0;
  return std::size_t(std::count_if(m_models.begin(), m_models.end(), [&](const Model_results& m)
                                   { return !m.methods[row - 1].failure.empty(); }));
}
