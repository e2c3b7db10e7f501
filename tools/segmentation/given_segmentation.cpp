// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "segmentation/given_segmentation.h"

#include <CGAL/Protrusion_segmentation/internal/Metrics/face_areas.h>
#include <CGAL/Protrusion_segmentation/internal/Segments/Segment_tree.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <queue>
#include <utility>

namespace tool {
namespace {

namespace internal = CGAL::Protrusion_segmentation::internal;
using internal::Segment_tree;
using Index = Segment_tree::Index;
using Halfedge = Mesh::Halfedge_index;

std::vector<std::size_t> numbers_of(const std::vector<std::size_t>& labels)
{
  std::map<std::size_t, std::size_t> numbers;
  for (const std::size_t label : labels)
    numbers[label];
  std::size_t next = 0;
  for (auto& [label, number] : numbers)
    number = next++;
  std::vector<std::size_t> result;
  for (const std::size_t label : labels)
    result.push_back(numbers[label]);
  return result;
}

// Lengths are those of the mesh in a cube of size two, which are finite, until the protrusions are made.
class Given_segments
{
public:
  Given_segments(const Mesh& mesh,
                 const std::vector<std::size_t>& segments,
                 std::size_t number_of_segments)
    : m_mesh(mesh),
      m_segments(segments),
      m_number(number_of_segments),
      m_measures(internal::face_areas_and_centroids(mesh, mesh.points())),
      m_points(mesh.points().begin(), mesh.points().end()),
      m_areas(m_number, 0)
  {
    m_exponent = internal::scale_to_unit(m_points);
    for (const Face f : faces(mesh))
      m_areas[segments[f]] += m_measures[f].area;
    for (const Halfedge h : halfedges(mesh))
      if (is_border(h) && segment(h) < segment(mesh.opposite(h)))
        m_lengths[{Index(segment(h)), Index(segment(mesh.opposite(h)))}] += length(h);
  }

  // The largest first.
  std::vector<Protrusion> protrusions()
  {
    std::vector<bool> is_seen(m_number, false);
    for (Index s = 0; s < m_number; ++s)
      if (!is_seen[s])
        hang_up(connected_with(s, is_seen));
    std::sort(m_protrusions.begin(), m_protrusions.end(),
              [](const Protrusion& a, const Protrusion& b)
              { return std::make_pair(-a.area, a.segment) < std::make_pair(-b.area, b.segment); });
    find_tips();
    for (Protrusion& protrusion : m_protrusions)
    {
      protrusion.border_length = std::ldexp(border_length(protrusion.segment), m_exponent);
      protrusion.border_distance = std::ldexp(protrusion.border_distance, m_exponent);
      protrusion.area = std::ldexp(protrusion.area, 2 * m_exponent);
      protrusion.value = std::numeric_limits<double>::quiet_NaN();
    }
    return std::move(m_protrusions);
  }

private:
  std::size_t segment(Halfedge h) const { return m_segments[m_mesh.face(h)]; }

  bool is_border(Halfedge h) const
  {
    return !m_mesh.is_border(h) && !m_mesh.is_border(m_mesh.opposite(h)) &&
           segment(h) != segment(m_mesh.opposite(h));
  }

  double length(Halfedge h) const
  {
    return std::sqrt(CGAL::squared_distance(m_points[m_mesh.source(h)], m_points[m_mesh.target(h)]));
  }

  std::vector<Index> connected_with(Index first, std::vector<bool>& is_seen) const
  {
    std::vector<Index> result(1, first);
    is_seen[first] = true;
    for (std::size_t i = 0; i < result.size(); ++i)
      for (const auto& [border, length] : m_lengths)
        for (const auto& [s, t] : {border, std::make_pair(border.second, border.first)})
          if (s == result[i] && !is_seen[t])
          {
            is_seen[t] = true;
            result.push_back(t);
          }
    std::sort(result.begin(), result.end());
    return result;
  }

  void hang_up(const std::vector<Index>& segments)
  {
    std::vector<double> areas;
    std::map<Index, Index> place;
    for (const Index s : segments)
    {
      place[s] = Index(areas.size());
      areas.push_back(m_areas[s]);
    }
    Segment_tree::Lengths lengths;
    for (const auto& [border, length] : m_lengths)
      if (place.count(border.first) > 0)
        lengths[{place[border.first], place[border.second]}] = length;
    const Segment_tree tree(areas, lengths);
    for (Index i = 0; i < segments.size(); ++i)
      if (i != tree.body())
      {
        m_protrusions.emplace_back();
        m_protrusions.back().segment = segments[i];
        m_protrusions.back().parent = segments[tree.parent(i)];
        m_protrusions.back().area = tree.area_beyond(i);
      }
  }

  // All at once, by shortest paths over the centroids of faces that stay in their segments, from the borders to the parents.
  void find_tips()
  {
    std::vector<Protrusion*> protrusion_of(m_number, nullptr);
    for (Protrusion& protrusion : m_protrusions)
      protrusion_of[protrusion.segment] = &protrusion;
    using Offer = std::pair<double, Face>;
    std::priority_queue<Offer, std::vector<Offer>, std::greater<>> offers;
    for (const Halfedge h : halfedges(m_mesh))
      if (is_border(h) && protrusion_of[segment(h)] &&
          protrusion_of[segment(h)]->parent == segment(m_mesh.opposite(h)))
        offers.emplace(0, m_mesh.face(h));
    std::vector<bool> is_reached(m_segments.size(), false);
    while (!offers.empty())
    {
      const auto [distance, f] = offers.top();
      offers.pop();
      if (is_reached[f])
        continue;
      is_reached[f] = true;
      protrusion_of[m_segments[f]]->tip = f; // the last one is the farthest
      protrusion_of[m_segments[f]]->border_distance = distance;
      for (const Halfedge h : halfedges_around_face(m_mesh.halfedge(f), m_mesh))
        if (const Halfedge across = m_mesh.opposite(h);
            !m_mesh.is_border(across) && segment(across) == m_segments[f])
          offers.emplace(distance + std::sqrt(CGAL::squared_distance(
                                      m_measures[f].centroid, m_measures[m_mesh.face(across)].centroid)),
                         m_mesh.face(across));
    }
  }

  // between a segment with all that sticks out of it, and the rest
  double border_length(std::size_t segment) const
  {
    std::vector<std::size_t> parent(m_number, m_number);
    for (const Protrusion& protrusion : m_protrusions)
      parent[protrusion.segment] = protrusion.parent;
    const auto is_beyond = [&](std::size_t s)
    {
      while (s != segment && s != m_number)
        s = parent[s];
      return s == segment;
    };
    double sum = 0;
    for (const auto& [border, length] : m_lengths)
      if (is_beyond(border.first) != is_beyond(border.second))
        sum += length;
    return sum;
  }

  const Mesh& m_mesh;
  const std::vector<std::size_t>& m_segments; // of the faces
  std::size_t m_number;
  std::vector<internal::Polygon_measures> m_measures; // of the faces
  std::vector<Point> m_points;
  int m_exponent; // of the largest coordinate
  std::vector<double> m_areas;
  Segment_tree::Lengths m_lengths;
  std::vector<Protrusion> m_protrusions;
};

} // namespace

Segmentation given_segmentation(const Mesh& mesh, const std::vector<std::size_t>& labels)
{
  Segmentation result;
  result.segment_ids = numbers_of(labels);
  result.number_of_segments = 1 + *std::max_element(result.segment_ids.begin(), result.segment_ids.end());
  for (const Protrusion& protrusion :
       Given_segments(mesh, result.segment_ids, result.number_of_segments).protrusions())
    result.record.on_protrusion(protrusion);
  return result;
}

} // namespace tool
