// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Any bytes as a mesh file that is read without a library. The first byte chooses format, method and number of segments,
// the rest is the file. With an extension in the environment variable FUZZED_FORMAT (`.stl`), all files are in that format.

#include "fuzz_target.h"
#include "mesh_file.h"

#include <cstdlib>
#include <vector>

void fuzz(const std::string& bytes)
{
  static const char* fuzzed = std::getenv("FUZZED_FORMAT");
  static const std::vector<std::string> extensions = {".off", ".obj", ".ply", ".stl", ".ts"};
  if (bytes.empty())
    return;
  const std::size_t choice = static_cast<unsigned char>(bytes[0]);
  fuzz_mesh_file(fuzzed != nullptr ? fuzzed : extensions[choice % extensions.size()], bytes.substr(1),
                 choice / extensions.size());
}
