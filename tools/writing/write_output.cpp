// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "writing/write_output.h"

#include "command_line/Error.h"
#include "writing/Output_files.h"

#include <iostream>

namespace tool
{

void write_output(const std::string& file_name, const std::function<void(std::ostream&)>& write)
{
  Output_files files;
  files.add(file_name, write);
  files.publish();
}

void finish_standard_output()
{
  std::cout.flush();
  if (!std::cout)
    throw Error("the standard output", "cannot be written");
}

} // namespace tool
