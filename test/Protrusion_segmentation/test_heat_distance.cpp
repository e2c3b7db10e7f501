// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The distance of the heat method against analytic distances.

#include "test_distances.h"

#include <CGAL/Protrusion_segmentation/Geodesic_distance.h>
#include <CGAL/Protrusion_segmentation/Heat_distance.h>

using namespace test_meshes;
using namespace CGAL::Protrusion_segmentation;

// The source is a face's set of corners: distances are too small by up to the way from there to its
// centroid. What remains is the error of the method itself.
void distances_on_a_plane_are_euclidean()
{
  const Indexed_surface surface = to_surface(triangulated(sheet(40, 40)));
  auto distances = Heat_distance().on(surface, quiet_execution());
  std::vector<double> row;
  for (Index source : {Index(0), Index(1640), Index(2000)})
  {
    distances(source, row);
    for (Index f = 0; f < surface.number_of_faces(); ++f)
    {
      const double d = std::sqrt(squared_distance(surface.centroid(source), surface.centroid(f)));
      CGAL_CHECK_CLOSE(row[f], d, 0.06 * d + 1);
    }
  }
}

void distances_on_a_sphere_are_arcs()
{
  const Indexed_surface surface = to_surface(icosphere(4));
  auto distances = Heat_distance().on(surface, quiet_execution());
  std::vector<double> row;
  const auto direction = [&](Index f)
  {
    const Indexed_surface::Vector_3 v = surface.centroid(f) - Indexed_surface::Point_3(0, 0, 0);
    return v / std::sqrt(v.squared_length());
  };
  for (Index source : {Index(0), Index(1234)})
  {
    distances(source, row);
    for (Index f = 0; f < surface.number_of_faces(); ++f)
    {
      const double arc = std::acos((std::max)(-1., (std::min)(1., direction(source) * direction(f))));
      CGAL_CHECK_CLOSE(row[f], arc, 0.03 * arc + 0.06);
    }
  }
}

// The side of a cylinder is a rolled up rectangle.
void distances_on_a_cylinder_are_those_of_its_net()
{
  const Indexed_surface surface = to_surface(open_cylinder(1, 4, 0.1));
  auto distances = Heat_distance().on(surface, quiet_execution());
  std::vector<double> row;
  const Indexed_surface::Point_3 source = surface.centroid(0);
  distances(0, row);
  for (Index f = 0; f < surface.number_of_faces(); ++f)
  {
    const Indexed_surface::Point_3 p = surface.centroid(f);
    const double turn = std::abs(std::atan2(p.y(), p.x()) - std::atan2(source.y(), source.x()));
    const double d = std::hypot((std::min)(turn, 2 * pi - turn), p.z() - source.z());
    CGAL_CHECK_CLOSE(row[f], d, 0.06 * d + 0.1);
  }
}

// The heat fades below the smallest number on the way along a strip as long as a thousand of its edges. Then
// the distances are those in the dual graph.
void where_the_heat_does_not_reach_distances_are_those_of_the_dual_graph()
{
  const Indexed_surface surface = to_surface(triangulated(sheet(1500, 1)));
  std::vector<double> row, in_dual_graph;
  Heat_distance().on(surface, quiet_execution())(0, row);
  Geodesic_distance().on(surface, quiet_execution())(0, in_dual_graph);
  CGAL_CHECK(row == in_dual_graph);
}

int main()
{
  distances_on_a_plane_are_euclidean();
  distances_on_a_sphere_are_arcs();
  distances_on_a_cylinder_are_those_of_its_net();
  where_the_heat_does_not_reach_distances_are_those_of_the_dual_graph();
  check_search_finds_the_largest_sum(Heat_distance(), 0.05);
  check_survives_awkward_surfaces(Heat_distance());
  check_segments_stars(Heat_distance());
  return check::result();
}
