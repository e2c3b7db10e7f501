// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Benchmark_folder.h"

#include "Segmentation_folder.h"
#include "read_mesh.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>
#include <stdexcept>

namespace fs = std::filesystem;

namespace {

bool is_number(const std::string& text)
{
  return !text.empty() && text.size() < 9 &&
         std::all_of(text.begin(), text.end(), [](unsigned char c) { return std::isdigit(c); });
}

int number_in_list(const std::string& text, const std::string& list)
{
  if (!is_number(text))
    throw std::invalid_argument("the list of models '" + list + "' is not like 2,4,10-50,60-400/8");
  return std::stoi(text);
}

std::set<int> parsed_list(const std::string& list)
{
  std::set<int> result;
  std::istringstream in(list);
  for (std::string range; std::getline(in, range, ',');)
  {
    const std::size_t slash = range.find('/'), dash = range.find('-');
    const int step = slash == std::string::npos ? 1 : number_in_list(range.substr(slash + 1), list);
    range = range.substr(0, slash);
    const int first = number_in_list(range.substr(0, dash), list);
    const int last = dash == std::string::npos ? first : number_in_list(range.substr(dash + 1), list);
    for (int model = first; model <= last; model += (std::max)(step, 1))
      result.insert(model);
  }
  return result;
}

// The first of them that is there, else the first.
fs::path existing(const std::vector<fs::path>& paths)
{
  const auto found = std::find_if(paths.begin(), paths.end(),
                                  [](const fs::path& path) { return fs::exists(path); });
  return found == paths.end() ? paths.front() : *found;
}

// Sorted. Throws if the folder cannot be opened.
std::vector<fs::path> files_in(const fs::path& folder, const std::string& extension)
{
  std::error_code error;
  std::vector<fs::path> files;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, error))
    if (entry.path().extension() == extension)
      files.push_back(entry.path());
  if (error)
    throw std::runtime_error(folder.string() + ": cannot be opened");
  std::sort(files.begin(), files.end());
  return files;
}

} // namespace

Benchmark_folder::Benchmark_folder(const std::string& path, const std::string& classes)
{
  const fs::path folder(path);
  std::string of_file;
  std::getline(std::ifstream(folder / "classes.txt"), of_file);
  if (const std::string& text = classes.empty() ? of_file : classes; !text.empty())
    m_classes = Model_classes(text);
  m_meshes = existing({folder / "off", folder / "data/off"});
  m_segmentations = m_meshes.parent_path() / "seg";
  if (fs::exists(m_segmentations / "Benchmark"))
    m_segmentations /= "Benchmark";
  for (const fs::path& file : files_in(m_meshes, ".off"))
    if (is_number(file.stem().string()))
      m_models.push_back(std::stoi(file.stem().string()));
  std::sort(m_models.begin(), m_models.end());
  if (m_models.empty())
    throw std::runtime_error(m_meshes.string() + ": has no <model>.off");

  const fs::path by_model = existing({folder / "nSeg-ByModel.txt",
                                      folder / "util/parameters/nSeg-ByModel.txt",
                                      folder / "../util/parameters/nSeg-ByModel.txt"});
  std::ifstream in(by_model);
  if (!in)
    throw std::runtime_error(by_model.string() + ": cannot be opened");
  for (std::size_t number; in >> number;)
    m_numbers_of_segments.push_back(number);
  if (m_numbers_of_segments.size() < std::size_t(m_models.back()))
    throw std::runtime_error(by_model.string() + ": has fewer lines than there are models");
}

std::string Benchmark_folder::mesh_file(int number) const
{
  return (m_meshes / (std::to_string(number) + ".off")).string();
}

std::vector<int> Benchmark_folder::models(const std::string& list) const
{
  if (list.empty())
    return m_models;
  const std::set<int> chosen = parsed_list(list);
  std::vector<int> result;
  std::copy_if(m_models.begin(), m_models.end(), std::back_inserter(result),
               [&](int model) { return chosen.count(model) > 0; });
  return result;
}

Model Benchmark_folder::read_model(int number) const
{
  Model model;
  model.number = number;
  model.class_name = m_classes.of_model(number);
  model.number_of_segments = m_numbers_of_segments.at(std::size_t(number - 1));

  Mesh_of_file read = read_mesh(mesh_file(number));
  model.mesh = std::move(read.mesh);
  model.faces = std::move(read.faces);

  const fs::path folder = m_segmentations / std::to_string(number);
  for (const fs::path& file : files_in(folder, ".seg"))
    model.humans.push_back(read_labels(file.string(), model.faces));
  if (model.humans.empty())
    throw std::runtime_error(folder.string() + ": has no .seg file");
  return model;
}
