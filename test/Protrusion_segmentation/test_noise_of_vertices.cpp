// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The noise of vertices, and parts of shapes with noise.

#include "check.h"
#include "dual_graphs.h"
#include "flat_shapes.h"
#include "segmentations.h"
#include "test_meshes.h"

#include <CGAL/Protrusion_segmentation/internal/Cut_method/Graph/average_normals.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Graph/noise_of_vertices.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <set>
#include <vector>

using namespace test_meshes;

namespace {

using namespace CGAL::Protrusion_segmentation::internal;

Padded_vectors normals(const Indexed_surface& surface)
{
  const auto graph = seam_graph(surface);
  const auto centre = centres(surface);
  return average_normals(surface, Surface_average(graph, centre, normal_radius / 9, quiet_execution()), quiet_execution());
}

// In units of the mesh.
double noise(const Test_mesh& mesh)
{
  const Indexed_surface surface = to_surface(mesh);
  return noise_of_vertices(surface, normals(surface)) * std::sqrt(surface.area());
}

// By the sums written out: for each vertex its neighbours are looked for in all faces.
void heights_are_below_centroids_of_neighbors()
{
  for (const Test_mesh& mesh : {jittered(icosphere(2), 0.02, 3), jittered(torus(), 0.02, 4), jittered(sheet(5, 7), 0.2, 5)})
  {
    const Indexed_surface surface = to_surface(mesh);
    const Padded_vectors of_faces = normals(surface);
    const std::vector<double> heights = heights_below_neighbors(surface, of_faces);
    for (std::size_t v = 0; v < mesh.points.size(); ++v)
    {
      std::set<std::size_t> next, previous;
      Point normal{0, 0, 0}, centroid{0, 0, 0};
      for (std::size_t f = 0; f < mesh.faces.size(); ++f)
        for (std::size_t i = 0; i < mesh.faces[f].size(); ++i)
          if (const Face& face = mesh.faces[f]; face[i] == v)
          {
            next.insert(face[(i + 1) % face.size()]);
            previous.insert(face[(i + face.size() - 1) % face.size()]);
            normal = normal + Point{of_faces[f][0], of_faces[f][1], of_faces[f][2]};
          }
      for (const std::size_t n : next)
        centroid = centroid + (1. / double(next.size())) * mesh.points[n];
      const double expected = next == previous ? dot(centroid - mesh.points[v], normal) / length(normal) : 0;
      CGAL_CHECK_CLOSE(heights[v], expected, 1e-6);
    }
  }
}

void numbers_are_limited_to_their_median()
{
  std::vector<double> numbers = {1, -2, 3, -40, 50};
  limit_to_median(numbers, 4);
  CGAL_CHECK((numbers == std::vector<double>{1, -2, 3, -12, 12}));
}

// Uniform in an interval, which has a standard deviation of its length by the square root of twelve.
void noise_is_found(std::uint_fast32_t seed)
{
  for (const double size : {0.01, 0.1, 0.2})
    CGAL_CHECK_CLOSE(noise(jittered(triangulated(sheet(60, 60)), size, seed)), size / std::sqrt(3.), 0.1 * size);
  for (const Test_mesh& mesh : {icosphere(5), triangulated(torus(2, 0.7, 120, 40))})
    for (const double size : {0.01, 0.02})
      CGAL_CHECK_CLOSE(noise(jittered(mesh, size, seed)), size / std::sqrt(3.), 0.15 * size);
}

// However they are curved, folded or coarse.
void shapes_without_noise_have_none()
{
  for (const Test_mesh& mesh :
       {icosphere(1), icosphere(4), torus(), box(12, 12, 12), box(3, 8, 1), capsule(), dumbbell(), star(5), creature(),
        thickened(flat_figure(60), 0.1), flat_star(5, 30), tetrahedron(), single_triangle()})
    CGAL_CHECK(noise(mesh) < 1e-6);
}

void the_radius_is_limited()
{
  CGAL_CHECK_EQUAL(radius_against_noise(0, 0.01), normal_radius);
  CGAL_CHECK_CLOSE(radius_against_noise(0.0027, 0.01), 0.06, 1e-9);
  CGAL_CHECK_EQUAL(radius_against_noise(1, 1), 0.1);
}

Test_mesh with_noise(const Test_mesh& mesh, std::uint_fast32_t seed)
{
  return jittered(mesh, 0.008 * std::sqrt(area(mesh)), seed);
}

// They were cut into up to twenty segments.
void convex_shapes_with_noise_are_whole(std::uint_fast32_t seed)
{
  for (const Test_mesh& mesh : {box(30, 30, 30), box(40, 20, 10), icosphere(5), closed_cylinder(1, 3, 0.06)})
    CGAL_CHECK_EQUAL(automatic_segmentation(with_noise(mesh, seed)).number, 1u);
}

void arms_with_noise_are_parts(std::uint_fast32_t seed)
{
  for (const std::size_t arms : {5, 8})
  {
    const Test_mesh mesh = star(arms);
    check_parts(mesh, automatic_segmentation(with_noise(mesh, seed)), 0.92);
  }
}

} // namespace

int main()
{
  heights_are_below_centroids_of_neighbors();
  numbers_are_limited_to_their_median();
  shapes_without_noise_have_none();
  the_radius_is_limited();
  for (std::uint_fast32_t seed : {1, 2, 3})
  {
    noise_is_found(seed);
    convex_shapes_with_noise_are_whole(seed);
    arms_with_noise_are_parts(seed);
  }
  return check::result();
}
