// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Connected test meshes with their cuts.

#ifndef CGAL_TEST_PROTRUSION_SEGMENTATION_COMPONENTS_H
#define CGAL_TEST_PROTRUSION_SEGMENTATION_COMPONENTS_H

#include "check.h"
#include "dual_graphs.h"

#include <CGAL/Protrusion_segmentation/internal/Cut_method/Component.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <vector>

namespace test_meshes {

namespace internal = CGAL::Protrusion_segmentation::internal;

struct Component_of_mesh
{
  explicit Component_of_mesh(const Test_mesh& mesh, const Cut_options& given = default_options())
    : surface(to_surface(mesh)),
      options(given),
      component(surface, distance, options, quiet_execution())
  {}

  Indexed_surface surface;
  std::optional<internal::Any_distance> distance;
  Cut_options options;
  internal::Component component;
};

// The segment of every node of the coarse graph; every one has just one.
inline std::vector<Index> labels_of_nodes(const internal::Component& component,
                                          const internal::Cut_set& set)
{
  std::vector<Index> labels(component.graphs().coarse.number_of_nodes(), Indexed_surface::no_face());
  for (std::size_t s = 0; s < set.segments.size(); ++s)
    for (const Index i : component.memo()[set.segments[s]].segment.nodes)
    {
      CGAL_CHECK_EQUAL(labels[i], Indexed_surface::no_face());
      labels[i] = Index(s);
    }
  CGAL_CHECK_EQUAL(std::count(labels.begin(), labels.end(), Indexed_surface::no_face()), 0);
  return labels;
}

inline std::vector<Index> labels_of_faces(const internal::Component& component,
                                          const internal::Cut_set& set)
{
  const std::vector<Index> of_nodes = labels_of_nodes(component, set);
  std::vector<Index> result;
  for (const Index node : component.graphs().node_of_face)
    result.push_back(of_nodes[node]);
  return result;
}

} // namespace test_meshes

#endif // CGAL_TEST_PROTRUSION_SEGMENTATION_COMPONENTS_H
