// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the command line tools share: exit codes, and errors in one line.

#ifndef PROTRUSION_SEGMENTATION_TOOLS_COMMAND_LINE_TOOL_MAIN_H
#define PROTRUSION_SEGMENTATION_TOOLS_COMMAND_LINE_TOOL_MAIN_H

#include <functional>

namespace CLI
{
class App;
}

namespace tool
{

constexpr int done = 0;
constexpr int failure = 1;   // bad input, or an output that cannot be written
constexpr int bad_usage = 2; // the command line makes no sense

// Parses the command line, then calls `run()`; returns the exit code of the program.
int main(CLI::App& app, int argc, char** argv, const std::function<void()>& run);

} // namespace tool

#endif // PROTRUSION_SEGMENTATION_TOOLS_COMMAND_LINE_TOOL_MAIN_H
