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
  return !text.empty() && text.size() < 9
      && std::all_of(text.begin(), text.end(), [](unsigned char c) { return std::isdigit(c); });
}

int number_in_list(const std::string& text, const std::string& list)
{
  if(!is_number(text))
    throw std::invalid_argument("the list of models '" + list + "' is not like 2,4,10-50");
  return std::stoi(text);
}

std::set<int> parsed_list(const std::string& list)
{
  std::set<int> result;
  std::istringstream in(list);
  for(std::string range; std::getline(in, range, ','); )
  {
    const std::size_t dash = range.find('-');
    const int first = number_in_list(range.substr(0, dash), list);
    const int last =
      dash == std::string::npos ? first : number_in_list(range.substr(dash + 1), list);
    for(int model = first; model <= last; ++model)
      result.insert(model);
  }
  return result;
}

} // namespace

Benchmark_folder::Benchmark_folder(const std::string& path, const Model_classes& classes)
  : m_path(path), m_classes(classes)
{
  std::error_code error;
  for(const fs::directory_entry& entry : fs::directory_iterator(fs::path(path) / "off", error))
    if(entry.path().extension() == ".off" && is_number(entry.path().stem().string()))
      m_models.push_back(std::stoi(entry.path().stem().string()));
  std::sort(m_models.begin(), m_models.end());
  if(m_models.empty())
    throw std::runtime_error(path + ": there is no off/<model>.off");

  const std::string by_model = (fs::path(path) / "nSeg-ByModel.txt").string();
  std::ifstream in(by_model);
  for(std::size_t number; in >> number; )
    m_numbers_of_segments.push_back(number);
  if(m_numbers_of_segments.size() < std::size_t(m_models.back()))
    throw std::runtime_error(by_model + ": has fewer lines than there are models");
}

std::vector<int> Benchmark_folder::models(const std::string& list) const
{
  if(list.empty())
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
  const std::string name = std::to_string(number);
  model.number = number;
  model.class_name = m_classes.of_model(number);
  model.number_of_segments = m_numbers_of_segments.at(std::size_t(number - 1));

  const std::string mesh_file = (fs::path(m_path) / "off" / (name + ".off")).string();
  Mesh_of_file read = read_mesh(mesh_file);
  model.mesh = std::move(read.mesh);
  model.faces = std::move(read.faces);

  std::vector<fs::path> files;
  for(const fs::directory_entry& entry : fs::directory_iterator(fs::path(m_path) / "seg" / name))
    if(entry.path().extension() == ".seg")
      files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  for(const fs::path& file : files)
    model.humans.push_back(read_labels(file.string(), model.faces));
  if(model.humans.empty())
    throw std::runtime_error("model " + name + " has no human segmentation");
  return model;
}
