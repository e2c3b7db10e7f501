// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The classes that the models of a benchmark belong to, by their numbers.

#ifndef CGAL_PROTRUSION_SEGMENTATION_BENCHMARK_MODEL_CLASSES_H
#define CGAL_PROTRUSION_SEGMENTATION_BENCHMARK_MODEL_CLASSES_H

#include <string>
#include <vector>

class Model_classes
{
public:
  // Those of the Princeton Segmentation Benchmark: nineteen, of twenty models each.
  Model_classes();

  // From a text such as "People=1-200,Animals=201-300". Throws `std::invalid_argument` if it is none.
  explicit Model_classes(const std::string& text);

  // Throws `std::invalid_argument` for a number in no class.
  const std::string& of_model(int model) const;

private:
  struct Class
  {
    std::string name;
    int first, last; // models
  };

  std::vector<Class> m_classes;
};

#endif // CGAL_PROTRUSION_SEGMENTATION_BENCHMARK_MODEL_CLASSES_H
