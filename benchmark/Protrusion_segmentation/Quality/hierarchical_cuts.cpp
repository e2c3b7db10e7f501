// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "hierarchical_cuts.h"

#include <CGAL/Polygon_mesh_processing/compute_normal.h>
#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/measure.h>

#include <algorithm>
#include <cmath>

namespace {

namespace PMP = CGAL::Polygon_mesh_processing;

// Relative to the length: an edge that costs nothing would be no part of a minimum.
constexpr double least_cost = 1e-3;

double cost_of_angle(const Mesh& mesh, Halfedge h, double exponent)
{
  const double pi = 4 * std::atan(1.);
  const Vector normal = PMP::compute_face_normal(mesh.face(h), mesh);
  const Vector other_normal = PMP::compute_face_normal(mesh.face(mesh.opposite(h)), mesh);
  const Vector to_other_tip = mesh.point(mesh.target(mesh.next(mesh.opposite(h)))) -
                              mesh.point(mesh.target(h));
  if (normal * to_other_tip <= 0)
    return 1;
  const double angle = std::acos(std::clamp(normal * other_normal, -1., 1.));
  return (std::max)(least_cost, std::pow(1 - angle / pi, exponent));
}

} // namespace

std::vector<Seam> all_seams(const Mesh& mesh, double exponent)
{
  std::vector<Seam> seams;
  for (const auto e : mesh.edges())
  {
    if (mesh.is_border(e))
      continue;
    const Halfedge h = mesh.halfedge(e);
    const double length = std::sqrt(
      CGAL::squared_distance(mesh.point(mesh.source(h)), mesh.point(mesh.target(h))));
    seams.push_back(
      {mesh.face(h), mesh.face(mesh.opposite(h)), length, length * cost_of_angle(mesh, h, exponent)});
  }
  return seams;
}

std::vector<double> face_areas(const Mesh& mesh)
{
  std::vector<double> areas;
  for (const Face f : mesh.faces())
    areas.push_back(PMP::face_area(f, mesh));
  return areas;
}

Segment_faces::Segment_faces(const std::vector<Seam>& all_seams,
                             const std::vector<double>& all_areas,
                             const Labels& labels,
                             std::size_t label)
{
  std::vector<std::size_t> number(labels.size());
  for (std::size_t f = 0; f < labels.size(); ++f)
    if (labels[f] == label)
    {
      number[f] = faces.size();
      faces.push_back(f);
      areas.push_back(all_areas[f]);
      area += all_areas[f];
    }
  for (const Seam& seam : all_seams)
    if (labels[seam.a] == label && labels[seam.b] == label)
      seams.push_back({number[seam.a], number[seam.b], seam.length, seam.cost});
}

double normalized_cost(const Segment_faces& segment, const std::vector<bool>& side)
{
  double cost = 0, area = 0;
  for (const Seam& seam : segment.seams)
    cost += side[seam.a] != side[seam.b] ? seam.cost : 0;
  for (std::size_t i = 0; i < side.size(); ++i)
    area += side[i] ? segment.areas[i] : 0;
  return cost / area + cost / (segment.area - area);
}

Labels split_best_first(const Mesh& mesh,
                        std::size_t number_of_segments,
                        const std::function<Split(const Labels&, std::size_t label)>& split_of)
{
  Labels labels(mesh.number_of_faces());
  const std::size_t components = PMP::connected_components(mesh, CGAL::make_property_map(labels));
  std::vector<Split> splits;
  for (std::size_t label = 0; label < components; ++label)
    splits.push_back(split_of(labels, label));
  const auto is_worse = [](const Split& a, const Split& b)
  { return a.faces.empty() != b.faces.empty() ? a.faces.empty() : a.value < b.value; };
  while (splits.size() < number_of_segments)
  {
    const auto best = std::max_element(splits.begin(), splits.end(), is_worse);
    if (best->faces.empty())
      break;
    const std::size_t old_label = std::size_t(best - splits.begin()), new_label = splits.size();
    for (const std::size_t f : best->faces)
      labels[f] = new_label;
    splits[old_label] = split_of(labels, old_label);
    splits.push_back(split_of(labels, new_label));
  }
  return labels;
}
