// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_SEGMENT_MESH_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_SEGMENT_MESH_H

#include <CGAL/Protrusion_segmentation/Execution.h>
#include <CGAL/Protrusion_segmentation/Indexed_surface.h>
#include <CGAL/Protrusion_segmentation/Segment_hierarchy.h>
#include <CGAL/Protrusion_segmentation/internal/Execution/for_each_index.h>
#include <CGAL/Protrusion_segmentation/internal/Mesh/Mesh_observer.h>
#include <CGAL/Protrusion_segmentation/internal/Mesh/named_parameters.h>
#include <CGAL/Protrusion_segmentation/internal/Mesh/read_surface.h>
#include <CGAL/Protrusion_segmentation/internal/Mesh/write_segments.h>
#include <CGAL/Protrusion_segmentation/internal/Segments/Nested_segments.h>
#include <CGAL/Protrusion_segmentation/internal/Surface/Canonical_surface.h>
#include <CGAL/Protrusion_segmentation/internal/Surface/Surface_without_small_components.h>
#include <CGAL/Protrusion_segmentation/internal/Tips/select_protrusion_tips.h>

#include <CGAL/Named_function_parameters.h>

#include <cstddef>
#include <map>
#include <optional>
#include <stdexcept>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Protrusion_segmentation::internal {

// The way of the data, the same for all public functions: the mesh becomes index arrays, these get their canonical
// order, a method makes segments of them, and these go back to the mesh.

// Whether the arguments of a call are right; if not, a `static_assert` says why in one sentence.
template <typename FaceGraph, typename SegmentMap, typename NamedParameters>
constexpr bool writes_segments = std::conjunction_v<Check_mesh<FaceGraph>,
                                                    Check_segment_map<FaceGraph, SegmentMap>,
                                                    Check_edge_map<FaceGraph, NamedParameters>,
                                                    Check_visitor<FaceGraph, NamedParameters>>;
template <typename FaceGraph, typename NamedParameters>
constexpr bool writes_no_segments = std::conjunction_v<Check_mesh<FaceGraph>,
                                                       Check_no_edge_map<NamedParameters>,
                                                       Check_visitor<FaceGraph, NamedParameters>>;

// The result of `run(surface, execution)` on the arrays of a mesh.
template <typename ConcurrencyTag, typename FaceGraph, typename NamedParameters, typename Run>
auto run_on_mesh(const FaceGraph& mesh, const NamedParameters& np, Run run)
{
  auto visitor_parameter = parameters::choose_parameter(
    parameters::get_parameter(np, internal_np::visitor), Segmentation_visitor<FaceGraph>());
  auto& visitor = unwrap(visitor_parameter);
  using Visitor = std::remove_reference_t<decltype(visitor)>;
  Mesh_observer<FaceGraph, Visitor> observer(mesh, visitor);
  Execution execution(observer, random_seed(np), is_parallel<ConcurrencyTag>());
  std::optional<Canonical_surface> surface;
  {
    const Stage_scope stage(observer, Stage::READING);
    Surface_without_small_components rest = leave_out_small_components(read_arrays(mesh, np, execution.is_parallel()));
    if (rest.number_of_small_components > 0)
      observer.small_components_left_out(rest.number_of_small_components);
    execution.check();
    surface.emplace(std::move(rest), execution.is_parallel());
  }
  observer.set_surface(*surface);
  execution.check();
  auto result = run(*surface, execution);
  execution.progress(1);
  return result;
}

// The segments of a mesh; `labels` is in its order.
struct Mesh_segments
{
  Nested_segments segments; // none if there is no face
  std::vector<Indexed_surface::Index> labels;
};

// Runs a method: `segment(surface, execution)` on index arrays.
template <typename ConcurrencyTag, typename FaceGraph, typename NamedParameters, typename Segment>
Mesh_segments segments_of_mesh(const FaceGraph& mesh, const NamedParameters& np, Segment segment)
{
  return run_on_mesh<ConcurrencyTag>(mesh, np,
                                     [&](const Canonical_surface& surface, Execution& execution)
                                     {
                                       Mesh_segments result;
                                       if (surface.surface().number_of_faces() > 0)
                                         result.segments = segment(surface, execution);
                                       result.labels = surface.in_order_of_mesh(result.segments.labels());
                                       return result;
                                     });
}

template <typename ConcurrencyTag, typename FaceGraph, typename Method, typename NamedParameters>
Mesh_segments segment_by_number(const FaceGraph& mesh,
                                std::optional<std::size_t> number_of_segments,
                                const Method& method,
                                const NamedParameters& np)
{
  return segments_of_mesh<ConcurrencyTag>(
    mesh, np,
    [&](const Canonical_surface& surface, Execution& execution)
    { return method.segment(surface.surface(), number_of_segments, execution); });
}

// Writes the results; returns the number of segments.
template <typename FaceGraph, typename SegmentMap, typename NamedParameters>
std::size_t write_results(const FaceGraph& mesh,
                          const Mesh_segments& result,
                          SegmentMap& segment_ids,
                          const NamedParameters& np)
{
  write_segments(mesh, result.labels, segment_ids);
  write_borders(mesh, result.labels, np);
  return result.segments.number_of_segments();
}

// `number_of_segments` is an integer or `std::nullopt`.
template <typename ConcurrencyTag,
          typename FaceGraph,
          typename SegmentMap,
          typename Number,
          typename Method,
          typename NamedParameters>
std::size_t segment_mesh(const FaceGraph& mesh,
                         SegmentMap segment_ids,
                         Number number_of_segments,
                         const Method& method,
                         const NamedParameters& np)
{
  if constexpr (writes_segments<FaceGraph, SegmentMap, NamedParameters>)
  {
    std::optional<std::size_t> number;
    if constexpr (!std::is_same_v<Number, std::nullopt_t>)
      number = checked_count("number_of_segments", number_of_segments, Number(1), mesh);
    return write_results(mesh, segment_by_number<ConcurrencyTag>(mesh, number, method, np), segment_ids,
                         np);
  }
  else
    return 0;
}

// The positions of the given faces in the order of `faces(mesh)`.
template <typename FaceGraph, typename FaceRange>
std::vector<Indexed_surface::Index> face_numbers(const FaceGraph& mesh, const FaceRange& range)
{
  using Index = Indexed_surface::Index;
  std::map<Face_of<FaceGraph>, Index> numbers;
  for (const auto f : range)
    numbers[f] = Indexed_surface::no_face();
  Index i = 0;
  for (const auto f : faces(mesh))
  {
    const auto found = numbers.find(f);
    if (found != numbers.end())
      found->second = i;
    ++i;
  }
  std::vector<Index> result;
  for (const auto f : range)
  {
    if (numbers[f] == Indexed_surface::no_face())
      throw std::invalid_argument("tips: a face is not in pmesh");
    result.push_back(numbers[f]);
  }
  return result;
}

template <typename ConcurrencyTag,
          typename FaceGraph,
          typename FaceRange,
          typename SegmentMap,
          typename Method,
          typename NamedParameters>
std::size_t segment_mesh_from_tips(const FaceGraph& mesh,
                                   const FaceRange& tips,
                                   SegmentMap segment_ids,
                                   const Method& method,
                                   const NamedParameters& np)
{
  if constexpr (writes_segments<FaceGraph, SegmentMap, NamedParameters>)
    if constexpr (Check_tips<FaceGraph, FaceRange>::value)
    {
      const std::vector<Indexed_surface::Index> numbers = face_numbers(mesh, tips);
      const Mesh_segments result = segments_of_mesh<ConcurrencyTag>(
        mesh, np,
        [&](const Canonical_surface& surface, Execution& execution)
        { return method.segment_from_tips(surface.surface(), surface.faces_at(numbers), execution); });
      return write_results(mesh, result, segment_ids, np);
    }
  return 0;
}

template <typename ConcurrencyTag,
          typename FaceGraph,
          typename Number,
          typename Method,
          typename NamedParameters>
Segment_hierarchy mesh_hierarchy(const FaceGraph& mesh,
                                 Number maximum_number_of_segments,
                                 const Method& method,
                                 const NamedParameters& np)
{
  if constexpr (writes_no_segments<FaceGraph, NamedParameters>)
  {
    const std::size_t number = checked_count("maximum_number_of_segments", maximum_number_of_segments,
                                             Number(1), mesh);
    Mesh_segments result = segment_by_number<ConcurrencyTag>(mesh, number, method, np);
    return Segment_hierarchy(result.segments, std::move(result.labels));
  }
  else
    return {};
}

template <typename ConcurrencyTag,
          typename FaceGraph,
          typename Number,
          typename OutputIterator,
          typename Distance,
          typename NamedParameters>
OutputIterator select_mesh_tips(const FaceGraph& mesh,
                                Number number_of_tips,
                                OutputIterator tips,
                                const Distance& distance,
                                const NamedParameters& np)
{
  if constexpr (writes_no_segments<FaceGraph, NamedParameters>)
  {
    const std::size_t number = checked_count("number_of_tips", number_of_tips, Number(0), mesh);
    const std::vector<Face_of<FaceGraph>> descriptors(faces(mesh).begin(), faces(mesh).end());
    const Any_distance any_distance(distance);
    const std::vector<Indexed_surface::Index> positions = run_on_mesh<ConcurrencyTag>(
      mesh, np,
      [&](const Canonical_surface& surface, Execution& execution)
      {
        std::vector<Indexed_surface::Index> result = select_tips_of_components(
          surface.surface(), any_distance, number, execution);
        for (Indexed_surface::Index& tip : result)
          tip = surface.positions()[tip];
        return result;
      });
    for (const Indexed_surface::Index p : positions)
      *tips++ = descriptors[p];
  }
  return tips;
}

} // namespace CGAL::Protrusion_segmentation::internal

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_SEGMENT_MESH_H
