// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "command_line/connector_options.h"

#include "command_line/integer_option.h"
#include "command_line/number.h"

#include <CLI/CLI.hpp>

#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <string>

namespace tool {
namespace {

const char* const group = "Connectors";

// A real number for which `is_good`, which `range` describes.
void add_number(CLI::App& app,
                const std::string& name,
                const std::string& type,
                const std::string& text,
                const std::string& range,
                const std::function<bool(double)>& is_good,
                const std::function<void(double)>& set)
{
  const auto problem_with = [=](const std::string& word) -> std::string
  {
    const std::optional<double> value = number<double>(word);
    return value && std::isfinite(*value) && is_good(*value) ? ""
                                                             : "'" + word + "' is no number " + range;
  };
  app
    .add_option_function<std::string>(
      name, [=](const std::string& word) { set(number<double>(word).value_or(0)); }, text)
    ->check(CLI::Validator(problem_with, ""))
    ->needs("--connectors")
    ->type_name(type)
    ->group(group);
}

} // namespace

void add_connector_options(CLI::App& app, Command_line& command_line)
{
  using CGAL::Protrusion_segmentation::internal::least_number_of_sides;
  using CGAL::Protrusion_segmentation::internal::most_sides;
  auto& connectors = command_line.connectors;
  app
    .add_flag(
      "--connectors", command_line.has_connectors,
      "with --close, hold parts together by a peg on one and a socket in the other, at each cap with "
      "room for them. The note and the record of --json tell where there is none.")
    ->group(group);
  add_number(
    app, "--tolerance", "LENGTH",
    "distance between the sides of peg and socket, in the unit of the mesh (default: a twentieth of the "
    "radius of the peg)",
    "of at least 0", [](double value) { return value >= 0; },
    [&connectors](double value) { connectors.tolerance = value; });
  add_number(
    app, "--peg-radius", "SHARE",
    "radius of a peg, as a share of that of the largest circle in the cap (default: 0.5). Where there is "
    "less room, pegs are thinner, down to a half of this, and shorter.",
    "above 0 and below 1", [](double value) { return value > 0 && value < 1; },
    [&connectors](double value) { connectors.radius = value; });
  add_number(
    app, "--peg-depth", "SHARE", "length of a peg, as a share of the same (default: 0.75)", "above 0",
    [](double value) { return value > 0; }, [&connectors](double value) { connectors.depth = value; });
  add_number(
    app, "--peg-chamfer", "SHARE",
    "width of the chamfer at the end of a peg, as a share of its radius (default: 0.2; 0: none)",
    "from 0 to 0.5", [](double value) { return value >= 0 && value <= 0.5; },
    [&connectors](double value) { connectors.chamfer = value; });
  add_number(
    app, "--smallest-peg", "LENGTH",
    "least radius of a peg, in the unit of the mesh (default: a hundredth of the size of the mesh)",
    "of at least 0", [](double value) { return value >= 0; },
    [&connectors](double value) { connectors.smallest_radius = value; });
  app
    .add_option("--peg-sides", connectors.number_of_sides,
                "number of sides of a peg: few keep the parts from turning, many make it round")
    ->transform(integer("number of sides", least_number_of_sides, most_sides))
    ->needs("--connectors")
    ->type_name("N")
    ->capture_default_str()
    ->group(group);
}

} // namespace tool
