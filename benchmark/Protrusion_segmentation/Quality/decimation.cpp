// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "decimation.h"

#include "other_triangles.h"

#include <CGAL/Surface_mesh_simplification/edge_collapse.h>

namespace {

// CGAL's own has other names in other versions.
struct Is_small_enough
{
  std::size_t number_of_edges;

  template <typename Cost, typename Profile>
  bool operator()(const Cost&, const Profile&, std::size_t, std::size_t current_number_of_edges) const
  {
    return current_number_of_edges <= number_of_edges;
  }
};

} // namespace

Mesh decimated(const Mesh& mesh, std::size_t number_of_faces)
{
  Mesh result = mesh;
  if (result.number_of_faces() <= number_of_faces)
    return result;
  CGAL::Surface_mesh_simplification::edge_collapse(result, Is_small_enough{number_of_faces * 3 / 2});
  result.collect_garbage();
  return result;
}

Labels labels_from_decimated(const Mesh& mesh, const Mesh& decimated, const Labels& labels)
{
  if (mesh.number_of_faces() == decimated.number_of_faces()) // nothing was collapsed
    return labels;
  Labels result;
  for (const Face f : nearest_faces(mesh, decimated))
    result.push_back(labels[f]);
  return result;
}
