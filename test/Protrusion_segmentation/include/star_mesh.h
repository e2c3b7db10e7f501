// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A body with four arms, small and quickly made, for tests of the interface.

#ifndef CGAL_TEST_PROTRUSION_SEGMENTATION_STAR_MESH_H
#define CGAL_TEST_PROTRUSION_SEGMENTATION_STAR_MESH_H

#include "test_meshes.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

namespace test_meshes {

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

inline const Test_mesh& star_soup()
{
  static const Test_mesh soup = star(4, 1, 0.15, 0.04, 0.2);
  return soup;
}

inline const Mesh& star_mesh()
{
  static const Mesh mesh = to_graph<Mesh>(star_soup());
  return mesh;
}

} // namespace test_meshes

#endif // CGAL_TEST_PROTRUSION_SEGMENTATION_STAR_MESH_H
