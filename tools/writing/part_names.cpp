// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "writing/part_names.h"

#include "command_line/number.h"

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <iterator>
#include <set>
#include <string_view>
#include <system_error>

namespace tool
{
namespace
{

namespace fs = std::filesystem;

// Where a name has a number: "%d", or as in "%03d" with a width; or a name, "%s".
struct Placeholder
{
  std::size_t begin = std::string::npos;
  std::size_t size = 0;
  std::size_t width = 0;
  char fill = ' ';
  bool is_name = false;
};

Placeholder find_placeholder(const std::string& name, std::size_t from = 0)
{
  for (std::size_t begin = name.find('%', from); begin != std::string::npos;
       begin = name.find('%', begin + 1))
  {
    const std::size_t end = name.find_first_not_of("0123456789", begin + 1);
    const std::string digits = name.substr(begin + 1, end - begin - 1);
    if (end != std::string::npos && name[end] == 'd' && digits.size() <= 2)
      return {begin, end + 1 - begin, digits.empty() ? 0 : std::stoul(digits),
              digits.substr(0, 1) == "0" ? '0' : ' '};
    if (end == begin + 1 && name[end] == 's')
      return {begin, 2, 0, ' ', true};
  }
  return {};
}

// For which the pattern gives this name; folders are not looked at.
std::optional<std::size_t> number_of_part(const std::string& pattern, const std::string& name)
{
  const Placeholder placeholder = find_placeholder(pattern);
  const std::size_t size_of_rest = pattern.size() - placeholder.size;
  if (name.size() <= size_of_rest || placeholder.is_name)
    return std::nullopt;
  const std::string digits = name.substr(placeholder.begin, name.size() - size_of_rest);
  const std::size_t begin = digits.find_first_not_of(' ');
  const auto segment = number<std::size_t>(begin == std::string::npos ? "" : digits.substr(begin));
  return segment && name_of_part(pattern, *segment) == name ? segment : std::nullopt;
}

// Without characters that names of files, or of groups in OBJ, cannot have.
std::string one_word(const std::string& name)
{
  std::string word = name;
  for (char& c : word)
    if (static_cast<unsigned char>(c) < 0x80 && !std::isalnum(static_cast<unsigned char>(c)) && c != '-' && c != '_' &&
        (c != '.' || &c == &word.front()))
      c = '_';
  return word;
}

bool begins_or_is_begun_by(std::string_view a, std::string_view b)
{
  const std::size_t size = (std::min)(a.size(), b.size());
  return a.substr(0, size) == b.substr(0, size);
}

// Can a pattern with a "%s" give a name, or a name that another pattern gives?
bool can_be_equal(const std::string& pattern, const std::string& other)
{
  const Placeholder first = find_placeholder(pattern), second = find_placeholder(other);
  const std::string reversed(pattern.rbegin(), pattern.rend() - std::ptrdiff_t(first.begin + first.size));
  if (second.size > 0)
  {
    const std::string other_reversed(other.rbegin(), other.rend() - std::ptrdiff_t(second.begin + second.size));
    return begins_or_is_begun_by(pattern.substr(0, first.begin), other.substr(0, second.begin)) &&
           begins_or_is_begun_by(reversed, other_reversed);
  }
  return other.size() > pattern.size() - first.size && other.compare(0, first.begin, pattern, 0, first.begin) == 0 &&
         std::equal(reversed.begin(), reversed.end(), other.rbegin());
}

std::string file_name(const std::string& name)
{
  return fs::path(name).filename().string();
}

fs::path folder_of(const std::string& name)
{
  return place_of_file(name).parent_path();
}

} // namespace

bool is_pattern(const std::string& name)
{
  return find_placeholder(name).size > 0;
}

bool is_valid_pattern(const std::string& name)
{
  return is_pattern(file_name(name)) && find_placeholder(name, find_placeholder(name).begin + 1).size == 0;
}

std::string name_of_part(const std::string& pattern, std::size_t segment)
{
  const Placeholder placeholder = find_placeholder(pattern);
  std::string number = (placeholder.is_name ? "segment_" : "") + std::to_string(segment);
  number.insert(0, placeholder.width > number.size() ? placeholder.width - number.size() : 0,
                placeholder.fill);
  return std::string(pattern).replace(placeholder.begin, placeholder.size, number);
}

std::vector<std::string> names_of_parts(const std::string& pattern,
                                        std::size_t number_of_segments,
                                        const std::vector<std::string>& names_of_segments)
{
  const Placeholder placeholder = find_placeholder(pattern);
  std::vector<std::string> result;
  std::set<std::string> words;
  for (std::size_t s = 0; s < number_of_segments; ++s)
  {
    result.push_back(name_of_part(pattern, s));
    if (!placeholder.is_name)
      continue;
    std::string word = one_word(s < names_of_segments.size() ? names_of_segments[s] : "");
    if (word.empty())
      word = "segment_" + std::to_string(s);
    while (!words.insert(word).second)
      word += "_" + std::to_string(s);
    result.back() = std::string(pattern).replace(placeholder.begin, placeholder.size, word);
  }
  return result;
}

fs::path place_of_file(const std::string& name)
{
  std::error_code error;
  const fs::path absolute = fs::absolute(name, error); // without which a missing file keeps its name as it is
  const fs::path place = fs::weakly_canonical(absolute, error);
  return error ? absolute : place;
}

bool gives_part(const std::string& pattern, const std::string& name)
{
  const fs::path place = place_of_file(name);
  const std::string pattern_of_file = file_name(pattern), file = place.filename().string();
  if (place.parent_path() == folder_of(pattern) &&
      (find_placeholder(pattern_of_file).is_name ? can_be_equal(pattern_of_file, file)
                                                 : number_of_part(pattern_of_file, file).has_value()))
    return true;
  for (const auto& [segment, part] : parts_in_place(pattern))
    if (place_of_file(part) == place)
      return true;
  return false;
}

std::optional<std::string> common_part(const std::string& pattern, const std::string& other)
{
  constexpr std::size_t enough = 10000; // patterns that agree agree early, but where names are full of digits
  if (folder_of(pattern) != folder_of(other))
    return std::nullopt;
  const std::string first = file_name(pattern), second = file_name(other);
  if (find_placeholder(first).is_name || find_placeholder(second).is_name)
    return can_be_equal(first, second) ? std::optional<std::string>(name_of_part(pattern, 0)) : std::nullopt;
  for (std::size_t segment = 0; segment < enough; ++segment)
    if (number_of_part(second, name_of_part(first, segment)))
      return name_of_part(pattern, segment);
    else if (number_of_part(first, name_of_part(second, segment)))
      return name_of_part(other, segment);
  return std::nullopt;
}

std::map<std::size_t, std::string> parts_in_place(const std::string& pattern)
{
  std::map<std::size_t, std::string> parts;
  const fs::path folder = fs::path(pattern).parent_path();
  std::error_code error;
  fs::directory_iterator entry(folder.empty() ? "." : folder, error);
  for (const fs::directory_iterator end; !error && entry != end; entry.increment(error))
    if (const auto segment = number_of_part(file_name(pattern), entry->path().filename().string()))
      parts[*segment] = (folder / entry->path().filename()).string();
  return parts;
}

std::string note_on_further_parts(const std::string& pattern, std::size_t number_of_segments)
{
  const std::map<std::size_t, std::string> parts = parts_in_place(pattern);
  const auto first = parts.lower_bound(number_of_segments);
  const auto number = std::distance(first, parts.end());
  if (number == 0)
    return "";
  if (number == 1)
    return first->second + " is not of this run";
  return first->second + " to " + parts.rbegin()->second + ", " + std::to_string(number) + " files, are not of this run";
}

} // namespace tool
