// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_REPAIR_NEAR_PIECES_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_REPAIR_NEAR_PIECES_H

#include <CGAL/Protrusion_segmentation/internal/Repair/Polygon_soup.h>
#include <CGAL/Protrusion_segmentation/internal/Surface/Disjoint_sets.h>
#include <CGAL/Protrusion_segmentation/internal/Surface/Surface_arrays.h>
#include <CGAL/Protrusion_segmentation/internal/Surface/polygon_measures.h>

#include <CGAL/Bbox_3.h>
#include <CGAL/Box_intersection_d/Box_with_info_d.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Side_of_triangle_mesh.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/box_intersection_d.h>
#include <CGAL/number_utils.h>

#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace CGAL::Protrusion_segmentation::internal {

using Soup_kernel = Exact_predicates_inexact_constructions_kernel;

inline Soup_kernel::Point_3 exact(const Polygon_soup::Point_3& p)
{
  return Soup_kernel::Point_3(p.x(), p.y(), p.z());
}

// The triangles of a polygon that are not degenerate, as a fan: `visit(a, b, c)` gets indices of points.
template <typename Visit>
void for_each_triangle(const Polygon_soup& soup, std::size_t polygon, Visit visit)
{
  const Polygons::Corners corners = soup.polygons[polygon];
  for (std::ptrdiff_t i = 2; i < std::ptrdiff_t(corners.size()); ++i)
  {
    const std::size_t a = corners.begin()[0], b = corners.begin()[i - 1], c = corners.begin()[i];
    if (!collinear(exact(soup.points[a]), exact(soup.points[b]), exact(soup.points[c])))
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
  std::map<std::size_t, Index> numbers; // of the pieces
  std::vector<Index> pieces;            // of the polygons
  std::vector<Box> boxes;
  for (std::size_t i = 0; i < soup.polygons.size(); ++i)
  {
    pieces.push_back(numbers.emplace(piece_of_polygon[i], Index(numbers.size())).first->second);
    for_each_triangle(soup, i,
                      [&](std::size_t a, std::size_t b, std::size_t c)
                      {
                        const Soup_kernel::Triangle_3 triangle(exact(soup.points[a]), exact(soup.points[b]),
                                                                exact(soup.points[c]));
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

// Finds the nearest of polygons, by the triangles of each.
class Nearest_polygon
{
public:
  using Index = Surface_arrays::Index;

  // `polygons` in the order in which the first of several nearest ones is chosen
  template <typename Numbers>
  Nearest_polygon(const Surface_arrays& surface, const Numbers& polygons)
  {
    for (const auto number : polygons)
    {
      const Index i = static_cast<Index>(number);
      for_each_triangle_of_fan(Corners_of_face<Surface_arrays>{surface, i},
                               [&](const auto& p, const auto& q, const auto& r) { add(exact(p), exact(q), exact(r), i); });
    }
    m_tree.insert(m_mesh.faces_begin(), m_mesh.faces_end(), m_mesh);
    m_tree.build();
  }

  Index operator()(const Polygon_soup::Point_3& point) const
  {
    return m_polygons[m_tree.closest_point_and_primitive(exact(point)).second];
  }

private:
  using Point_3 = Soup_kernel::Point_3;
  using Mesh = Surface_mesh<Point_3>;

  // Triangles that share no vertices are enough.
  void add(const Point_3& p, const Point_3& q, const Point_3& r, Index polygon)
  {
    if (collinear(p, q, r))
      return;
    m_mesh.add_face(m_mesh.add_vertex(p), m_mesh.add_vertex(q), m_mesh.add_vertex(r));
    m_polygons.push_back(polygon);
  }

  Mesh m_mesh;
  std::vector<Index> m_polygons; // of the triangles
  Side_of_triangle_mesh<Mesh, Soup_kernel>::AABB_tree m_tree;
};

} // namespace CGAL::Protrusion_segmentation::internal

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_REPAIR_NEAR_PIECES_H
