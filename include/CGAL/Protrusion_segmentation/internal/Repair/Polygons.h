// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_REPAIR_POLYGONS_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_REPAIR_POLYGONS_H

#include <boost/iterator/counting_iterator.hpp>
#include <boost/iterator/transform_iterator.hpp>
#include <boost/range/iterator_range.hpp>

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <limits>
#include <stdexcept>
#include <vector>

namespace CGAL::Protrusion_segmentation::internal {

// Polygons of any number of corners in a row; the corners of all of them are numbered in a row, too. A range of ranges: a vector of
// vectors would take three times the memory.
class Polygons
{
public:
  using Index = std::uint32_t;
  using Corners = boost::iterator_range<const Index*>;

  std::size_t size() const { return m_first.size() - 1; }
  bool empty() const { return size() == 0; }
  const std::vector<Index>& corners() const { return m_corners; } // of all
  std::size_t number_of_corners() const { return m_corners.size(); }
  std::size_t first_corner(std::size_t polygon) const { return m_first[polygon]; }
  std::size_t corner(std::size_t number) const { return m_corners[number]; }
  Corners operator[](std::size_t polygon) const
  {
    return {m_corners.data() + m_first[polygon], m_corners.data() + m_first[polygon + 1]};
  }
  auto begin() const { return iterator_at(0); }
  auto end() const { return iterator_at(size()); }

  void reserve(std::size_t polygons, std::size_t corners)
  {
    m_first.reserve(polygons + 1);
    m_corners.reserve(corners);
  }
  template <typename Range>
  void add(const Range& corners)
  {
    for (const auto corner : corners)
      m_corners.push_back(static_cast<Index>(corner));
    if (m_corners.size() > (std::numeric_limits<Index>::max)())
      throw std::length_error("more than 4294967295 corners");
    m_first.push_back(static_cast<Index>(m_corners.size()));
  }
  void add(std::initializer_list<std::size_t> corners) { add<std::initializer_list<std::size_t>>(corners); }

private:
  struct Corners_of
  {
    const Polygons* polygons;
    Corners operator()(std::size_t polygon) const { return (*polygons)[polygon]; }
  };

  boost::transform_iterator<Corners_of, boost::counting_iterator<std::size_t>> iterator_at(std::size_t polygon) const
  {
    return {boost::counting_iterator<std::size_t>(polygon), Corners_of{this}};
  }

  std::vector<Index> m_first = {0}; // of every polygon, and the end
  std::vector<Index> m_corners;
};

} // namespace CGAL::Protrusion_segmentation::internal

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_REPAIR_POLYGONS_H
