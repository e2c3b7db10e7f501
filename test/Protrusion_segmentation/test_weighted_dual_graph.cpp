// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The weights of seams (what minimum cuts are made of) and the coarse graph.

#include "check.h"
#include "indexed_surfaces.h"
#include "test_meshes.h"
#include "weighted_dual_graphs.h"

#include <CGAL/Protrusion_segmentation/internal/Cut_method/coarsen_graph.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/make_weighted_dual_graph.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/measure_volumes.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

using namespace test_meshes;
using namespace CGAL::Protrusion_segmentation;
using internal::Weighted_dual_graph;

internal::Diffusion::Values normals_of_faces(const Indexed_surface& surface)
{
  internal::Diffusion::Values normals;
  for (Index f = 0; f < surface.number_of_faces(); ++f)
  {
    const Indexed_surface::Vector_3 normal = surface.area_vector(f) / surface.area(f);
    normals.push_back({float(normal.x()), float(normal.y()), float(normal.z())});
  }
  return normals;
}

void smoothed_normals_of_a_sphere_point_outward()
{
  const Indexed_surface surface = to_surface(jittered(icosphere(4), 0.005, 1));
  const auto normals =
    internal::smooth_normals(weighted_dual_graph(surface), normals_of_faces(surface), 0.03, quiet_execution());
  for (Index f = 0; f < surface.number_of_faces(); ++f)
  {
    const Indexed_surface::Vector_3 radius = surface.centroid(f) - Indexed_surface::Point_3(0, 0, 0);
    const Indexed_surface::Vector_3 normal(normals[f][0], normals[f][1], normals[f][2]);
    CHECK_CLOSE(normal.squared_length(), 1, 1e-6);
    CHECK(normal * radius > 0.98 * std::sqrt(radius.squared_length()));
  }
}

// The same average, the long way.
internal::Diffusion::Values average_without_groups(const Weighted_dual_graph& graph,
                                                   internal::Diffusion::Values values,
                                                   double radius)
{
  internal::Diffusion diffuse(graph, radius * radius / 16);
  for (int step = 0; step < 2; ++step)
    diffuse(values, 1e-5, quiet_execution());
  return values;
}

// Where faces are small for the radius they are averaged in groups, and groups of groups. A step, a wave and a constant
// come out as without groups, as far as discrete operators of different meshes agree.
void groups_of_faces_average_like_faces()
{
  const Indexed_surface surface = to_surface(jittered(icosphere(5), 0.002, 3));
  const Weighted_dual_graph graph = weighted_dual_graph(surface);
  for (const double radius : {0.2, 0.3})
  {
    CHECK(surface.number_of_faces() > 8 * std::pow(6 / radius, 2)); // two levels of groups
    internal::Diffusion::Values values;
    for (Index f = 0; f < surface.number_of_faces(); ++f)
      values.push_back({surface.centroid(f).z() > 0 ? 1.f : 0.f, float(std::sin(4 * surface.centroid(f).x())), 1.f});
    const auto expected = average_without_groups(graph, values, radius);
    internal::Multilevel_diffusion(radius, quiet_execution())(graph, values);
    for (int i = 0; i < 3; ++i)
    {
      double squares = 0, largest = 0;
      for (Index f = 0; f < surface.number_of_faces(); ++f)
      {
        const double error = std::abs(values[f][i] - expected[f][i]);
        squares += graph.area[f] * error * error;
        largest = (std::max)(largest, error);
      }
      std::cout << "radius " << radius << ", value " << i << ": " << std::sqrt(squares) << ", " << largest << "\n";
      CHECK(std::sqrt(squares) < (i == 2 ? 1e-3 : 0.03));
      CHECK(largest < 0.1);
    }
  }
}

// Diffusion keeps the integral and no value leaves the range of the values; the three coordinates, of which
// the last one is solved at once, know nothing of each other.
void diffusion_keeps_the_mean()
{
  constexpr double tolerance = 1e-4;
  const Weighted_dual_graph graph = weighted_dual_graph(to_surface(random_surface(7)));
  internal::Diffusion::Values values(graph.number_of_nodes());
  for (Index f = 0; f < values.size(); ++f)
    values[f] = {float(f % 3), float(f % 5) / 2, 0.5f};
  internal::Diffusion::Values first_only(values.size());
  for (Index f = 0; f < values.size(); ++f)
    first_only[f] = {values[f][0], 0, 0};
  const internal::Diffusion::Values start = values;
  internal::Diffusion diffuse(graph, 0.01);
  diffuse(values, tolerance, quiet_execution());
  diffuse(first_only, tolerance, quiet_execution());
  std::array<double, 3> before = {0, 0, 0}, after = {0, 0, 0};
  for (Index f = 0; f < values.size(); ++f)
  {
    CHECK_EQUAL(values[f][0], first_only[f][0]);
    CHECK_EQUAL(first_only[f][1], 0);
    CHECK_CLOSE(values[f][2], 0.5, 1e-5);
    for (int i = 0; i < 3; ++i)
    {
      before[i] += graph.area[f] * start[f][i];
      after[i] += graph.area[f] * values[f][i];
      CHECK(values[f][i] > -0.01 && values[f][i] < 2.01);
    }
  }
  for (int i = 0; i < 3; ++i)
    CHECK_CLOSE(after[i], before[i], 1e-2 * before[i]);
}

// All arcs between two nodes together weigh the same in both directions.
void check_symmetry(const Weighted_dual_graph& graph)
{
  std::map<std::pair<Index, Index>, std::array<double, 3>> weights;
  for (Index i = 0; i < graph.number_of_nodes(); ++i)
    for (const Index arc : graph.arcs(i))
    {
      std::array<double, 3>& sum = weights[{i, graph.target[arc]}];
      sum[0] += graph.capacity[arc];
      sum[1] += graph.length[arc];
      sum[2] += graph.border_length[arc];
      CHECK(graph.capacity[arc] <= graph.border_length[arc] * (1 + 1e-6));
      CHECK(graph.seam_length(arc) >= graph.length[arc]);
      CHECK(graph.concave_border(arc) <= graph.border_length[arc] * (1 + 1e-6));
    }
  for (const auto& [arc, sum] : weights)
  {
    const auto opposite = weights.find({arc.second, arc.first});
    CHECK(opposite != weights.end());
    if (opposite != weights.end())
      for (int i = 0; i < 3; ++i)
        CHECK_CLOSE(opposite->second[i], sum[i], 1e-6);
  }
}

double sum(const std::vector<float>& values)
{
  double result = 0;
  for (const float value : values)
    result += value;
  return result;
}

// Necks of a dumbbell: concave where a ball meets the bar, nowhere else.
void seams_lie_where_parts_meet()
{
  const Test_mesh mesh = star(5);
  const Indexed_surface surface = to_surface(mesh);
  const Indexed_surface reversed = to_surface(with_reversed_orientation(mesh));
  const Weighted_dual_graph graph = weighted_dual_graph(surface);
  check_symmetry(graph);
  double between = 0, inside = 0;
  std::size_t count_between = 0, count_inside = 0;
  for (Index f = 0; f < surface.number_of_faces(); ++f)
    for (const Index arc : graph.arcs(f))
    {
      const bool same = mesh.parts[f] == mesh.parts[graph.target[arc]];
      (same ? inside : between) += graph.capacity[arc] / graph.border_length[arc];
      ++(same ? count_inside : count_between);
    }
  CHECK(count_between > 0);
  CHECK(between / double(count_between) < 0.7 * inside / double(count_inside));
  // what is inside is found out from the volume: an inward orientation gives the same weights
  CHECK_CLOSE(sum(weighted_dual_graph(reversed).capacity), sum(graph.capacity), 1e-3);
}

void weights_do_not_depend_on_scale()
{
  const Weighted_dual_graph small = weighted_dual_graph(to_surface(scaled(star(3), 0.5)));
  const Weighted_dual_graph large = weighted_dual_graph(to_surface(scaled(star(3), 64)));
  CHECK(small.capacity == large.capacity);
  CHECK(small.curvature == large.curvature);
}

void coarse_nodes_are_connected_and_add_up(const Test_mesh& mesh, Index number_of_nodes)
{
  const Weighted_dual_graph fine = weighted_dual_graph(to_surface(mesh));
  const internal::Coarse_graph coarse = internal::coarsen(fine, number_of_nodes, quiet_execution());
  const Index n = coarse.graph.number_of_nodes();
  CHECK(n <= fine.number_of_nodes());
  check_symmetry(coarse.graph);

  std::vector<double> area(n, 0);
  double border = 0;
  for (Index f = 0; f < fine.number_of_nodes(); ++f)
  {
    area[coarse.node[f]] += fine.area[f];
    for (const Index arc : fine.arcs(f))
      if (coarse.node[fine.target[arc]] != coarse.node[f])
        border += fine.capacity[arc];
  }
  for (Index i = 0; i < n; ++i)
    CHECK_CLOSE(area[i], coarse.graph.area[i], 1e-12);
  CHECK_CLOSE(sum(coarse.graph.capacity), border, 1e-4 * (1 + border));

  // every node's faces are reached from its first one
  std::vector<bool> has_begun(n, false), is_reached(fine.number_of_nodes(), false);
  std::size_t reached = 0;
  for (Index f = 0; f < fine.number_of_nodes(); ++f)
  {
    if (has_begun[coarse.node[f]])
      continue;
    has_begun[coarse.node[f]] = true;
    std::vector<Index> queue(1, f);
    is_reached[f] = true;
    for (std::size_t i = 0; i < queue.size(); ++i, ++reached)
      for (const Index arc : fine.arcs(queue[i]))
      {
        const Index g = fine.target[arc];
        if (!is_reached[g] && coarse.node[g] == coarse.node[f])
        {
          is_reached[g] = true;
          queue.push_back(g);
        }
      }
  }
  CHECK_EQUAL(reached, fine.number_of_nodes());
}

// Faces of a strip that are next to each other lie far from each other in the order of the faces.
void a_strip_as_narrow_as_a_face_is_coarsened()
{
  const Weighted_dual_graph strip = weighted_dual_graph(to_surface(thin_strip(10000, 1e-4)));
  for (const Index number : {Index(6000), Index(500)})
    CHECK(internal::coarsen(strip, number, quiet_execution()).graph.number_of_nodes() < 1.1 * number);
}

// Threads are there to save time only: all weights and nodes are the same to the last bit, of a surface so large that it
// is divided among them, and with groups of faces.
void the_number_of_threads_does_not_matter()
{
#ifdef CGAL_LINKED_WITH_TBB
  const Indexed_surface surface = to_surface(jittered(icosphere(6), 0.001, 5));
  Execution parallel(0, true);
  const Weighted_dual_graph expected = weighted_dual_graph(surface);
  const Weighted_dual_graph found = weighted_dual_graph(surface, parallel);
  CHECK(found.first_arc == expected.first_arc && found.target == expected.target);
  CHECK(found.length == expected.length && found.border_length == expected.border_length);
  CHECK(found.curvature == expected.curvature && found.capacity == expected.capacity);
  CHECK(found.area == expected.area && found.centre == expected.centre);

  internal::Coarse_graph expected_nodes = internal::coarsen(expected, 2000, quiet_execution());
  internal::Coarse_graph nodes = internal::coarsen(found, 2000, parallel);
  internal::measure_volumes(surface, expected_nodes.node, expected_nodes.graph);
  internal::measure_volumes(surface, nodes.node, nodes.graph, true);
  CHECK(nodes.node == expected_nodes.node);
  CHECK(nodes.graph.first_arc == expected_nodes.graph.first_arc && nodes.graph.target == expected_nodes.graph.target);
  CHECK(nodes.graph.length == expected_nodes.graph.length && nodes.graph.area == expected_nodes.graph.area);
  CHECK(nodes.graph.curvature == expected_nodes.graph.curvature);
  CHECK(nodes.graph.capacity == expected_nodes.graph.capacity);
  CHECK(nodes.graph.border_vector == expected_nodes.graph.border_vector);
  CHECK(nodes.graph.border_area == expected_nodes.graph.border_area && nodes.graph.flux == expected_nodes.graph.flux);
#endif
}

int main()
{
  smoothed_normals_of_a_sphere_point_outward();
  groups_of_faces_average_like_faces();
  diffusion_keeps_the_mean();
  a_strip_as_narrow_as_a_face_is_coarsened();
  the_number_of_threads_does_not_matter();
  seams_lie_where_parts_meet();
  weights_do_not_depend_on_scale();
  coarse_nodes_are_connected_and_add_up(star(4), 300);
  coarse_nodes_are_connected_and_add_up(sheet(20, 30), 50);
  coarse_nodes_are_connected_and_add_up(icosahedron(), 2000);
  coarse_nodes_are_connected_and_add_up(merged({torus(), icosphere(3)}), 100);
  for (unsigned int seed = 0; seed < 20; ++seed)
    coarse_nodes_are_connected_and_add_up(random_surface(seed), 10);
  return check::result();
}
