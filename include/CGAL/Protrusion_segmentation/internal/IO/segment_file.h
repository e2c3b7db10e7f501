// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Parsing of `.seg` files, with the cause of a failure as a text.

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_IO_SEGMENT_FILE_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_IO_SEGMENT_FILE_H

#include <boost/property_map/property_map.hpp>

#include <cctype>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <fstream>
#include <iostream>
#include <iterator>
#include <limits>
#include <string>
#include <system_error>
#include <vector>

namespace CGAL::Protrusion_segmentation::internal {

inline std::string without_surrounding_blanks(const std::string& line)
{
  const char* blanks = " \t\r";
  const std::size_t first = line.find_first_not_of(blanks);
  return first == std::string::npos ? "" : line.substr(first, line.find_last_not_of(blanks) - first + 1);
}

// The start of a text from a file, fit to be printed in one line.
inline std::string quoted(const std::string& text)
{
  constexpr std::size_t longest = 24;
  std::string result = text.substr(0, longest);
  for (char& c : result)
    if (!std::isprint(static_cast<unsigned char>(c)))
      c = '?';
  return "'" + result + (text.size() > longest ? "...'" : "'");
}

// Sets `id`, or returns what is wrong.
inline std::string parse_segment_id(const std::string& text, std::uint64_t largest_id, std::uint64_t& id)
{
  if (text.empty())
    return "the line is empty";
  const bool is_negative = text.front() == '-';
  const char* first = text.data() + (is_negative ? 1 : 0);
  const char* last = text.data() + text.size();
  const auto [end, error] = std::from_chars(first, last, id);
  if (error == std::errc::invalid_argument || end != last)
    return quoted(text) + " is not a segment id";
  if (is_negative)
    return "the segment id " + quoted(text) + " is negative";
  if (error == std::errc::result_out_of_range || id > largest_id)
    return "the segment id " + quoted(text) + " is too large";
  return "";
}

// Tells of a failure on the standard error if that is wanted.
inline void report_problem(const std::string& what_failed, const std::string& problem, bool is_verbose)
{
  if (is_verbose && !problem.empty())
    std::cerr << "Error: " << what_failed << ": " << problem << std::endl;
}

// Reads one id a line; blank lines may follow at the end only. Sets `ids`, or returns the cause of
// the failure.
inline std::string parse_segment_ids(std::istream& is,
                                     std::size_t number_of_faces,
                                     std::uint64_t largest_id,
                                     std::vector<std::uint64_t>& ids)
{
  const std::string faces = std::to_string(number_of_faces) + " faces";
  std::size_t line_number = 0;
  std::size_t blank_lines = 0;
  for (std::string line; std::getline(is, line);)
  {
    ++line_number;
    const std::string text = without_surrounding_blanks(line);
    if (text.empty())
    {
      ++blank_lines;
      continue;
    }
    std::uint64_t id = 0;
    std::string problem;
    if (blank_lines > 0)
      problem = "a segment id follows a blank line";
    else if (ids.size() == number_of_faces)
      problem = "there are more segment ids than the mesh has faces (" + faces + ")";
    else
      problem = parse_segment_id(text, largest_id, id);
    if (!problem.empty())
      return "line " + std::to_string(line_number) + ": " + problem;
    ids.push_back(id);
  }
  if (is.bad())
    return "it cannot be read";
  if (ids.size() < number_of_faces)
    return "there are only " + std::to_string(ids.size()) + " segment ids for " + faces;
  return "";
}

// Reads the segmentation from a stream, or returns the cause of the failure, then without having
// changed the map.
template <typename FaceGraph, typename SegmentIdMap>
std::string read_segments(std::istream& is, const FaceGraph& mesh, SegmentIdMap segment_ids)
{
  using Id = typename boost::property_traits<SegmentIdMap>::value_type;

  if (!is.good())
    return "it cannot be read";
  const auto all_faces = faces(mesh);
  std::vector<std::uint64_t> ids;
  const auto number_of_faces = static_cast<std::size_t>(
    std::distance(all_faces.begin(), all_faces.end()));
  const auto largest_id = static_cast<std::uint64_t>((std::numeric_limits<Id>::max)());
  const std::string problem = parse_segment_ids(is, number_of_faces, largest_id, ids);
  if (!problem.empty())
    return problem;

  std::size_t i = 0;
  for (const auto f : all_faces)
    put(segment_ids, f, static_cast<Id>(ids[i++]));
  return "";
}

// The same for a file; the text does not repeat the name of the file.
template <typename FaceGraph, typename SegmentIdMap>
std::string read_segments(const std::string& file_name, const FaceGraph& mesh, SegmentIdMap segment_ids)
{
  std::ifstream in(file_name);
  if (!in)
    return "it cannot be opened";
  return read_segments(in, mesh, segment_ids);
}

} // namespace CGAL::Protrusion_segmentation::internal

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_IO_SEGMENT_FILE_H
