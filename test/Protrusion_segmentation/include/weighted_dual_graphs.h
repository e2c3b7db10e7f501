// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Test meshes as the default method sees them.

#ifndef CGAL_TEST_PROTRUSION_SEGMENTATION_WEIGHTED_DUAL_GRAPHS_H
#define CGAL_TEST_PROTRUSION_SEGMENTATION_WEIGHTED_DUAL_GRAPHS_H

#include "indexed_surfaces.h"

#include <CGAL/Protrusion_segmentation/internal/Cut_method/Cut_policy.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/make_weighted_dual_graph.h>

namespace test_meshes {

inline CGAL::Protrusion_segmentation::internal::Weighted_dual_graph weighted_dual_graph(
  const Indexed_surface& surface,
  CGAL::Protrusion_segmentation::Execution& execution = quiet_execution())
{
  using namespace CGAL::Protrusion_segmentation::internal;
  Weighted_dual_graph graph;
  Weighted_dual_graph_maker maker(surface, default_cut_policy(), execution, graph);
  maker.measure();
  maker.weigh();
  return graph;
}

inline CGAL::Protrusion_segmentation::internal::Weighted_dual_graph weighted_dual_graph(const Test_mesh& mesh)
{
  return weighted_dual_graph(to_surface(mesh));
}

} // namespace test_meshes

#endif // CGAL_TEST_PROTRUSION_SEGMENTATION_WEIGHTED_DUAL_GRAPHS_H
