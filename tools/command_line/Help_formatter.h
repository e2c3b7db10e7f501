// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The layout of --help, from which the manual pages are made: at most 80 columns, no notes of CLI11.

#ifndef PROTRUSION_SEGMENTATION_TOOLS_COMMAND_LINE_HELP_FORMATTER_H
#define PROTRUSION_SEGMENTATION_TOOLS_COMMAND_LINE_HELP_FORMATTER_H

#include <CLI/CLI.hpp>

#include <string>
#include <utility>
#include <vector>

namespace tool {

class Help_formatter : public CLI::Formatter
{
public:
  // `usage` follows the name of the program; `positionals` is the heading above its operands.
  Help_formatter(std::string usage, const std::string& positionals);

  std::string make_usage(const CLI::App* app, std::string name) const override;
  std::string make_help(const CLI::App* app, std::string name, CLI::AppFormatMode mode) const override;
  std::string make_option_name(const CLI::Option* option, bool is_positional) const override;
  std::string make_option_opts(const CLI::Option* option) const override;
  std::string make_option_desc(const CLI::Option* option) const override;

private:
  std::string m_usage;
};

struct Example
{
  std::string command;
  std::string description;
};

// Gives the tool its layout, its examples, the exit codes, and --help and --version as the last options. To be called
// when all other options are there.
void complete_help(CLI::App& app,
                   const std::string& usage,
                   const std::string& positionals,
                   const std::vector<Example>& examples);

} // namespace tool

#endif // PROTRUSION_SEGMENTATION_TOOLS_COMMAND_LINE_HELP_FORMATTER_H
