// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "reading/formats.h"

#include "reading/Normalized_text.h"

#include <CGAL/IO/GOCAD.h>

namespace tool
{

Polygon_soup read_TS(const std::string& bytes)
{
  Normalized_text text;
  for (Lines lines(bytes); lines.next();)
  {
    text << trim(lines.line());
    text.end_line(lines.line_number());
  }
  Polygon_soup soup;
  text.read_by([&](std::istream& in) { return CGAL::IO::read_GOCAD(in, soup.points, soup.polygons); });
  return soup;
}

} // namespace tool
