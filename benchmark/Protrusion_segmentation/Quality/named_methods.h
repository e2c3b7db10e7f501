// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_BENCHMARK_NAMED_METHODS_H
#define CGAL_PROTRUSION_SEGMENTATION_BENCHMARK_NAMED_METHODS_H

#include <algorithm>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

// Those of `all`, which have a member `name`, that a list such as "Minimum-cut,Paper-GD" names, in its order. Throws
// `std::invalid_argument` for a name that none of them has.
template <typename Method>
std::vector<Method> named_methods(const std::vector<Method>& all, const std::string& list)
{
  std::vector<Method> result;
  std::istringstream in(list);
  for (std::string name; std::getline(in, name, ',');)
  {
    const auto found = std::find_if(all.begin(), all.end(), [&](const Method& method)
                                    { return method.name == name; });
    if (found == all.end())
      throw std::invalid_argument("there is no method '" + name + "'");
    result.push_back(*found);
  }
  return result;
}

#endif // CGAL_PROTRUSION_SEGMENTATION_BENCHMARK_NAMED_METHODS_H
