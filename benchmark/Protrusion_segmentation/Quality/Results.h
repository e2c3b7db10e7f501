// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The scores of all methods on all models, and means of them by class.

#ifndef CGAL_PROTRUSION_SEGMENTATION_BENCHMARK_RESULTS_H
#define CGAL_PROTRUSION_SEGMENTATION_BENCHMARK_RESULTS_H

#include "Benchmark_folder.h"
#include "Scores.h"

#include <string>
#include <vector>

struct Model_result
{
  Labels labels;       // empty for the humans
  Scores scores;
  std::string failure; // what a method that threw said; it is scored as one segment
};

struct Model_results
{
  int model = 0;
  std::string class_name;
  std::size_t number_of_segments = 0;  // asked for
  Scores humans;
  std::size_t typical_human = 0;
  std::vector<Model_result> methods;   // in the order of the methods
};

// Row 0 of a table is the humans', row i that of method i - 1.
class Results
{
public:
  Results(std::vector<std::string> methods, std::vector<Model_results> models)
    : m_methods(std::move(methods)), m_models(std::move(models))
  { }

  const std::vector<std::string>& methods() const { return m_methods; }
  const std::vector<Model_results>& models() const { return m_models; }

  std::size_t number_of_rows() const { return m_methods.size() + 1; }
  std::string row_name(std::size_t row) const { return row == 0 ? "Human" : m_methods[row - 1]; }
  static const Scores& scores(const Model_results& model, std::size_t row)
  {
    return row == 0 ? model.humans : model.methods[row - 1].scores;
  }

  // Of the models, in their order.
  std::vector<std::string> classes() const;

  // Mean over the models of a class.
  Scores of_class(std::size_t row, const std::string& class_name) const;

  // Mean over those of the classes of which there is a model, each counted once.
  Scores of_classes(std::size_t row, const std::vector<std::string>& class_names) const;

  std::size_t models_without_cut_discrepancy(std::size_t row) const;
  std::size_t models_with_the_segments_asked_for(std::size_t row) const;
  std::size_t failures(std::size_t row) const;

private:
  std::vector<std::string> m_methods;
  std::vector<Model_results> m_models; // sorted by number
};

#endif // CGAL_PROTRUSION_SEGMENTATION_BENCHMARK_RESULTS_H
