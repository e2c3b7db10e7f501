// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "command_line/Help_formatter.h"

#include <memory>
#include <sstream>

namespace tool {
namespace {

constexpr std::size_t name_width = 22;
constexpr std::size_t description_width = 80 - name_width;

// Breaks a line between words, but not before a default value. Further lines of a choice, "name: what it is", are indented.
std::string wrap(const std::string& line)
{
  const std::size_t colon = line.find(": ");
  const bool is_choice = colon != std::string::npos && line.find(' ') > colon;
  std::istringstream words(line);
  std::string result, word;
  std::size_t width = 0;
  while (words >> word)
  {
    if (std::string value; word == "(default:" && words >> value)
      word += " " + value;
    if (width > 0 && width + 1 + word.size() > description_width)
    {
      result += is_choice ? "\n  " : "\n";
      width = is_choice ? 2 : 0;
    }
    else if (width > 0)
    {
      result += " ";
      ++width;
    }
    result += word;
    width += word.size();
  }
  return result;
}

} // namespace

Help_formatter::Help_formatter(std::string usage, const std::string& positionals)
  : m_usage(std::move(usage))
{
  column_width(name_width);
  label("Positionals", positionals);
}

std::string Help_formatter::make_usage(const CLI::App*, std::string name) const
{
  return "Usage: " + name + " " + m_usage + "\n";
}

std::string Help_formatter::make_help(const CLI::App* app,
                                      std::string name,
                                      CLI::AppFormatMode mode) const
{
  return CLI::detail::find_and_replace(Formatter::make_help(app, name, mode), "\n\n\n", "\n\n");
}

// Without the value that a flag has by itself.
std::string Help_formatter::make_option_name(const CLI::Option* option, bool is_positional) const
{
  if (is_positional)
    return option->get_name(true, false);
  std::string names;
  for (const std::string& name : option->get_snames())
    names += (names.empty() ? "-" : ", -") + name;
  for (const std::string& name : option->get_lnames())
    names += (names.empty() ? "--" : ", --") + name;
  return names;
}

std::string Help_formatter::make_option_opts(const CLI::Option* option) const
{
  const std::string type = option->get_option_text().empty() && option->get_type_size() > 0
                             ? option->get_type_name()
                             : option->get_option_text();
  const bool is_appended = type.empty() || type.front() == '[';
  return (is_appended ? "" : " ") + type;
}

std::string Help_formatter::make_option_desc(const CLI::Option* option) const
{
  std::istringstream lines(option->get_description());
  std::string result, line;
  const std::string value = option->get_default_str();
  const bool has_default = !value.empty() && option->get_expected_min() > 0;
  for (bool is_first = true; std::getline(lines, line); is_first = false)
    result += (is_first ? "" : "\n") +
              wrap(is_first && has_default ? line + " (default: " + value + ")" : line);
  return result;
}

void complete_help(CLI::App& app,
                   const std::string& usage,
                   const std::string& positionals,
                   const std::vector<Example>& examples)
{
  const std::string name = app.get_name();
  app.formatter(std::make_shared<Help_formatter>(usage, positionals));
  app.set_help_flag();
  app
    .set_version_flag("--version", name + " " + PROTRUSION_SEGMENTATION_VERSION,
                      "print the version and exit")
    ->group("Help");
  app.set_help_flag("-h,--help", "print this text and exit")->group("Help");
  std::string footer = "Examples:\n";
  for (const Example& example : examples)
    footer += "  " + example.command + "\n      " + example.description + "\n";
  footer += "\nExit status:\n  0  done\n  1  bad input, or a file that cannot be written\n  2  wrong "
            "command line";
  app.footer(footer);
}

} // namespace tool
