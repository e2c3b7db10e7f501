// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Regular and nearly regular polyhedra, the duals and truncations of others, and round spheres.

#ifndef CGAL_TEST_PROTRUSION_SEGMENTATION_TEST_MESHES_SPHERES_H
#define CGAL_TEST_PROTRUSION_SEGMENTATION_TEST_MESHES_SPHERES_H

#include "test_mesh.h"

namespace test_meshes {

// The faces around every vertex of a closed mesh, counterclockwise seen from outside.
inline std::vector<Face> faces_around_vertices(const Test_mesh& mesh)
{
  std::vector<std::map<std::size_t, Edge>> steps(mesh.points.size());
  for (std::size_t f = 0; f < mesh.faces.size(); ++f)
  {
    const Face& face = mesh.faces[f];
    const std::size_t n = face.size();
    for (std::size_t i = 0; i < n; ++i) // around face[i], from the edge to its next to its previous
      steps[face[i]][face[(i + 1) % n]] = {f, face[(i + n - 1) % n]};
  }
  std::vector<Face> result(mesh.points.size());
  for (std::size_t v = 0; v < steps.size(); ++v)
    for (std::size_t i = 0, end = steps[v].begin()->first; i < steps[v].size(); ++i)
    {
      const Edge step = steps[v].at(end);
      result[v].push_back(step.first);
      end = step.second;
    }
  return result;
}

// A vertex at the centroid of each face of a closed mesh, a face for each vertex. One part.
inline Test_mesh dual(const Test_mesh& mesh)
{
  Test_mesh result;
  for (const Face& face : mesh.faces)
    result.add_point(centroid(mesh, face));
  for (const Face& face : faces_around_vertices(mesh))
    result.add_face(face);
  return result;
}

// The corners of a closed mesh cut off at a third of each edge. Parts: 0 the faces (of 2 n sides
// each, first and in their order), 1 the cuts.
inline Test_mesh truncated(const Test_mesh& mesh)
{
  Test_mesh result;
  std::map<Edge, std::size_t> vertices;
  for (const auto& item : faces_of_edges(mesh))
  {
    const Edge edge = item.first;
    vertices[edge] = result.add_point((2. / 3) * mesh.points[edge.first] +
                                      (1. / 3) * mesh.points[edge.second]);
  }
  std::vector<std::map<std::size_t, std::size_t>> next_end(mesh.points.size());
  for (const Face& face : mesh.faces)
  {
    Face cut;
    for (std::size_t i = 0; i < face.size(); ++i)
    {
      const std::size_t v = face[i], w = face[(i + 1) % face.size()];
      cut.push_back(vertices.at({v, w}));
      cut.push_back(vertices.at({w, v}));
      next_end[w][face[(i + 2) % face.size()]] = v;
    }
    result.add_face(cut, 0);
  }
  for (std::size_t v = 0; v < mesh.points.size(); ++v)
  {
    Face corner;
    for (std::size_t end = next_end[v].begin()->first; corner.size() < next_end[v].size();
         end = next_end[v].at(end))
      corner.push_back(vertices.at({v, end}));
    result.add_face(corner, 1);
  }
  return result;
}

// The regular icosahedron with vertices at distance 1 from the origin.
inline Test_mesh icosahedron()
{
  const double golden = (1 + std::sqrt(5.)) / 2, scale = 1 / std::sqrt(1 + golden * golden);
  Test_mesh result;
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (double a : {-1., 1.})
      for (double b : {-golden, golden})
      {
        Point p = {0, 0, 0};
        p[(axis + 1) % 3] = scale * a;
        p[(axis + 2) % 3] = scale * b;
        result.add_point(p);
      }
  // The edges are the 30 nearest pairs of vertices; the faces are their triangles.
  auto adjacent = [&](std::size_t i, std::size_t j)
  { return length(result.points[i] - result.points[j]) < 2.1 * scale; };
  for (std::size_t i = 0; i < 12; ++i)
    for (std::size_t j = i + 1; j < 12; ++j)
      for (std::size_t k = j + 1; k < 12; ++k)
        if (adjacent(i, j) && adjacent(j, k) && adjacent(k, i))
        {
          Face face = {i, j, k};
          if (dot(area_vector(result, face), result.points[i]) < 0)
            std::swap(face[1], face[2]);
          result.add_face(face);
        }
  return result;
}

// Twelve regular pentagons.
inline Test_mesh dodecahedron()
{
  return dual(icosahedron());
}

// Twenty hexagons, then twelve pentagons.
inline Test_mesh football()
{
  return truncated(icosahedron());
}

// Each triangle cut into four, `levels` times, the vertices moved to distance 1 from the origin:
// 20 * 4^levels triangles. One part.
inline Test_mesh icosphere(std::size_t levels)
{
  Test_mesh mesh = icosahedron();
  for (; levels > 0; --levels)
  {
    Test_mesh finer;
    finer.points = mesh.points;
    std::map<Edge, std::size_t> midpoints;
    auto midpoint = [&](std::size_t i, std::size_t j)
    {
      const auto found = midpoints.emplace(std::minmax(i, j), finer.points.size());
      const Point sum = mesh.points[i] + mesh.points[j];
      if (found.second)
        finer.add_point((1 / length(sum)) * sum);
      return found.first->second;
    };
    for (const Face& face : mesh.faces)
    {
      const std::size_t a = face[0], b = face[1], c = face[2];
      const std::size_t ab = midpoint(a, b), bc = midpoint(b, c), ca = midpoint(c, a);
      for (const Face& part : {Face{a, ab, ca}, Face{ab, b, bc}, Face{ca, bc, c}, Face{ab, bc, ca}})
        finer.add_face(part);
    }
    mesh = std::move(finer);
  }
  return mesh;
}

} // namespace test_meshes

#endif // CGAL_TEST_PROTRUSION_SEGMENTATION_TEST_MESHES_SPHERES_H
