// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the fuzz targets share. Each defines `fuzz()`, which ends the program if a guarantee is broken;
// libFuzzer calls it with bytes of its own, `replay.cpp` with those of files.

#ifndef CGAL_TEST_PROTRUSION_SEGMENTATION_FUZZ_TARGET_H
#define CGAL_TEST_PROTRUSION_SEGMENTATION_FUZZ_TARGET_H

#include <cstdlib>
#include <iostream>
#include <string>

void fuzz(const std::string& bytes);

inline void require(bool condition, const std::string& problem)
{
  if (condition)
    return;
  std::cerr << "a guarantee is broken: " << problem << std::endl;
  std::abort();
}

#endif // CGAL_TEST_PROTRUSION_SEGMENTATION_FUZZ_TARGET_H
