// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reading meshes of any format that CGAL reads, with the cause of a failure.

#ifndef CGAL_EXAMPLES_PROTRUSION_SEGMENTATION_READ_MESH_H
#define CGAL_EXAMPLES_PROTRUSION_SEGMENTATION_READ_MESH_H

#include "check_announcements.h"
#include "tool_error.h"

#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/stitch_borders.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#ifdef CGAL_USE_VTK
#include <CGAL/IO/VTK.h>
#endif

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <exception>
#include <fstream>
#include <iostream>
#include <new>
#include <stdexcept>
#include <string>
#include <vector>

namespace tool {

using Point = CGAL::Simple_cartesian<double>::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Face = boost::graph_traits<Mesh>::face_descriptor;

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

// The corners of a face. A broken file that announces too many is not taken at its word.
struct Polygon : std::vector<std::size_t>
{
  static constexpr std::size_t maximum_size = 1000000; // far beyond any real face

  using std::vector<std::size_t>::vector;
  void resize(std::size_t size)
  {
    if(size > maximum_size)
      throw std::length_error("a face has too many corners");
    std::vector<std::size_t>::resize(size);
  }
};

struct Polygon_soup
{
  std::vector<Point> points;
  std::vector<Polygon> polygons;
};

// The extensions of the formats that CGAL reads; VTP is one only if VTK was there at compile time.
inline std::vector<std::string> mesh_extensions()
{
  return {".off", ".obj", ".ply", ".stl", ".ts",
#ifdef CGAL_USE_VTK
          ".vtp"
#endif
  };
}

inline std::string known_formats()
{
  std::string names;
  for(const std::string& extension : mesh_extensions())
    names += (names.empty() ? "" : ", ") + extension.substr(1);
  return names;
}

inline void check_format(const std::string& file_name)
{
  const std::vector<std::string> known = mesh_extensions();
  if(std::find(known.begin(), known.end(), lower_case_extension(file_name)) == known.end())
    throw Error(file_name, "is in no known format (known are " + known_formats() + ")");
}

// Is this a file whose first bytes can be read? CGAL's readers tell that from no other failure.
inline void check_readable(const std::string& file_name)
{
  std::ifstream in(file_name, std::ios::binary);
  if(!in)
    throw Error(file_name, "cannot be opened");
  in.peek();
  if(in.bad())
    throw Error(file_name, "cannot be read");
  if(in.eof())
    throw Error(file_name, "is empty");
}

inline bool read_soup_by_extension(const std::string& file_name, Polygon_soup& soup)
{
#ifdef CGAL_USE_VTK
  if(lower_case_extension(file_name) == ".vtp")
    return CGAL::IO::read_VTP(file_name, soup.points, soup.polygons);
#endif
  return CGAL::IO::read_polygon_soup(file_name, soup.points, soup.polygons,
                                     CGAL::parameters::verbose(false));
}

inline Polygon_soup read_soup(const std::string& file_name)
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
  catch(const std::bad_alloc&)
  {
    throw Error(file_name, "announces more than fits into memory");
  }
  catch(const std::exception&)
  {
    is_read = false;
  }
  if(!is_read)
    throw Error(file_name, "is not a well-formed mesh file");
  return soup;
}

inline void check_soup(const Polygon_soup& soup, const std::string& file_name)
{
  if(soup.polygons.empty())
    throw Error(file_name, "has no faces");
  for(std::size_t i = 0; i < soup.points.size(); ++i)
    for(int c = 0; c < 3; ++c)
      if(!std::isfinite(soup.points[i][c]))
        throw Error(file_name, "vertex " + std::to_string(i) + " has no finite coordinates");
  for(std::size_t i = 0; i < soup.polygons.size(); ++i)
  {
    Polygon corners = soup.polygons[i];
    std::sort(corners.begin(), corners.end());
    const std::string face = "face " + std::to_string(i);
    if(corners.size() < 3)
      throw Error(file_name, face + " has fewer than three corners");
    if(corners.back() >= soup.points.size())
      throw Error(file_name, face + " has a corner that does not exist");
    if(std::adjacent_find(corners.begin(), corners.end()) != corners.end())
      throw Error(file_name, face + " has one corner twice");
  }
}

// Makes a mesh with the faces of `soup` in their order. Where faces do not fit together as they are,
// CGAL reorients them and duplicates vertices.
inline Mesh mesh_of_soup(Polygon_soup soup, const std::string& file_name)
{
  namespace PMP = CGAL::Polygon_mesh_processing;

  if(!PMP::is_polygon_soup_a_polygon_mesh(soup.polygons))
    PMP::orient_polygon_soup(soup.points, soup.polygons);
  if(!PMP::is_polygon_soup_a_polygon_mesh(soup.polygons))
    throw Error(file_name, "its faces do not make up a surface mesh");
  Mesh mesh;
  PMP::polygon_soup_to_polygon_mesh(soup.points, soup.polygons, mesh);
  if(mesh.number_of_faces() != soup.polygons.size() || !mesh.is_valid(false))
    throw Error(file_name, "its faces do not make up a surface mesh");
  return mesh;
}

// Reads a mesh of any format that CGAL reads, chosen by the extension of the name; or throws an
// `Error`. Faces are in the order of the file, all of them. Border edges that lie on each other are
// joined, as of faces that share no vertices.
inline Mesh read_mesh(const std::string& file_name)
{
  const Polygon_soup soup = read_soup(file_name);
  check_soup(soup, file_name);
  Mesh mesh = mesh_of_soup(soup, file_name);
  CGAL::Polygon_mesh_processing::stitch_borders(mesh);
  mesh.collect_garbage();
  if(mesh.number_of_faces() != soup.polygons.size() || !mesh.is_valid(false))
    throw Error(file_name, "its faces do not make up a surface mesh");
  return mesh;
}

} // namespace tool

#endif // CGAL_EXAMPLES_PROTRUSION_SEGMENTATION_READ_MESH_H
