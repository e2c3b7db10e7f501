// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROTRUSION_SEGMENTATION_TOOLS_READING_MESH_OF_SOUP_H
#define PROTRUSION_SEGMENTATION_TOOLS_READING_MESH_OF_SOUP_H

#include "reading/Mesh.h"

#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

namespace tool
{

// The corners of a face. A broken file that announces too many is not taken at its word.
struct Polygon : std::vector<std::size_t>
{
  static constexpr std::size_t maximum_size = 1000000; // far beyond any real face

  using std::vector<std::size_t>::vector;
  void resize(std::size_t size)
  {
    if (size > maximum_size)
      throw std::length_error("a face has too many corners");
    std::vector<std::size_t>::resize(size);
  }
};

struct Polygon_soup
{
  std::vector<Point> points;
  std::vector<Polygon> polygons;
};

// Makes a mesh with the faces of `soup` in their order. Where faces do not fit together as they are,
// CGAL reorients them and duplicates vertices. Throws an `Error` that names `file_name` if that is
// not enough.
Mesh mesh_of_soup(Polygon_soup soup, const std::string& file_name);

} // namespace tool

#endif // PROTRUSION_SEGMENTATION_TOOLS_READING_MESH_OF_SOUP_H
