// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Other meshes of the same shape, or of the same shape with something beside it.

#ifndef CGAL_PROTRUSION_SEGMENTATION_BENCHMARK_CHANGES_OF_MESH_H
#define CGAL_PROTRUSION_SEGMENTATION_BENCHMARK_CHANGES_OF_MESH_H

#include "Segmentation_method.h"

#include <cstddef>
#include <functional>
#include <limits>
#include <string>
#include <vector>

constexpr std::size_t no_origin = (std::numeric_limits<std::size_t>::max)();

struct Changed_mesh
{
  Mesh mesh;
  std::vector<std::size_t> origins; // of every face, the face of the mesh that it came from, or `no_origin`
  std::vector<std::size_t> copies;  // of every face, the number of its copy
};

struct Change_of_mesh
{
  std::string name;
  std::string goal; // the share of pairs of faces that may be divided differently; "-" for none
  std::function<Changed_mesh(const Mesh&)> apply;
  // the number of segments that one expects, for that of the mesh
  std::function<std::size_t(std::size_t)> number_of_segments = [](std::size_t n) { return n; };
};

// All changes that are measured. Random numbers have fixed seeds.
std::vector<Change_of_mesh> all_changes_of_mesh();

#endif // CGAL_PROTRUSION_SEGMENTATION_BENCHMARK_CHANGES_OF_MESH_H
