// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_BENCHMARK_NAMED_METHODS_H
#define CGAL_PROTRUSION_SEGMENTATION_BENCHMARK_NAMED_METHODS_H

#include "Segmentation_method.h"

#include <algorithm>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

// Those of `all` that a list such as "Minimum-cut,Paper-GD" names, in its order. Throws `std::invalid_argument`
// for a name that none of them has.
inline std::vector<Segmentation_method> named_methods(const std::vector<Segmentation_method>& all,
                                                      const std::string& list)
{
  std::vector<Segmentation_method> result;
  std::istringstream in(list);
  for (std::string name; std::getline(in, name, ',');)
  {
    const auto found = std::find_if(all.begin(), all.end(), [&](const Segmentation_method& method)
                                    { return method.name == name; });
    if (found == all.end())
      throw std::invalid_argument("there is no method '" + name + "'");
    result.push_back(*found);
  }
  return result;
}

#endif // CGAL_PROTRUSION_SEGMENTATION_BENCHMARK_NAMED_METHODS_H
