// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "segment.h"

#include "reading/polygon_area.h"
#include "repair/face_patch_map.h"

#include <CGAL/Protrusion_segmentation/segment_borders.h>
#include <CGAL/Protrusion_segmentation/segmentation_from_protrusion_tips.h>
#include <CGAL/Protrusion_segmentation/segmentation_via_protrusion_tips.h>

#include <boost/property_map/property_map.hpp>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#endif

#include <algorithm>
#include <functional>
#include <iterator>
#include <limits>
#include <set>
#include <stdexcept>
#include <utility>
#include <vector>

namespace python {
namespace {

constexpr double no_number = std::numeric_limits<double>::quiet_NaN();

auto label_map(std::vector<std::size_t>& labels, const tool::Mesh& mesh)
{
  return boost::make_iterator_property_map(labels.begin(), get(boost::face_index, mesh));
}

// `patches` are those of the mesh, which may have none.
auto named_parameters(const Request& request,
                      Watcher& watcher,
                      const std::vector<std::size_t>& patches)
{
  return CGAL::parameters::random_seed(request.random_seed)
    .visitor(std::ref(watcher))
    .face_patch_map(tool::face_patch_map(patches));
}

// The result of `run(tag)` with as many threads as asked for, or with one where there is no oneTBB.
template <typename Run>
auto with_threads(const Request& request, Run run)
{
#ifdef CGAL_LINKED_WITH_TBB
  if (request.threads > 1)
  {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, request.threads);
    return run(CGAL::Parallel_tag());
  }
#endif
  return run(CGAL::Sequential_tag());
}

void check_number(const Request& request, std::int64_t least, const tool::Input_mesh& input)
{
  const auto most = static_cast<std::int64_t>(input.mesh.number_of_faces());
  if (request.number && (*request.number < least || *request.number > most))
    throw std::invalid_argument(request.name_of_number + " is " + std::to_string(*request.number) +
                                ", but it must be from " + std::to_string(least) + " to " +
                                std::to_string(most) + ", the number of faces of the mesh");
}

// A face that is not in the mesh has a tip where it has its label from.
std::vector<tool::Face> faces_at(const std::vector<std::int64_t>& tips, const tool::Input_mesh& input)
{
  std::vector<tool::Face> faces;
  for (const std::int64_t tip : tips)
  {
    if (tip < 0 || static_cast<std::size_t>(tip) >= input.label_giver.size())
      throw std::invalid_argument("tips: there is no face " + std::to_string(tip));
    faces.emplace_back(
      static_cast<tool::Mesh::size_type>(input.label_giver[static_cast<std::size_t>(tip)]));
  }
  return faces;
}

std::size_t run_method(const Request& request,
                       const tool::Input_mesh& input,
                       std::vector<std::size_t>& labels,
                       Watcher& watcher)
{
  check_number(request, 1, input);
  const tool::Mesh& mesh = input.mesh;
  const Chosen_method method(request.method);
  const std::vector<std::size_t> patches = tool::patches_of_mesh(input);
  const auto np = named_parameters(request, watcher, patches);
  return with_threads(request,
                      [&](auto tag)
                      {
                        using Tag = decltype(tag);
                        const auto map = label_map(labels, mesh);
                        if (request.tips)
                          return CGAL::segmentation_from_protrusion_tips<Tag>(
                            mesh, faces_at(*request.tips, input), map, method, np);
                        return request.number
                                 ? CGAL::segmentation_via_protrusion_tips<Tag>(mesh, map, *request.number,
                                                                               method, np)
                                 : CGAL::segmentation_via_protrusion_tips<Tag>(mesh, map, method, np);
                      });
}

double area(tool::Face face, const tool::Mesh& mesh)
{
  std::vector<tool::Point> corners;
  for (const auto v : vertices_around_face(mesh.halfedge(face), mesh))
    corners.push_back(mesh.point(v));
  return tool::polygon_area(std::move(corners));
}

std::vector<Segment> describe_segments(std::size_t number,
                                       const std::vector<std::size_t>& labels,
                                       const tool::Input_mesh& input,
                                       const Watcher& found)
{
  std::vector<Segment> segments(number);
  for (std::size_t s = 0; s < number; ++s)
  {
    Segment& segment = segments[s];
    segment.parent = static_cast<std::int64_t>(s);
    segment.protruding_area = segment.border_length = segment.border_distance = no_number;
    segment.value = segment.probability = no_number;
    const auto confidence = found.least_probability(s) ? found.least_probability(s)
                                                       : found.least_value(s);
    segment.confidence = confidence.value_or(std::numeric_limits<double>::infinity());
  }
  for (const auto& protrusion : found.protrusions())
  {
    Segment& segment = segments[protrusion.segment];
    segment.parent = static_cast<std::int64_t>(protrusion.parent);
    segment.tip = static_cast<std::int64_t>(input.face_in_file[protrusion.tip]);
    segment.protruding_area = protrusion.area;
    segment.border_length = protrusion.border_length;
    segment.border_distance = protrusion.border_distance;
    segment.value = protrusion.value;
    segment.probability = protrusion.probability.value_or(no_number);
    if (protrusion.border_slot)
      segment.border_slot = static_cast<std::int64_t>(*protrusion.border_slot);
    segment.distance_histogram = protrusion.distance_histogram;
    segment.sectional_diameter_histogram = protrusion.sectional_diameter_histogram;
  }
  for (const tool::Face face : input.mesh.faces())
    segments[labels[face]].area += area(face, input.mesh);
  return segments;
}

std::vector<Border> find_borders(std::vector<std::size_t>& labels,
                                 const tool::Mesh& mesh,
                                 const Watcher& found)
{
  std::vector<CGAL::Protrusion_segmentation::Segment_border<tool::Point>> lines;
  CGAL::Protrusion_segmentation::segment_borders(mesh, label_map(labels, mesh),
                                                 std::back_inserter(lines));
  std::vector<Border> borders;
  for (auto& line : lines)
  {
    const auto [s, t] = line.segments;
    borders.push_back({std::move(line), found.value(s, t).value_or(no_number),
                       found.probability(s, t).value_or(no_number)});
  }
  return borders;
}

// None if pieces were joined, since the vertices are not those that were given then.
std::vector<std::int64_t> find_border_edges(const std::vector<std::size_t>& labels,
                                            const tool::Input_mesh& input)
{
  std::vector<std::int64_t> ends;
  const tool::Mesh& mesh = input.mesh;
  if (input.has_joined_pieces())
    return ends;
  for (const auto edge : mesh.edges())
    if (!mesh.is_border(edge) &&
        labels[mesh.face(mesh.halfedge(edge, 0))] != labels[mesh.face(mesh.halfedge(edge, 1))])
      for (const unsigned int i : {0u, 1u})
        ends.push_back(static_cast<std::int64_t>(input.point_of_vertex[mesh.vertex(edge, i)]));
  return ends;
}

} // namespace

Segmentation segment(const Request& request, Watcher& watcher)
{
  const tool::Input_mesh input = mesh_of_arrays(request.arrays);
  std::vector<std::size_t> labels(input.mesh.number_of_faces());
  Segmentation result;
  const std::size_t number = run_method(request, input, labels, watcher);
  result.labels = tool::labels_of_file(labels, input);
  result.segments = describe_segments(number, labels, input, watcher);
  result.borders = find_borders(labels, input.mesh, watcher);
  result.border_edges = find_border_edges(labels, input);
  for (const tool::Face tip : watcher.tips())
    result.selected_tips.push_back(static_cast<std::int64_t>(input.face_in_file[tip]));
  result.number_of_small_components = watcher.number_of_small_components();
  result.repairs = input.repairs;
  result.number_of_inside_out_components = input.inside_out_components;
  result.number_of_pieces = std::set<std::size_t>(input.pieces.begin(), input.pieces.end()).size();
  return result;
}

std::vector<std::size_t> select_tips(const Request& request, Watcher& watcher)
{
  const tool::Input_mesh input = mesh_of_arrays(request.arrays);
  check_number(request, 0, input);
  std::vector<tool::Face> found;
  const Chosen_distance distance = choose_distance(request.method).value();
  const std::vector<std::size_t> patches = tool::patches_of_mesh(input);
  const auto np = named_parameters(request, watcher, patches);
  with_threads(request,
               [&](auto tag)
               {
                 return CGAL::protrusion_tips<decltype(tag)>(input.mesh, *request.number,
                                                             std::back_inserter(found), distance, np);
               });
  std::vector<std::size_t> faces;
  for (const tool::Face face : found)
    faces.push_back(input.face_in_file[face]);
  return faces;
}

} // namespace python
