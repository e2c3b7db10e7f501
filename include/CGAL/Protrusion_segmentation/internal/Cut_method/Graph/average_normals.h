// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_GRAPH_AVERAGE_NORMALS_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_GRAPH_AVERAGE_NORMALS_H

#include <CGAL/Protrusion_segmentation/Execution.h>
#include <CGAL/Protrusion_segmentation/Indexed_surface.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Cut_options.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Graph/Surface_average.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Graph/diffusion.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Graph/noise_of_vertices.h>
#include <CGAL/Protrusion_segmentation/internal/Execution/for_each_block.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace CGAL::Protrusion_segmentation::internal {

// Scales each vector to length 1; where it vanishes, it stays the zero vector.
inline void normalize(Padded_vectors& vectors, bool is_parallel)
{
  for_each_number(vectors.size(), is_parallel,
                  [&](std::size_t i)
                  {
                    Padded_vector& v = vectors[i];
                    if (const float length = std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]); length > 0)
                      v = v / length;
                  });
}

// The radius over which normals are averaged, in units of the square root of the area, as the arguments are. The curvature that is
// left of noise grows with the length of edges and falls with the cube of the radius.
inline double radius_against_noise(double noise, double edge_length)
{
  constexpr double factor = 2;           // from 1.7 to 2.4 there is little difference
  constexpr double largest_radius = 0.1; // over more, parts melt together
  return std::clamp(factor * std::cbrt(noise * edge_length), normal_radius, largest_radius);
}

// The unit normals of the faces, each the average over a radius around it, which is larger if there is noise.
inline Padded_vectors average_normals(const Indexed_surface& surface, const Surface_average& average, Execution& execution)
{
  Padded_vectors of_faces(surface.number_of_faces());
  for_each_number(of_faces.size(), execution.is_parallel(),
                  [&](Indexed_surface::Index f) { of_faces[f] = unit_normal(surface, f); });
  const auto averaged = [&](double radius)
  {
    Padded_vectors normals = of_faces;
    average(normals, radius);
    normalize(normals, execution.is_parallel());
    return normals;
  };
  const Padded_vectors normals = averaged(normal_radius);
  const double edge_length = 1 / std::sqrt(double(surface.number_of_vertices())), noise = noise_of_vertices(surface, normals);
  const double radius = radius_against_noise(noise, edge_length);
  return radius > normal_radius ? averaged(radius) : normals;
}

} // namespace CGAL::Protrusion_segmentation::internal

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_GRAPH_AVERAGE_NORMALS_H
