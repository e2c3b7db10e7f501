// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "contact_sheet.h"

#include "render.h"

#include <CGAL/segmentation_metrics.h>

#include <algorithm>
#include <iomanip>
#include <limits>
#include <numeric>
#include <string>

namespace {

std::string base64(const std::vector<std::uint8_t>& bytes)
{
  const char* digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string result;
  for(std::size_t i = 0; i < bytes.size(); i += 3)
  {
    const auto byte = [&](std::size_t j) { return i + j < bytes.size() ? bytes[i + j] : 0u; };
    const unsigned int group = byte(0) << 16 | byte(1) << 8 | byte(2);
    for(std::size_t j = 0; j < 4; ++j)
      result += i + j <= bytes.size() ? digits[group >> (18 - 6 * j) & 63] : '=';
  }
  return result;
}

void write_picture(std::ostream& out, const Mesh& mesh, const Labels& colors)
{
  out << "<img alt=\"\" src=\"data:image/png;base64," << base64(render(mesh, colors)) << "\">";
}

// The segments' labels renamed so that a segment has the label of the reference's segment which it
// shares most faces with, as long as that is free: what is alike gets one colour.
Labels with_colors_of(const Mesh& mesh, const Labels& labels, const Labels& reference)
{
  namespace engine = CGAL::Protrusion_segmentation::internal;
  const Labels numbers = engine::compact_segment_ids(mesh, label_map(labels));
  const Labels reference_numbers = engine::compact_segment_ids(mesh, label_map(reference));
  const engine::Segment_overlap overlap(numbers, reference_numbers,
                                        std::vector<double>(numbers.size(), 0.));
  std::vector<engine::Segment_overlap::Cell> cells = overlap.cells();
  std::sort(cells.begin(), cells.end(), [](const auto& a, const auto& b)
            { return a.common.count > b.common.count; });

  constexpr std::size_t none = (std::numeric_limits<std::size_t>::max)();
  std::vector<std::size_t> color(overlap.first_segments().size(), none);
  std::vector<bool> is_taken(overlap.second_segments().size(), false);
  for(const auto& cell : cells)
    if(color[cell.first] == none && !is_taken[cell.second])
    {
      color[cell.first] = cell.second;
      is_taken[cell.second] = true;
    }
  std::size_t next = is_taken.size();
  Labels result;
  for(const std::size_t number : numbers)
  {
    if(color[number] == none)
      color[number] = next++;
    result.push_back(color[number]);
  }
  return result;
}

double excess(const Model_results& model, std::size_t method)
{
  return *model.methods[method].scores[Score::rand_index_error]
       - model.humans[Score::rand_index_error].value_or(0); // one human has no error
}

// Red where the method is much worse than the humans: 0.2 is about the distance from the humans'
// mean to that of cells chosen without a look at the shape.
std::string background(double excess_error)
{
  const int strength = int(std::lround(120 * std::clamp(excess_error / 0.2, 0., 1.)));
  return "rgb(255," + std::to_string(255 - strength) + "," + std::to_string(255 - strength) + ")";
}

void write_value(std::ostream& out, const char* name, const std::optional<double>& value)
{
  out << " " << name << " ";
  if(value)
    out << *value;
  else
    out << "-";
}

void write_model(std::ostream& out, const Model& model, const Model_results& results,
                 std::size_t method)
{
  const Model_result& result = results.methods[method];
  const Labels& human = model.humans[results.typical_human];
  const Labels numbers = CGAL::Protrusion_segmentation::internal::compact_segment_ids(
    model.mesh, label_map(human));
  out << "<figure style=\"background:" << background(excess(results, method)) << "\">";
  write_picture(out, model.mesh, with_colors_of(model.mesh, result.labels, human));
  write_picture(out, model.mesh, numbers);
  out << "<figcaption><b>" << model.number << " " << model.class_name << "</b>";
  write_value(out, "RI", result.scores[Score::rand_index_error]);
  write_value(out, "(human", results.humans[Score::rand_index_error]);
  out << ")";
  write_value(out, "HD", result.scores[Score::hamming_distance]);
  write_value(out, "CD", result.scores[Score::cut_discrepancy]);
  out << std::setprecision(0) << " segments " << *result.scores[Score::segments] << " of "
      << results.number_of_segments << std::setprecision(3) << result.failure
      << "</figcaption></figure>\n";
}

// As many as a page shows.
constexpr std::size_t models_of_comparison = 10;

void write_head(std::ostream& out, const std::string& title)
{
  out << "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>" << title
      << "</title>\n<style>body{font:13px sans-serif}"
         "figure{display:inline-block;margin:3px;padding:3px;border:1px solid #bbb}"
         "figcaption{max-width:440px}td,th{text-align:center;padding:2px}td img{width:150px}</style></head>\n<body><h1>"
      << title << "</h1>\n";
}

void write_comparison_row(std::ostream& out, const Model& model, const Model_results& results)
{
  const Labels& human = model.humans[results.typical_human];
  out << "<tr><th>" << model.number << "<br>" << model.class_name << "</th><td>";
  write_picture(out, model.mesh, with_colors_of(model.mesh, human, human));
  out << "<br>" << results.number_of_segments << "</td>";
  for(std::size_t i = 0; i < results.methods.size(); ++i)
  {
    out << "<td style=\"background:" << background(excess(results, i)) << "\">";
    write_picture(out, model.mesh, with_colors_of(model.mesh, results.methods[i].labels, human));
    out << "<br>" << *results.methods[i].scores[Score::rand_index_error] << "</td>";
  }
  out << "</tr>\n";
}

} // namespace

void write_comparison_sheet(std::ostream& out, const Benchmark_folder& folder, const Results& results)
{
  write_head(out, "All methods");
  out << "<p>Below a human the number of segments that is asked for, below methods their Rand index error; the redder, the "
         "farther from the humans.</p>\n<table><tr><th></th><th>Human</th>"
      << std::fixed << std::setprecision(3);
  for(const std::string& name : results.methods())
    out << "<th>" << name << "</th>";
  out << "</tr>\n";
  const std::size_t number = (std::min)(models_of_comparison, results.models().size());
  for(std::size_t i = 0; i < number; ++i)
  {
    const Model_results& model = results.models()[i * results.models().size() / number];
    write_comparison_row(out, folder.read_model(model.model), model);
  }
  out << "</table></body></html>\n";
}

void write_contact_sheet(std::ostream& out, const Benchmark_folder& folder, const Results& results,
                         std::size_t method)
{
  std::vector<std::size_t> order(results.models().size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b)
  {
    return excess(results.models()[a], method) > excess(results.models()[b], method);
  });

  write_head(out, results.methods()[method]);
  out << "<p>Left the method, right the human who agrees best with the others. The farther "
         "from the humans in the Rand index error (RI), the redder and the earlier.</p>\n"
      << std::fixed << std::setprecision(3);
  for(const std::size_t i : order)
    write_model(out, folder.read_model(results.models()[i].model), results.models()[i], method);
  out << "</body></html>\n";
}
