// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "comparison.h"

#include <algorithm>
#include <functional>

namespace {

// Any fixed number makes runs repeatable.
constexpr unsigned int seed_of_samples = 1;

// Values of the models that have one.
Values_by_class by_class(const Results& results,
                         const std::function<std::optional<double>(const Model_results&)>& value)
{
  Values_by_class values;
  for (const std::string& name : results.classes())
  {
    values.emplace_back();
    for (const Model_results& model : results.models())
      if (model.class_name == name)
        if (const std::optional<double> of_model = value(model))
          values.back().push_back(*of_model);
  }
  return values;
}

bool has_values(const Values_by_class& values)
{
  return std::any_of(values.begin(), values.end(),
                     [](const std::vector<double>& v) { return !v.empty(); });
}

} // namespace

std::optional<Mean_with_interval> mean_with_interval(const Results& results, std::size_t row, Score score)
{
  const Values_by_class values = by_class(results, [&](const Model_results& model)
                                          { return Results::scores(model, row)[score]; });
  if (!has_values(values))
    return std::nullopt;
  return bootstrap_mean(values, seed_of_samples);
}

std::optional<Comparison> comparison(const Results& results,
                                     std::size_t first,
                                     std::size_t second,
                                     Score score)
{
  Comparison result;
  const Values_by_class differences = by_class(
    results,
    [&](const Model_results& model) -> std::optional<double>
    {
      const std::optional<double> a = Results::scores(model, first)[score];
      const std::optional<double> b = Results::scores(model, second)[score];
      if (!a || !b)
        return std::nullopt;
      ++(*a < *b ? result.first_is_better : *b < *a ? result.second_is_better : result.both_are_equal);
      return *a - *b;
    });
  if (!has_values(differences))
    return std::nullopt;
  result.difference = bootstrap_mean(differences, seed_of_samples);
  return result;
}
