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
#include <iterator>
#include <optional>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>

namespace CGAL::Protrusion_segmentation::internal {

// What the arguments of the public functions mean, and whether they are of the right kind.

template <typename FaceGraph>
using Face_of = typename boost::graph_traits<FaceGraph>::face_descriptor;

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

// A number that a user gave as an integer of any type. A negative one would become a huge one.
template <typename Integer>
std::size_t checked_count(const char* name, Integer value)
{
  static_assert(std::is_integral<Integer>::value && !std::is_same<Integer, bool>::value,
                "a number of segments, tips or iterations must be an integer");
  if constexpr (std::is_signed<Integer>::value)
    if (value < 0)
      throw std::invalid_argument(std::string(name) + " is " + std::to_string(value) +
                                  ", but it must be at least 0");
  return static_cast<std::size_t>(value);
}

// The same from `least` to the number of faces.
template <typename Integer, typename FaceGraph>
std::size_t checked_count(const char* name, Integer value, Integer least, const FaceGraph& mesh)
{
  const auto number_of_faces = static_cast<std::size_t>(
    std::distance(faces(mesh).begin(), faces(mesh).end()));
  if (value < least || checked_count(name, value) > number_of_faces)
    throw std::invalid_argument(std::string(name) + " is " + std::to_string(value) +
                                ", but it must be from " + std::to_string(least) + " to " +
                                std::to_string(number_of_faces) + ", the number of faces of pmesh");
  return static_cast<std::size_t>(value);
}

// Whether a type is one of the methods.
template <typename Method, typename = void>
struct Is_method : std::false_type
{};
template <typename Method>
struct Is_method<
  Method,
  std::void_t<decltype(std::declval<const Method&>().segment(std::declval<const Indexed_surface&>(),
                                                             std::optional<std::size_t>(),
                                                             std::declval<Execution&>()))>>
  : std::true_type
{};

template <typename Number>
using If_number = std::enable_if_t<std::is_integral<Number>::value, int>;
template <typename Method>
using If_method = std::enable_if_t<Is_method<Method>::value, int>;

// Boost's `graph_traits` of what is no graph fail inside.
template <typename FaceGraph, typename = void>
struct Is_mesh : std::false_type
{};
template <typename FaceGraph>
struct Is_mesh<FaceGraph, std::void_t<decltype(faces(std::declval<const FaceGraph&>()))>> : std::true_type
{};

// Each of the checks fails with one sentence; the value is for `if constexpr`, so that no further errors bury it.
template <typename FaceGraph>
struct Check_mesh : Is_mesh<FaceGraph>
{
  static_assert(Check_mesh::value, "pmesh is no model of FaceListGraph and HalfedgeGraph");
};

// Boost's `put()` takes keys of any type, and fails inside.
template <typename Map, typename Key, typename = void>
struct Is_writable_map : std::false_type
{};
template <typename Map, typename Key>
struct Is_writable_map<
  Map,
  Key,
  std::void_t<typename boost::property_traits<Map>::category,
              decltype(put(std::declval<Map&>(),
                           std::declval<const Key&>(),
                           std::declval<typename boost::property_traits<Map>::value_type>()))>>
  : std::is_convertible<Key, typename boost::property_traits<Map>::key_type>
{};

template <typename FaceGraph, typename SegmentMap, typename = void>
struct Is_segment_map : std::false_type
{};
template <typename FaceGraph, typename SegmentMap>
struct Is_segment_map<
  FaceGraph,
  SegmentMap,
  std::enable_if_t<
    Is_writable_map<SegmentMap, typename boost::graph_traits<FaceGraph>::face_descriptor>::value>>
  : std::is_integral<typename boost::property_traits<SegmentMap>::value_type>
{};

template <typename FaceGraph, typename SegmentMap>
struct Check_segment_map : Is_segment_map<FaceGraph, SegmentMap>
{
  static_assert(Check_segment_map::value,
                "segment_ids is no writable property map from the faces of the mesh to an integer type");
};

template <typename FaceGraph, typename FaceRange, typename = void>
struct Is_face_range : std::false_type
{};
template <typename FaceGraph, typename FaceRange>
struct Is_face_range<FaceGraph,
                     FaceRange,
                     std::void_t<decltype(*std::begin(std::declval<const FaceRange&>()))>>
  : std::is_convertible<decltype(*std::begin(std::declval<const FaceRange&>())),
                        typename boost::graph_traits<FaceGraph>::face_descriptor>
{};

template <typename FaceGraph, typename FaceRange>
struct Check_tips : Is_face_range<FaceGraph, FaceRange>
{
  static_assert(Check_tips::value, "tips is no range of faces of the mesh");
};

// Whether a type has all functions of a visitor.
template <typename Visitor, typename Face>
auto is_visitor(Visitor& v, Face f) -> decltype(v.on_reading_begin(),
                                                v.on_reading_end(),
                                                v.on_preparation_begin(),
                                                v.on_preparation_end(),
                                                v.on_tips_begin(),
                                                v.on_tips_end(),
                                                v.on_borders_begin(),
                                                v.on_borders_end(),
                                                v.on_labels_begin(),
                                                v.on_labels_end(),
                                                v.on_progress(0.),
                                                static_cast<bool>(v.go_further()),
                                                v.on_distances(std::size_t(0)),
                                                v.on_small_components(std::size_t(0)),
                                                v.on_tip(f),
                                                v.on_eliminated_tip(f),
                                                v.on_protrusion(Protrusion<Face>()),
                                                std::true_type());
std::false_type is_visitor(...);

template <typename T>
T& unwrapped(const std::reference_wrapper<T>&);
template <typename T>
T& unwrapped(const T&);

// The type of the visitor among the named parameters.
template <typename FaceGraph, typename NamedParameters>
using Visitor_type = decltype(unwrapped(
  std::declval<typename internal_np::Lookup_named_param_def<internal_np::visitor_t,
                                                            NamedParameters,
                                                            Segmentation_visitor<FaceGraph>>::type>()));

template <typename FaceGraph, typename NamedParameters>
struct Check_visitor : decltype(is_visitor(std::declval<Visitor_type<FaceGraph, NamedParameters>>(),
                                           std::declval<Face_of<FaceGraph>>()))
{
  static_assert(Check_visitor::value,
                "the visitor is no model of ProtrusionSegmentationVisitor: derive it from "
                "Protrusion_segmentation::Segmentation_visitor of the mesh type");
};

// The type of the map of the named parameter `edge_is_constrained_map`.
template <typename NamedParameters>
using Edge_map =
  std::decay_t<typename internal_np::Lookup_named_param_def<internal_np::edge_is_constrained_t,
                                                            NamedParameters,
                                                            internal_np::Param_not_found>::type>;

template <typename NamedParameters>
constexpr bool has_edge_map = !std::is_same_v<Edge_map<NamedParameters>, internal_np::Param_not_found>;

template <typename FaceGraph, typename NamedParameters>
struct Check_edge_map
  : std::bool_constant<!has_edge_map<NamedParameters> ||
                       Is_writable_map<Edge_map<NamedParameters>,
                                       typename boost::graph_traits<FaceGraph>::edge_descriptor>::value>
{
  static_assert(Check_edge_map::value,
                "edge_is_constrained_map is no writable property map from the edges of the mesh to bool");
};

template <typename NamedParameters>
struct Check_no_edge_map : std::bool_constant<!has_edge_map<NamedParameters>>
{
  static_assert(
    Check_no_edge_map::value,
    "edge_is_constrained_map has no meaning here: only functions that write segments mark their borders");
};

} // namespace CGAL::Protrusion_segmentation::internal

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_MESH_NAMED_PARAMETERS_H
