// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The distances that need a library, for the tests of all distances: where the library is missing, so are they.

#ifndef CGAL_TEST_PROTRUSION_SEGMENTATION_OPTIONAL_DISTANCES_H
#define CGAL_TEST_PROTRUSION_SEGMENTATION_OPTIONAL_DISTANCES_H

#include "test_mesh.h" // first: it includes a header of Boost that does not compile after those of Boost Graph

#include <CGAL/Protrusion_segmentation/Diffusion_distance.h>
#include <CGAL/Protrusion_segmentation/Heat_distance.h>

#ifdef CGAL_EIGEN3_ENABLED
template <typename Function>
void with_heat_distance(Function function)
{
  function(CGAL::Protrusion_segmentation::Heat_distance());
}
#else
template <typename Function>
void with_heat_distance(Function)
{}
#endif

#if defined(CGAL_EIGEN3_ENABLED) && __has_include(<Spectra/SymEigsSolver.h>)
template <typename Function>
void with_diffusion_distance(Function function)
{
  function(CGAL::Protrusion_segmentation::Diffusion_distance());
}
#else
template <typename Function>
void with_diffusion_distance(Function)
{}
#endif

#endif // CGAL_TEST_PROTRUSION_SEGMENTATION_OPTIONAL_DISTANCES_H
