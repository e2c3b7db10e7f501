// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_SEGMENT_MESH_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_SEGMENT_MESH_H

#include <CGAL/Protrusion_segmentation/Default_visitor.h>
#include <CGAL/Protrusion_segmentation/Segment_hierarchy.h>
#include <CGAL/Protrusion_segmentation/Indexed_surface.h>
#include <CGAL/Protrusion_segmentation/internal/Execution/Monitor.h>
#include <CGAL/Protrusion_segmentation/internal/Segments/Nested_segments.h>
#include <CGAL/Protrusion_segmentation/internal/Surface/canonical_order.h>
#include <CGAL/Protrusion_segmentation/internal/Surface/extract_segment.h>
#include <CGAL/Protrusion_segmentation/internal/Surface/read_surface.h>
#include <CGAL/Protrusion_segmentation/internal/Tips/select_protrusion_tips.h>

#include <CGAL/Named_function_parameters.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <iterator>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Protrusion_segmentation {
namespace internal {

// From meshes and named parameters to index arrays and back: what the public functions have in common.

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

inline void check_number_of_segments(std::size_t number_of_segments, std::size_t number_of_faces)
{
  if (number_of_segments == 0)
    throw std::invalid_argument("number_of_segments is 0");
  if (number_of_segments > number_of_faces)
    throw std::invalid_argument("number_of_segments is " + std::to_string(number_of_segments) +
                                ", but tmesh has only " + std::to_string(number_of_faces) + " faces");
}

template <typename FaceGraph, typename SegmentMap>
void write_segments(const FaceGraph& mesh,
                    const std::vector<Indexed_surface::Index>& labels,
                    SegmentMap& segment_ids)
{
  std::size_t i = 0;
  for (const auto f : faces(mesh))
    put(segment_ids, f, static_cast<std::size_t>(labels[i++]));
}

// Marks the edges between different segments, if the caller wants them.
template <typename FaceGraph, typename NamedParameters>
void write_borders(const FaceGraph& mesh,
                   const std::vector<Indexed_surface::Index>& labels,
                   const NamedParameters& np)
{
  using No_map = std::is_same<
    typename internal_np::Lookup_named_param_def<internal_np::edge_is_constrained_t, NamedParameters,
                                                 internal_np::Param_not_found>::type,
    internal_np::Param_not_found>;
  if constexpr (!No_map::value)
  {
    auto borders = parameters::get_parameter(np, internal_np::edge_is_constrained);
    auto label = get(CGAL::dynamic_face_property_t<Indexed_surface::Index>(), mesh);
    std::size_t i = 0;
    for (const auto f : faces(mesh))
      put(label, f, labels[i++]);
    const auto null_face = boost::graph_traits<FaceGraph>::null_face();
    for (const auto e : edges(mesh))
    {
      const auto f = face(halfedge(e, mesh), mesh);
      const auto g = face(opposite(halfedge(e, mesh), mesh), mesh);
      put(borders, e, f != null_face && g != null_face && get(label, f) != get(label, g));
    }
  }
}

// A mesh as index arrays, whose results do not depend on the order of its faces.
struct Canonical_surface
{
  using Index = Indexed_surface::Index;

  Indexed_surface part;
  std::vector<Index> position; // in `faces(mesh)` of every face of the part
  double unit;                               // what turns lengths back into those of the mesh

  template <typename FaceGraph, typename NamedParameters>
  Canonical_surface(const FaceGraph& mesh, const NamedParameters& np)
  {
    Arrays_of_mesh input = read_arrays(mesh, np);
    unit = input.unit;
    position = canonical_order(input.surface);
    Surface_arrays ordered = Face_selector<Surface_arrays>(input.surface)(position, [](Index) {});
    input.surface = {}; // before memory is needed for more
    part = std::move(ordered).to_part();
  }

  // The faces of the part for faces given by their positions.
  std::vector<Index> faces_at(const std::vector<Index>& positions) const
  {
    std::vector<Index> face(position.size()), result;
    for (Index f = 0; f < position.size(); ++f)
      face[position[f]] = f;
    for (Index p : positions)
      result.push_back(face[p]);
    return result;
  }

  // Values of the faces of the part in the order of the mesh.
  std::vector<Index> in_order_of_mesh(const std::vector<Index>& values) const
  {
    std::vector<Index> result(values.size());
    for (Index f = 0; f < values.size(); ++f)
      result[position[f]] = values[f];
    return result;
  }
};

// Runs `segment(surface, monitor)` on the arrays of a mesh; no result if the visitor stopped it or there is
// no face.
template <typename FaceGraph, typename NamedParameters, typename Segment>
std::optional<Nested_segments> run_on_mesh(const FaceGraph& mesh,
                                          const NamedParameters& np,
                                          Segment segment)
{
  auto visitor_parameter =
    parameters::choose_parameter(parameters::get_parameter(np, internal_np::visitor), Default_visitor());
  auto& visitor = unwrap(visitor_parameter);
  using Visitor = std::remove_reference_t<decltype(visitor)>;
  try
  {
    std::optional<Canonical_surface> surface;
    {
      const Stage_scope<Visitor> stage(visitor, Stage::READING);
      surface.emplace(mesh, np);
    }
    Monitor<Visitor> monitor(visitor, random_seed(np), surface->unit, surface->position);
    monitor.check();
    if (surface->part.number_of_faces() == 0)
      return std::nullopt;
    Nested_segments forest = segment(*surface, monitor);
    forest.labels = surface->in_order_of_mesh(forest.labels);
    monitor.progress(1, 1);
    return forest;
  }
  catch (const Cancelled&)
  {
    return std::nullopt;
  }
}

// Writes the results, if there are any; returns the number of segments.
template <typename FaceGraph, typename SegmentMap, typename NamedParameters>
std::size_t write_results(const FaceGraph& mesh,
                          const std::optional<Nested_segments>& forest,
                          SegmentMap& segment_ids,
                          const NamedParameters& np)
{
  if (!forest)
    return 0;
  write_segments(mesh, forest->labels, segment_ids);
  write_borders(mesh, forest->labels, np);
  return forest->number_of_segments();
}

template <typename FaceGraph, typename Distance, typename Border, typename NamedParameters>
std::optional<Nested_segments> forest_of_mesh(const FaceGraph& mesh,
                                             std::optional<std::size_t> number_of_segments,
                                             const Distance& distance,
                                             const Border& border,
                                             const NamedParameters& np)
{
  if (number_of_segments)
    check_number_of_segments(*number_of_segments,
                             std::distance(faces(mesh).begin(), faces(mesh).end()));
  return run_on_mesh(mesh, np, [&](const Canonical_surface& surface, auto& monitor)
                     { return border.segment(surface.part, distance, number_of_segments, monitor); });
}

template <typename FaceGraph,
          typename SegmentMap,
          typename Distance,
          typename Border,
          typename NamedParameters>
std::size_t segment_mesh(const FaceGraph& mesh,
                         SegmentMap segment_ids,
                         std::optional<std::size_t> number_of_segments,
                         const Distance& distance,
                         const Border& border,
                         const NamedParameters& np)
{
  return write_results(mesh, forest_of_mesh(mesh, number_of_segments, distance, border, np), segment_ids,
                       np);
}

template <typename FaceGraph, typename Distance, typename Border, typename NamedParameters>
Segment_hierarchy mesh_hierarchy(const FaceGraph& mesh,
                                 std::size_t maximum_number_of_segments,
                                 const Distance& distance,
                                 const Border& border,
                                 const NamedParameters& np)
{
  std::optional<Nested_segments> forest =
    forest_of_mesh(mesh, maximum_number_of_segments, distance, border, np);
  return forest ? Segment_hierarchy(std::move(*forest)) : Segment_hierarchy();
}

// The positions of the given faces in the order of `faces(mesh)`.
template <typename FaceGraph, typename FaceRange>
std::vector<Indexed_surface::Index> face_numbers(const FaceGraph& mesh, const FaceRange& range)
{
  using Index = Indexed_surface::Index;
  std::map<typename boost::graph_traits<FaceGraph>::face_descriptor, Index> numbers;
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
      throw std::invalid_argument("tips: a face is not in tmesh");
    result.push_back(numbers[f]);
  }
  return result;
}

template <typename FaceGraph,
          typename FaceRange,
          typename SegmentMap,
          typename Distance,
          typename Border,
          typename NamedParameters>
std::size_t segment_mesh_from_tips(const FaceGraph& mesh,
                                   const FaceRange& tips,
                                   SegmentMap segment_ids,
                                   const Distance& distance,
                                   const Border& border,
                                   const NamedParameters& np)
{
  const std::vector<Indexed_surface::Index> numbers = face_numbers(mesh, tips);
  const std::optional<Nested_segments> forest =
    run_on_mesh(mesh, np, [&](const Canonical_surface& surface, auto& monitor)
                {
                  return border.segment_from_tips(surface.part, distance, surface.faces_at(numbers),
                                                  monitor);
                });
  return write_results(mesh, forest, segment_ids, np);
}

// How many of `number_of_tips` each component gets: one after the other to the component with the largest
// area per tip, the new one counted; never more than it has faces.
inline std::vector<std::size_t> share_out_tips(std::size_t number_of_tips,
                                               const std::vector<double>& areas,
                                               const std::vector<std::size_t>& face_counts)
{
  std::vector<std::size_t> shares(areas.size(), 0);
  for (std::size_t t = 0; t < number_of_tips; ++t)
  {
    std::optional<std::size_t> best;
    for (std::size_t c = 0; c < areas.size(); ++c)
      if (shares[c] < face_counts[c] &&
          (!best || areas[c] / static_cast<double>(shares[c] + 1) >
                      areas[*best] / static_cast<double>(shares[*best] + 1)))
        best = c;
    ++shares[*best];
  }
  return shares;
}

template <typename FaceGraph, typename OutputIterator, typename Distance, typename NamedParameters>
OutputIterator select_mesh_tips(const FaceGraph& mesh,
                                std::size_t number_of_tips,
                                OutputIterator tips,
                                const Distance& distance,
                                const NamedParameters& np)
{
  using Index = Indexed_surface::Index;
  const Canonical_surface surface(mesh, np);
  const Indexed_surface& part = surface.part;
  if (number_of_tips > part.number_of_faces())
    throw std::invalid_argument("number_of_tips is " + std::to_string(number_of_tips) +
                                ", but tmesh has only " + std::to_string(part.number_of_faces()) +
                                " faces");
  const Nested_segments components(part);
  std::vector<double> areas(components.number_of_segments(), 0);
  std::vector<std::size_t> face_counts(components.number_of_segments(), 0);
  for (Index f = 0; f < part.number_of_faces(); ++f)
  {
    areas[components.labels[f]] += part.area(f);
    ++face_counts[components.labels[f]];
  }
  const std::vector<std::size_t> shares = share_out_tips(number_of_tips, areas, face_counts);

  const std::vector<typename boost::graph_traits<FaceGraph>::face_descriptor> descriptors(
    faces(mesh).begin(), faces(mesh).end());
  Segment_extractor extract(part);
  for (Index c = 0; c < shares.size(); ++c)
  {
    const Extracted_segment component = extract(components.faces_of(c));
    auto distances = distance.on(component.part, random_seed(np));
    const Tip_selection selection = select_protrusion_tips(
      component.part, distances, shares[c], [](Index) { return true; },
      [](Index, const std::vector<double>&) {});
    for (Index tip : selection.tips)
      *tips++ = descriptors[surface.position[component.faces[tip]]];
  }
  return tips;
}

} // namespace internal
} // namespace Protrusion_segmentation
} // namespace CGAL

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_SEGMENT_MESH_H
