// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "reading/read_labels.h"

#include "command_line/Error.h"
#include "command_line/number.h"
#include "reading/Format_error.h"
#include "reading/formats.h"
#include "reading/lower_case_extension.h"
#include "reading/read_bytes.h"
#include "reading/read_segmentation.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace tool {
namespace {

// The value of a key in the header of an .npy file, a Python dictionary, up to one of the characters.
std::string value_in(const std::string& header, const std::string& key, const char* ends)
{
  const std::size_t begin = header.find("'" + key + "':");
  if (begin == std::string::npos)
    throw Format_error("its header has no " + key);
  const std::size_t value = header.find_first_not_of(" ('", begin + key.size() + 3);
  return value == std::string::npos ? ""
                                    : header.substr(value, header.find_first_of(ends, value) - value);
}

double integer_of_bytes(const std::string& bytes,
                        std::size_t begin,
                        std::size_t size,
                        bool is_signed,
                        bool is_big_endian)
{
  std::uint64_t bits = 0;
  for (std::size_t i = 0; i < size; ++i)
    bits = bits << 8 | static_cast<unsigned char>(bytes[begin + (is_big_endian ? i : size - 1 - i)]);
  const std::uint64_t sign = std::uint64_t(1) << (8 * size - 1);
  return is_signed && (bits & sign) != 0 ? -1 : double(bits); // which negative number does not matter
}

// An array of integers of one dimension.
std::vector<double> read_NPY(const std::string& bytes)
{
  constexpr std::size_t begin_of_length = 8; // after the magic word and the version
  if (bytes.compare(0, 6, "\x93NUMPY") != 0 || bytes.size() < begin_of_length + 4)
    throw Format_error("is no .npy file");
  const std::size_t size_of_length = bytes[6] == 1 ? 2 : 4;
  const std::size_t begin = begin_of_length + size_of_length;
  const auto length = static_cast<std::size_t>(
    integer_of_bytes(bytes, begin_of_length, size_of_length, false, false));
  const std::string header = bytes.substr(begin, length);
  const std::string type = value_in(header, "descr", "'");
  const auto count = number<std::size_t>(value_in(header, "shape", ",)"));
  const bool is_vector = header.find(",)") != std::string::npos;
  if (type.size() != 3 || (type[1] != 'i' && type[1] != 'u') || !is_vector || !count)
    throw Format_error("is no array of integers of one dimension");
  const auto size = static_cast<std::size_t>(type[2] - '0');
  if (size == 0 || size > 8)
    throw Format_error("has integers of " + type.substr(2) + " bytes");
  if (bytes.size() < begin + length || (bytes.size() - begin - length) / size < *count)
    throw Format_error("ends too early");
  std::vector<double> values;
  for (std::size_t i = 0; i < *count; ++i)
    values.push_back(
      integer_of_bytes(bytes, begin + length + i * size, size, type[1] == 'i', type[0] == '>'));
  return values;
}

using Json = nlohmann::json;

double label_of(const Json& value)
{
  if (!value.is_number_integer())
    throw Format_error("has a label that is no integer: " + value.dump());
  return value.get<double>();
}

// [3, 1, ...], or {"0": 3, "1": 1, ...} as some learned methods write it.
std::vector<double> read_JSON(const std::string& bytes)
{
  const Json content = Json::parse(bytes, nullptr, false);
  if (!content.is_array() && !content.is_object())
    throw Format_error("is no JSON with an array of labels, or an object with a label for each face");
  if (content.is_object() && content.contains("format_version"))
    throw Format_error("is a record as of --json, which has no labels of faces; -o NAME.seg writes them");
  std::vector<double> labels(content.size());
  std::vector<bool> is_known(content.size(), content.is_array());
  for (const auto& [key, value] : content.items())
  {
    const auto face = number<std::size_t>(key);
    if (!face || *face >= labels.size())
      throw Format_error("has " + std::to_string(labels.size()) +
                         " labels, and one of them is for face '" + key + "'");
    labels[*face] = label_of(value);
    is_known[*face] = true;
  }
  if (const auto unknown = std::find(is_known.begin(), is_known.end(), false); unknown != is_known.end())
    throw Format_error("has no label for face " + std::to_string(unknown - is_known.begin()));
  return labels;
}

bool is_SEG(const std::string& file_name)
{
  const std::string extension = lower_case_extension(file_name);
  return extension != ".npy" && extension != ".json" && extension != ".ply" && extension != ".vtp";
}

std::vector<double> read_values(const std::string& file_name)
{
  const std::string extension = lower_case_extension(file_name), bytes = read_bytes(file_name);
  if (extension == ".npy")
    return read_NPY(bytes);
  if (extension == ".json")
    return read_JSON(bytes);
  if (extension == ".ply")
    return read_PLY_labels(bytes);
#ifdef PROTRUSION_SEGMENTATION_HAS_VTK
  if (extension == ".vtp")
    return read_VTP_labels(bytes);
#endif
  throw Format_error(
    "labels are read from .seg, .npy, .json, .ply and, if VTK was found at build time, .vtp");
}

std::vector<std::int64_t> labels_of_file(const std::string& file_name, std::size_t number_of_faces)
{
  const std::vector<double> values = read_values(file_name);
  if (values.empty())
    throw Format_error("its faces have no data named segment or label");
  if (values.size() != number_of_faces)
    throw Format_error("has " + std::to_string(values.size()) + " labels, but the mesh has " +
                       std::to_string(number_of_faces) + " faces");
  constexpr double end = 4294967296.; // of what 32 bits can hold
  std::vector<std::int64_t> labels;
  for (const double value : values)
  {
    if (!(std::abs(value) < end && value == std::floor(value)))
      throw Format_error("the label of face " + std::to_string(labels.size()) +
                         " is no integer of 32 bits");
    labels.push_back(static_cast<std::int64_t>(value));
  }
  return labels;
}

} // namespace

std::vector<std::int64_t> read_some_labels(const std::string& file_name, Input_mesh& input)
{
  std::vector<std::int64_t> result;
  if (is_SEG(file_name))
  {
    Segment_ids ids = read_segmentation(file_name, input);
    for (const Face f : faces(input.mesh))
      result.push_back(static_cast<std::int64_t>(ids[f]));
    input.mesh.remove_property_map(ids);
    return result;
  }
  try
  {
    const std::vector<std::int64_t> labels = labels_of_file(file_name, input.label_giver.size());
    for (const std::size_t face : input.face_in_file)
      result.push_back(labels[face]);
    return result;
  }
  catch (const Format_error& error)
  {
    throw Error(file_name, error.what());
  }
}

std::vector<std::size_t> read_labels(const std::string& file_name, Input_mesh& input)
{
  if (is_SEG(file_name) && lower_case_extension(file_name) != ".seg")
    throw Error(file_name,
                "labels are read from .seg, .npy, .json, .ply and, if VTK was found at build time, .vtp");
  const std::vector<std::int64_t> labels = read_some_labels(file_name, input);
  for (std::size_t i = 0; i < labels.size(); ++i)
    if (labels[i] < 0)
      throw Error(file_name,
                  "the label of face " + std::to_string(input.face_in_file[i]) + " is no integer from 0");
  return std::vector<std::size_t>(labels.begin(), labels.end());
}

} // namespace tool
