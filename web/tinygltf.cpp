// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// tinygltf, which Debian has compiled for other processors only.

#define TINYGLTF_IMPLEMENTATION
#define TINYGLTF_NO_STB_IMAGE
#define TINYGLTF_NO_STB_IMAGE_WRITE
#include <tiny_gltf.h>

namespace tinygltf {

// Pictures are left alone.
bool LoadImageData(Image*, int, std::string*, std::string*, int, int, const unsigned char*, int, void*)
{
  return true;
}

bool WriteImageData(const std::string*, const std::string*, const Image*, bool, std::string*, void*)
{
  return false;
}

} // namespace tinygltf
