// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_SEGMENTS_NESTED_SEGMENTS_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_SEGMENTS_NESTED_SEGMENTS_H

#include <CGAL/Protrusion_segmentation/Indexed_surface.h>
#include <CGAL/Protrusion_segmentation/internal/Surface/Index_groups.h>
#include <CGAL/Protrusion_segmentation/internal/Surface/connected_faces.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL::Protrusion_segmentation::internal {

// The segments of a surface and where each was cut from.
//
// The bodies of the connected components come first, the largest component first. Every other segment sticks out of its parent. The segmentation
// into any smaller number of segments is found by giving the faces of the last segments back: each to the nearest
// ancestor that is left.
class Nested_segments
{
public:
  using Index = Indexed_surface::Index;
  using Faces = std::vector<Index>;

  Nested_segments() = default;

  explicit Nested_segments(const Indexed_surface& surface)
  {
    Label_components components = label_components(surface, std::vector<Index>(surface.number_of_faces(), 0));
    const std::vector<Index> rank = ranks_by_area(components.area);
    for (Index& component : components.component)
      component = rank[component];
    m_labels = std::move(components.component);
    m_number_of_components = rank.size();
    m_parents.resize(rank.size());
    std::iota(m_parents.begin(), m_parents.end(), Index(0));
    collect_faces();
  }

  // `labels`: the segment of every face; `parents`: of every segment, the bodies first, which are their own
  Nested_segments(std::vector<Index> labels, std::vector<Index> parents, std::size_t number_of_components)
    : m_labels(std::move(labels)),
      m_parents(std::move(parents)),
      m_number_of_components(number_of_components)
  {
    collect_faces();
  }

  std::size_t number_of_components() const { return m_number_of_components; }
  std::size_t number_of_segments() const { return m_parents.size(); }
  // of a segment; that of a connected component is the segment itself
  Index parent(std::size_t segment) const { return m_parents[segment]; }
  // the segment of every face
  const std::vector<Index>& labels() const { return m_labels; }
  // the faces of a segment, ascending
  const Faces& faces(std::size_t segment) const { return m_faces[segment]; }

  // whether a face lies beside a face of another segment
  bool is_on_border(const Indexed_surface& surface, Index face) const
  {
    for (Index c = surface.first_corner(face); c < surface.first_corner(face + 1); ++c)
      if (const Index g = surface.neighbor(c); g != Indexed_surface::no_face() && m_labels[g] != m_labels[face])
        return true;
    return false;
  }

  double area(const Indexed_surface& surface, std::size_t segment) const
  {
    double sum = 0;
    for (Index f : m_faces[segment])
      sum += surface.area(f);
    return sum;
  }

  // Makes some faces of a segment, ascending, but not all, a protrusion of it, a segment of their own; returns its id.
  Index cut_off(Index segment, Faces protrusion)
  {
    const Index id = static_cast<Index>(m_parents.size());
    Faces& faces = m_faces[segment];
    Faces rest;
    rest.reserve(faces.size());
    std::set_difference(faces.begin(), faces.end(), protrusion.begin(), protrusion.end(), std::back_inserter(rest));
    CGAL_precondition(!protrusion.empty() && !rest.empty() && rest.size() + protrusion.size() == faces.size());
    faces = std::move(rest);
    for (Index f : protrusion)
      m_labels[f] = id;
    m_parents.push_back(segment);
    m_faces.push_back(std::move(protrusion));
    return id;
  }

private:
  // The largest area has rank 0. Areas that are the same in single precision, as those of copies are, stay in their order.
  static std::vector<Index> ranks_by_area(const std::vector<double>& areas)
  {
    std::vector<Index> order(areas.size()), ranks(areas.size());
    std::iota(order.begin(), order.end(), Index(0));
    std::stable_sort(order.begin(), order.end(),
                     [&](Index a, Index b) { return static_cast<float>(areas[a]) > static_cast<float>(areas[b]); });
    for (Index rank = 0; rank < order.size(); ++rank)
      ranks[order[rank]] = rank;
    return ranks;
  }

  void collect_faces()
  {
    const Index_groups faces(m_labels, m_parents.size());
    for (Index s = 0; s < faces.number_of_groups(); ++s)
      m_faces.emplace_back(faces[s].begin(), faces[s].end());
  }

  std::vector<Index> m_labels;
  std::vector<Index> m_parents;
  std::vector<Faces> m_faces;
  std::size_t m_number_of_components = 0;
};

} // namespace CGAL::Protrusion_segmentation::internal

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_SEGMENTS_NESTED_SEGMENTS_H
