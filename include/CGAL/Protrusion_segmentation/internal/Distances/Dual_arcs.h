// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_DISTANCES_DUAL_ARCS_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_DISTANCES_DUAL_ARCS_H

#include <CGAL/Protrusion_segmentation/Indexed_surface.h>

#include <boost/range/iterator_range.hpp>

#include <cmath>
#include <cstddef>
#include <cstring>
#include <vector>

namespace CGAL::Protrusion_segmentation::internal {

// The face dual graph as shortest paths read it: target and length of an arc lie side by side.
class Dual_arcs
{
public:
  using Index = Indexed_surface::Index;

  // 12 bytes, without a gap between the target and the length.
  class Arc
  {
  public:
    Arc(Index target, double length) : m_target(target) { std::memcpy(m_length, &length, sizeof(length)); }
    Index target() const { return m_target; }
    double length() const
    {
      double length;
      std::memcpy(&length, m_length, sizeof(length));
      return length;
    }

  private:
    Index m_target;
    Index m_length[2];
  };

  // The arcs of a face by its number. A view, to be copied into loops.
  class View
  {
  public:
    View(const Index* first, const Arc* arcs) : m_first(first), m_arcs(arcs) {}
    boost::iterator_range<const Arc*> operator[](Index face) const
    {
      return {m_arcs + m_first[face], m_arcs + m_first[face + 1]};
    }

  private:
    const Index* m_first;
    const Arc* m_arcs;
  };

  explicit Dual_arcs(const Indexed_surface& surface)
  {
    reserve(surface.number_of_faces(), surface.number_of_corners());
    for (Index f = 0; f < surface.number_of_faces(); ++f)
    {
      const Indexed_surface::Point_3 centroid = surface.centroid(f);
      for (Index c = surface.first_corner(f); c < surface.first_corner(f + 1); ++c)
        if (const Index g = surface.neighbor(c); g != Indexed_surface::no_face() && g != f)
          m_arcs.emplace_back(g, std::sqrt(squared_distance(centroid, surface.centroid(g))));
      m_first.push_back(static_cast<Index>(m_arcs.size()));
    }
  }

  // The arcs between some faces, where `numbers` has the place of each among them, or else `no_face()`.
  Dual_arcs(const Dual_arcs& all, const std::vector<Index>& faces, const std::vector<Index>& numbers)
  {
    reserve(faces.size(), 3 * faces.size());
    for (const Index face : faces)
    {
      for (const Arc& arc : all[face])
        if (const Index number = numbers[arc.target()]; number != Indexed_surface::no_face())
          m_arcs.emplace_back(number, arc.length());
      m_first.push_back(static_cast<Index>(m_arcs.size()));
    }
  }

  Index number_of_faces() const { return static_cast<Index>(m_first.size() - 1); }
  View view() const { return {m_first.data(), m_arcs.data()}; }
  boost::iterator_range<const Arc*> operator[](Index face) const { return view()[face]; }

private:
  void reserve(std::size_t number_of_faces, std::size_t number_of_arcs)
  {
    m_first.reserve(number_of_faces + 1);
    m_first.push_back(0);
    m_arcs.reserve(number_of_arcs);
  }

  std::vector<Index> m_first; // in m_arcs of every face, and the end
  std::vector<Arc> m_arcs;
};

} // namespace CGAL::Protrusion_segmentation::internal

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_DISTANCES_DUAL_ARCS_H
