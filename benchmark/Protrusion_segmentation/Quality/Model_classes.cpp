// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Model_classes.h"

#include <sstream>
#include <stdexcept>

Model_classes::Model_classes()
{
  const int models_per_class = 20;
  // The benchmark dropped a class: numbers 261 to 280 are not used.
  const char* names[] = {"Human",     "Cup",   "Glasses", "Airplane", "Ant",  "Chair",  "Octopus",
                         "Table",     "Teddy", "Hand",    "Plier",    "Fish", "Bird",   nullptr,
                         "Armadillo", "Bust",  "Mech",    "Bearing",  "Vase", "FourLeg"};
  int first = 1;
  for (const char* name : names)
  {
    if (name)
      m_classes.push_back({name, first, first + models_per_class - 1});
    first += models_per_class;
  }
}

Model_classes::Model_classes(const std::string& text)
{
  std::istringstream in(text);
  for (std::string part; std::getline(in, part, ',');)
  {
    std::istringstream range(part);
    Class next{"", 0, 0};
    char dash = 0;
    const bool is_read = std::getline(range, next.name, '=') &&
                         range >> next.first >> dash >> next.last && dash == '-' &&
                         (range >> std::ws).eof();
    if (!is_read || next.name.empty() || next.first > next.last)
      throw std::invalid_argument("the classes '" + text + "' are not like People=1-200,Animals=201-300");
    m_classes.push_back(next);
  }
}

const std::string& Model_classes::of_model(int model) const
{
  for (const Class& one : m_classes)
    if (one.first <= model && model <= one.last)
      return one.name;
  throw std::invalid_argument("model " + std::to_string(model) + " is in no class");
}
