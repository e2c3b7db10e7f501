// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_DISTANCES_DUAL_ARCS_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_DISTANCES_DUAL_ARCS_H

#include <CGAL/Protrusion_segmentation/Indexed_surface.h>
#include <CGAL/Protrusion_segmentation/internal/Execution/for_each_block.h>

#include <boost/range/iterator_range.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <vector>

namespace CGAL {
namespace Protrusion_segmentation {
namespace internal {

// The face dual graph as shortest paths read it: what is known of an arc lies in one place.
//
// If all faces are triangles, each has three places for them, so that neither where they begin nor how many there
// are must be looked up, and a loop over them is none: the paper's method takes 5 % less time with twenty thousand faces, and
// a tenth with a million. A place without an arc leads from the face to itself, which shortens no path.
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
  using Three_arcs = std::array<Arc, 3>;

  explicit Dual_arcs(const Indexed_surface& surface, bool is_parallel = false)
  {
    add_faces(surface.number_of_faces(), surface.has_triangles_only(), surface.number_of_corners(), is_parallel,
              [&](Index f, auto add)
              {
                const Indexed_surface::Point_3 centroid = surface.centroid(f);
                for (Index c = surface.first_corner(f); c < surface.first_corner(f + 1); ++c)
                  if (const Index g = surface.neighbor(c); g != Indexed_surface::no_face() && g != f)
                    add(Arc(g, std::sqrt(squared_distance(centroid, surface.centroid(g)))));
              });
  }

  // The arcs between some faces, where `numbers` has the place of each among them, or else `no_face()`.
  Dual_arcs(const Dual_arcs& all, const std::vector<Index>& faces, const std::vector<Index>& numbers)
  {
    add_faces(static_cast<Index>(faces.size()), all.has_three_places(), 3 * faces.size(), false,
              [&](Index i, auto add)
              {
                for (const Arc& arc : all[faces[i]])
                  if (const Index number = numbers[arc.target()]; number != Indexed_surface::no_face())
                    add(Arc(number, arc.length()));
              });
  }

  Index number_of_faces() const
  {
    return static_cast<Index>(has_three_places() ? m_three_places.size() : m_first.size() - 1);
  }
  boost::iterator_range<const Arc*> operator[](Index face) const
  {
    if (!has_three_places())
      return any_places()[face];
    const Three_arcs& places = m_three_places[face];
    return {places.begin(), std::find_if(places.begin(), places.end(), [=](const Arc& arc) { return arc.target() == face; })};
  }

  // For loops that know which it is: the places of the arcs of a face by its number, to be copied.
  bool has_three_places() const { return m_first.empty(); }
  const Three_arcs* three_places() const { return m_three_places.data(); }

  class Any_places
  {
  public:
    Any_places(const Index* first, const Arc* arcs) : m_first(first), m_arcs(arcs) {}
    boost::iterator_range<const Arc*> operator[](Index face) const
    {
      return {m_arcs + m_first[face], m_arcs + m_first[face + 1]};
    }

  private:
    const Index* m_first;
    const Arc* m_arcs;
  };
  Any_places any_places() const { return {m_first.data(), m_arcs.data()}; }

  // The same as a graph of Boost's.
  Indexed_surface::Dual_graph graph() const
  {
    std::vector<Index> sources, targets;
    std::vector<Indexed_surface::Arc> properties;
    for (Index f = 0; f < number_of_faces(); ++f)
      for (const Arc& arc : (*this)[f])
      {
        sources.push_back(f);
        targets.push_back(arc.target());
        properties.push_back({arc.length()});
      }
    return Indexed_surface::Dual_graph(boost::construct_inplace_from_sources_and_targets, sources, targets, properties,
                                       number_of_faces());
  }

private:
  // `for_each_arc(f, add)` calls `add(arc)` for every arc of a face.
  template <typename ForEachArc>
  void add_faces(Index number_of_faces, bool three_places, std::size_t most_arcs, bool is_parallel, ForEachArc for_each_arc)
  {
    if (three_places)
      return fill_three_places(number_of_faces, is_parallel, for_each_arc);
    m_first.reserve(number_of_faces + std::size_t(1));
    m_first.push_back(0);
    m_arcs.reserve(most_arcs);
    for (Index f = 0; f < number_of_faces; ++f)
    {
      for_each_arc(f, [this](const Arc& arc) { m_arcs.push_back(arc); });
      m_first.push_back(static_cast<Index>(m_arcs.size()));
    }
  }

  template <typename ForEachArc>
  void fill_three_places(Index number_of_faces, bool is_parallel, ForEachArc for_each_arc)
  {
    const auto all = [](const Arc& arc) { return Three_arcs{arc, arc, arc}; };
    m_three_places.resize(number_of_faces, all(Arc(0, 0)));
    for_each_block(number_of_faces, is_parallel,
                   [&](std::size_t begin, std::size_t end, std::size_t)
                   {
                     for (Index f = static_cast<Index>(begin); f < end; ++f)
                     {
                       m_three_places[f] = all(Arc(f, 0));
                       auto place = m_three_places[f].begin();
                       for_each_arc(f, [&](const Arc& arc) { *place++ = arc; });
                     }
                   });
  }

  std::vector<Three_arcs> m_three_places;
  std::vector<Index> m_first; // in m_arcs of every face, and the end; empty if there are three places for each
  std::vector<Arc> m_arcs;
};

} // namespace internal
} // namespace Protrusion_segmentation
} // namespace CGAL

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_DISTANCES_DUAL_ARCS_H
