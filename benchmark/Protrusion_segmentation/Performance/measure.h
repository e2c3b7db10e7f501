// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Seconds, bytes, and tables of them.

#ifndef CGAL_PROTRUSION_SEGMENTATION_BENCHMARK_MEASURE_H
#define CGAL_PROTRUSION_SEGMENTATION_BENCHMARK_MEASURE_H

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

// The median; 0 of none.
double median(std::vector<double> values);
double mean(const std::vector<double>& values);

enum class Clock
{
  PROCESSOR, // of all threads of the process: other load on the machine hardly matters
  WALL
};

// The median of the seconds of `repetitions` calls.
double seconds_of(std::size_t repetitions, const std::function<void()>& call,
                  Clock clock = Clock::PROCESSOR);

// By how many bytes the memory of the process grew at most during a call; 0 where the system does not tell
// (elsewhere than on Linux).
double peak_bytes_of(const std::function<void()>& call);

// `digits` significant digits, never an exponent.
std::string number(double value, int digits = 3);

// Prints a table in Markdown, row by row so that long runs show where they are.
class Markdown_table
{
public:
  explicit Markdown_table(const std::vector<std::string>& header);
  // Cells that are missing at the end are empty.
  void row(std::vector<std::string> cells) const;

private:
  std::size_t m_number_of_columns;
};

#endif // CGAL_PROTRUSION_SEGMENTATION_BENCHMARK_MEASURE_H
