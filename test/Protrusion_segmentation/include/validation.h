// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TEST_PROTRUSION_SEGMENTATION_VALIDATION_H
#define CGAL_TEST_PROTRUSION_SEGMENTATION_VALIDATION_H

#include <CGAL/Protrusion_segmentation/internal/Mesh/read_surface.h>
#include <CGAL/Protrusion_segmentation/internal/Surface/Surface_without_small_components.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/properties.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace validation {

namespace internal = CGAL::Protrusion_segmentation::internal;

// Checks of what every segmentation guarantees, shared by tests and benchmarks. Faces are named by their
// position in `faces(mesh)`.

// The face that has a segment beyond the last one, or the segment that has no face.
inline std::optional<std::string> problem_with_segment_ids(const std::vector<std::size_t>& ids,
                                                           std::size_t number_of_segments)
{
  std::vector<bool> is_used(number_of_segments, false);
  for (std::size_t f = 0; f < ids.size(); ++f)
  {
    if (ids[f] >= number_of_segments)
      return "face " + std::to_string(f) + " has segment " + std::to_string(ids[f]) + ", but there are " +
             std::to_string(number_of_segments) + " segments";
    is_used[ids[f]] = true;
  }
  for (std::size_t s = 0; s < number_of_segments; ++s)
    if (!is_used[s])
      return "segment " + std::to_string(s) + " of " + std::to_string(number_of_segments) +
             " has no face";
  return std::nullopt;
}

// For each face the faces that it shares an edge with.
template <typename FaceGraph>
std::vector<std::vector<std::size_t>> face_neighbors(const FaceGraph& mesh)
{
  auto positions = get(CGAL::dynamic_face_property_t<std::size_t>(), mesh);
  std::size_t number_of_faces = 0;
  for (const auto f : faces(mesh))
    put(positions, f, number_of_faces++);
  std::vector<std::vector<std::size_t>> neighbors(number_of_faces);
  for (const auto f : faces(mesh))
    for (const auto g : CGAL::faces_around_face(halfedge(f, mesh), mesh))
      if (g != boost::graph_traits<FaceGraph>::null_face())
        neighbors[get(positions, f)].push_back(get(positions, g));
  return neighbors;
}

// For each face whether its component has the segments of another one: it is small, or the wall of a cavity.
template <typename FaceGraph>
std::vector<bool> faces_left_out(const FaceGraph& mesh)
{
  const auto rest = internal::leave_out_small_components(
    internal::read_arrays(mesh, CGAL::parameters::default_values()));
  std::vector<bool> result(rest.nearest_faces.empty() ? rest.arrays.number_of_faces()
                                                      : rest.nearest_faces.size(),
                           !rest.nearest_faces.empty());
  for (const std::uint32_t face : rest.faces)
    result[face] = false;
  return result;
}

// The segment that is not connected over edges, but for faces left out.
inline std::optional<std::string> problem_with_connectedness(
  const std::vector<std::vector<std::size_t>>& neighbors,
  const std::vector<bool>& is_left_out,
  const std::vector<std::size_t>& ids,
  std::size_t number_of_segments)
{
  constexpr std::size_t none = (std::numeric_limits<std::size_t>::max)();
  std::vector<std::size_t> first_face(number_of_segments, none);
  std::vector<bool> is_reached(ids.size(), false);
  for (std::size_t f = 0; f < ids.size(); ++f)
  {
    if (is_reached[f] || is_left_out[f])
      continue;
    if (first_face[ids[f]] != none)
      return "segment " + std::to_string(ids[f]) + " is not connected: faces " +
             std::to_string(first_face[ids[f]]) + " and " + std::to_string(f) +
             " are in different pieces";
    first_face[ids[f]] = f;
    is_reached[f] = true;
    std::vector<std::size_t> queue(1, f);
    while (!queue.empty())
    {
      const std::size_t last = queue.back();
      queue.pop_back();
      for (const std::size_t g : neighbors[last])
        if (!is_reached[g] && ids[g] == ids[f])
        {
          is_reached[g] = true;
          queue.push_back(g);
        }
    }
  }
  return std::nullopt;
}

// The first problem of a segmentation for which a function returned `number_of_segments`, or nothing: every
// face has a segment, ids are 0 to n - 1 and all used, every segment is connected but for small components and walls of
// cavities. `segment_ids` is a model of `ReadablePropertyMap` with integers as values.
template <typename FaceGraph, typename SegmentMap>
std::optional<std::string> problem_with_segmentation(const FaceGraph& mesh,
                                                     const SegmentMap& segment_ids,
                                                     std::size_t number_of_segments)
{
  std::vector<std::size_t> ids; // a negative id becomes a huge one, which is no segment either
  for (const auto f : faces(mesh))
    ids.push_back(static_cast<std::size_t>(get(segment_ids, f)));
  if (const auto problem = problem_with_segment_ids(ids, number_of_segments))
    return problem;
  return problem_with_connectedness(face_neighbors(mesh), faces_left_out(mesh), ids, number_of_segments);
}

} // namespace validation

#endif // CGAL_TEST_PROTRUSION_SEGMENTATION_VALIDATION_H
