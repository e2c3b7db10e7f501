// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_BENCHMARK_FILE_FACES_H
#define CGAL_PROTRUSION_SEGMENTATION_BENCHMARK_FILE_FACES_H

#include "Segmentation_method.h"

#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

// The faces of a file and those of the mesh that was made of it, which has no place for degenerate and duplicate ones.
// Labels in files are those of the file's faces.
class File_faces
{
public:
  // They are the same.
  explicit File_faces(std::size_t number_of_faces = 0) : m_in_file(number_of_faces)
  {
    std::iota(m_in_file.begin(), m_in_file.end(), std::size_t(0));
    m_label_giver = m_in_file;
  }
  // `in_file` has for each face of the mesh that of the file, `label_giver` for each face of the file the face of the
  // mesh that has its label.
  File_faces(std::vector<std::size_t> in_file, std::vector<std::size_t> label_giver)
    : m_in_file(std::move(in_file)), m_label_giver(std::move(label_giver))
  {}

  std::size_t number_in_file() const { return m_label_giver.size(); }

  Labels labels_of_mesh(const Labels& of_file) const { return picked(of_file, m_in_file); }
  Labels labels_of_file(const Labels& of_mesh) const { return picked(of_mesh, m_label_giver); }

private:
  static Labels picked(const Labels& labels, const std::vector<std::size_t>& indices)
  {
    Labels result;
    result.reserve(indices.size());
    for (const std::size_t i : indices)
      result.push_back(labels.at(i));
    return result;
  }

  std::vector<std::size_t> m_in_file;
  std::vector<std::size_t> m_label_giver;
};

#endif // CGAL_PROTRUSION_SEGMENTATION_BENCHMARK_FILE_FACES_H
