// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_REPAIR_NEAR_PIECES_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_REPAIR_NEAR_PIECES_H

#include <CGAL/Protrusion_segmentation/internal/Repair/Polygon_soup.h>
#include <CGAL/Protrusion_segmentation/internal/Surface/Disjoint_sets.h>

#include <CGAL/Bbox_3.h>
#include <CGAL/Box_intersection_d/Box_with_info_d.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/box_intersection_d.h>
#include <CGAL/number_utils.h>

#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace CGAL::Protrusion_segmentation::internal {

using Soup_kernel = Exact_predicates_inexact_constructions_kernel;

// The triangles of a polygon that are not degenerate, as a fan: `visit(a, b, c)` gets indices of points.
template <typename Visit>
void for_each_triangle(const Polygon_soup& soup, std::size_t polygon, Visit visit)
{
  const auto exact = [&](std::size_t point)
  {
    const Polygon_soup::Point_3& p = soup.points[point];
    return Soup_kernel::Point_3(p.x(), p.y(), p.z());
  };
  const Polygons::Corners corners = soup.polygons[polygon];
  for (std::ptrdiff_t i = 2; i < std::ptrdiff_t(corners.size()); ++i)
  {
    const std::size_t a = corners.begin()[0], b = corners.begin()[i - 1], c = corners.begin()[i];
    if (!collinear(exact(a), exact(b), exact(c)))
      visit(a, b, c);
  }
}

// Pieces that are nearer to each other than the gap, or by way of others, are one shape. Returns the polygons of each shape.
inline std::vector<std::vector<std::size_t>> shapes_of_pieces(
  const Polygon_soup& soup,
  const std::vector<std::size_t>& piece_of_polygon,
  double gap)
{
  using Index = Disjoint_sets::Index;
  using Box = Box_intersection_d::Box_with_info_d<double, 3, std::pair<Index, Soup_kernel::Triangle_3>>;
  const auto point = [&](std::size_t i)
  { return Soup_kernel::Point_3(soup.points[i].x(), soup.points[i].y(), soup.points[i].z()); };
  std::map<std::size_t, Index> numbers; // of the pieces
  std::vector<Index> pieces;            // of the polygons
  std::vector<Box> boxes;
  for (std::size_t i = 0; i < soup.polygons.size(); ++i)
  {
    pieces.push_back(numbers.emplace(piece_of_polygon[i], Index(numbers.size())).first->second);
    for_each_triangle(soup, i,
                      [&](std::size_t a, std::size_t b, std::size_t c)
                      {
                        const Soup_kernel::Triangle_3 triangle(point(a), point(b), point(c));
                        const Bbox_3 box = triangle.bbox();
                        boxes.emplace_back(Bbox_3(box.xmin() - gap / 2, box.ymin() - gap / 2,
                                                  box.zmin() - gap / 2, box.xmax() + gap / 2,
                                                  box.ymax() + gap / 2, box.zmax() + gap / 2),
                                           std::make_pair(pieces.back(), triangle));
                      });
  }
  Disjoint_sets sets(numbers.size());
  box_self_intersection_d(boxes.begin(), boxes.end(),
                          [&](const Box& a, const Box& b)
                          {
                            const auto& [p, t] = a.info();
                            const auto& [q, u] = b.info();
                            if (sets.find_set(p) != sets.find_set(q) &&
                                squared_distance(t, u) <= CGAL::square(gap))
                              sets.union_set(p, q);
                          });
  std::map<Index, std::vector<std::size_t>> shapes;
  for (std::size_t i = 0; i < pieces.size(); ++i)
    shapes[sets.find_set(pieces[i])].push_back(i);
  std::vector<std::vector<std::size_t>> result;
  for (auto& [set, polygons] : shapes)
    result.push_back(std::move(polygons));
  return result;
}

} // namespace CGAL::Protrusion_segmentation::internal

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_REPAIR_NEAR_PIECES_H
