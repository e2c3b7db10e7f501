// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "results.h"

#include "numpy_arrays.h"

#include <pybind11/stl.h>

#include <cstddef>
#include <cstdint>

namespace python {
namespace {

template <typename T>
auto column(const std::vector<Segment>& segments, T Segment::*field)
{
  std::vector<T> values;
  for (const Segment& segment : segments)
    values.push_back(segment.*field);
  return as_array(values);
}

// A row for each segment; bodies, which have no histogram, have zeros.
template <typename T>
auto table(const std::vector<Segment>& segments, std::vector<T> Segment::*field)
{
  std::size_t width = 0;
  for (const Segment& segment : segments)
    width = (std::max)(width, (segment.*field).size());
  std::vector<T> values;
  for (const Segment& segment : segments)
  {
    values.insert(values.end(), (segment.*field).begin(), (segment.*field).end());
    values.resize(values.size() + width - (segment.*field).size());
  }
  return as_rows(values, width);
}

py::array as_coordinates(const std::vector<tool::Point>& points)
{
  std::vector<double> coordinates;
  for (const tool::Point& p : points)
    coordinates.insert(coordinates.end(), {p.x(), p.y(), p.z()});
  return as_points(coordinates);
}

py::tuple as_tuple(const Border& border)
{
  return py::make_tuple(py::make_tuple(border.line.segments[0], border.line.segments[1]),
                        as_coordinates(border.line.points), border.line.is_closed, border.line.length,
                        border.value, border.probability);
}

// in the order of the fields of `Repairs`
py::tuple repairs(const Segmentation& found)
{
  const tool::Repairs& r = found.repairs;
  return py::make_tuple(r.degenerate_polygons, r.duplicate_polygons, r.non_manifold_edges,
                        r.unorientable_edges, r.reversed_polygons, r.joined_corners, r.split_edges,
                        r.small_components, found.number_of_inside_out_components, found.number_of_pieces,
                        r.components);
}

} // namespace

py::dict as_dict(const Segmentation& found)
{
  py::dict result;
  const std::vector<Segment>& segments = found.segments;
  result["labels"] = as_array(found.labels);
  result["parents"] = column(segments, &Segment::parent);
  result["tips"] = column(segments, &Segment::tip);
  result["areas"] = column(segments, &Segment::area);
  result["protruding_areas"] = column(segments, &Segment::protruding_area);
  result["border_lengths"] = column(segments, &Segment::border_length);
  result["border_distances"] = column(segments, &Segment::border_distance);
  result["values"] = column(segments, &Segment::value);
  result["probabilities"] = column(segments, &Segment::probability);
  result["confidences"] = column(segments, &Segment::confidence);
  result["border_slots"] = column(segments, &Segment::border_slot);
  result["distance_histograms"] = table(segments, &Segment::distance_histogram);
  result["diameter_histograms"] = table(segments, &Segment::sectional_diameter_histogram);
  py::list borders;
  for (const Border& border : found.borders)
    borders.append(as_tuple(border));
  result["borders"] = borders;
  result["border_edges"] = as_rows(found.border_edges, 2);
  result["selected_tips"] = as_array(found.selected_tips);
  result["number_of_small_components"] = found.number_of_small_components;
  result["repairs"] = repairs(found);
  return result;
}

py::dict as_dict(const Smoothed& smoothed)
{
  py::dict result;
  result["vertices"] = as_points(smoothed.coordinates);
  result["corners"] = as_array(smoothed.corners);
  result["sizes"] = as_array(smoothed.sizes);
  result["labels"] = as_array(smoothed.labels);
  result["old_faces"] = as_array(smoothed.old_faces);
  result["number_of_fixed_segments"] = smoothed.number_of_fixed_segments;
  return result;
}

py::dict as_python(const std::vector<Joint>& joints)
{
  std::vector<tool::Point> points;
  std::vector<std::size_t> parents, segments;
  py::array_t<bool> are_tips(static_cast<py::ssize_t>(joints.size()));
  for (std::size_t j = 0; j < joints.size(); ++j)
  {
    points.push_back(joints[j].point);
    parents.push_back(joints[j].parent);
    segments.push_back(joints[j].segment);
    are_tips.mutable_at(static_cast<py::ssize_t>(j)) = joints[j].is_tip;
  }
  py::dict result;
  result["points"] = as_coordinates(points);
  result["parents"] = as_array(parents);
  result["segments"] = as_array(segments);
  result["are_tips"] = are_tips;
  return result;
}

py::list as_python(const std::vector<Part>& parts)
{
  py::list result;
  for (const Part& part : parts)
  {
    std::vector<std::size_t> corners, sizes;
    for (const auto& polygon : part.polygons)
    {
      corners.insert(corners.end(), polygon.begin(), polygon.end());
      sizes.push_back(polygon.size());
    }
    result.append(py::make_tuple(as_coordinates(part.points), as_array(corners), as_array(sizes)));
  }
  return result;
}

// Connectors in the order of the fields of `Connector`.
py::tuple as_python(const Connected_parts& parts)
{
  using Status = CGAL::Protrusion_segmentation::Connector_status;
  const std::map<Status, const char*> names = {{Status::PLACED, "placed"},
                                               {Status::CAP_TOO_SMALL, "cap too small"},
                                               {Status::CAP_NOT_FLAT, "cap not flat"},
                                               {Status::NO_ROOM, "no room"}};
  py::list connectors;
  for (const auto& c : parts.connectors)
  {
    const py::object base = as_coordinates({c.base}).attr("__getitem__")(0),
                     end = as_coordinates({c.end}).attr("__getitem__")(0);
    connectors.append(py::make_tuple(c.segment, c.parent, names.at(c.status), c.cap_radius,
                                     c.is_peg_on_segment ? c.segment : c.parent, base, end, c.radius,
                                     c.depth, c.tolerance));
  }
  return py::make_tuple(as_python(parts.parts), connectors);
}

// in the order of the fields of `Metrics`
py::list as_list(const std::vector<CGAL::Protrusion_segmentation::Segmentation_metrics>& metrics)
{
  py::list result;
  for (const auto& m : metrics)
    result.append(py::make_tuple(m.rand_index_error, m.hamming_distance.distance,
                                 m.hamming_distance.missing_rate, m.hamming_distance.false_alarm_rate,
                                 m.cut_discrepancy, m.consistency_error.global, m.consistency_error.local,
                                 m.consistency_error.global_by_area, m.consistency_error.local_by_area,
                                 m.mean_best_intersection_over_union));
  return result;
}

} // namespace python
