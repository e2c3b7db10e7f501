// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A folder with the Princeton Segmentation Benchmark, as its archive is laid out or flat:
//
//   data/off/<model>.off                             or off/<model>.off: the mesh
//   data/seg/Benchmark/<model>/<model>_<human>.seg   or seg/<model>/...: a human's segmentation
//   util/parameters/nSeg-ByModel.txt                 or nSeg-ByModel.txt: line <model>: the number of segments to ask for
//   classes.txt                                      if its classes are not Princeton's: as Model_classes takes them
//
// The archive's folder data can be named as well.

#ifndef CGAL_PROTRUSION_SEGMENTATION_BENCHMARK_BENCHMARK_FOLDER_H
#define CGAL_PROTRUSION_SEGMENTATION_BENCHMARK_BENCHMARK_FOLDER_H

#include "File_faces.h"
#include "Model_classes.h"
#include "Segmentation_method.h"

#include <cstddef>
#include <filesystem>
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
  // Throws `std::runtime_error`, which names the file and the cause, if the folder is not laid out as above. Classes that are
  // named go before those of the file.
  explicit Benchmark_folder(const std::string& path, const std::string& classes = "");

  // The models that are there among those of the list, such as "2,4,10-50,60-400/8"; "" stands for all.
  // Throws `std::invalid_argument` if the list cannot be understood.
  std::vector<int> models(const std::string& list) const;

  std::string mesh_file(int number) const;

  // Throws `std::runtime_error` if a file is missing or malformed.
  Model read_model(int number) const;

private:
  std::filesystem::path m_meshes, m_segmentations;
  Model_classes m_classes;
  std::vector<int> m_models;                      // sorted
  std::vector<std::size_t> m_numbers_of_segments; // of model 1, 2, ...
};

#endif // CGAL_PROTRUSION_SEGMENTATION_BENCHMARK_BENCHMARK_FOLDER_H
