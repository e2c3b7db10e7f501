// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What holds of segments with connectors, whatever the mesh.

#ifndef CGAL_TEST_PROTRUSION_SEGMENTATION_CONNECTED_PARTS_H
#define CGAL_TEST_PROTRUSION_SEGMENTATION_CONNECTED_PARTS_H

#include "closed_parts.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/Protrusion_segmentation/closed_segments.h>
#include <CGAL/Protrusion_segmentation/closed_segments_with_connectors.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <string>
#include <vector>

using Connector = CGAL::Protrusion_segmentation::Connector<Mesh::Point>;
using Connector_options = CGAL::Protrusion_segmentation::Connector_options;
using Status = CGAL::Protrusion_segmentation::Connector_status;

struct Connected
{
  std::vector<Part> parts;
  std::vector<Connector> connectors;
};

inline Connected connected(const Mesh& mesh,
                           const Labels& labels,
                           const Labels& parents,
                           const Connector_options& options = {})
{
  Connected result;
  CGAL::Protrusion_segmentation::closed_segments_with_connectors(
    mesh, map_of(labels, mesh), record_of(parents), options, std::back_inserter(result.parts),
    std::back_inserter(result.connectors));
  return result;
}

inline std::vector<Part> without_connectors(const Mesh& mesh, const Labels& labels, const Labels& parents)
{
  std::vector<Part> parts;
  CGAL::Protrusion_segmentation::closed_segments(mesh, map_of(labels, mesh), record_of(parents),
                                                 std::back_inserter(parts));
  return parts;
}

inline bool cuts_itself(const Part& part)
{
  using Exact_mesh = CGAL::Surface_mesh<CGAL::Exact_predicates_inexact_constructions_kernel::Point_3>;
  std::vector<Exact_mesh::Point> points;
  for (const Mesh::Point& p : part.points)
    points.emplace_back(p.x(), p.y(), p.z());
  Exact_mesh mesh;
  if (!CGAL::Polygon_mesh_processing::is_polygon_soup_a_polygon_mesh(part.polygons))
    return true;
  CGAL::Polygon_mesh_processing::polygon_soup_to_polygon_mesh(points, part.polygons, mesh);
  CGAL::Polygon_mesh_processing::triangulate_faces(mesh);
  return CGAL::Polygon_mesh_processing::does_self_intersect(mesh);
}

// With a chamfer of 45 degrees at the end.
inline double volume_of_prism(std::size_t sides, double apothem, double height, double chamfer)
{
  const auto area = [&](double a) { return double(sides) * a * a * std::tan(CGAL_PI / double(sides)); };
  const double wide = area(apothem), narrow = area(apothem - chamfer);
  return wide * (height - chamfer) + chamfer / 3 * (wide + narrow + std::sqrt(wide * narrow));
}

struct Volumes
{
  double peg, socket;
};

inline Volumes volumes_of(const Connector& connector, const Connector_options& options)
{
  const double apothem = connector.radius * std::cos(CGAL_PI / double(options.number_of_sides));
  const double chamfer = (std::min)(options.chamfer * connector.radius,
                                    (std::min)(apothem, connector.depth) / 2);
  // Sides and ends move by the tolerance, and so does the slope between them.
  const double wider = chamfer > 0 ? chamfer + (2 - std::sqrt(2.)) * connector.tolerance : 0;
  return {volume_of_prism(options.number_of_sides, apothem, connector.depth, chamfer),
          volume_of_prism(options.number_of_sides, apothem + connector.tolerance,
                          connector.depth + connector.tolerance, wider)};
}

inline std::size_t number_of_placed(const Connected& found)
{
  return std::size_t(std::count_if(found.connectors.begin(), found.connectors.end(),
                                   [](const Connector& c) { return c.status == Status::PLACED; }));
}

// All that holds whatever the mesh, if its flat parts do not cut themselves.
inline void check_connected(const Mesh& mesh,
                            const Labels& labels,
                            const Labels& parents,
                            const Connector_options& options,
                            const std::string& name)
{
  const Connected found = connected(mesh, labels, parents, options);
  const std::vector<Part> flat = without_connectors(mesh, labels, parents);
  CGAL_CHECK_EQUAL(found.parts.size(), flat.size());
  double sum = 0;
  for (std::size_t s = 0; s < found.parts.size(); ++s)
  {
    const std::string part = name + ": part " + std::to_string(s);
    check::report(number_of_open_edges(found.parts[s]) == 0, __FILE__, __LINE__, part + " is not closed");
    check::report(cuts_itself(flat[s]) || !cuts_itself(found.parts[s]), __FILE__, __LINE__,
                  part + " cuts itself");
    sum += volume(found.parts[s]) / 6;
  }
  double expected = volume(whole(mesh)) / 6;
  for (const Connector& connector : found.connectors)
    if (connector.status == Status::PLACED)
    {
      const Volumes volumes = volumes_of(connector, options);
      expected -= volumes.socket - volumes.peg;
      CGAL_CHECK(connector.depth >= connector.radius / 2);
      CGAL_CHECK(connector.radius < connector.cap_radius);
      CGAL_CHECK_CLOSE(std::sqrt((connector.end - connector.base).squared_length()), connector.depth, 1e-9);
    }
  check::report(std::abs(sum - expected) <= 1e-9 * std::abs(expected), __FILE__, __LINE__,
                name + ": volumes add up to " + std::to_string(sum) + ", not to " +
                  std::to_string(expected));
}

#endif // CGAL_TEST_PROTRUSION_SEGMENTATION_CONNECTED_PARTS_H
