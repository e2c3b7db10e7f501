// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_GRAPH_DIVIDE_LONG_FACES_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_GRAPH_DIVIDE_LONG_FACES_H

#include <CGAL/Protrusion_segmentation/Indexed_surface.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Graph/Dual_graph.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Graph/Grid_cutter.h>
#include <CGAL/Protrusion_segmentation/internal/Surface/polygon_measures.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Protrusion_segmentation::internal {

// A surface whose long faces are divided, and the face that each of its faces is a piece of.
struct Divided_surface
{
  Indexed_surface surface;
  std::vector<Indexed_surface::Index> face_of_piece; // ascending

  Indexed_surface::Index first_piece(Indexed_surface::Index face) const
  {
    return static_cast<Indexed_surface::Index>(std::lower_bound(face_of_piece.begin(), face_of_piece.end(), face) - face_of_piece.begin());
  }
};

// Divides flat faces that span a shape, as programs for construction make them: where one triangle leads from an arm to the other, no
// border can run between them.
class Face_divider
{
public:
  using Index = Indexed_surface::Index;
  using Point_3 = Indexed_surface::Point_3;

  explicit Face_divider(const Indexed_surface& surface) : m_surface(surface) {}

  // Nothing if no face is long, or if the long ones are those of a curved surface.
  std::optional<Divided_surface> operator()()
  {
    const Index n = m_surface.number_of_faces();
    if (!find_long_faces())
      return std::nullopt;
    std::vector<Point_3> points;
    for (Index v = 0; v < m_surface.number_of_vertices(); ++v)
      points.push_back(m_surface.point(v));
    Grid_cutter cutter(std::move(points), m_cell);
    for (Index f = 0; f < n; ++f)
      if (m_is_long[f] && is_convex(f))
        divide(cutter, f);
      else
        divide_edges(cutter, f);
    m_corner_begin.push_back(static_cast<Index>(m_corners.size()));
    return result(std::move(cutter.points()));
  }

private:
  using Corner = Grid_cutter::Corner;

  bool is_long(double length) const { return length > 2 * m_cell; }

  // Returns whether there are any that are to be divided.
  bool find_long_faces()
  {
    constexpr double cell = 0.03;            // of the grid, in units of the root of the area: the size of a node
    constexpr double growth = 1.25;          // of cells if there would be too many pieces
    constexpr double planes_on_length = 1.3; // that meet a line as long as a cell, about
    constexpr double largest_share_of_curved = 0.25; // animals of few faces have .3 or more, what is constructed .2 or less
    const Index n = m_surface.number_of_faces();
    // a box stays as simple as it is
    const double most_pieces = (std::max)((std::min)(32. * n, 50000.), 2. * n);
    std::vector<double> lengths(n);
    for (Index f = 0; f < n; ++f)
      lengths[f] = std::sqrt(squared_length(f));
    double pieces = 0, area = 0, curved_area = 0;
    m_cell = cell * unit_of_length(m_surface);
    for (;; m_cell *= growth)
    {
      pieces = area = curved_area = 0;
      m_is_long.assign(n, false);
      for (Index f = 0; f < n; ++f)
        if (is_long(lengths[f]))
        {
          m_is_long[f] = true;
          pieces += 1 + planes_on_length * lengths[f] / m_cell + m_surface.area(f) / CGAL::square(m_cell);
          area += m_surface.area(f);
          curved_area += is_curved(f) ? m_surface.area(f) : 0;
        }
      if (pieces <= most_pieces)
        break;
    }
    return pieces > 0 && curved_area <= largest_share_of_curved * area;
  }

  // of the longest edge of a face, or of a way from the centroid of a polygon to a corner if that is longer
  double squared_length(Index f) const
  {
    const Corners_of_face<Indexed_surface> corners{m_surface, f};
    double result = 0;
    for (std::size_t i = 0; i < corners.size(); ++i)
      result = (std::max)(result, squared_distance(corners[i], corners[(i + 1) % corners.size()]));
    for (std::size_t i = 0; corners.size() > 3 && i < corners.size(); ++i)
      result = (std::max)(result, squared_distance(corners[i], m_surface.centroid(f)));
    return result;
  }

  void begin_piece(Index f)
  {
    m_face_of_piece.push_back(f);
    m_corner_begin.push_back(static_cast<Index>(m_corners.size()));
  }

  // A polygon that is no triangle is divided around its centroid first: its corners need not lie in a plane.
  void divide(Grid_cutter& cutter, Index f)
  {
    const Index first = m_surface.first_corner(f), end = m_surface.first_corner(f + 1);
    const auto corner = [&](Index c) { return Corner{m_surface.vertex(c), m_surface.neighbor(c)}; };
    const auto add = [&](const Grid_cutter::Polygon& piece)
    {
      begin_piece(f);
      m_corners.insert(m_corners.end(), piece.begin(), piece.end());
    };
    if (end - first == 3)
      return cutter.cut(f, {corner(first), corner(first + 1), corner(first + 2)}, add);
    const Index middle = cutter.add(m_surface.centroid(f));
    for (Index c = first; c < end; ++c)
      cutter.cut(
        f, {corner(c), Corner{m_surface.vertex(m_surface.next_corner(f, c)), f}, Corner{middle, f}}, add);
  }

  // The face stays one piece, with the pieces of its edges.
  void divide_edges(Grid_cutter& cutter, Index f)
  {
    begin_piece(f);
    for (Index c = m_surface.first_corner(f); c < m_surface.first_corner(f + 1); ++c)
    {
      const Index beyond = m_surface.neighbor(c), from = m_surface.vertex(c),
                  to = m_surface.vertex(m_surface.next_corner(f, c));
      if (m_is_long[f] || (beyond != Indexed_surface::no_face() && m_is_long[beyond]))
        cutter.cut_edge(from, to, [&](Index vertex) { m_corners.push_back({vertex, beyond}); });
      else
        m_corners.push_back({from, beyond});
    }
  }

  // Whether the surface bends along a long edge, but has no sharp one there: then a face is as fine as what it stands for, and
  // its pieces would meet those of the next one in a seam that the shape does not have.
  bool is_curved(Index f) const
  {
    constexpr double cosine_of_flat = 0.985, cosine_of_sharp = 0.766; // 10 and 40 degrees
    const Indexed_surface::Vector_3 normal = m_surface.area_vector(f);
    for (Index c = m_surface.first_corner(f); c < m_surface.first_corner(f + 1); ++c)
    {
      const Index g = m_surface.neighbor(c);
      if (g == Indexed_surface::no_face() || !is_long(m_surface.edge_length(f, c)))
        continue;
      const double sizes = m_surface.area(f) * m_surface.area(g), product = normal * m_surface.area_vector(g);
      if (product > cosine_of_sharp * sizes && product < cosine_of_flat * sizes)
        return true;
    }
    return false;
  }

  // Whether the centroid of a face sees all its edges from inside.
  bool is_convex(Index f) const
  {
    const Corners_of_face<Indexed_surface> corners{m_surface, f};
    const Indexed_surface::Vector_3 normal = m_surface.area_vector(f);
    const Point_3 middle = m_surface.centroid(f);
    for (std::size_t i = 0; i < corners.size(); ++i)
      if (!(cross_product(corners[i] - middle, corners[(i + 1) % corners.size()] - middle) * normal > 0))
        return corners.size() == 3; // without area
    return true;
  }

  // Nothing if pieces do not fit together: neighbours that do not share the vertices of their edge.
  std::optional<Divided_surface> result(std::vector<Point_3> points)
  {
    std::optional<std::vector<Index>> neighbors = neighbors_of_corners();
    if (!neighbors)
      return std::nullopt;
    std::vector<Index> vertices, patches;
    for (const Corner& corner : m_corners)
      vertices.push_back(corner.vertex);
    if (m_surface.has_patches())
      for (Index f : m_face_of_piece)
        patches.push_back(m_surface.patch(f));
    return Divided_surface{Indexed_surface(std::move(points), std::move(m_corner_begin), std::move(vertices), std::move(*neighbors),
                                           false, std::move(patches)),
                           std::move(m_face_of_piece)};
  }

  // A piece at an edge: the vertices of that and the faces on both sides, each the lower one first.
  struct Side
  {
    std::array<Index, 4> edge;
    Index corner, piece;
  };

  // The pieces beyond the edges; nothing if an edge has not two of them.
  std::optional<std::vector<Index>> neighbors_of_corners() const
  {
    std::vector<Index> result(m_corners.size(), Indexed_surface::no_face());
    std::vector<Side> sides = sides_of_long_faces(result);
    std::stable_sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) { return a.edge < b.edge; });
    for (std::size_t i = 0; i < sides.size(); i += 2)
    {
      if (i + 1 == sides.size() || sides[i].edge != sides[i + 1].edge)
        return std::nullopt;
      result[sides[i].corner] = sides[i + 1].piece;
      result[sides[i + 1].corner] = sides[i].piece;
    }
    return result;
  }

  // Where no face is long the neighbours are known, and are set.
  std::vector<Side> sides_of_long_faces(std::vector<Index>& neighbors) const
  {
    std::vector<Index> first_piece(m_surface.number_of_faces());
    for (std::size_t p = m_face_of_piece.size(); p-- > 0;)
      first_piece[m_face_of_piece[p]] = static_cast<Index>(p);
    std::vector<Side> sides;
    for (Index p = 0; p < m_face_of_piece.size(); ++p)
      for (Index c = m_corner_begin[p]; c < m_corner_begin[p + 1]; ++c)
      {
        const Index f = m_face_of_piece[p], beyond = m_corners[c].beyond;
        if (beyond == Indexed_surface::no_face())
          continue;
        if (!m_is_long[f] && !m_is_long[beyond])
        {
          neighbors[c] = first_piece[beyond];
          continue;
        }
        const Index next = c + 1 < m_corner_begin[p + 1] ? c + 1 : m_corner_begin[p];
        const auto vertices = std::minmax(m_corners[c].vertex, m_corners[next].vertex), faces = std::minmax(f, beyond);
        sides.push_back({{vertices.first, vertices.second, faces.first, faces.second}, c, p});
      }
    return sides;
  }

  const Indexed_surface& m_surface;
  double m_cell = 0;
  std::vector<bool> m_is_long; // of every face
  std::vector<Index> m_face_of_piece, m_corner_begin;
  std::vector<Corner> m_corners;
};

} // namespace CGAL::Protrusion_segmentation::internal

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_GRAPH_DIVIDE_LONG_FACES_H
