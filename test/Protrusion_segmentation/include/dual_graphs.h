// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Test meshes as the default method sees them.

#ifndef CGAL_TEST_PROTRUSION_SEGMENTATION_DUAL_GRAPHS_H
#define CGAL_TEST_PROTRUSION_SEGMENTATION_DUAL_GRAPHS_H

#include "indexed_surfaces.h"

#include <CGAL/Protrusion_segmentation/internal/Cut_method/Cut_options.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Graph/Dual_graph.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Graph/measure_coarse_graph.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Graph/contract_graph.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Graph/Seam_finder.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Graph/make_dual_graph.h>

#include <numeric>
#include <utility>
#include <vector>

namespace test_meshes {

using CGAL::Protrusion_segmentation::internal::Centres;
using CGAL::Protrusion_segmentation::internal::Cut_options;
using CGAL::Protrusion_segmentation::internal::Dual_graph;
using CGAL::Protrusion_segmentation::internal::Seam_graph;
using CGAL::Protrusion_segmentation::internal::Volume_graph;

inline const Cut_options& default_options()
{
  static const Cut_options options;
  return options;
}

inline Centres centres(const Indexed_surface& surface)
{
  return CGAL::Protrusion_segmentation::internal::centres_of_faces(surface, false);
}

// Every face is a node.
inline Seam_graph seam_graph(const Indexed_surface& surface, Execution& execution = quiet_execution())
{
  using namespace CGAL::Protrusion_segmentation::internal;
  Seam_graph graph;
  Dual_graph_maker{surface}(graph, execution.is_parallel());
  Seam_finder(surface, default_options(), execution)(graph,
                                                     centres_of_faces(surface, execution.is_parallel()));
  return graph;
}

inline Seam_graph seam_graph(const Test_mesh& mesh)
{
  return seam_graph(to_surface(mesh));
}

inline std::vector<Index> all_nodes(const Dual_graph& graph)
{
  std::vector<Index> nodes(graph.number_of_nodes());
  std::iota(nodes.begin(), nodes.end(), Index(0));
  return nodes;
}

// Every face is a node. Borders are as long as their edges.
inline Volume_graph volume_graph(const Indexed_surface& surface)
{
  using namespace CGAL::Protrusion_segmentation::internal;
  const Seam_graph faces = seam_graph(surface);
  Contracted<Seam_graph> contracted = contract(faces, centres(surface),
                                               {all_nodes(faces), faces.number_of_nodes()}, false);
  Volume_graph graph;
  static_cast<Seam_graph&>(graph) = std::move(contracted.graph);
  graph.centre = std::move(contracted.centre);
  measure_volumes(surface, contracted.node, Index_groups(contracted.node, graph.number_of_nodes()), graph,
                  false);
  return graph;
}

} // namespace test_meshes

#endif // CGAL_TEST_PROTRUSION_SEGMENTATION_DUAL_GRAPHS_H
