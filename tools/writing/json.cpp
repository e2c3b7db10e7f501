// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "writing/json.h"

#include "reading/polygon_area.h"
#include "writing/Json_object.h"
#include "writing/borders.h"
#include "writing/peak_memory.h"
#include "writing/skeleton.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace tool
{
namespace
{

using Object = Json_object;

// As in the file that was read.
std::size_t number_of_face(const Input_mesh& mesh, Face face)
{
  return mesh.face_in_file[face];
}

std::vector<double> mean_of_corners(const Mesh& mesh, Face face)
{
  std::vector<double> sum = {0, 0, 0};
  for (const auto v : vertices_around_face(mesh.halfedge(face), mesh))
    for (int c = 0; c < 3; ++c)
      sum[std::size_t(c)] += mesh.point(v)[c] /
                             mesh.degree(face); // divided first: large coordinates may not overflow
  return sum;
}

Json describe(const Protrusion& protrusion, const Input_mesh& mesh)
{
  const auto& distances = protrusion.distance_histogram;
  const auto& diameters = protrusion.sectional_diameter_histogram;
  Object object;
  object.add("segment", protrusion.segment)
    .add("parent", protrusion.parent)
    .add("tip", number_of_face(mesh, protrusion.tip))
    .add("tip_point", mean_of_corners(mesh.mesh, protrusion.tip))
    .add_optional("border_slot", protrusion.border_slot)
    .add("border_distance", protrusion.border_distance)
    .add("value", protrusion.value)
    .add_optional("probability", protrusion.probability)
    .add("area", protrusion.area)
    .add("border_length", protrusion.border_length)
    .add_if(!distances.empty(), "distance_histogram", distances)
    .add_if(!diameters.empty(), "sectional_diameter_histogram", diameters);
  return object.take();
}

Json describe_protrusions(const Findings& findings)
{
  Json array = Json::array();
  for (const Protrusion& protrusion : findings.segmentation.record.protrusions())
    array.push_back(describe(protrusion, findings.mesh));
  return array;
}

Json describe_stage(const std::string& name, double seconds)
{
  return Object().add("stage", name).add("seconds", seconds).take();
}

// Together they take as long as all does.
Json describe_stages(const Findings& findings)
{
  Json array = Json::array({describe_stage("file", findings.seconds_for_file)});
  double rest = findings.segmentation.seconds;
  for (const Stage_record& stage : findings.segmentation.record.stages())
  {
    array.push_back(describe_stage(stage.name, stage.seconds));
    rest -= stage.seconds;
  }
  array.push_back(describe_stage("rest", (std::max)(rest, 0.)));
  return array;
}

double area(const Polygon_soup& soup, const Corners& polygon)
{
  std::vector<Point> corners;
  for (const std::size_t i : polygon)
    corners.push_back(soup.points[i]);
  return polygon_area(std::move(corners));
}

// Faces of the file, duplicate and degenerate ones among them; the area counts duplicates once.
Json describe_measures(const Findings& findings)
{
  const Input_mesh& input = findings.mesh;
  const std::vector<std::size_t>& ids = findings.segmentation.segment_ids;
  std::vector<std::size_t> faces(findings.segmentation.number_of_segments, 0);
  std::vector<double> areas(faces.size(), 0);
  const std::vector<std::size_t> labels = labels_of_file(ids, input);
  for (const std::size_t segment : labels)
    ++faces[segment];
  if (input.has_joined_pieces())
    for (std::size_t i = 0; i < labels.size(); ++i)
      areas[labels[i]] += area(input.soup, input.soup.polygons[i]);
  else
    for (std::size_t i = 0; i < ids.size(); ++i)
      areas[ids[i]] += area(input.soup, input.soup.polygons[input.face_in_file[i]]);
  const Recorder& record = findings.segmentation.record;
  Json array = Json::array();
  for (std::size_t s = 0; s < faces.size(); ++s)
    array.push_back(Object()
                      .add("segment", s)
                      .add_if(s < findings.names.size() && !findings.names[s].empty(), "name",
                              s < findings.names.size() ? findings.names[s] : "")
                      .add("faces", faces[s])
                      .add("area", areas[s])
                      .add_optional("confidence", record.least_probability(s) ? record.least_probability(s)
                                                                                : record.least_value(s))
                      .take());
  return array;
}

Json describe(const Border& border)
{
  Json points = Json::array();
  for (const Point& point : border.points)
    points.push_back({point.x(), point.y(), point.z()});
  Object object;
  object.add("segments", border.segments)
    .add("is_closed", border.is_closed)
    .add("length", border.length)
    .add_optional("value", border.value)
    .add_optional("probability", border.probability)
    .add("points", points);
  return object.take();
}

Json describe_skeleton(const Findings& findings)
{
  Json array = Json::array();
  for (const Joint& joint : find_skeleton(findings))
    array.push_back(Object()
                      .add("point", std::vector<double>{joint.point.x(), joint.point.y(), joint.point.z()})
                      .add("parent", joint.parent)
                      .add("segment", joint.segment)
                      .add("is_tip", joint.is_tip)
                      .take());
  return array;
}

Json describe_borders(const Findings& findings)
{
  Json array = Json::array();
  for (const Border& border : find_borders(findings))
    array.push_back(describe(border));
  return array;
}

Json describe_surface(const Input_mesh& mesh)
{
  const Repairs& repairs = mesh.repairs;
  Object object;
  object.add("faces", mesh.face_in_file.size())
    .add("components", repairs.components)
    .add("small_components", repairs.small_components)
    .add("degenerate_faces", repairs.degenerate_polygons)
    .add("duplicate_faces", repairs.duplicate_polygons)
    .add("joined_corners", repairs.joined_corners)
    .add("split_edges", repairs.split_edges)
    .add("non_manifold_edges", repairs.non_manifold_edges)
    .add("unorientable_edges", repairs.unorientable_edges)
    .add("reversed_faces", repairs.reversed_polygons)
    .add("inside_out_components", mesh.inside_out_components);
  return object.take();
}

Json describe_subtree(std::size_t segment, const std::vector<std::vector<std::size_t>>& children)
{
  Json array = Json::array();
  for (std::size_t child : children[segment])
    array.push_back(describe_subtree(child, children));
  return Object().add("segment", segment).add("children", array).take();
}

// The nested protrusions as a tree for each connected component, whose body is the root. The children
// are in the order in which their borders were chosen.
Json describe_hierarchy(const Segmentation& segmentation)
{
  const std::vector<Protrusion>& protrusions = segmentation.record.protrusions();
  std::vector<std::vector<std::size_t>> children(segmentation.number_of_segments);
  std::vector<bool> is_body(children.size(), true);
  for (const Protrusion& protrusion : protrusions)
  {
    children[protrusion.parent].push_back(protrusion.segment);
    is_body[protrusion.segment] = false;
  }
  Json roots = Json::array();
  for (std::size_t s = 0; s < children.size(); ++s)
    if (is_body[s])
      roots.push_back(describe_subtree(s, children));
  return roots;
}

} // namespace

Json describe(const Findings& findings)
{
  const Recorder& record = findings.segmentation.record;
  const std::optional<std::size_t> memory = peak_memory();
  Object object;
  object.add("format_version", json_format_version)
    .add("input", findings.input)
    .add("faces", findings.mesh.label_giver.size())
    .add("surface", describe_surface(findings.mesh))
    .add_all(describe(findings.options))
    .add("segments", findings.segmentation.number_of_segments)
    .add_if(!findings.note.empty(), "note", findings.note)
    .add("seconds", findings.seconds())
    .add("stages", describe_stages(findings))
    .add_if(findings.seconds_for_writing.has_value(), "writing_seconds", findings.seconds_for_writing.value_or(0))
    .add_if(!findings.formats.empty(), "formats", findings.formats)
    .add("threads", findings.options.threads)
    .add_if(memory.has_value(), "peak_memory", memory.value_or(0))
    .add("dijkstra_runs", record.number_of_runs())
    .add("tips_eliminated", record.number_of_eliminated_tips())
    .add("measures", describe_measures(findings))
    .add("protrusions", describe_protrusions(findings))
    .add("borders", describe_borders(findings))
    .add("skeleton", describe_skeleton(findings))
    .add_if(findings.connectors.has_value(), "connectors",
            describe(findings.connectors.value_or(std::vector<Connector>())))
    .add("hierarchy", describe_hierarchy(findings.segmentation));
  return object.take();
}

void write_json(std::ostream& out, const nlohmann::ordered_json& json)
{
  // A name that is no UTF-8 must not keep the rest from being written.
  out << json.dump(2, ' ', false, Json::error_handler_t::replace) << "\n";
}

} // namespace tool
