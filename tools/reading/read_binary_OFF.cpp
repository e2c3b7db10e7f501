// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The writers of binary OFF agree neither on the order of bytes (Geomview and CGAL: the largest first; pmp: that of the
// machine) nor on colours of faces (Geomview and CGAL: behind each face, how many numbers, then these; pmp: none).
// Only one of the layouts reaches the end of the file exactly.

#include "reading/formats.h"

#include "reading/Format_error.h"

#include <array>
#include <cstdint>
#include <cstring>
#include <optional>

namespace tool
{
namespace
{

struct Layout
{
  bool is_largest_byte_first;
  bool has_face_colors;
  std::size_t numbers_of_vertex;
};

class Walk
{
public:
  Walk(std::string_view bytes, const Layout& layout) : m_bytes(bytes), m_layout(layout) {}

  // The faces, if the layout fits.
  std::optional<Polygon_soup> read()
  {
    const std::size_t vertices = take(), faces = take();
    take(); // the number of edges
    if (vertices > m_bytes.size() || faces > m_bytes.size())
      return std::nullopt;
    Polygon_soup soup;
    for (std::size_t i = 0; i < vertices && m_is_good; ++i)
      soup.points.push_back(take_point());
    for (std::size_t i = 0; i < faces && m_is_good; ++i)
      soup.polygons.add(take_face(vertices));
    return m_is_good && m_bytes.empty() ? std::optional<Polygon_soup>(soup) : std::nullopt;
  }

private:
  std::uint32_t take()
  {
    m_is_good = m_is_good && m_bytes.size() >= 4;
    if (!m_is_good)
      return 0;
    std::uint32_t number = 0;
    for (int i = 0; i < 4; ++i)
      number = number << 8 | static_cast<unsigned char>(m_bytes[m_layout.is_largest_byte_first ? i : 3 - i]);
    m_bytes.remove_prefix(4);
    return number;
  }

  float take_float()
  {
    const std::uint32_t bits = take();
    float number;
    static_assert(sizeof(number) == sizeof(bits));
    std::memcpy(&number, &bits, sizeof(number));
    return number;
  }

  Point take_point()
  {
    const float x = take_float(), y = take_float(), z = take_float();
    for (std::size_t i = 3; i < m_layout.numbers_of_vertex; ++i)
      take();
    return Point(x, y, z);
  }

  Polygon take_face(std::size_t vertices)
  {
    Polygon face;
    const std::size_t size = take();
    for (std::size_t i = 0; i < size && m_is_good; ++i)
    {
      face.push_back(take());
      m_is_good = m_is_good && face.back() < vertices;
    }
    const std::size_t colors = m_layout.has_face_colors ? take() : 0;
    m_is_good = m_is_good && colors <= 4;
    for (std::size_t i = 0; i < colors && m_is_good; ++i)
      take();
    return face;
  }

  std::string_view m_bytes;
  Layout m_layout;
  bool m_is_good = true;
};

} // namespace

Polygon_soup read_binary_OFF(std::string_view rest, bool has_normals, bool has_colors)
{
  const std::size_t numbers = has_normals ? 6 : 3;
  for (const bool is_largest_byte_first : {true, false})
    for (const bool has_face_colors : {true, false})
      for (const std::size_t color : {3, 4})
      {
        const Layout layout = {is_largest_byte_first, has_face_colors, numbers + (has_colors ? color : 0)};
        if (std::optional<Polygon_soup> soup = Walk(rest, layout).read())
          return *soup;
      }
  throw Format_error("is binary OFF in which no layout of bytes reaches the end of the file");
}

} // namespace tool
