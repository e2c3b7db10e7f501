// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "reading/formats.h"

#include "reading/Format_error.h"

#include <CGAL/IO/VTK.h>
#include <CGAL/Protrusion_segmentation/internal/IO/write_complete_file.h>

#include <filesystem>
#include <ostream>

namespace tool
{

// CGAL reads this format from files only.
Polygon_soup read_VTP(const std::string& bytes)
{
  namespace internal = CGAL::Protrusion_segmentation::internal;
  const internal::Temporary_file file(std::filesystem::temp_directory_path() / "mesh.vtp");
  Polygon_soup soup;
  if (!internal::write_file(file.name(), [&](std::ostream& out) { out << bytes; }))
    throw Format_error("cannot be copied to the folder of temporary files");
  if (!CGAL::IO::read_VTP(file.name().string(), soup.points, soup.polygons))
    throw Format_error("is not a well-formed VTP file");
  return soup;
}

} // namespace tool
