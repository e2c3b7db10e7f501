// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Makes a benchmark folder of random shapes whose parts are known.

#include "random_shapes.h"

#include <CGAL/IO/OFF.h>
#include <CGAL/Simple_cartesian.h>

#include <CLI/CLI.hpp>

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;

void write(const fs::path& file, const std::string& text)
{
  std::ofstream out(file);
  out << text;
  if (!out.flush())
    throw std::runtime_error("cannot write '" + file.string() + "'");
}

std::string off(const test_meshes::Test_mesh& mesh)
{
  std::vector<CGAL::Simple_cartesian<double>::Point_3> points;
  for (const test_meshes::Point& p : mesh.points)
    points.emplace_back(p[0], p[1], p[2]);
  std::ostringstream out;
  CGAL::IO::write_OFF(out, points, mesh.faces, CGAL::parameters::stream_precision(9));
  return out.str();
}

std::string seg(const test_meshes::Test_mesh& mesh)
{
  std::string text;
  for (const std::size_t part : mesh.parts)
    text += std::to_string(part) + '\n';
  return text;
}

void make_folder(const fs::path& folder, std::size_t of_each_kind, std::uint32_t seed)
{
  fs::create_directories(folder / "off");
  std::string numbers, classes;
  std::size_t model = 0;
  for (std::size_t kind = 0; kind < kinds_of_random_shapes().size(); ++kind)
  {
    classes += (kind == 0 ? "" : ",") + kinds_of_random_shapes()[kind] + '=' + std::to_string(model + 1) + '-' +
               std::to_string(model + of_each_kind);
    for (std::size_t i = 0; i < of_each_kind; ++i)
    {
      const std::string name = std::to_string(++model);
      const test_meshes::Test_mesh mesh = random_shape(kind, seed + static_cast<std::uint32_t>(model));
      fs::create_directories(folder / "seg" / name);
      write(folder / "off" / (name + ".off"), off(mesh));
      write(folder / "seg" / name / (name + "_0.seg"), seg(mesh));
      numbers += std::to_string(std::set<std::size_t>(mesh.parts.begin(), mesh.parts.end()).size()) + '\n';
    }
  }
  write(folder / "nSeg-ByModel.txt", numbers);
  write(folder / "classes.txt", classes + '\n');
}

} // namespace

int main(int argc, char** argv)
{
  CLI::App app("Makes a benchmark folder of random shapes whose parts are known, and classes.txt with their kinds.");
  std::string folder;
  std::size_t of_each_kind = 50;
  std::uint32_t seed = 0;
  app.add_option("folder", folder, "to be made")->required();
  app.add_option("--of-each-kind", of_each_kind, "shapes")->check(CLI::PositiveNumber)->capture_default_str();
  app.add_option("--seed", seed, "other shapes for another one")->capture_default_str();
  CLI11_PARSE(app, argc, argv);
  try
  {
    make_folder(folder, of_each_kind, seed);
    return EXIT_SUCCESS;
  }
  catch (const std::exception& error)
  {
    std::cerr << "make_random_shapes: " << error.what() << std::endl;
    return EXIT_FAILURE;
  }
}
