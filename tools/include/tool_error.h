// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXAMPLES_PROTRUSION_SEGMENTATION_TOOL_ERROR_H
#define CGAL_EXAMPLES_PROTRUSION_SEGMENTATION_TOOL_ERROR_H

#include <stdexcept>
#include <string>

namespace tool {

// The message names the file and the cause.
struct Error : std::runtime_error
{
  using std::runtime_error::runtime_error;
  Error(const std::string& file_name, const std::string& cause)
    : std::runtime_error(file_name + ": " + cause)
  { }
};

} // namespace tool

#endif // CGAL_EXAMPLES_PROTRUSION_SEGMENTATION_TOOL_ERROR_H
