// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Valid meshes that are hard on a segmentation: few faces, no protrusion, polygons, holes, handles, needles,
// faces without area, repeated points, coordinates at the ends of the range of double.

#ifndef CGAL_TEST_PROTRUSION_SEGMENTATION_AWKWARD_MESHES_H
#define CGAL_TEST_PROTRUSION_SEGMENTATION_AWKWARD_MESHES_H

#include "test_meshes.h"

#include <string>

namespace test_meshes {

struct Awkward_mesh
{
  std::string name;
  Test_mesh mesh;
};
using Awkward_meshes = std::vector<Awkward_mesh>;

inline Awkward_meshes meshes_of_few_faces()
{
  return {{"triangle", single_triangle()},
          {"two triangles", thin_strip(1)},
          {"quad", sheet(1, 1)},
          {"tetrahedron", tetrahedron()},
          {"box", box()}};
}

inline Awkward_meshes bodies_without_protrusions()
{
  return {{"sphere", icosphere(2)},
          {"flat sheet", sheet(15, 15)},
          {"torus", torus(2, 0.5, 24, 10)},
          {"open cylinder", open_cylinder(1, 1)},
          {"coarse sphere", uv_sphere(1, 0.3)},
          {"prism", regular_prism(40)}};
}

inline Awkward_meshes polygons_holes_and_handles()
{
  return {{"football", football()},
          {"dodecahedron", dodecahedron()},
          {"concave polygons", l_prism()},
          {"handles", pierced_plate(3, 2)},
          {"height field", height_field(12, 9, 1)},
          {"inward", with_reversed_orientation(bumpy_sphere(2, 1))},
          {"components", merged({icosphere(1), translated(sheet(3, 2), {3, 0, 0}),
                                 translated(single_triangle(), {0, 5, 0})})}};
}

inline Awkward_meshes needles_and_slivers()
{
  return {{"thin strip", thin_strip(200, 1e-9)},
          {"thinner strip", thin_strip(200, 1e-200)},
          {"needle", scaled(bumpy_sphere(2, 2), 1e-12, 1, 1e6)},
          {"thinner needle", scaled(icosphere(2), 1e-300, 1e-300, 1)}};
}

// Flattened to a plane, a line and a point: faces without area, edges without length.
inline Awkward_meshes collapsed_bodies()
{
  Awkward_meshes result;
  for (const Test_mesh& mesh : {bumpy_sphere(2, 5), torus(2, 0.5, 20, 8)})
  {
    result.push_back({"plane", scaled(mesh, 1, 1, 0)});
    result.push_back({"line", scaled(mesh, 1, 0, 0)});
    result.push_back({"point", scaled(mesh, 0)});
  }
  return result;
}

inline Test_mesh with_repeated_points(Test_mesh mesh, std::size_t number)
{
  Random random(1);
  for (; number > 0; --number)
  {
    const std::size_t from = random.index(mesh.points.size());
    mesh.points[random.index(mesh.points.size())] = mesh.points[from];
  }
  return mesh;
}

inline Awkward_meshes points_at_random()
{
  Awkward_meshes result = {{"repeated points", with_repeated_points(bumpy_sphere(2, 6), 80)}};
  for (std::uint_fast32_t seed = 0; seed < 5; ++seed)
    result.push_back({"random points " + std::to_string(seed), jittered(random_surface(seed), 10, seed)});
  return result;
}

inline Awkward_meshes tiny_and_huge_coordinates()
{
  Awkward_meshes result;
  for (const double factor : {1e-320, 1e-300, 1e-100, 1e100, 1e300, 1.2e308})
    result.push_back(
      {"scaled by " + std::to_string(std::log10(factor)), scaled(bumpy_sphere(2, 7), factor)});
  result.push_back({"far away", translated(bumpy_sphere(2, 7), {1e12, 0, 0})});
  result.push_back({"one point for all digits lost", translated(bumpy_sphere(2, 7), {1e300, 0, 0})});
  return result;
}

inline Awkward_meshes awkward_meshes()
{
  Awkward_meshes result;
  for (const Awkward_meshes& some :
       {meshes_of_few_faces(), bodies_without_protrusions(), polygons_holes_and_handles(),
        needles_and_slivers(), collapsed_bodies(), points_at_random(), tiny_and_huge_coordinates()})
    result.insert(result.end(), some.begin(), some.end());
  return result;
}

} // namespace test_meshes

#endif // CGAL_TEST_PROTRUSION_SEGMENTATION_AWKWARD_MESHES_H
