// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Polygonal data of VTK, as XML. CGAL's writer of this format writes no data of cells; and as text the
// file can be written without VTK and read by people.

#ifndef PROTRUSION_SEGMENTATION_TOOLS_WRITING_VTP_H
#define PROTRUSION_SEGMENTATION_TOOLS_WRITING_VTP_H

#include "reading/Mesh.h"
#include "writing/palette.h"

#include <cstddef>
#include <ostream>
#include <string>

namespace tool
{

template <typename WriteValues>
void write_data_array(std::ostream& out, const std::string& attributes, const WriteValues& write_values)
{
  out << "<DataArray " << attributes << " format=\"ascii\">\n";
  write_values();
  out << "</DataArray>\n";
}

// A cell for each face, in their order, with the segment and its colour.
template <typename SegmentMap>
void write_cell_data(std::ostream& out, const Mesh& mesh, const SegmentMap& segments)
{
  out << "<CellData Scalars=\"segment\">\n";
  write_data_array(out, "type=\"UInt32\" Name=\"segment\"", [&]() {
    for (const Face f : faces(mesh))
      out << segments[f] << "\n";
  });
  write_data_array(out, "type=\"UInt8\" Name=\"color\" NumberOfComponents=\"3\"", [&]() {
    for (const Face f : faces(mesh))
    {
      const CGAL::IO::Color color = segment_color(segments[f]);
      out << int(color.red()) << " " << int(color.green()) << " " << int(color.blue()) << "\n";
    }
  });
  out << "</CellData>\n";
}

inline void write_polygons(std::ostream& out, const Mesh& mesh)
{
  out << "<Points>\n";
  write_data_array(out, "type=\"Float64\" NumberOfComponents=\"3\"", [&]() {
    for (const auto v : vertices(mesh))
      out << mesh.point(v) << "\n";
  });
  out << "</Points>\n<Polys>\n";
  write_data_array(out, "type=\"Int64\" Name=\"connectivity\"", [&]() {
    for (const Face f : faces(mesh))
    {
      for (const auto v : vertices_around_face(mesh.halfedge(f), mesh))
        out << v.idx() << " ";
      out << "\n";
    }
  });
  write_data_array(out, "type=\"Int64\" Name=\"offsets\"", [&]() {
    std::size_t end = 0;
    for (const Face f : faces(mesh))
      out << (end += mesh.degree(f)) << "\n";
  });
  out << "</Polys>\n";
}

template <typename SegmentMap>
void write_VTP(std::ostream& out, const Mesh& mesh, const SegmentMap& segments)
{
  out.precision(17); // a double is read as it was written
  out << "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"0.1\">\n<PolyData>\n"
      << "<Piece NumberOfPoints=\"" << mesh.number_of_vertices() << "\" NumberOfPolys=\""
      << mesh.number_of_faces() << "\">\n";
  write_cell_data(out, mesh, segments);
  write_polygons(out, mesh);
  out << "</Piece>\n</PolyData>\n</VTKFile>\n";
}

} // namespace tool

#endif // PROTRUSION_SEGMENTATION_TOOLS_WRITING_VTP_H
