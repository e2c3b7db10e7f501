// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "writing/write_output.h"

#include "command_line/Error.h"
#include "writing/write_complete_file.h"

#include <iostream>

namespace tool
{

void write_output(const std::string& file_name, const std::function<void(std::ostream&)>& write)
{
  if (!write_complete_file(file_name, write))
    throw Error(file_name, "cannot be written");
}

void finish_standard_output()
{
  std::cout.flush();
  if (!std::cout)
    throw Error("the standard output", "cannot be written");
}

} // namespace tool
