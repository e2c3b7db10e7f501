// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The figures of one segmentation, one model, one class, or all; and means of them.

#ifndef CGAL_PROTRUSION_SEGMENTATION_BENCHMARK_SCORES_H
#define CGAL_PROTRUSION_SEGMENTATION_BENCHMARK_SCORES_H

#include <CGAL/segmentation_metrics.h>

#include <array>
#include <cstddef>
#include <optional>

enum class Score : std::size_t
{
  rand_index_error,
  hamming_distance,
  missing_rate,
  false_alarm_rate,
  cut_discrepancy,
  global_consistency_error, // by area, as the benchmark plots it
  local_consistency_error,
  segments,
  seconds
};

constexpr std::size_t number_of_scores = 9;

// Headings of tables and of CSV columns, in the order of `Score`.
constexpr std::array<const char*, number_of_scores> score_names = {
  "RI", "HD", "Rm", "Rf", "CD", "GCE", "LCE", "segments", "seconds"};

class Scores
{
public:
  Scores() = default;

  Scores(const CGAL::Protrusion_segmentation::Segmentation_metrics& metrics,
         std::size_t number_of_segments)
    : m_values{metrics.rand_index_error,
               metrics.hamming_distance.distance,
               metrics.hamming_distance.missing_rate,
               metrics.hamming_distance.false_alarm_rate,
               metrics.cut_discrepancy,
               metrics.consistency_error.global_by_area,
               metrics.consistency_error.local_by_area,
               double(number_of_segments),
               std::nullopt}
  {}

  std::optional<double>& operator[](Score score) { return m_values[std::size_t(score)]; }
  const std::optional<double>& operator[](Score score) const { return m_values[std::size_t(score)]; }

private:
  std::array<std::optional<double>, number_of_scores> m_values;
};

// Means of what has a value.
class Mean_scores
{
public:
  void add(const Scores& scores)
  {
    for (std::size_t i = 0; i < number_of_scores; ++i)
      if (const std::optional<double>& value = scores[Score(i)])
      {
        m_sums[i] += *value;
        ++m_counts[i];
      }
  }

  Scores value() const
  {
    Scores result;
    for (std::size_t i = 0; i < number_of_scores; ++i)
      if (m_counts[i] > 0)
        result[Score(i)] = m_sums[i] / double(m_counts[i]);
    return result;
  }

private:
  std::array<double, number_of_scores> m_sums{};
  std::array<std::size_t, number_of_scores> m_counts{};
};

#endif // CGAL_PROTRUSION_SEGMENTATION_BENCHMARK_SCORES_H
