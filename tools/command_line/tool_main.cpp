// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "command_line/tool_main.h"

#include "writing/write_output.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <exception>
#include <filesystem>
#include <iostream>
#include <new>
#include <string>
#include <system_error>

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

// A file whose name begins with a dash is taken for options.
std::string hint_at_dash(int argc, char** argv)
{
  std::error_code ignored;
  for (int i = 1; i < argc; ++i)
    if (const std::string word = argv[i]; word.size() > 1 && word[0] == '-' && std::filesystem::exists(word, ignored))
      return "; the file " + word + " is named by ./" + word;
  return "";
}

int call(const CLI::App& app, const std::function<void()>& run)
{
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

} // namespace

int main(CLI::App& app, int argc, char** argv, const std::function<void()>& run)
{
  try
  {
    app.parse(argc, argv);
  }
  catch (const CLI::Success& help_or_version)
  {
    return call(app,
                [&]()
                {
                  app.exit(help_or_version);
                  finish_standard_output();
                });
  }
  catch (const CLI::ParseError& error)
  {
    return report(app.get_name(), error.what() + hint_at_dash(argc, argv) + " (see --help)", bad_usage);
  }

  return call(app, run);
}

} // namespace tool
