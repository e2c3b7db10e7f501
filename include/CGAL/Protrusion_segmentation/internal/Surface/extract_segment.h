// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_SURFACE_EXTRACT_SEGMENT_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_SURFACE_EXTRACT_SEGMENT_H

#include <CGAL/Protrusion_segmentation/Indexed_surface.h>
#include <CGAL/Protrusion_segmentation/internal/Execution/for_each_block.h>
#include <CGAL/Protrusion_segmentation/internal/Surface/Surface_arrays.h>

#include <cstddef>
#include <vector>

namespace CGAL::Protrusion_segmentation::internal {

// Chooses and orders faces of a surface, `Indexed_surface` or `Surface_arrays`. The work arrays, as long as the
// surface, are kept between calls; a call takes time linear in the number of faces that it chooses.
template <typename Surface>
class Face_selector
{
public:
  using Index = Indexed_surface::Index;

  explicit Face_selector(const Surface& surface, bool is_parallel = false)
    : m_surface(surface),
      m_is_parallel(is_parallel),
      m_new_face(surface.number_of_faces(), none),
      m_new_vertex(surface.number_of_vertices(), none)
  {}

  // The given faces, numbered in the given order; vertices are numbered as the faces need them.
  Surface_arrays operator()(const std::vector<Index>& faces)
  {
    for (Index i = 0; i < faces.size(); ++i)
      m_new_face[faces[i]] = i;
    Surface_arrays result;
    number_corners(faces, result);
    select_neighbors(faces, result);
    select_vertices(faces, result);
    if (m_surface.has_patches())
      for (Index f : faces)
        result.patches.push_back(m_surface.patch(f));
    for (Index f : faces)
      m_new_face[f] = none;
    return result;
  }

private:
  static constexpr Index none = Indexed_surface::no_face();

  void number_corners(const std::vector<Index>& faces, Surface_arrays& result) const
  {
    result.corner_begin.reserve(faces.size() + 1);
    for (Index f : faces)
      result.corner_begin.push_back(result.corner_begin.back() + m_surface.first_corner(f + 1) -
                                    m_surface.first_corner(f));
  }

  // Calls `visit(corner, old)` for every corner of the result, `old` in the surface; if parallel, several threads do so.
  template <typename Visit>
  void for_each_corner(const std::vector<Index>& faces, const Surface_arrays& result, Visit visit) const
  {
    for_each_block(faces.size(), m_is_parallel,
                   [&](std::size_t begin, std::size_t end, std::size_t)
                   {
                     Index corner = result.corner_begin[begin];
                     for (std::size_t i = begin; i < end; ++i)
                       for (Index c = m_surface.first_corner(faces[i]);
                            c < m_surface.first_corner(faces[i] + 1); ++c)
                         visit(corner++, c);
                   });
  }

  void select_neighbors(const std::vector<Index>& faces, Surface_arrays& result) const
  {
    result.corner_neighbors.resize(result.corner_begin.back());
    for_each_corner(faces, result,
                    [&](Index corner, Index old)
                    {
                      const Index g = m_surface.neighbor(old);
                      result.corner_neighbors[corner] = g == Indexed_surface::no_face() ? g
                                                                                        : m_new_face[g];
                    });
  }

  void select_vertices(const std::vector<Index>& faces, Surface_arrays& result)
  {
    result.corner_vertices.resize(result.corner_begin.back());
    for_each_corner(faces, result,
                    [&](Index corner, Index old)
                    { result.corner_vertices[corner] = m_surface.vertex(old); });
    std::vector<Index> vertices; // of the surface, in the order of the points
    for (Index& v : result.corner_vertices)
    {
      if (m_new_vertex[v] == none)
      {
        m_new_vertex[v] = static_cast<Index>(vertices.size());
        vertices.push_back(v);
      }
      v = m_new_vertex[v];
    }
    result.points.resize(vertices.size());
    for_each_number(vertices.size(), m_is_parallel,
                    [&](Index i) { result.points[i] = m_surface.point(vertices[i]); });
    for (Index v : vertices)
      m_new_vertex[v] = none;
  }

  const Surface& m_surface;
  bool m_is_parallel;
  std::vector<Index> m_new_face;
  std::vector<Index> m_new_vertex;
};

} // namespace CGAL::Protrusion_segmentation::internal

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_SURFACE_EXTRACT_SEGMENT_H
