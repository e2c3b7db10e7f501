// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_FACE_BORDERS_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_FACE_BORDERS_H

#include <CGAL/Protrusion_segmentation/Indexed_surface.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Cut_policy.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Graph_partition.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/minimum_cut.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Protrusion_segmentation {
namespace internal {

// Brings cuts of the coarse graph to the faces.
class Face_borders
{
public:
  using Index = Weighted_dual_graph::Index;
  using Nodes = Graph_partition::Nodes;

  // `node_of_face`: of the coarse graph
  Face_borders(Graph_partition& fine,
               Graph_partition& coarse,
               const std::vector<Index>& node_of_face,
               const Cut_policy& policy)
    : m_fine(fine),
      m_coarse(coarse),
      m_node(node_of_face),
      m_policy(policy),
      m_number(node_of_face.size(), Indexed_surface::no_face())
  {}

  // The faces of a segment, out of `faces`, on the inner side of a coarse cut, marked, with the minimum cut near
  // it as border. None or all of them if all faces lie on one side.
  Nodes inner_faces(Index segment, const Nodes& faces, const Nodes& segment_nodes, const Nodes& inner_nodes)
  {
    constexpr Band band = {0.05, 2, 0.7};
    m_coarse.mark(segment_nodes, inner_nodes);
    mark_faces(segment, faces);
    Nodes inner = m_fine.marked(faces);
    if (inner.empty() || inner.size() == faces.size())
      return inner;
    inner = m_fine.connect_sides(faces, segment, inner);
    if (!m_policy.moves_borders_on_faces())
      return inner;
    inner = refine_cut(m_fine, segment, faces, inner, band, m_number);
    return m_fine.connect_sides(faces, segment, inner);
  }

private:
  // A face follows its node. Borders made before follow the faces, not the nodes: faces of this segment whose
  // node belongs to another one go with their neighbours.
  void mark_faces(Index segment, const Nodes& faces)
  {
    Nodes known;
    std::vector<bool> is_known(faces.size(), false);
    for (std::size_t i = 0; i < faces.size(); ++i)
    {
      const Index node = m_node[faces[i]];
      m_number[faces[i]] = static_cast<Index>(i);
      is_known[i] = m_coarse.segment(node) == segment;
      m_fine.set_inner(faces[i], is_known[i] && m_coarse.is_inner(node));
      if (is_known[i])
        known.push_back(faces[i]);
    }
    for (std::size_t i = 0; i < known.size(); ++i)
      for (Index arc : m_fine.graph().arcs(known[i]))
      {
        const Index g = m_fine.graph().target[arc];
        if (m_fine.segment(g) != segment || is_known[m_number[g]])
          continue;
        is_known[m_number[g]] = true;
        m_fine.set_inner(g, m_fine.is_inner(known[i]));
        known.push_back(g);
      }
    for (Index f : faces)
      m_number[f] = Indexed_surface::no_face();
  }

  Graph_partition& m_fine;
  Graph_partition& m_coarse;
  const std::vector<Index>& m_node;
  const Cut_policy& m_policy;
  std::vector<Index> m_number;
};

} // namespace internal
} // namespace Protrusion_segmentation
} // namespace CGAL

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_FACE_BORDERS_H
