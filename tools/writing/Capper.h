// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROTRUSION_SEGMENTATION_TOOLS_WRITING_CAPPER_H
#define PROTRUSION_SEGMENTATION_TOOLS_WRITING_CAPPER_H

#include "reading/Mesh.h"

#include <array>
#include <cstddef>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace tool
{

using Loop = std::vector<std::size_t>;       // numbers of vertices
using Triangle = std::array<std::size_t, 3>; // the same, the smallest first

// The triangle that looks the other way.
Triangle turned_over(const Triangle& triangle);

// Makes caps of loops, the same for a loop whatever its first vertex and its direction are.
class Capper
{
public:
  explicit Capper(const Mesh& mesh);

  // Of the vertices of the mesh and, behind them, those that caps added.
  const std::vector<Point>& points() const { return m_points; }

  // Triangles with all edges of the loop in its direction.
  std::vector<Triangle> cap(Loop loop);

private:
  using Edge = std::pair<std::size_t, std::size_t>;

  std::vector<Triangle> make_cap(const Loop& loop);
  std::vector<Triangle> triangulate(const Loop& loop) const;
  std::vector<Triangle> fan(const Loop& loop);
  bool is_edge(const Edge& edge) const;

  const Mesh& m_mesh;
  std::vector<Point> m_points;
  std::map<Loop, std::vector<Triangle>> m_caps;
  std::set<Edge> m_diagonals; // of all caps
};

} // namespace tool

#endif // PROTRUSION_SEGMENTATION_TOOLS_WRITING_CAPPER_H
