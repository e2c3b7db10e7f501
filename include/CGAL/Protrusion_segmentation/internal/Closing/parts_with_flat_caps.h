// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CLOSING_PARTS_WITH_FLAT_CAPS_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CLOSING_PARTS_WITH_FLAT_CAPS_H

#include <CGAL/Protrusion_segmentation/internal/Closing/Capper.h>
#include <CGAL/Protrusion_segmentation/internal/Segments/subtree.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace CGAL::Protrusion_segmentation::internal {

// The loops of a walk that comes back to some of its vertices, none twice in one of them.
inline void add_simple_loops(const Loop& walk, std::vector<Loop>& loops)
{
  Loop open;
  std::map<std::size_t, std::size_t> place; // of the vertices of `open`
  for (const std::size_t v : walk)
  {
    if (const auto seen = place.find(v); seen != place.end())
    {
      const auto begin = open.begin() + std::ptrdiff_t(seen->second);
      loops.emplace_back(begin, open.end());
      for (auto w = begin + 1; w != open.end(); ++w)
        place.erase(*w);
      open.erase(begin + 1, open.end());
    }
    else
    {
      place[v] = open.size();
      open.push_back(v);
    }
  }
  loops.push_back(open);
}

// The borders of sets of segments.
class Borders_of_segments
{
public:
  Borders_of_segments(const Mesh_to_close& mesh, const std::vector<std::size_t>& segment_of_face)
    : m_mesh(mesh),
      m_segment_of_face(segment_of_face)
  {
    for (const Mesh_to_close::Halfedge_index h : halfedges(mesh))
      if (!mesh.is_border(h) && !mesh.is_border(mesh.opposite(h)) &&
          segment(h) != segment(mesh.opposite(h)))
        m_halfedges.push_back(h);
  }

  // The closed loops around the segments that are `inside`, with them on the left.
  std::vector<Loop> loops_around(const std::vector<bool>& inside) const
  {
    std::vector<Loop> loops;
    std::set<Mesh_to_close::Halfedge_index> seen;
    for (const Mesh_to_close::Halfedge_index h : m_halfedges)
      if (is_border(h, inside) && seen.count(h) == 0)
        if (const Loop walk = walk_from(h, inside, seen); !walk.empty())
          add_simple_loops(walk, loops);
    return loops;
  }

private:
  std::size_t segment(Mesh_to_close::Halfedge_index h) const { return m_segment_of_face[m_mesh.face(h)]; }

  bool is_border(Mesh_to_close::Halfedge_index h, const std::vector<bool>& inside) const
  {
    return inside[segment(h)] && !m_mesh.is_border(m_mesh.opposite(h)) &&
           !inside[segment(m_mesh.opposite(h))];
  }

  // None if the walk ends at a border of the mesh, maybe behind another one that did.
  Loop walk_from(Mesh_to_close::Halfedge_index first,
                 const std::vector<bool>& inside,
                 std::set<Mesh_to_close::Halfedge_index>& seen) const
  {
    Loop walk;
    Mesh_to_close::Halfedge_index h = first;
    do
    {
      seen.insert(h);
      walk.push_back(std::size_t(m_mesh.source(h)));
      h = m_mesh.next(h);
      while (!is_border(h, inside))
      {
        h = m_mesh.opposite(h);
        if (m_mesh.is_border(h))
          return {};
        h = m_mesh.next(h);
      }
      if (h != first && seen.count(h) > 0)
        return {};
    } while (h != first);
    return walk;
  }

  const Mesh_to_close& m_mesh;
  const std::vector<std::size_t>& m_segment_of_face;
  std::vector<Mesh_to_close::Halfedge_index> m_halfedges; // between two segments
};

// Where a segment with all that sticks out of it is cut off.
struct Flat_cap
{
  std::size_t segment, parent;
  Loop loop;                        // with the segment on the left
  std::vector<Triangle> of_segment; // what closes the segment there
  std::vector<Triangle> of_parent;  // the same, turned over, unless there is a connector
};

// `parents` has for each segment what it sticks out of, itself for a body. A border that ends at a border of the mesh gets no cap.
inline std::vector<Flat_cap> flat_caps(const Mesh_to_close& mesh,
                                       const std::vector<std::size_t>& segment_of_face,
                                       const std::vector<std::size_t>& parents,
                                       Capper& capper)
{
  const Borders_of_segments borders(mesh, segment_of_face);
  std::vector<Flat_cap> caps;
  for (std::size_t s = 0; s < parents.size(); ++s)
    if (parents[s] != s)
      for (const Loop& loop : borders.loops_around(subtree(s, parents)))
      {
        Flat_cap cap = {s, parents[s], loop, {}, capper.cap(loop)};
        std::transform(cap.of_parent.begin(), cap.of_parent.end(), std::back_inserter(cap.of_segment),
                       turned_over); // its edges meet those of the faces of the segment
        caps.push_back(std::move(cap));
      }
  return caps;
}

struct Parts_with_flat_caps
{
  std::vector<Mesh_to_close::Point> points; // of all vertices of the mesh and, behind them, of caps
  std::vector<std::vector<Loop>> polygons;  // of each segment
};

// For each segment its faces and the triangles of its caps.
inline Parts_with_flat_caps parts_with_caps(const Mesh_to_close& mesh,
                                            const std::vector<std::size_t>& segment_of_face,
                                            std::size_t number_of_segments,
                                            const std::vector<Flat_cap>& caps,
                                            const std::vector<Mesh_to_close::Point>& points)
{
  Parts_with_flat_caps result = {points, std::vector<std::vector<Loop>>(number_of_segments)};
  for (const auto f : faces(mesh))
  {
    Loop corners;
    for (const auto v : vertices_around_face(mesh.halfedge(f), mesh))
      corners.push_back(std::size_t(v));
    result.polygons[segment_of_face[f]].push_back(std::move(corners));
  }
  std::vector<std::multiset<Triangle>> caps_of_parts(number_of_segments); // without what is there both ways
  const auto add = [](const std::vector<Triangle>& triangles, std::multiset<Triangle>& caps_of_part)
  {
    for (const Triangle& triangle : triangles)
      if (const auto other = caps_of_part.find(turned_over(triangle)); other != caps_of_part.end())
        caps_of_part.erase(other);
      else
        caps_of_part.insert(triangle);
  };
  for (const Flat_cap& cap : caps)
  {
    add(cap.of_segment, caps_of_parts[cap.segment]);
    add(cap.of_parent, caps_of_parts[cap.parent]);
  }
  for (std::size_t s = 0; s < number_of_segments; ++s)
    for (const Triangle& triangle : caps_of_parts[s])
      result.polygons[s].emplace_back(triangle.begin(), triangle.end());
  return result;
}

// Where a segment and all that sticks out of it is cut off, both sides get the same cap, turned over: so all parts of a closed
// mesh are closed, and their volumes add up to the whole.
inline Parts_with_flat_caps parts_with_flat_caps(const Mesh_to_close& mesh,
                                                 const std::vector<std::size_t>& segment_of_face,
                                                 const std::vector<std::size_t>& parents)
{
  Capper capper(mesh);
  const std::vector<Flat_cap> caps = flat_caps(mesh, segment_of_face, parents, capper);
  return parts_with_caps(mesh, segment_of_face, parents.size(), caps, capper.points());
}

} // namespace CGAL::Protrusion_segmentation::internal

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CLOSING_PARTS_WITH_FLAT_CAPS_H
