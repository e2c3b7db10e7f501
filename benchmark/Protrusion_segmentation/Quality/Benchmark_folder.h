// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A folder laid out as the Princeton Segmentation Benchmark:
//
//   off/<model>.off                    the mesh
//   seg/<model>/<model>_<human>.seg    a human's segmentation
//   nSeg-ByModel.txt                   line <model>: the number of segments to ask for

#ifndef CGAL_PROTRUSION_SEGMENTATION_BENCHMARK_BENCHMARK_FOLDER_H
#define CGAL_PROTRUSION_SEGMENTATION_BENCHMARK_BENCHMARK_FOLDER_H

#include "File_faces.h"
#include "Model_classes.h"
#include "Segmentation_method.h"

#include <cstddef>
#include <string>
#include <vector>

struct Model
{
  int number = 0;
  std::string class_name;
  std::size_t number_of_segments = 0;
  Mesh mesh;
  File_faces faces;
  std::vector<Labels> humans; // of the faces of the mesh
};

class Benchmark_folder
{
public:
  // Throws `std::runtime_error` if the folder is not laid out as above.
  explicit Benchmark_folder(const std::string& path, const Model_classes& classes = Model_classes());

  // The models that are there among those of the list, such as "2,4,10-50"; "" stands for all.
  // Throws `std::invalid_argument` if the list cannot be understood.
  std::vector<int> models(const std::string& list) const;

  // Throws `std::runtime_error` if a file is missing or malformed.
  Model read_model(int number) const;

private:
  std::string m_path;
  Model_classes m_classes;
  std::vector<int> m_models;                    // sorted
  std::vector<std::size_t> m_numbers_of_segments; // of model 1, 2, ...
};

#endif // CGAL_PROTRUSION_SEGMENTATION_BENCHMARK_BENCHMARK_FOLDER_H
