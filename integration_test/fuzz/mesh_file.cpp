// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "mesh_file.h"

#include "fuzz_target.h"

#include "reading/read_mesh.h"
#include "validation.h"

#include <CGAL/Protrusion_segmentation/Diffusion_distance.h>
#include <CGAL/Protrusion_segmentation/Histogram_method.h>
#include <CGAL/protrusion_segmentation.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <filesystem>
#include <fstream>
#include <optional>
#include <system_error>

#include <unistd.h>

namespace {

using namespace CGAL::Protrusion_segmentation;

// Larger ones only take longer.
constexpr std::size_t maximum_number_of_faces = 2000;

class Temporary_mesh_file
{
public:
  Temporary_mesh_file(const std::string& extension, const std::string& bytes)
    : m_name(
        (std::filesystem::temp_directory_path() / ("fuzz_mesh_" + std::to_string(getpid()) + extension))
          .string())
  {
    std::ofstream(m_name, std::ios::binary) << bytes;
  }
  Temporary_mesh_file(const Temporary_mesh_file&) = delete;
  Temporary_mesh_file& operator=(const Temporary_mesh_file&) = delete;
  ~Temporary_mesh_file()
  {
    std::error_code ignored;
    std::filesystem::remove(m_name, ignored);
  }
  const std::string& name() const { return m_name; }

private:
  std::string m_name;
};

template <typename Method>
void segment(const tool::Mesh& mesh, std::size_t k, const Method& method)
{
  std::vector<std::size_t> ids(mesh.number_of_faces(), mesh.number_of_faces());
  const auto map = boost::make_iterator_property_map(ids.begin(), get(boost::face_index, mesh));
  const std::size_t number = k == 0 ? CGAL::segmentation_via_protrusion_tips(mesh, map, method)
                                    : CGAL::segmentation_via_protrusion_tips(
                                        mesh, map, (std::min)(k, ids.size()), method);
  const auto problem = validation::problem_with_segmentation(mesh, map, number);
  require(!problem, problem.value_or(""));
}

void segment(const tool::Mesh& mesh, std::size_t method, std::size_t k)
{
  switch (method)
  {
  case 0:
    return segment(mesh, k, Minimum_cut_method());
  case 1:
    return segment(mesh, k, Histogram_method());
  case 2:
    return segment(mesh, k, Histogram_method(Landmark_geodesic_distance()));
  default:
    return segment(mesh, k, Histogram_method(Diffusion_distance()));
  }
}

// What read_input_mesh() promises.
void check(const tool::Input_mesh& input)
{
  const std::size_t faces = input.mesh.number_of_faces();
  require(input.mesh.is_valid(false), "the faces do not make up a surface mesh");
  require(input.label_giver.size() == input.soup.polygons.size(), "a face of the file is without label");
  require(input.face_in_file.size() == faces, "a face of the mesh is not from the file");
  require(input.point_of_vertex.size() == input.mesh.number_of_vertices(), "a vertex is not from the file");
  for (const std::size_t giver : input.label_giver)
    require(giver < faces, "a face of the file has the label of no face");
  for (std::size_t i = 0; i < faces; ++i)
    require(input.label_giver[input.face_in_file[i]] == i, "a face of the mesh does not label itself");
}

// Joins the pieces of a file, with a gap that makes few faces.
void join(const tool::Polygon_soup& soup)
{
  constexpr std::size_t most_polygons = 200; // more only take longer
  CGAL::Bbox_3 box;
  for (const tool::Corners& polygon : soup.polygons)
    for (const std::size_t corner : polygon)
      box += soup.points[corner].bbox();
  const double size = (std::max)({box.x_span(), box.y_span(), box.z_span()});
  if (soup.polygons.size() > most_polygons || !std::isfinite(size))
    return;
  tool::Input_mesh input;
  try
  {
    input = tool::join_pieces(soup, size / 4);
  }
  catch (const std::exception&) // no polygon has an area
  {
    return;
  }
  require(input.mesh.is_valid(false) && is_closed(input.mesh), "the surface around the pieces is not closed");
  const std::vector<std::size_t> labels = tool::labels_of_file(
    std::vector<std::size_t>(input.mesh.number_of_faces(), 0), input);
  require(labels == std::vector<std::size_t>(soup.polygons.size(), 0), "a face has the label of no face");
}

} // namespace

void fuzz_mesh_file(const std::string& extension, const std::string& bytes, std::size_t choice)
{
  const Temporary_mesh_file file(extension, bytes);
  tool::Input_mesh input;
  try
  {
    constexpr double wide = .1;
    input = tool::read_input_mesh(file.name(), choice % 3 == 0 ? std::optional<double>(wide) : std::nullopt);
  }
  catch (const tool::Error& error)
  {
    require(std::string(error.what()).find(file.name()) == 0, "the error does not name the file");
    require(std::string(error.what()).find('\n') == std::string::npos, "the error is longer than a line");
    return;
  }
  check(input);
  if (choice % 8 == 0)
    join(input.soup);
  if (input.mesh.number_of_faces() <= maximum_number_of_faces)
    segment(input.mesh, choice % 4, choice / 4);
}
