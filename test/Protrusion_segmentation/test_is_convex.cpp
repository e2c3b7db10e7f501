// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which surfaces are convex, and that these are one segment that is not searched for cuts.

#include "check.h"
#include "indexed_surfaces.h"
#include "recorder.h"
#include "segmentations.h"
#include "test_meshes.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Protrusion_segmentation/internal/Mesh/read_surface.h>
#include <CGAL/Protrusion_segmentation/internal/Surface/is_convex.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/convex_hull_3.h>

#include <boost/property_map/property_map.hpp>

#include <cmath>
#include <random>
#include <vector>

using namespace test_meshes;
using CGAL::Protrusion_segmentation::internal::is_convex;
using Mesh = CGAL::Surface_mesh<CGAL::Exact_predicates_inexact_constructions_kernel::Point_3>;

void check_convex(const Test_mesh& mesh, bool expected)
{
  for (const Test_mesh& same : {mesh, with_reversed_orientation(mesh), scaled(mesh, 1e-3), rotated(mesh, {1, 2, 3}, 1)})
    CGAL_CHECK_EQUAL(is_convex(to_surface(same)), expected);
  Recorder<Mesh> record;
  const Mesh graph = to_graph<Mesh>(mesh);
  const Segmentation found = checked(
    graph, [&](auto ids)
    { return CGAL::segmentation_via_protrusion_tips(graph, ids, CGAL::parameters::visitor(std::ref(record))); });
  CGAL_CHECK_EQUAL(record.stages.count("preparation"), expected ? 0u : 1u);
  if (expected)
    CGAL_CHECK_EQUAL(found.number, 1);
}

bool is_convex_mesh(const Mesh& mesh)
{
  return is_convex(
    CGAL::Protrusion_segmentation::internal::read_surface(mesh, CGAL::parameters::default_values()).surface.to_surface());
}

// With a dent they are not.
void hulls_of_random_points()
{
  std::mt19937 random(1);
  const auto coordinate = [&random]() { return static_cast<double>(random()) / 4294967296. - 0.5; };
  for (const std::size_t number : {6, 10, 30, 100, 400})
  {
    std::vector<Mesh::Point> points;
    for (std::size_t i = 0; i < number; ++i)
      points.emplace_back(coordinate(), 2 * coordinate(), 0.5 * coordinate());
    Mesh hull;
    CGAL::convex_hull_3(points.begin(), points.end(), hull);
    CGAL_CHECK(is_convex_mesh(hull));
    const auto v = *hull.vertices().begin();
    Mesh::Point middle(0, 0, 0);
    for (const auto w : vertices_around_target(hull.halfedge(v), hull))
      middle = middle + (hull.point(w) - CGAL::ORIGIN) / double(hull.degree(v));
    hull.point(v) = middle + 1.05 * (middle - hull.point(v));
    CGAL_CHECK(!is_convex_mesh(hull));
  }
}

// Two halves of a convex body may be parts.
void patches_are_looked_at()
{
  const Mesh mesh = to_graph<Mesh>(scaled(icosphere(3), 3, 1, 1));
  std::vector<int> patches;
  for (const auto f : mesh.faces())
    patches.push_back(mesh.point(mesh.target(mesh.halfedge(f))).x() > 0 ? 1 : 0);
  const auto map = boost::make_iterator_property_map(patches.begin(), get(boost::face_index, mesh));
  Recorder<Mesh> record;
  checked(mesh,
          [&](auto ids)
          {
            return CGAL::segmentation_via_protrusion_tips(mesh, ids,
                                                          CGAL::parameters::face_patch_map(map).visitor(std::ref(record)));
          });
  CGAL_CHECK_EQUAL(record.stages.count("preparation"), 1);
}

int main()
{
  patches_are_looked_at();
  for (const Test_mesh& mesh : {tetrahedron(), box(), box(4, 1, 1), regular_prism(5), icosahedron(), icosphere(3)})
    check_convex(mesh, true);
  for (const Test_mesh& mesh : {star(5, 2, 0.25, 0.1, 0.2), sheet(7, 5, 30, 20)})
    check_convex(mesh, false);
  hulls_of_random_points();
  return check::result();
}
