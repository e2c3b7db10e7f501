// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "example_meshes/mesh_of_shape.h"

#include "example_meshes/remesh.h"
#include "zero_set.h" // the mesher of the tests

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace example_shapes
{
namespace
{

constexpr double thinnest = 0.1; // about the radius of the thinnest tip; a coarser grid misses it

using test_meshes::Test_mesh;

Test_mesh fine_mesh(const Shape& shape, double cell)
{
  const CGAL::Bbox_3 bbox = shape.bbox();
  const test_meshes::Box box = {{bbox.xmin(), bbox.ymin(), bbox.zmin()},
                                {bbox.xmax(), bbox.ymax(), bbox.zmax()}};
  const auto value = [&](const test_meshes::Point& p) { return shape(Point(p[0], p[1], p[2])); };
  return test_meshes::Marching_tetrahedra(value, box, cell).run();
}

} // namespace

// The number of faces is nearly proportional to 1 / edge^2.
tool::Mesh mesh_of_shape(const Shape& shape, std::size_t number_of_faces)
{
  const double wanted = 1.12 * double(number_of_faces);
  const Test_mesh rough = fine_mesh(shape, thinnest);
  double edge = std::sqrt(4 / std::sqrt(3.) * test_meshes::area(rough) / wanted);
  const tool::Mesh fine = test_meshes::to_graph<tool::Mesh>(fine_mesh(shape, (std::min)(1.2 * edge, thinnest)));
  for (;;)
  {
    tool::Mesh mesh = fine;
    remesh(mesh, shape, edge);
    const double found = double(mesh.number_of_faces());
    if (found >= double(number_of_faces) && found <= 1.25 * double(number_of_faces))
      return mesh;
    edge *= std::sqrt(found / wanted);
  }
}

} // namespace example_shapes
