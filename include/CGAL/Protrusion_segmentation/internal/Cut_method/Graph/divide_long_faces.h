// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_GRAPH_DIVIDE_LONG_FACES_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_GRAPH_DIVIDE_LONG_FACES_H

#include <CGAL/Protrusion_segmentation/Indexed_surface.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Graph/Dual_graph.h>
#include <CGAL/Protrusion_segmentation/internal/Surface/polygon_measures.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <optional>
#include <tuple>
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
// border can run between them. An edge that is too long is halved, and so are its halves; a triangle is halved at its longest edge,
// which depends on nothing else, so that the pieces of neighbours fit together.
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
    for (Index v = 0; v < m_surface.number_of_vertices(); ++v)
      m_points.push_back(m_surface.point(v));
    for (Index f = 0; f < n; ++f)
      if (m_is_long[f] && is_convex(f))
        divide(f);
      else
        divide_edges(f);
    m_corner_begin.push_back(static_cast<Index>(m_corners.size()));
    return result();
  }

private:
  struct Corner
  {
    Index vertex, beyond; // the face beyond the edge to the next corner: the own one inside of a face
  };
  using Triangle = std::array<Corner, 3>;

  double squared_length(Index v, Index w) const { return squared_distance(m_points[v], m_points[w]); }

  // Returns whether there are any that are to be divided.
  bool find_long_faces()
  {
    constexpr double longest_edge = 0.06; // in units of the root of the area: twice the size of a node; with .04 coarse stars change
    constexpr double growth = 1.25;       // of that if there would be too many pieces
    constexpr double largest_share_of_curved = 0.25; // animals of few faces have .3 or more, what is constructed .2 or less
    const Index n = m_surface.number_of_faces();
    const double most_pieces = (std::max)((std::min)(16. * n, 50000.), 2. * n); // a box stays as simple as it is
    constexpr double exponent_of_needle = 0.79; // half of log 3 / log 2: if its long edges are halved, there are three of half the length
    std::vector<double> squared_lengths(n);
    for (Index f = 0; f < n; ++f)
      squared_lengths[f] = squared_length(f);
    double pieces = 0, area = 0, curved_area = 0;
    double limit = longest_edge * unit_of_length(m_surface);
    do
    {
      m_squared_limit = CGAL::square(limit);
      pieces = area = curved_area = 0;
      m_is_long.assign(n, false);
      for (Index f = 0; f < n; ++f)
        if (squared_lengths[f] > m_squared_limit)
        {
          m_is_long[f] = true;
          pieces += std::pow(squared_lengths[f] / m_squared_limit, exponent_of_needle) + 4 * m_surface.area(f) / m_squared_limit;
          area += m_surface.area(f);
          curved_area += is_curved(f) ? m_surface.area(f) : 0;
        }
      limit *= growth;
    } while (pieces > most_pieces);
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

  void divide(Index f)
  {
    const Index first = m_surface.first_corner(f), end = m_surface.first_corner(f + 1);
    const auto corner = [&](Index c) { return Corner{m_surface.vertex(c), m_surface.neighbor(c)}; };
    if (end - first == 3)
      return divide(f, {corner(first), corner(first + 1), corner(first + 2)});
    const Index middle = static_cast<Index>(m_points.size());
    m_points.push_back(m_surface.centroid(f));
    for (Index c = first; c < end; ++c)
      divide(f, {corner(c), Corner{m_surface.vertex(m_surface.next_corner(f, c)), f}, Corner{middle, f}});
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
      if (g == Indexed_surface::no_face() || CGAL::square(m_surface.edge_length(f, c)) <= m_squared_limit)
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

  // Of equally long edges that with the first midpoint, whatever corner a triangle begins with.
  void divide(Index f, const Triangle& triangle)
  {
    const auto key = [&](std::size_t i)
    {
      const Index v = triangle[i].vertex, w = triangle[(i + 1) % 3].vertex;
      return std::make_tuple(-squared_length(v, w), CGAL::midpoint(m_points[v], m_points[w]));
    };
    std::size_t longest = 0;
    for (std::size_t i : {1, 2})
      if (key(i) < key(longest))
        longest = i;
    const Corner a = triangle[longest], b = triangle[(longest + 1) % 3], c = triangle[(longest + 2) % 3];
    if (squared_length(a.vertex, b.vertex) <= m_squared_limit)
    {
      begin_piece(f);
      m_corners.insert(m_corners.end(), triangle.begin(), triangle.end());
      return;
    }
    const Index middle = middle_of(a.vertex, b.vertex);
    divide(f, {a, Corner{middle, f}, c});
    divide(f, {Corner{middle, a.beyond}, b, Corner{c.vertex, f}});
  }

  // The face stays one piece, with the halves of its edges.
  void divide_edges(Index f)
  {
    begin_piece(f);
    for (Index c = m_surface.first_corner(f); c < m_surface.first_corner(f + 1); ++c)
      divide_edge(m_surface.vertex(c), m_surface.vertex(m_surface.next_corner(f, c)), m_surface.neighbor(c));
  }

  void divide_edge(Index from, Index to, Index beyond)
  {
    if (squared_length(from, to) <= m_squared_limit)
      return m_corners.push_back({from, beyond});
    const Index middle = middle_of(from, to);
    divide_edge(from, middle, beyond);
    divide_edge(middle, to, beyond);
  }

  Index middle_of(Index v, Index w)
  {
    const auto [found, is_new] = m_middles.try_emplace(std::minmax(v, w), static_cast<Index>(m_points.size()));
    if (is_new)
      m_points.push_back(CGAL::midpoint(m_points[found->first.first], m_points[found->first.second]));
    return found->second;
  }

  // Nothing if pieces do not fit together: neighbours that do not share the vertices of their edge.
  std::optional<Divided_surface> result()
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
    return Divided_surface{Indexed_surface(std::move(m_points), std::move(m_corner_begin), std::move(vertices), std::move(*neighbors),
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
  double m_squared_limit = 0;
  std::vector<bool> m_is_long; // of every face
  std::vector<Point_3> m_points;
  std::map<std::pair<Index, Index>, Index> m_middles; // of edges, by their vertices
  std::vector<Index> m_face_of_piece, m_corner_begin;
  std::vector<Corner> m_corners;
};

} // namespace CGAL::Protrusion_segmentation::internal

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_GRAPH_DIVIDE_LONG_FACES_H
