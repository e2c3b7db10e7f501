// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Meshes built in code, with the true part of every face. Closed ones are oriented outward.
//
//   using namespace test_meshes;
//   const Test_mesh soup = star(5);                          // points, faces, parts
//   const auto pmesh = to_graph<CGAL::Surface_mesh<K::Point_3>>(soup);  // any MutableFaceGraph
//
// | header            | meshes                                                                |
// |-------------------|-----------------------------------------------------------------------|
// | polyhedra         | single_triangle, tetrahedron, box, voxels, pierced_plate (any genus), |
// |                   | sheet, thin_strip, moebius_strip, prism, regular_prism, l_prism, gear |
// | spheres           | icosahedron, dodecahedron, football, icosphere, dual, truncated       |
// | revolution        | uv_sphere, open_cylinder, closed_cylinder, capsule,                   |
// |                   | capsule_with_ball, dumbbell, torus, revolution of a Profile           |
// | bodies            | star, star_of_equal_arms, creature, body_with_hands, implicit_mesh    |
// | random            | jittered, bumpy_sphere, height_field, random_surface                  |
// | transformations   | translated, scaled, rotated, transformed, with_face_order,            |
// |                   | with_reversed_orientation, triangulated, merged, random_permutation   |

#ifndef CGAL_TEST_PROTRUSION_SEGMENTATION_TEST_MESHES_H
#define CGAL_TEST_PROTRUSION_SEGMENTATION_TEST_MESHES_H

#include "test_mesh.h"
#include "test_meshes_bodies.h"
#include "test_meshes_polyhedra.h"
#include "test_meshes_random.h"
#include "test_meshes_revolution.h"
#include "test_meshes_spheres.h"
#include "test_meshes_transformations.h"

#endif // CGAL_TEST_PROTRUSION_SEGMENTATION_TEST_MESHES_H
