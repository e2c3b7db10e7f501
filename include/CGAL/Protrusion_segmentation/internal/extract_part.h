// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_EXTRACT_PART_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_EXTRACT_PART_H

#include <CGAL/Protrusion_segmentation/Surface_part.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Protrusion_segmentation {
namespace internal {

// A segment as a surface of its own.
struct Extracted_part
{
  Surface_part part;
  std::vector<Surface_part::Index> faces; // the face of the whole surface for every face of the part
  std::vector<bool> is_on_cut;            // whether a face of the part lost a neighbour
};

// Cuts segments out of a surface. The work arrays, as long as the surface, are kept between calls; a call
// takes time linear in the number of faces of the segment.
class Part_extractor
{
public:
  using Index = Surface_part::Index;

  explicit Part_extractor(const Surface_part& surface)
    : m_surface(surface),
      m_new_face(surface.number_of_faces(), none),
      m_new_vertex(surface.number_of_vertices(), none)
  {}

  // The part with the given faces, numbered in the given order.
  Extracted_part operator()(std::vector<Index> faces)
  {
    for (Index i = 0; i < faces.size(); ++i)
      m_new_face[faces[i]] = i;
    std::vector<Surface_part::Point_3> points;
    std::vector<Index> vertices; // of the surface, in the order of `points`
    std::vector<Index> corner_begin(1, 0), corner_vertices, corner_neighbors;
    std::vector<bool> is_on_cut(faces.size(), false);
    corner_begin.reserve(faces.size() + 1);
    std::size_t number_of_corners = 0;
    for (Index f : faces)
      number_of_corners += m_surface.first_corner(f + 1) - m_surface.first_corner(f);
    corner_vertices.reserve(number_of_corners);
    corner_neighbors.reserve(number_of_corners);
    for (Index i = 0; i < faces.size(); ++i)
    {
      for (Index c = m_surface.first_corner(faces[i]); c < m_surface.first_corner(faces[i] + 1); ++c)
      {
        const Index v = m_surface.vertex(c);
        if (m_new_vertex[v] == none)
        {
          m_new_vertex[v] = static_cast<Index>(points.size());
          points.push_back(m_surface.point(v));
          vertices.push_back(v);
        }
        corner_vertices.push_back(m_new_vertex[v]);
        const Index g = m_surface.neighbor(c);
        corner_neighbors.push_back(g == Surface_part::no_face() ? g : m_new_face[g]);
        if (g != Surface_part::no_face() && m_new_face[g] == none)
          is_on_cut[i] = true;
      }
      corner_begin.push_back(static_cast<Index>(corner_vertices.size()));
    }
    for (Index f : faces)
      m_new_face[f] = none;
    for (Index v : vertices)
      m_new_vertex[v] = none;
    return {Surface_part(std::move(points), std::move(corner_begin), std::move(corner_vertices),
                         std::move(corner_neighbors)),
            std::move(faces), std::move(is_on_cut)};
  }

private:
  static constexpr Index none = Surface_part::no_face();

  const Surface_part& m_surface;
  std::vector<Index> m_new_face;
  std::vector<Index> m_new_vertex;
};

} // namespace internal
} // namespace Protrusion_segmentation
} // namespace CGAL

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_EXTRACT_PART_H
