// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "writing/borders.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

namespace tool
{
namespace
{

using Halfedge = Mesh::Halfedge_index;

class Border_finder
{
public:
  Border_finder(const Mesh& mesh, const std::vector<std::size_t>& segment_of_face)
    : m_mesh(mesh), m_segment_of_face(segment_of_face)
  { }

  std::vector<Border> find()
  {
    std::vector<Border> borders;
    for (const Halfedge h : halfedges(m_mesh))
      if (is_between_segments(h) && left(h) < right(h) && m_seen.count(h) == 0)
        borders.push_back(border_along(first_of_line(h)));
    return borders;
  }

private:
  bool is_between_segments(Halfedge h) const
  {
    return !m_mesh.is_border(h) && !m_mesh.is_border(m_mesh.opposite(h)) && left(h) != right(h);
  }
  std::size_t left(Halfedge h) const { return m_segment_of_face[m_mesh.face(h)]; }
  std::size_t right(Halfedge h) const { return left(m_mesh.opposite(h)); }

  // Around a vertex in the segment on the left, from `h` on, to where it ends; `step` is the next or the previous
  // halfedge in a face. None if the line does not go on, for there is a third segment or the border of the mesh.
  template <typename Step>
  std::optional<Halfedge> neighbor_in_line(Halfedge h, const Step& step) const
  {
    Halfedge g = step(h);
    while (!m_mesh.is_border(m_mesh.opposite(g)) && left(m_mesh.opposite(g)) == left(h))
      g = step(m_mesh.opposite(g));
    if (m_mesh.is_border(m_mesh.opposite(g)) || right(g) != right(h))
      return std::nullopt;
    return g;
  }
  std::optional<Halfedge> next_in_line(Halfedge h) const
  {
    return neighbor_in_line(h, [this](Halfedge g) { return m_mesh.next(g); });
  }

  // `h` itself in a closed line
  Halfedge first_of_line(Halfedge h) const
  {
    Halfedge first = h;
    while (const auto before = neighbor_in_line(first, [this](Halfedge g) { return m_mesh.prev(g); }))
    {
      first = *before;
      if (first == h)
        break;
    }
    return first;
  }

  Border border_along(Halfedge first)
  {
    Border border;
    border.segments = {left(first), right(first)};
    border.points.push_back(m_mesh.point(m_mesh.source(first)));
    for (std::optional<Halfedge> h = first; h && !border.is_closed;)
    {
      m_seen.insert(*h);
      const Point& from = m_mesh.point(m_mesh.source(*h));
      const Point& to = m_mesh.point(m_mesh.target(*h));
      border.length += std::hypot(to.x() - from.x(), to.y() - from.y(), to.z() - from.z());
      h = next_in_line(*h);
      border.is_closed = h == first;
      if (!border.is_closed)
        border.points.push_back(to);
    }
    return border;
  }

  const Mesh& m_mesh;
  const std::vector<std::size_t>& m_segment_of_face;
  std::set<Halfedge> m_seen;
};

} // namespace

std::vector<Border> find_borders(const Mesh& mesh, const std::vector<std::size_t>& segment_of_face)
{
  std::vector<Border> borders = Border_finder(mesh, segment_of_face).find();
  std::stable_sort(borders.begin(), borders.end(),
                   [](const Border& a, const Border& b) { return a.segments < b.segments; });
  return borders;
}

} // namespace tool
