// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Tables in Markdown.

#ifndef CGAL_PROTRUSION_SEGMENTATION_BENCHMARK_MARKDOWN_CELLS_H
#define CGAL_PROTRUSION_SEGMENTATION_BENCHMARK_MARKDOWN_CELLS_H

#include <cstddef>
#include <iomanip>
#include <optional>
#include <ostream>
#include <sstream>
#include <string>
#include <vector>

using Cells = std::vector<std::string>;
using Value = std::optional<double>;

inline std::string cell(const Value& value, int digits, bool signed_value = false)
{
  if (!value)
    return "-";
  std::ostringstream out;
  out << (signed_value ? std::showpos : std::noshowpos) << std::fixed << std::setprecision(digits)
      << *value;
  return out.str();
}

inline std::string error_cell(const Value& value)
{
  return cell(value, 3);
}

inline std::string signed_error_cell(const Value& value)
{
  return cell(value, 3, true);
}

inline void write_row(std::ostream& out, const Cells& cells)
{
  for (const std::string& text : cells)
    out << "| " << text << " ";
  out << "|\n";
}

inline void write_headings(std::ostream& out, const Cells& headings)
{
  write_row(out, headings);
  out << "|:--";
  for (std::size_t i = 1; i < headings.size(); ++i)
    out << "|--:";
  out << "|\n";
}

#endif // CGAL_PROTRUSION_SEGMENTATION_BENCHMARK_MARKDOWN_CELLS_H
