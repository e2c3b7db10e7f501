// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "contestants.h"

#include "Segmentation_folder.h"
#include "methods.h"
#include "named_methods.h"
#include "processor_seconds.h"

#include <algorithm>
#include <stdexcept>

namespace {

Contestant contestant(const Segmentation_method& method)
{
  return {method.name,
          [method](const Model& model, unsigned int seed) -> Timed_labels
          {
            const double begin = processor_seconds();
            Labels labels = method.segment(model.mesh, model.number_of_segments, seed);
            return {std::move(labels), processor_seconds() - begin + method.seconds_saved()};
          }};
}

Contestant contestant(const Segmentation_folder& folder)
{
  return {folder.name(), [folder](const Model& model, unsigned int) -> Timed_labels {
            return {folder.labels(model.number, model.faces), folder.seconds(model.number)};
          }};
}

bool has_name(const std::vector<Contestant>& contestants, const std::string& name)
{
  return std::any_of(contestants.begin(), contestants.end(),
                     [&](const Contestant& c) { return c.name == name; });
}

} // namespace

std::vector<Contestant> chosen_contestants(const std::string& list,
                                           const std::vector<std::string>& folders)
{
  std::vector<Contestant> of_folders, all, result;
  for (const std::string& folder : folders)
  {
    Contestant next = contestant(Segmentation_folder(folder));
    if (has_name(of_folders, next.name))
      throw std::invalid_argument("two folders of segmentations have the name '" + next.name + "'");
    of_folders.push_back(std::move(next));
  }
  all = of_folders;
  for (const Segmentation_method& method : all_methods())
    if (!has_name(of_folders, method.name))
    {
      all.push_back(contestant(method));
      if (list.empty() && method.runs_by_default)
        result.push_back(all.back());
    }
  if (!list.empty())
    result = named_methods(all, list);
  for (const Contestant& of_folder : of_folders)
    if (!has_name(result, of_folder.name))
      result.push_back(of_folder);
  return result;
}
