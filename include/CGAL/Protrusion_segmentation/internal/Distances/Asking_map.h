// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_DISTANCES_ASKING_MAP_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_DISTANCES_ASKING_MAP_H

#include <CGAL/Protrusion_segmentation/Execution.h>

#include <boost/property_map/property_map.hpp>

#include <cstddef>

namespace CGAL {
namespace Protrusion_segmentation {
namespace internal {

// A property map of a mesh that asks, each time that some more values were looked up, whether to go on: for algorithms
// of CGAL that compute for seconds and have no visitor.
template <typename Map>
class Asking_map
{
public:
  using key_type = typename boost::property_traits<Map>::key_type;
  using value_type = typename boost::property_traits<Map>::value_type;
  using reference = typename boost::property_traits<Map>::reference;
  using category = boost::readable_property_map_tag;

  Asking_map(Map map, Execution& execution) : m_map(map), m_execution(&execution) {}

  friend reference get(const Asking_map& map, const key_type& key)
  {
    constexpr std::size_t values_between_questions = 1 << 13;
    if (++map.m_number_of_values % values_between_questions == 0)
      map.m_execution->check();
    return get(map.m_map, key);
  }

private:
  Map m_map;
  Execution* m_execution;
  mutable std::size_t m_number_of_values = 0;
};

} // namespace internal
} // namespace Protrusion_segmentation
} // namespace CGAL

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_DISTANCES_ASKING_MAP_H
