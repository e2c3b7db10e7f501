// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Segmentation_folder.h"

#include <CGAL/IO/SEG.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <limits>
#include <stdexcept>
#include <vector>

namespace fs = std::filesystem;

namespace {

bool is_segmentation(const fs::path& file)
{
  return file.extension() == ".seg";
}

// Whether the folder or one in it has a .seg file.
bool has_segmentations(const std::string& path)
{
  const fs::recursive_directory_iterator files(path);
  return std::any_of(begin(files), end(files),
                     [](const fs::directory_entry& entry) { return is_segmentation(entry.path()); });
}

fs::path segmentation_file(const std::string& path, int model)
{
  const fs::path folder = fs::path(path) / std::to_string(model);
  const fs::path file = folder.string() + ".seg";
  if (fs::exists(file))
    return file;
  std::vector<fs::path> found;
  if (fs::is_directory(folder))
    for (const fs::directory_entry& entry : fs::directory_iterator(folder))
      if (is_segmentation(entry.path()))
        found.push_back(entry.path());
  if (found.empty())
    throw std::runtime_error(file.string() + ": there is no such file");
  if (found.size() > 1)
    throw std::runtime_error(folder.string() + ": there is more than one segmentation");
  return found.front();
}

fs::path seconds_file(const std::string& path, int model)
{
  return fs::path(path) / (std::to_string(model) + ".seconds");
}

template <typename Number>
void write_lines(const fs::path& file, const std::vector<Number>& numbers)
{
  std::ofstream out(file);
  for (const Number& number : numbers)
    out << number << "\n";
  out.close();
  if (!out)
    throw std::runtime_error(file.string() + ": cannot be written");
}

} // namespace

Labels read_labels(const std::string& file_name, const File_faces& faces)
{
  std::ifstream in(file_name);
  if (!in)
    throw std::runtime_error(file_name + ": cannot be opened");
  std::vector<std::uint64_t> ids;
  const std::string problem = CGAL::Protrusion_segmentation::internal::parse_segment_ids(
    in, faces.number_in_file(), (std::numeric_limits<std::size_t>::max)(), ids);
  if (!problem.empty())
    throw std::runtime_error(file_name + ": " + problem);
  return faces.labels_of_mesh(Labels(ids.begin(), ids.end()));
}

Segmentation_folder::Segmentation_folder(const std::string& name_and_path)
{
  const std::size_t sign = name_and_path.find('=');
  m_name = name_and_path.substr(0, sign);
  if (sign == std::string::npos || m_name.empty() || m_name.find_first_of(" ,|") != std::string::npos)
    throw std::invalid_argument("'" + name_and_path +
                                "' is not NAME=FOLDER with a name without blanks, commas and bars");
  m_path = name_and_path.substr(sign + 1);
  if (!fs::is_directory(m_path))
    throw std::invalid_argument(m_path + ": is no folder");
  if (!has_segmentations(m_path))
    throw std::invalid_argument(m_path + ": has no .seg files");
}

Labels Segmentation_folder::labels(int model, const File_faces& faces) const
{
  return read_labels(segmentation_file(m_path, model).string(), faces);
}

std::optional<double> Segmentation_folder::seconds(int model) const
{
  const fs::path file = seconds_file(m_path, model);
  if (!fs::exists(file))
    return std::nullopt;
  std::ifstream in(file);
  double result = 0;
  if (!(in >> result) || !(in >> std::ws).eof() || !std::isfinite(result) || result < 0)
    throw std::runtime_error(file.string() + ": is not a number of seconds");
  return result;
}

void add_to_segmentation_folder(const std::string& path,
                                int model,
                                const File_faces& faces,
                                const Labels& labels,
                                const std::optional<double>& seconds)
{
  fs::create_directories(path);
  write_lines(fs::path(path) / (std::to_string(model) + ".seg"), faces.labels_of_file(labels));
  if (seconds)
    write_lines(seconds_file(path, model), std::vector<double>{*seconds});
}
