// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "markdown_tables.h"

#include <algorithm>
#include <array>
#include <iomanip>

namespace {

// The names of `Result`, in its order.
constexpr std::array<const char*, 5> result_names = {"valid", "invalid", "refused", "crashed",
                                                     "over the limit"};

std::vector<std::string> methods_of(const std::vector<Run>& runs)
{
  std::vector<std::string> methods;
  for (const Run& run : runs)
    if (std::find(methods.begin(), methods.end(), run.method) == methods.end())
      methods.push_back(run.method);
  return methods;
}

void write_line(std::ostream& out, const std::string& method, const std::vector<Run>& runs)
{
  std::array<std::size_t, result_names.size()> counts = {};
  double longest = 0, sum = 0;
  for (const Run& run : runs)
    if (run.method == method)
    {
      ++counts[std::size_t(run.outcome.result)];
      longest = (std::max)(longest, run.outcome.seconds);
      sum += run.outcome.seconds;
    }
  out << "| " << method;
  for (const std::size_t count : counts)
    out << " | " << count;
  out << " | " << sum << " | " << longest << " |\n";
}

} // namespace

void write_table(std::ostream& out, const std::vector<Run>& runs)
{
  out << std::fixed << std::setprecision(1);
  out << "| method | valid | invalid | refused | crashed | over the limit | seconds | longest |\n"
      << "|---|--:|--:|--:|--:|--:|--:|--:|\n";
  for (const std::string& method : methods_of(runs))
    write_line(out, method, runs);
}

void write_problems(std::ostream& out, const std::vector<Run>& runs)
{
  for (const Run& run : runs)
    if (run.outcome.result != Result::VALID)
      out << run.method << ", " << run.file << ": " << result_names[std::size_t(run.outcome.result)] << " "
          << run.outcome.text << "\n";
}
