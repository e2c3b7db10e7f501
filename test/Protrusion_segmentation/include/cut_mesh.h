// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The clues of cuts of test meshes.

#ifndef CGAL_TEST_PROTRUSION_SEGMENTATION_CUT_MESH_H
#define CGAL_TEST_PROTRUSION_SEGMENTATION_CUT_MESH_H

#include "check.h"
#include "dual_graphs.h"

#include <CGAL/Protrusion_segmentation/internal/Cut_method/Cut/Bisection.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Cut/Clues_of_cut.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Graph/Graph_distances.h>

#include <cstddef>
#include <vector>

namespace test_meshes {

// A mesh whose faces are the nodes of the graph, and segments, all faces in segment 0 at first.
class Cut_mesh
{
public:
  using Cut_clues = CGAL::Protrusion_segmentation::internal::Cut_clues;
  using Nodes = CGAL::Protrusion_segmentation::internal::Nodes;

  explicit Cut_mesh(const Test_mesh& mesh)
    : m_mesh(mesh),
      m_graph(volume_graph(to_surface(mesh))),
      m_segments(mesh.faces.size(), 0)
  {}

  // The faces whose centroid is in a region become segment 1.
  template <typename Region>
  void cut_off(Region region)
  {
    for (const Index f : faces_in(0, region))
      m_segments[f] = 1;
  }

  // Of the cut of segment 0 around the faces whose centroid is in a region.
  template <typename Region>
  Cut_clues clues(Region region) const
  {
    return clues_of_faces(faces_in(0, region));
  }

  Cut_clues clues_of_part(std::size_t part) const
  {
    Nodes inner;
    for (Index f = 0; f < m_segments.size(); ++f)
      if (m_mesh.parts[f] == part)
        inner.push_back(f);
    return clues_of_faces(inner);
  }

private:
  Cut_clues clues_of_faces(const Nodes& inner) const
  {
    namespace internal = CGAL::Protrusion_segmentation::internal;
    const Nodes nodes = faces_in(0, [](const Point&) { return true; });
    CGAL_CHECK(!inner.empty() && inner.size() < nodes.size());
    const internal::Segment segment = {nodes, m_graph.area_of(nodes)};
    internal::Graph_partition partition(m_graph);
    internal::Bisection bisection(partition, segment);
    bisection.set_side(inner);
    internal::Graph_distances distances(m_graph);
    internal::Strip_measurer strips(m_graph, distances);
    return internal::Clues_of_cut(m_graph, bisection)(strips);
  }

  template <typename Region>
  Nodes faces_in(Index segment, Region region) const
  {
    Nodes result;
    for (Index f = 0; f < m_segments.size(); ++f)
      if (m_segments[f] == segment && region(centroid(m_mesh, m_mesh.faces[f])))
        result.push_back(f);
    return result;
  }

  Test_mesh m_mesh;
  Volume_graph m_graph;
  std::vector<Index> m_segments;
};

} // namespace test_meshes

#endif // CGAL_TEST_PROTRUSION_SEGMENTATION_CUT_MESH_H
