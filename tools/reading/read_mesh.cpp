// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "reading/read_mesh.h"

#include "reading/Format_error.h"

#include <new>
#include <stdexcept>

namespace tool {

Input_mesh read_input_mesh(const std::string& file_name, std::optional<double> tolerance)
{
  try
  {
    return make_input_mesh(read_soup(file_name), tolerance);
  }
  catch (const Format_error& error)
  {
    throw Error(file_name, error.what());
  }
}

Input_mesh read_joined_pieces(const std::string& file_name, std::optional<double> gap)
{
  try
  {
    return join_pieces(read_soup(file_name), gap);
  }
  catch (const Format_error& error)
  {
    throw Error(file_name, error.what());
  }
  catch (const std::invalid_argument& error)
  {
    throw Error(file_name, std::string("--join-pieces: ") + error.what());
  }
}

Mesh read_mesh(const std::string& file_name)
{
  return read_input_mesh(file_name).mesh;
}

} // namespace tool
