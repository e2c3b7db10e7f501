// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_MESH_NAMED_PARAMETERS_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_MESH_NAMED_PARAMETERS_H

#include <CGAL/Protrusion_segmentation/Execution.h>
#include <CGAL/Protrusion_segmentation/Indexed_surface.h>
#include <CGAL/Protrusion_segmentation/Segmentation_visitor.h>

#include <CGAL/Named_function_parameters.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <functional>
#include <optional>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace Protrusion_segmentation {
namespace internal {

// What the arguments of the public functions mean, and whether they are of the right kind.

template <typename NamedParameters>
unsigned int random_seed(const NamedParameters& np)
{
  return static_cast<unsigned int>(
    parameters::choose_parameter(parameters::get_parameter(np, internal_np::random_seed), 0u));
}

template <typename Visitor>
Visitor& unwrap(Visitor& visitor)
{
  return visitor;
}
template <typename Visitor>
Visitor& unwrap(std::reference_wrapper<Visitor>& visitor)
{
  return visitor.get();
}

// A count that a user gave as an integer of any type. A negative one would become a huge one.
template <typename Integer>
std::size_t checked_count(const char* name, Integer value)
{
  static_assert(std::is_integral<Integer>::value && !std::is_same<Integer, bool>::value,
                "a number of segments or tips must be an integer");
  if constexpr (std::is_signed<Integer>::value)
    if (value < 0)
      throw std::invalid_argument(std::string(name) + " is " + std::to_string(value));
  return static_cast<std::size_t>(value);
}

// Whether a type is one of the methods.
template <typename Method, typename = void>
struct Is_method : std::false_type {};
template <typename Method>
struct Is_method<Method,
                 std::void_t<decltype(std::declval<const Method&>().segment(
                   std::declval<const Indexed_surface&>(), std::optional<std::size_t>(), std::declval<Execution&>()))>>
  : std::true_type {};

template <typename Number>
using If_number = std::enable_if_t<std::is_integral<Number>::value, int>;
template <typename Method>
using If_method = std::enable_if_t<Is_method<Method>::value, int>;

// Boost's `put()` takes keys of any type, and fails inside.
template <typename Map, typename Key, typename = void>
struct Is_map_of_ids : std::false_type {};
template <typename Map, typename Key>
struct Is_map_of_ids<Map, Key,
                     std::void_t<typename boost::property_traits<Map>::category,
                                 decltype(put(std::declval<Map&>(), std::declval<const Key&>(),
                                              std::declval<typename boost::property_traits<Map>::value_type>()))>>
  : std::bool_constant<std::is_convertible<Key, typename boost::property_traits<Map>::key_type>::value &&
                       std::is_convertible<std::size_t, typename boost::property_traits<Map>::value_type>::value>
{};

template <typename FaceGraph, typename SegmentMap>
constexpr void check_segment_map()
{
  static_assert(
    Is_map_of_ids<SegmentMap, typename boost::graph_traits<FaceGraph>::face_descriptor>::value,
    "segment_ids is no writable property map from the faces of the mesh to std::size_t");
}

template <typename FaceGraph, typename Visitor>
constexpr void check_visitor()
{
  static_assert(std::is_base_of<Segmentation_visitor<FaceGraph>, Visitor>::value,
                "the visitor does not derive from Protrusion_segmentation::Segmentation_visitor of the mesh type");
}

} // namespace internal
} // namespace Protrusion_segmentation
} // namespace CGAL

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_MESH_NAMED_PARAMETERS_H
