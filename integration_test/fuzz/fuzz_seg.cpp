// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Any bytes as a `.seg` file: read completely or refused with a reason, the labels then untouched; what was
// read is written so that it is read again.

#include "fuzz_target.h"
#include "test_meshes_polyhedra.h"

#include <CGAL/IO/SEG.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <cstdint>
#include <sstream>

using namespace test_meshes;
using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

template <typename Id>
void read_and_write(const Mesh& mesh, const std::string& text)
{
  constexpr Id before = 77;
  std::vector<Id> ids(mesh.number_of_faces(), before);
  const auto map = boost::make_iterator_property_map(ids.begin(), get(boost::face_index, mesh));
  std::istringstream in(text);
  const std::string problem = CGAL::Protrusion_segmentation::internal::read_segments(in, mesh, map);
  if (!problem.empty())
  {
    require(ids == std::vector<Id>(ids.size(), before), "ids were written in spite of: " + problem);
    require(problem.find('\n') == std::string::npos, "the reason is longer than a line: " + problem);
    return;
  }
  std::stringstream written;
  require(CGAL::IO::write_SEG(written, mesh, map), "what was read cannot be written");
  const std::vector<Id> expected = ids;
  require(CGAL::IO::read_SEG(written, mesh, map) && ids == expected,
          "what was written reads as another one");
}

void fuzz(const std::string& bytes)
{
  static const Mesh mesh = to_graph<Mesh>(tetrahedron());
  read_and_write<std::uint8_t>(mesh, bytes);
  read_and_write<std::int32_t>(mesh, bytes);
  read_and_write<std::size_t>(mesh, bytes);
}
