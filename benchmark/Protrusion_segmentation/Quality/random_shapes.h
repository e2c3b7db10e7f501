// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Shapes with known parts, as many as are asked for: of one kind each, and otherwise random.

#ifndef CGAL_PROTRUSION_SEGMENTATION_BENCHMARK_RANDOM_SHAPES_H
#define CGAL_PROTRUSION_SEGMENTATION_BENCHMARK_RANDOM_SHAPES_H

#include "test_mesh.h"

#include <cstdint>
#include <string>
#include <vector>

// Pegs on bodies, limbs (some with limbs of their own), animals, plates with legs or pegs, sheets (flat, bent, rough), cookies
// (thick sheets), tubes, bodies that are one part, and bodies, some with limbs, that are full of valleys.
const std::vector<std::string>& kinds_of_random_shapes();

// The same for the same kind and seed. Of all kinds but sheets some shapes are open (no underside, or seen from one side
// only) or noisy, and triangles are coarse or fine. `parts` of the mesh has the part of every face.
test_meshes::Test_mesh random_shape(std::size_t kind, std::uint32_t seed);

#endif // CGAL_PROTRUSION_SEGMENTATION_BENCHMARK_RANDOM_SHAPES_H
