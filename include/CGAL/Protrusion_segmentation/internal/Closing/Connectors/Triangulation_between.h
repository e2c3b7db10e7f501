// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CLOSING_CONNECTORS_TRIANGULATION_BETWEEN_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CLOSING_CONNECTORS_TRIANGULATION_BETWEEN_H

#include <CGAL/Protrusion_segmentation/internal/Closing/Connectors/Cap_frame.h>

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <array>
#include <cstddef>
#include <set>
#include <utility>
#include <vector>

namespace CGAL::Protrusion_segmentation::internal::connectors {

// Triangles between two polygons. Their corners are those of the outer one, of the inner one and, behind them, further points.
struct Triangles_between
{
  std::vector<Point_2> further_points;
  std::vector<std::array<std::size_t, 3>> triangles; // counterclockwise
};

class Triangulation_between
{
  using Exact = CGAL::Exact_predicates_inexact_constructions_kernel;
  using Vertex_base = CGAL::Triangulation_vertex_base_with_info_2<std::size_t, Exact>;
  using Face_base = CGAL::Constrained_triangulation_face_base_2<Exact>;
  using Triangulation = CGAL::Constrained_Delaunay_triangulation_2<
    Exact,
    CGAL::Triangulation_data_structure_2<Vertex_base, Face_base>,
    CGAL::No_constraint_intersection_tag>;
  using Face_handle = Triangulation::Face_handle;

public:
  Triangulation_between(const std::vector<Point_2>& outer, const std::vector<Point_2>& inner)
    : m_number_outside(outer.size())
  {
    add_polygon(outer);
    add_polygon(inner);
  }

  // Between the polygons. These are the first of the further points.
  void add_point(const Point_2& p)
  {
    const std::size_t number_of_vertices = m_triangulation.number_of_vertices();
    const auto vertex = m_triangulation.insert(Exact::Point_2(p.x(), p.y()));
    if (m_triangulation.number_of_vertices() > number_of_vertices) // else there is one at that place
      vertex->info() = m_number_of_points;
    ++m_number_of_points;
    m_result.further_points.push_back(p);
  }

  // `is_taken(i, j)` says whether corners of the outer polygon must not be joined. A point divides such an edge.
  template <typename IsTaken>
  Triangles_between triangulate(const IsTaken& is_taken)
  {
    constexpr int most_rounds = 10; // one in practice
    for (int round = 0; round < most_rounds; ++round)
    {
      const std::vector<Exact::Point_2> middles = middles_of_taken_edges(is_taken);
      if (middles.empty())
        break;
      for (const Exact::Point_2& middle : middles)
      {
        m_result.further_points.emplace_back(middle.x(), middle.y());
        m_triangulation.insert(middle)->info() = m_number_of_points++;
      }
    }
    for (const Face_handle face : faces_between())
      m_result.triangles.push_back(
        {face->vertex(0)->info(), face->vertex(1)->info(), face->vertex(2)->info()});
    return m_result;
  }

private:
  void add_polygon(const std::vector<Point_2>& polygon)
  {
    std::vector<Triangulation::Vertex_handle> corners;
    for (const Point_2& p : polygon)
    {
      corners.push_back(m_triangulation.insert(Exact::Point_2(p.x(), p.y())));
      corners.back()->info() = m_number_of_points++;
    }
    for (std::size_t i = 0; i < corners.size(); ++i)
      m_triangulation.insert_constraint(corners[i], corners[(i + 1) % corners.size()]);
  }

  // Those that are reached from outside by one polygon.
  std::vector<Face_handle> faces_between() const
  {
    std::set<Face_handle> seen = {m_triangulation.infinite_face()};
    std::vector<Face_handle> outside = {m_triangulation.infinite_face()}, result;
    const auto add_neighbors = [&](std::vector<Face_handle>& faces, std::vector<Face_handle>* beyond)
    {
      for (std::size_t next = 0; next < faces.size(); ++next)
        for (int i = 0; i < 3; ++i)
        {
          const Face_handle face = faces[next], neighbor = face->neighbor(i);
          std::vector<Face_handle>* const place = face->is_constrained(i) ? beyond : &faces;
          if (place && seen.insert(neighbor).second)
            place->push_back(neighbor);
        }
    };
    add_neighbors(outside, &result);
    add_neighbors(result, nullptr);
    return result;
  }

  template <typename IsTaken>
  std::vector<Exact::Point_2> middles_of_taken_edges(const IsTaken& is_taken) const
  {
    std::vector<Exact::Point_2> middles;
    for (const Face_handle face : faces_between())
      for (int i = 0; i < 3; ++i)
      {
        const auto v = face->vertex(Triangulation::ccw(i)), w = face->vertex(Triangulation::cw(i));
        if (!face->is_constrained(i) && v->info() < w->info() && // once for both of its faces
            w->info() < m_number_outside && is_taken(v->info(), w->info()))
          middles.push_back(CGAL::midpoint(v->point(), w->point()));
      }
    return middles;
  }

  Triangulation m_triangulation;
  Triangles_between m_result;
  std::size_t m_number_outside, m_number_of_points = 0;
};

} // namespace CGAL::Protrusion_segmentation::internal::connectors

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CLOSING_CONNECTORS_TRIANGULATION_BETWEEN_H
