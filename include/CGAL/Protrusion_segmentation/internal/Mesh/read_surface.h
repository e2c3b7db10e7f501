// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_MESH_READ_SURFACE_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_MESH_READ_SURFACE_H

#include <CGAL/Protrusion_segmentation/Indexed_surface.h>
#include <CGAL/Protrusion_segmentation/internal/Execution/for_each_block.h>
#include <CGAL/Protrusion_segmentation/internal/Surface/Surface_arrays.h>
#include <CGAL/Protrusion_segmentation/internal/Surface/canonical_frame.h>
#include <CGAL/Protrusion_segmentation/internal/Surface/normalize_points.h>
#include <CGAL/Protrusion_segmentation/internal/user_points.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/properties.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

namespace CGAL::Protrusion_segmentation::internal {

// A mesh as index arrays, and the factor that turns its lengths back into those of the mesh.
struct Arrays_of_mesh
{
  Surface_arrays surface;
  double unit = 1;
};

// Numbers the vertices that have a face, in the order of `vertices(mesh)`, and returns their coordinates.
// Isolated vertices are no part of the surface: a far one would make the rest of the mesh tiny.
template <typename FaceGraph, typename VertexPointMap, typename VertexNumbers>
std::vector<Indexed_surface::Point_3> read_points(const FaceGraph& mesh,
                                               VertexPointMap vpm,
                                               VertexNumbers& numbers)
{
  std::vector<Indexed_surface::Point_3> points;
  points.reserve(num_vertices(mesh));
  std::size_t position = 0;
  for (const auto v : vertices(mesh))
  {
    const std::size_t i = position++;
    if (halfedge(v, mesh) == boost::graph_traits<FaceGraph>::null_halfedge())
      continue;
    const Indexed_surface::Point_3 p = to_double_point(get(vpm, v));
    if (!is_finite(p))
      throw std::invalid_argument("pmesh: vertex " + std::to_string(i) +
                                  " has a coordinate that is not finite");
    put(numbers, v, static_cast<Indexed_surface::Index>(points.size()));
    points.push_back(p);
  }
  return points;
}

// The patches of the faces, numbered in order; none if there are fewer than two.
template <typename FaceGraph, typename PatchMap>
std::vector<Indexed_surface::Index> read_patches(const FaceGraph& mesh, PatchMap patch_map)
{
  std::vector<Indexed_surface::Index> patches;
  std::map<typename boost::property_traits<PatchMap>::value_type, Indexed_surface::Index> numbers;
  for (const auto f : faces(mesh))
  {
    const auto next = static_cast<Indexed_surface::Index>(numbers.size());
    patches.push_back(numbers.emplace(get(patch_map, f), next).first->second);
  }
  return numbers.size() < 2 ? std::vector<Indexed_surface::Index>() : patches;
}

// Reads the index arrays of a mesh, in its coordinates: faces in the order of `faces(mesh)`. Linear time.
template <typename FaceGraph, typename NamedParameters>
Surface_arrays read_arrays(const FaceGraph& mesh, const NamedParameters& np, bool is_parallel = false)
{
  using Index = Indexed_surface::Index;

  auto vertex_numbers = get(CGAL::dynamic_vertex_property_t<Index>(), mesh);
  auto face_numbers = get(CGAL::dynamic_face_property_t<Index>(), mesh);

  Surface_arrays arrays;
  arrays.points = read_points(mesh, vertex_point_map(mesh, np), vertex_numbers);
  Index number_of_faces = 0;
  std::size_t number_of_corners = 0;
  for (const auto f : faces(mesh))
  {
    put(face_numbers, f, number_of_faces++);
    number_of_corners += halfedges_around_face(halfedge(f, mesh), mesh).size();
  }
  if (number_of_corners >= Indexed_surface::no_face())
    throw std::length_error("pmesh: more corners of faces than a 32 bit index can number");

  arrays.corner_begin.reserve(number_of_faces + 1);
  arrays.corner_vertices.reserve(number_of_corners);
  arrays.corner_neighbors.reserve(number_of_corners);
  const auto null_face = boost::graph_traits<FaceGraph>::null_face();
  for (const auto f : faces(mesh))
  {
    for (const auto h : halfedges_around_face(halfedge(f, mesh), mesh))
    {
      const auto g = face(opposite(h, mesh), mesh);
      arrays.corner_vertices.push_back(get(vertex_numbers, source(h, mesh)));
      arrays.corner_neighbors.push_back(g == null_face || g == f ? Indexed_surface::no_face()
                                                                 : get(face_numbers, g));
    }
    arrays.corner_begin.push_back(static_cast<Index>(arrays.corner_vertices.size()));
  }
  start_faces_canonically(arrays, false, is_parallel); // where `halfedge(f, mesh)` begins depends on how the mesh was built
  if constexpr (!parameters::is_default_parameter<NamedParameters, internal_np::face_patch_t>::value)
    arrays.patches = read_patches(mesh, parameters::get_parameter(np, internal_np::face_patch));
  return arrays;
}

// The same in a cube of size two.
template <typename FaceGraph, typename NamedParameters>
Arrays_of_mesh read_surface(const FaceGraph& mesh, const NamedParameters& np)
{
  Arrays_of_mesh result;
  result.surface = read_arrays(mesh, np);
  result.unit = normalize(result.surface.points);
  return result;
}

} // namespace CGAL::Protrusion_segmentation::internal

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_MESH_READ_SURFACE_H
