// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the command line tools share: exit codes, errors in one line, reading segmentations with the
// cause of a failure, files that appear only when they are complete.

#ifndef CGAL_EXAMPLES_PROTRUSION_SEGMENTATION_TOOL_SUPPORT_H
#define CGAL_EXAMPLES_PROTRUSION_SEGMENTATION_TOOL_SUPPORT_H

#include "read_mesh.h"
#include "tool_error.h"

#include <CGAL/IO/SEG.h>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstddef>
#include <exception>
#include <functional>
#include <iostream>
#include <new>
#include <ostream>
#include <string>

namespace tool {

constexpr int done = 0;
constexpr int failure = 1;   // bad input, or an output that cannot be written
constexpr int bad_usage = 2; // the command line makes no sense

using Segment_ids = Mesh::Property_map<Face, std::size_t>;

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
