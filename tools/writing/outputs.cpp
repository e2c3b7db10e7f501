// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "writing/outputs.h"

#include "reading/lower_case_extension.h"
#include "reading/mesh_of_soup.h"
#include "writing/closed_parts.h"
#include "writing/glb.h"
#include "writing/palette.h"
#include "writing/vtp.h"

#include <CGAL/IO/SEG.h>
#include <CGAL/Surface_mesh/IO/OFF.h>
#include <CGAL/Surface_mesh/IO/PLY.h>

#include <cstdint>
#include <filesystem>
#include <map>
#include <numeric>
#include <stdexcept>

namespace tool
{
namespace
{

// A mesh with its segments as face properties, which CGAL's writers put into files.
struct Segmented_mesh
{
  Mesh mesh;
  Mesh::Property_map<Face, std::uint32_t> segments; // a type that PLY knows
  Mesh::Property_map<Face, CGAL::IO::Color> colors;

  // `segment_of` has the segment of every face.
  Segmented_mesh(const Mesh& plain, const std::vector<std::size_t>& segment_of) : mesh(plain)
  {
    segments = mesh.add_property_map<Face, std::uint32_t>("f:segment").first;
    colors = mesh.add_property_map<Face, CGAL::IO::Color>("f:color").first;
    std::size_t i = 0;
    for (const Face f : faces(mesh))
    {
      segments[f] = static_cast<std::uint32_t>(segment_of[i]);
      colors[f] = segment_color(segment_of[i++]);
    }
  }
};

bool write_seg(std::ostream& out, const Segmented_mesh& segmented)
{
  return CGAL::IO::write_SEG(out, segmented.mesh, segmented.segments);
}

// Blender reads the colours of vertices only: a vertex gets that of one of its faces.
bool write_ply(std::ostream& out, const Segmented_mesh& segmented)
{
  Mesh mesh = segmented.mesh;
  auto vertex_colors = mesh.add_property_map<Mesh::Vertex_index, CGAL::IO::Color>("v:color").first;
  for (const Face f : faces(mesh))
    for (const auto v : vertices_around_face(mesh.halfedge(f), mesh))
      vertex_colors[v] = segmented.colors[f];
  CGAL::IO::set_binary_mode(out);
  return CGAL::IO::write_PLY(out, mesh);
}

bool write_off(std::ostream& out, const Segmented_mesh& segmented)
{
  out.precision(17); // a double is read as it was written
  return CGAL::IO::write_OFF(out, segmented.mesh);
}

bool write_glb(std::ostream& out, const Segmented_mesh& segmented)
{
  write_GLB(out, segmented.mesh, segmented.segments);
  return true;
}

bool write_vtp(std::ostream& out, const Segmented_mesh& segmented)
{
  write_VTP(out, segmented.mesh, segmented.segments);
  return true;
}

struct Format
{
  std::string extension;
  std::string description;
  bool (*write)(std::ostream&, const Segmented_mesh&);
  bool holds_a_mesh; // then there can be a file per segment
};

const std::vector<Format>& formats()
{
  static const std::vector<Format> table = {
      {".seg", "one segment id a line, as in the Princeton Segmentation Benchmark", write_seg,
       false},
      {".ply", "mesh with colours of faces and vertices and a face property 'segment', binary", write_ply,
       true},
      {".off", "mesh with face colours", write_off, true},
      {".glb", "glTF 2.0, binary: a coloured mesh of its own for each segment", write_glb, true},
      {".vtp", "VTK polygonal data, text, with cell data 'segment' and 'color'", write_vtp, true}};
  return table;
}

const Format* find_format(const std::string& name)
{
  const std::string extension = lower_case_extension(name);
  for (const Format& format : formats())
    if (format.extension == extension)
      return &format;
  return nullptr;
}

constexpr const char* placeholder = "%d";

std::string name_of_part(std::string pattern, std::size_t segment)
{
  return pattern.replace(pattern.find(placeholder), 2, std::to_string(segment));
}

// The faces of one segment, with the vertices that they need.
Polygon_soup soup_of_segment(const Mesh& mesh, const std::vector<Face>& faces_of_segment)
{
  Polygon_soup soup;
  std::map<Mesh::Vertex_index, std::size_t> indices;
  for (const Face f : faces_of_segment)
  {
    soup.polygons.emplace_back();
    for (const auto v : vertices_around_face(mesh.halfedge(f), mesh))
    {
      const auto [position, is_new] = indices.emplace(v, soup.points.size());
      if (is_new)
        soup.points.push_back(mesh.point(v));
      soup.polygons.back().push_back(position->second);
    }
  }
  return soup;
}

void add_file(const std::string& name, const Segmented_mesh& segmented, Output_files& files)
{
  const Format& format = *find_format(name);
  files.add(name,
            [&](std::ostream& out)
            {
              if (!format.write(out, segmented))
                out.setstate(std::ios::failbit);
            });
}

std::vector<Polygon_soup> open_soups(const Mesh& mesh, const Segmentation& segmentation)
{
  std::vector<std::vector<Face>> faces_of(segmentation.number_of_segments);
  std::size_t i = 0;
  for (const Face f : faces(mesh))
    faces_of[segmentation.segment_ids[i++]].push_back(f);
  std::vector<Polygon_soup> soups;
  for (const std::vector<Face>& faces_of_segment : faces_of)
    soups.push_back(soup_of_segment(mesh, faces_of_segment));
  return soups;
}

std::vector<Polygon_soup> closed_soups(const Mesh& mesh, const Segmentation& segmentation)
{
  std::vector<std::size_t> parents(segmentation.number_of_segments);
  std::iota(parents.begin(), parents.end(), std::size_t(0));
  for (const Protrusion& protrusion : segmentation.record.protrusions())
    parents[protrusion.segment] = protrusion.parent;
  std::vector<Polygon_soup> soups;
  for (const Closed_part& part : closed_parts(mesh, segmentation.segment_ids, parents))
  {
    soups.push_back({part.points, {}});
    for (const std::vector<std::size_t>& polygon : part.polygons)
      soups.back().polygons.emplace_back(polygon.begin(), polygon.end());
  }
  return soups;
}

void add_parts(const std::string& pattern,
               const std::vector<Polygon_soup>& soups,
               Output_files& files)
{
  files.make_folder_of(pattern);
  for (std::size_t s = 0; s < soups.size(); ++s)
  {
    const std::string name = name_of_part(pattern, s);
    const Mesh part = mesh_of_soup(soups[s], name);
    add_file(name, {part, std::vector<std::size_t>(part.number_of_faces(), s)}, files);
  }
}

} // namespace

std::vector<std::string> output_formats()
{
  std::vector<std::string> result;
  for (const Format& format : formats())
    result.push_back(format.extension + ": " + format.description);
  return result;
}

bool is_pattern(const std::string& name) { return name.find(placeholder) != std::string::npos; }

void check_output_name(const std::string& name)
{
  const Format* format = find_format(name);
  if (!format)
  {
    std::string known;
    for (const Format& f : formats())
      known += (known.empty() ? "" : ", ") + f.extension;
    throw std::invalid_argument("-o: '" + name + "' has none of the extensions " + known);
  }
  if (!is_pattern(name))
    return;
  if (!format->holds_a_mesh)
    throw std::invalid_argument("-o: '" + name + "' has a %d, but " + format->extension +
                                " files are of the whole mesh");
  if (name.find(placeholder) != name.rfind(placeholder) ||
      is_pattern(std::filesystem::path(name).parent_path().string()))
    throw std::invalid_argument("-o: '" + name +
                                "' has a %d elsewhere than once in the file's name");
}

void add_output(const std::string& name,
                const Mesh& mesh,
                const Segmentation& segmentation,
                bool is_closed,
                Output_files& files)
{
  if (is_pattern(name))
    add_parts(name, is_closed ? closed_soups(mesh, segmentation) : open_soups(mesh, segmentation), files);
  else
    add_file(name, {mesh, segmentation.segment_ids}, files);
}

} // namespace tool
