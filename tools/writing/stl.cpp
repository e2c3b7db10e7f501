// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "writing/formats.h"

#include "writing/binary_numbers.h"
#include "writing/triangles.h"

#include <CGAL/Kernel/global_functions.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>

namespace tool {
namespace {

// Of any length of sides; zero for a triangle without area.
CGAL::Simple_cartesian<double>::Vector_3 unit_normal(const Point& a, const Point& b, const Point& c)
{
  auto u = b - a, v = c - a;
  double size = 0;
  for (int i = 0; i < 3; ++i)
    size = (std::max)({size, std::abs(u[i]), std::abs(v[i])});
  if (!(size > 0 && std::isfinite(size)))
    return CGAL::NULL_VECTOR;
  const auto normal = CGAL::cross_product(u / size, v / size);
  const double length = std::sqrt(normal.squared_length());
  return length > 0 ? normal / length : CGAL::NULL_VECTOR;
}

} // namespace

void write_STL(std::ostream& out, const Output& output)
{
  constexpr std::size_t size_of_header = 80;
  std::string header = "binary STL of segment_by_protrusions"; // must not begin with "solid"
  header.resize(size_of_header, ' ');
  const Polygon_soup& soup = output.surface.soup;
  std::size_t number_of_triangles = 0;
  for (const Corners& polygon : soup.polygons)
    for_each_triangle(polygon, [&](auto, auto, auto) { ++number_of_triangles; });
  out << header;
  write_bits(out, static_cast<std::uint32_t>(number_of_triangles));
  for (const Corners& polygon : soup.polygons)
    for_each_triangle(
      polygon,
      [&](auto a, auto b, auto c)
      {
        const std::array<Point, 3> corners = {soup.points[a], soup.points[b], soup.points[c]};
        const auto normal = unit_normal(corners[0], corners[1], corners[2]);
        for (int i = 0; i < 3; ++i)
          write_float(out, normal[i]);
        for (const Point& corner : corners)
          for (int i = 0; i < 3; ++i)
            write_float(out, corner[i]);
        write_bits(out, std::uint16_t(0)); // bytes of attributes
      });
}

} // namespace tool
