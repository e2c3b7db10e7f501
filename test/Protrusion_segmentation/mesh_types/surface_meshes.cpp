// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "mesh_types.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

namespace mesh_types {

template <typename Kernel>
using Mesh_with = CGAL::Surface_mesh<typename Kernel::Point_3>;

// A map that is part of the mesh.
void property_maps_of_a_surface_mesh_take_the_labels()
{
  using Mesh = Mesh_with<CGAL::Simple_cartesian<double>>;
  Mesh mesh = to_graph<Mesh>(body());
  auto ids = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:segment", 0).first;
  const Mesh& constant_mesh = mesh;
  CGAL_CHECK_EQUAL(CGAL::segmentation_via_protrusion_tips(constant_mesh, ids, number_of_segments),
              number_of_segments);
  for (const auto f : faces(mesh))
    CGAL_CHECK_EQUAL(ids[f], expected_default_labels()[std::size_t(f)]);
}

// Removed elements stay in the arrays of the mesh, and its indices have gaps.
void removed_elements_of_a_surface_mesh_do_not_count()
{
  using Mesh = Mesh_with<CGAL::Simple_cartesian<double>>;
  Mesh mesh;
  const auto extra = mesh.add_face(mesh.add_vertex({9, 0, 0}), mesh.add_vertex({9, 1, 0}),
                                   mesh.add_vertex({9, 0, 1}));
  convert(body(), mesh);
  CGAL::Euler::remove_face(halfedge(extra, mesh), mesh);
  CGAL_CHECK(mesh.has_garbage());
  gives_the_same_labels(mesh);
}

void test_surface_meshes()
{
  gives_the_same_labels<Mesh_with<CGAL::Simple_cartesian<double>>>();
  gives_the_same_labels<Mesh_with<CGAL::Simple_cartesian<float>>>();
  gives_the_same_labels<Mesh_with<CGAL::Exact_predicates_inexact_constructions_kernel>>();
  gives_the_same_labels<Mesh_with<CGAL::Exact_predicates_exact_constructions_kernel>>();
  property_maps_of_a_surface_mesh_take_the_labels();
  removed_elements_of_a_surface_mesh_do_not_count();
}

} // namespace mesh_types
