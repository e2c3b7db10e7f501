// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The same labels on every mesh type and with every kernel.

#include "mesh_types/mesh_types.h"
#include "test_meshes.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

namespace mesh_types {

using Simplest_mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

const Test_mesh& body()
{
  static const Test_mesh the_body = transformed(star(4, 2, 0.15, 0.04, 0.2),
                                                [](const Point& p) {
                                                  return Point{float(p[0]), float(p[1]), float(p[2])};
                                                });
  return the_body;
}

const Labels& expected_paper_labels()
{
  static const Labels labels =
    paper_segmentation(to_graph<Simplest_mesh>(body()), number_of_segments).labels;
  return labels;
}

const Labels& expected_default_labels()
{
  static const Labels labels =
    default_segmentation(to_graph<Simplest_mesh>(body()), number_of_segments).labels;
  return labels;
}

} // namespace mesh_types

int main()
{
  mesh_types::test_surface_meshes();
  mesh_types::test_polyhedra();
  mesh_types::test_linear_cell_complex();
  mesh_types::test_views_of_meshes();
#ifdef CGAL_TEST_WITH_OPENMESH
  mesh_types::test_openmesh();
#endif
  return check::result();
}
