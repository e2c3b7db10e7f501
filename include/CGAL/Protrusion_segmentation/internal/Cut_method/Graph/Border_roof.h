// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_GRAPH_BORDER_ROOF_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_GRAPH_BORDER_ROOF_H

#include <CGAL/Protrusion_segmentation/Execution.h>
#include <CGAL/Protrusion_segmentation/Indexed_surface.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Cut_options.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Graph/Border_edges.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Graph/Surface_average.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Graph/diffusion.h>
#include <CGAL/Protrusion_segmentation/internal/Execution/for_each_block.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <vector>

namespace CGAL::Protrusion_segmentation::internal {

// A roof over an open surface, or over both sides of a thin plate, that falls towards the outline. Of a sheet only that shows
// what sticks out, of a scan from one side much of it: at a concave corner of the outline the roof has a valley, which is a seam
// from there into the sheet.
class Border_roof
{
public:
  using Index = Indexed_surface::Index;
  using Vector_3 = Indexed_surface::Vector_3;

  // The arguments must outlive the object.
  Border_roof(const Indexed_surface& surface, const Border_edges& border, Execution& execution)
    : m_surface(surface), m_border(border), m_execution(execution)
  {}

  // For each face the direction in which the roof falls, along the surface, as long as its slope. `normals`: the averaged ones
  Padded_vectors operator()(const Padded_vectors& normals, const Surface_average& average) const
  {
    Padded_vectors directions = directions_at_border(normals);
    average(directions, outline_radius);
    for (std::size_t f = 0; f < normals.size(); ++f)
    {
      const Vector_3 normal = unpadded(normals[f]), direction = unpadded(directions[f]);
      const Vector_3 tangential = direction - (direction * normal) * normal; // it may have come around an edge
      directions[f] = padded(steepness / (std::max)(1., std::sqrt(tangential.squared_length())) * tangential);
    }
    return directions;
  }

private:
  // A border that is shorter, in units of the square root of the area, is that of a hole or of a limb's end and has no roof: it
  // says nothing of the outline.
  static constexpr double longest_hole = 0.4;

  // How far to both sides the border is seen as straight, in units of the square root of the area and in mean edges of it, whichever
  // is longer: the zigzag of triangles along it has no corners. With 1 edge fingers are cut in two, with 2 fewer stars are right.
  static constexpr double straight_length = 0.03, straight_edges = 1.5;

  // The slope of the roof where directions have at least length 1, which is near the border. From 1.75 to 2.5 there is little
  // difference.
  static constexpr double steepness = 2;

  // Outwards in the faces at the border. After diffusion over the radius a straight border has directions of length 4.
  Padded_vectors directions_at_border(const Padded_vectors& normals) const
  {
    const double unit = unit_of_length(m_surface);
    const std::vector<Index> part = m_border.parts();
    std::map<Index, double> lengths; // of the parts
    double total = 0;
    for (std::size_t i = 0; i < part.size(); ++i)
    {
      lengths[part[i]] += m_border()[i].length();
      total += m_border()[i].length();
    }
    const double reach = (std::max)(straight_length * unit, straight_edges * total / double(part.size()));
    std::vector<Vector_3> borders(part.size(), Vector_3(0, 0, 0));
    for_each_number(borders.size(), m_execution.is_parallel(),
                    [&](std::size_t i)
                    {
                      if (lengths.at(part[i]) >= longest_hole * unit)
                        borders[i] = m_border.straight(i, reach);
                    });
    Padded_vectors result(m_surface.number_of_faces());
    for (std::size_t i = 0; i < borders.size(); ++i)
      if (const Index f = m_border()[i].face; m_surface.area(f) > 0)
      {
        const Vector_3 outwards = cross_product(borders[i], unpadded(normals[f])) * (2 * outline_radius * unit / m_surface.area(f));
        result[f] += padded(outwards);
      }
    return result;
  }

  const Indexed_surface& m_surface;
  const Border_edges& m_border;
  Execution& m_execution;
};

} // namespace CGAL::Protrusion_segmentation::internal

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_GRAPH_BORDER_ROOF_H
