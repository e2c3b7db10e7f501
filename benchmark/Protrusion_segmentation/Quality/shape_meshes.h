// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Meshes of bodies that are blended, with the part of every face.

#ifndef CGAL_PROTRUSION_SEGMENTATION_BENCHMARK_SHAPE_MESHES_H
#define CGAL_PROTRUSION_SEGMENTATION_BENCHMARK_SHAPE_MESHES_H

#include "body_functions.h"
#include "test_mesh.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <vector>

struct Shape
{
  std::vector<body_functions::Body> parts; // the body first
  double blend = 0;        // size of the fillets

  double operator()(const test_meshes::Point& p) const
  {
    double nearest = 1e9;
    std::vector<double> distances;
    for (const body_functions::Body& part : parts)
    {
      distances.push_back(part(p));
      nearest = (std::min)(nearest, distances.back());
    }
    if (blend == 0 || parts.size() == 1 || nearest > 1)
      return nearest;
    double sum = 0;
    for (const double d : distances)
      sum += std::exp((nearest - d) / blend);
    return nearest - blend * std::log(sum);
  }

  std::size_t part_at(const test_meshes::Point& p) const
  {
    std::size_t best = 0;
    double least = 1e9;
    for (std::size_t i = 0; i < parts.size(); ++i)
      if (const double d = parts[i](p); d < least)
      {
        least = d;
        best = i;
      }
    return best;
  }
};

// The largest connected piece, with about so many edges along its longest extent. The shape is within 3.4 of the origin.
test_meshes::Test_mesh mesh_of(const Shape& shape, double cells);

// The faces with such centroids, of these the largest connected piece.
test_meshes::Test_mesh kept_faces(const test_meshes::Test_mesh& mesh, const std::function<bool(const test_meshes::Point&)>& keep);

#endif // CGAL_PROTRUSION_SEGMENTATION_BENCHMARK_SHAPE_MESHES_H
