// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Whether segments as surfaces of their own are closed, and what their volumes are.

#ifndef CGAL_TEST_PROTRUSION_SEGMENTATION_CLOSED_PARTS_H
#define CGAL_TEST_PROTRUSION_SEGMENTATION_CLOSED_PARTS_H

#include "check.h"
#include "test_meshes.h" // Boost demands that it comes before Boost Graph

#include <CGAL/Protrusion_segmentation/Closed_segment.h>
#include <CGAL/Protrusion_segmentation/Segmentation_record.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <map>
#include <random>
#include <utility>
#include <vector>

using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
using Labels = std::vector<std::size_t>;
using Part = CGAL::Protrusion_segmentation::Closed_segment<Mesh::Point>;

inline auto map_of(const Labels& labels, const Mesh& mesh)
{
  return boost::make_iterator_property_map(labels.begin(), get(boost::face_index, mesh));
}

// Of segments that stick out of `parents`, those of bodies being themselves.
inline CGAL::Protrusion_segmentation::Segmentation_record<Mesh> record_of(const Labels& parents)
{
  CGAL::Protrusion_segmentation::Segmentation_record<Mesh> record;
  for (std::size_t s = 0; s < parents.size(); ++s)
    if (parents[s] != s)
    {
      CGAL::Protrusion_segmentation::Protrusion<Mesh::Face_index> protrusion;
      protrusion.segment = s;
      protrusion.parent = parents[s];
      record.on_protrusion(protrusion);
    }
  return record;
}

// Any segments at all, each with a parent that comes before it.
struct Random_segments
{
  Labels labels, parents = {0};

  Random_segments(const Mesh& mesh, std::size_t number, unsigned int seed) : labels(mesh.number_of_faces())
  {
    std::mt19937 random(seed);
    for (std::size_t s = 1; s < number; ++s)
      parents.push_back(random() % s);
    for (std::size_t& label : labels)
      label = random() % number;
  }
};

// Six times the volume, of fans.
inline double volume(const Part& part)
{
  double sum = 0;
  for (const auto& polygon : part.polygons)
    for (std::size_t i = 2; i < polygon.size(); ++i)
      sum += CGAL::determinant(part.points[polygon[0]] - CGAL::ORIGIN,
                               part.points[polygon[i - 1]] - CGAL::ORIGIN,
                               part.points[polygon[i]] - CGAL::ORIGIN);
  return sum;
}

inline Part whole(const Mesh& mesh)
{
  Part part;
  for (const auto v : vertices(mesh))
    part.points.push_back(mesh.point(v));
  for (const auto f : faces(mesh))
  {
    part.polygons.emplace_back();
    for (const auto v : vertices_around_face(mesh.halfedge(f), mesh))
      part.polygons.back().push_back(std::size_t(v));
  }
  return part;
}

// Edges that are not once in each direction.
inline std::size_t number_of_open_edges(const Part& part)
{
  std::map<std::pair<std::size_t, std::size_t>, int> uses;
  for (const auto& polygon : part.polygons)
    for (std::size_t i = 0; i < polygon.size(); ++i)
      ++uses[{polygon[i], polygon[(i + 1) % polygon.size()]}];
  std::size_t count = 0;
  for (const auto& [edge, number] : uses)
  {
    const auto back = uses.find({edge.second, edge.first});
    count += number == 1 && back != uses.end() && back->second == 1 ? 0 : 1;
  }
  return count;
}

// 0 or 1 for the faces on either side of a plane across an axis.
inline Labels labels_of_halves(const Mesh& mesh, int axis, double position)
{
  Labels labels;
  for (const auto f : faces(mesh))
  {
    double sum = 0;
    for (const auto v : vertices_around_face(mesh.halfedge(f), mesh))
      sum += mesh.point(v)[axis] - position;
    labels.push_back(sum > 0 ? 1 : 0);
  }
  return labels;
}

#endif // CGAL_TEST_PROTRUSION_SEGMENTATION_CLOSED_PARTS_H
