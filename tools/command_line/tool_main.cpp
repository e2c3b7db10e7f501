// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "command_line/tool_main.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <exception>
#include <iostream>
#include <new>
#include <string>

namespace tool
{
namespace
{

int report(const std::string& program, const std::string& message, int exit_code)
{
  std::string line = program + ": " + message;
  std::replace(line.begin(), line.end(), '\n', ' ');
  std::cerr << line << std::endl;
  return exit_code;
}

} // namespace

int main(CLI::App& app, int argc, char** argv, const std::function<void()>& run)
{
  try
  {
    app.parse(argc, argv);
  }
  catch (const CLI::Success& help_or_version)
  {
    return app.exit(help_or_version);
  }
  catch (const CLI::ParseError& error)
  {
    return report(app.get_name(), std::string(error.what()) + " (see --help)", bad_usage);
  }

  try
  {
    run();
    return done;
  }
  catch (const std::bad_alloc&)
  {
    return report(app.get_name(), "out of memory", failure);
  }
  catch (const std::exception& error)
  {
    return report(app.get_name(), error.what(), failure);
  }
}

} // namespace tool
