// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the command line tools share: exit codes, errors in one line, reading meshes and
// segmentations with the cause of a failure, files that appear only when they are complete.

#ifndef CGAL_EXAMPLES_PROTRUSION_SEGMENTATION_TOOL_SUPPORT_H
#define CGAL_EXAMPLES_PROTRUSION_SEGMENTATION_TOOL_SUPPORT_H

#include <CGAL/IO/SEG.h>
#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/stitch_borders.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#ifdef CGAL_USE_VTK
#include <CGAL/IO/VTK.h>
#endif

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstddef>
#include <exception>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iostream>
#include <new>
#include <ostream>
#include <stdexcept>
#include <string>
#include <vector>

namespace tool {

constexpr int done = 0;
constexpr int failure = 1;   // bad input, or an output that cannot be written
constexpr int bad_usage = 2; // the command line makes no sense

using Point = CGAL::Simple_cartesian<double>::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Face = boost::graph_traits<Mesh>::face_descriptor;
using Segment_ids = Mesh::Property_map<Face, std::size_t>;

// The message names the file and the cause.
struct Error : std::runtime_error
{
  using std::runtime_error::runtime_error;
  Error(const std::string& file_name, const std::string& cause)
    : std::runtime_error(file_name + ": " + cause)
  { }
};

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

struct Polygon_soup
{
  std::vector<Point> points;
  std::vector<std::vector<std::size_t>> polygons;
};

inline std::string lower_case_extension(const std::string& file_name)
{
  std::string extension = std::filesystem::path(file_name).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return char(std::tolower(c)); });
  return extension;
}

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
    std::vector<std::size_t> corners = soup.polygons[i];
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

// Reads a `.seg` file into a new property map of the mesh; or throws an `Error`.
inline Segment_ids read_segmentation(const std::string& file_name, Mesh& mesh)
{
  const Segment_ids segment_ids = mesh.add_property_map<Face, std::size_t>().first;
  const std::string problem =
    CGAL::Protrusion_segmentation::internal::read_segments(file_name, mesh, segment_ids);
  if(!problem.empty())
    throw Error(file_name, problem);
  return segment_ids;
}

// Writes a file so that it appears only when it is complete; or throws an `Error`.
inline void write_output(const std::string& file_name,
                         const std::function<void(std::ostream&)>& write)
{
  if(!CGAL::Protrusion_segmentation::internal::write_complete_file(file_name, write))
    throw Error(file_name, "cannot be written");
}

// Flushes the standard output; throws an `Error` if not everything got there.
inline void finish_standard_output()
{
  std::cout.flush();
  if(!std::cout)
    throw Error("the standard output", "cannot be written");
}

inline int report(const std::string& program, const std::string& message, int exit_code)
{
  std::string line = program + ": " + message;
  std::replace(line.begin(), line.end(), '\n', ' ');
  std::cerr << line << std::endl;
  return exit_code;
}

// Parses the command line, then calls `run()`; returns the exit code of the program.
inline int main(CLI::App& app, int argc, char** argv, const std::function<void()>& run)
{
  try
  {
    app.parse(argc, argv);
  }
  catch(const CLI::Success& help_or_version)
  {
    return app.exit(help_or_version);
  }
  catch(const CLI::ParseError& error)
  {
    return report(app.get_name(), std::string(error.what()) + " (see --help)", bad_usage);
  }

  try
  {
    run();
    return done;
  }
  catch(const std::bad_alloc&)
  {
    return report(app.get_name(), "out of memory", failure);
  }
  catch(const std::exception& error)
  {
    return report(app.get_name(), error.what(), failure);
  }
}

} // namespace tool

#endif // CGAL_EXAMPLES_PROTRUSION_SEGMENTATION_TOOL_SUPPORT_H
