// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Segmentations of the benchmark's models that any program made, in a folder:
//
//   <model>.seg, or <model>/ with one .seg file of any name
//   <model>.seconds    what it took, in seconds; may be missing

#ifndef CGAL_PROTRUSION_SEGMENTATION_BENCHMARK_SEGMENTATION_FOLDER_H
#define CGAL_PROTRUSION_SEGMENTATION_BENCHMARK_SEGMENTATION_FOLDER_H

#include "File_faces.h"
#include "Segmentation_method.h"

#include <optional>
#include <string>

// The labels that a .seg file has for the mesh with these faces. Throws `std::runtime_error`, which names the file, if it
// is none.
Labels read_labels(const std::string& file_name, const File_faces& faces);

class Segmentation_folder
{
public:
  // `name_and_path` is NAME=FOLDER. Throws `std::invalid_argument` if it is not, or if the folder has no
  // segmentation.
  explicit Segmentation_folder(const std::string& name_and_path);

  const std::string& name() const { return m_name; }

  // Throws `std::runtime_error` if there is no segmentation of the model, more than one, or a malformed one.
  Labels labels(int model, const File_faces& faces) const;

  // Throws `std::runtime_error` if there is a file that has no such number.
  std::optional<double> seconds(int model) const;

private:
  std::string m_name;
  std::string m_path;
};

// Adds a segmentation to such a folder, which is created if need be. Throws `std::runtime_error` if a file cannot
// be written.
void add_to_segmentation_folder(const std::string& path,
                                int model,
                                const File_faces& faces,
                                const Labels& labels,
                                const std::optional<double>& seconds);

#endif // CGAL_PROTRUSION_SEGMENTATION_BENCHMARK_SEGMENTATION_FOLDER_H
