// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A reader for each format: from the bytes of a file, all of them, to its faces; or throws a `Format_error`.
// Text in OBJ and STL is brought into the form that CGAL's readers are sure to understand. What they take
// on trust is checked on the way: that there is as much as is announced, and that corners exist.

#ifndef PROTRUSION_SEGMENTATION_TOOLS_READING_FORMATS_H
#define PROTRUSION_SEGMENTATION_TOOLS_READING_FORMATS_H

#include "reading/Polygon_soup.h"

#include <string>
#include <string_view>
#include <vector>

namespace tool
{

Polygon_soup read_OBJ(const std::string& bytes);
Polygon_soup read_OFF(const std::string& bytes); // text and, in either byte order, binary
Polygon_soup read_PLY(const std::string& bytes);
Polygon_soup read_STL(const std::string& bytes);
Polygon_soup read_TS(const std::string& bytes);
#ifdef PROTRUSION_SEGMENTATION_HAS_VTK
Polygon_soup read_VTP(const std::string& bytes);
#endif
#ifdef PROTRUSION_SEGMENTATION_HAS_3MF
Polygon_soup read_3MF(const std::string& bytes);
#endif
#ifdef PROTRUSION_SEGMENTATION_HAS_GLTF
Polygon_soup read_glTF(const std::string& bytes, const std::string& folder); // where files that it names are
#endif

// The labels of faces in face data of a name in `is_label()`.
std::vector<double> read_PLY_labels(const std::string& bytes);
#ifdef PROTRUSION_SEGMENTATION_HAS_VTK
std::vector<double> read_VTP_labels(const std::string& bytes);
#endif
inline bool is_label(std::string_view name)
{
  return name == "segment" || name == "segments" || name == "label" || name == "labels" || name == "Label";
}

// `rest` is what follows the header line of a binary file, which says what vertices carry.
Polygon_soup read_binary_OFF(std::string_view rest, bool has_normals, bool has_colors);

// Is the file as long as a binary one with the number of facets that it announces?
bool is_binary_STL(const std::string& bytes);

} // namespace tool

#endif // PROTRUSION_SEGMENTATION_TOOLS_READING_FORMATS_H
