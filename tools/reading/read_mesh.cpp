// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The only file that includes CGAL's readers, which take long to compile.

#include "reading/read_mesh.h"

#include "reading/check_announcements.h"
#include "reading/lower_case_extension.h"
#include "reading/mesh_of_soup.h"

#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/stitch_borders.h>

#ifdef CGAL_USE_VTK
#include <CGAL/IO/VTK.h>
#endif

#include <algorithm>
#include <cmath>
#include <exception>
#include <fstream>
#include <iostream>
#include <new>
#include <stdexcept>
#include <string>
#include <vector>

namespace tool
{
namespace
{

// CGAL's readers print remarks of their own; a tool prints one line, with the cause.
class Silence
{
public:
  Silence() : m_cerr(std::cerr.rdbuf(nullptr)), m_cout(std::cout.rdbuf(nullptr)) { }
  Silence(const Silence&) = delete;
  Silence& operator=(const Silence&) = delete;
  ~Silence()
  {
    std::cerr.rdbuf(m_cerr);
    std::cout.rdbuf(m_cout);
    std::cerr.clear();
    std::cout.clear();
  }

private:
  std::streambuf* m_cerr;
  std::streambuf* m_cout;
};

void check_format(const std::string& file_name)
{
  const std::vector<std::string> known = mesh_extensions();
  if (std::find(known.begin(), known.end(), lower_case_extension(file_name)) == known.end())
    throw Error(file_name, "is in no known format (known are " + known_formats() + ")");
}

// Is this a file whose first bytes can be read? CGAL's readers tell that from no other failure.
void check_readable(const std::string& file_name)
{
  std::ifstream in(file_name, std::ios::binary);
  if (!in)
    throw Error(file_name, "cannot be opened");
  in.peek();
  if (in.bad())
    throw Error(file_name, "cannot be read");
  if (in.eof())
    throw Error(file_name, "is empty");
}

bool read_soup_by_extension(const std::string& file_name, Polygon_soup& soup)
{
#ifdef CGAL_USE_VTK
  if (lower_case_extension(file_name) == ".vtp")
    return CGAL::IO::read_VTP(file_name, soup.points, soup.polygons);
#endif
  return CGAL::IO::read_polygon_soup(file_name, soup.points, soup.polygons,
                                     CGAL::parameters::verbose(false));
}

Polygon_soup read_soup(const std::string& file_name)
{
  check_readable(file_name);
  check_format(file_name);
  check_announcements(file_name);
  Polygon_soup soup;
  bool is_read = false;
  try
  {
    const Silence silence;
    is_read = read_soup_by_extension(file_name, soup);
  }
  catch (const std::bad_alloc&)
  {
    throw Error(file_name, "announces more than fits into memory");
  }
  catch (const std::exception&)
  {
    is_read = false;
  }
  if (!is_read)
    throw Error(file_name, "is not a well-formed mesh file");
  return soup;
}

void check_soup(const Polygon_soup& soup, const std::string& file_name)
{
  if (soup.polygons.empty())
    throw Error(file_name, "has no faces");
  for (std::size_t i = 0; i < soup.points.size(); ++i)
    for (int c = 0; c < 3; ++c)
      if (!std::isfinite(soup.points[i][c]))
        throw Error(file_name, "vertex " + std::to_string(i) + " has no finite coordinates");
  for (std::size_t i = 0; i < soup.polygons.size(); ++i)
  {
    Polygon corners = soup.polygons[i];
    std::sort(corners.begin(), corners.end());
    const std::string face = "face " + std::to_string(i);
    if (corners.size() < 3)
      throw Error(file_name, face + " has fewer than three corners");
    if (corners.back() >= soup.points.size())
      throw Error(file_name, face + " has a corner that does not exist");
    if (std::adjacent_find(corners.begin(), corners.end()) != corners.end())
      throw Error(file_name, face + " has one corner twice");
  }
}

} // namespace

std::vector<std::string> mesh_extensions()
{
  return {".off", ".obj", ".ply", ".stl", ".ts",
#ifdef CGAL_USE_VTK
          ".vtp"
#endif
  };
}

std::string known_formats()
{
  std::string names;
  for (const std::string& extension : mesh_extensions())
    names += (names.empty() ? "" : ", ") + extension.substr(1);
  return names;
}

Mesh mesh_of_soup(Polygon_soup soup, const std::string& file_name)
{
  namespace PMP = CGAL::Polygon_mesh_processing;

  if (!PMP::is_polygon_soup_a_polygon_mesh(soup.polygons))
    PMP::orient_polygon_soup(soup.points, soup.polygons);
  if (!PMP::is_polygon_soup_a_polygon_mesh(soup.polygons))
    throw Error(file_name, "its faces do not make up a surface mesh");
  Mesh mesh;
  PMP::polygon_soup_to_polygon_mesh(soup.points, soup.polygons, mesh);
  if (mesh.number_of_faces() != soup.polygons.size() || !mesh.is_valid(false))
    throw Error(file_name, "its faces do not make up a surface mesh");
  return mesh;
}

Mesh read_mesh(const std::string& file_name)
{
  const Polygon_soup soup = read_soup(file_name);
  check_soup(soup, file_name);
  Mesh mesh = mesh_of_soup(soup, file_name);
  CGAL::Polygon_mesh_processing::stitch_borders(mesh);
  mesh.collect_garbage();
  if (mesh.number_of_faces() != soup.polygons.size() || !mesh.is_valid(false))
    throw Error(file_name, "its faces do not make up a surface mesh");
  return mesh;
}

} // namespace tool
