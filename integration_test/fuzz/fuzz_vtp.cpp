// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Any bytes as a file of VTK. The first byte chooses method and number of segments, the rest is the file.

#include "fuzz_target.h"
#include "mesh_file.h"

void fuzz(const std::string& bytes)
{
  if (!bytes.empty())
    fuzz_mesh_file(".vtp", bytes.substr(1), static_cast<unsigned char>(bytes[0]));
}
