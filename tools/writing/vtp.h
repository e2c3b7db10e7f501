// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Polygonal data of VTK, as XML. CGAL's writer of this format writes no data of cells; and as text the
// file can be written without VTK and read by people.

#ifndef PROTRUSION_SEGMENTATION_TOOLS_WRITING_VTP_H
#define PROTRUSION_SEGMENTATION_TOOLS_WRITING_VTP_H

#include <ostream>
#include <string>

namespace tool {

template <typename WriteValues>
void write_data_array(std::ostream& out, const std::string& attributes, const WriteValues& write_values)
{
  out << "<DataArray " << attributes << " format=\"ascii\">\n";
  write_values();
  out << "</DataArray>\n";
}

} // namespace tool

#endif // PROTRUSION_SEGMENTATION_TOOLS_WRITING_VTP_H
