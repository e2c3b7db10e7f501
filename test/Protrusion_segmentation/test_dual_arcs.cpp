// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The arcs of the face dual graph are those of the graph for the Boost Graph Library, of all faces and of some.

#include "check.h"
#include "indexed_surfaces.h"
#include "test_meshes.h"

#include <CGAL/Protrusion_segmentation/internal/Distances/Dual_arcs.h>

#include <utility>
#include <vector>

using namespace test_meshes;
using CGAL::Protrusion_segmentation::internal::Dual_arcs;

using Arcs = std::vector<std::pair<Index, double>>;

Arcs arcs_of(const Dual_arcs& all, Index face)
{
  Arcs result;
  for (const Dual_arcs::Arc& arc : all[face])
    result.emplace_back(arc.target(), arc.length());
  return result;
}

Arcs arcs_of(const Indexed_surface::Dual_graph& graph, Index face)
{
  Arcs result;
  for (const auto& arc : boost::make_iterator_range(out_edges(face, graph)))
    result.emplace_back(static_cast<Index>(target(arc, graph)), get(&Indexed_surface::Arc::length, graph, arc));
  return result;
}

// Also the arcs between the faces with these numbers, in this order.
void check_subset(const Dual_arcs& all, const std::vector<Index>& faces)
{
  std::vector<Index> numbers(all.number_of_faces(), Indexed_surface::no_face());
  for (std::size_t i = 0; i < faces.size(); ++i)
    numbers[faces[i]] = static_cast<Index>(i);
  const Dual_arcs some(all, faces, numbers);
  CGAL_CHECK_EQUAL(some.number_of_faces(), faces.size());
  for (std::size_t i = 0; i < faces.size(); ++i)
  {
    Arcs expected;
    for (const auto& arc : arcs_of(all, faces[i]))
      if (numbers[arc.first] != Indexed_surface::no_face())
        expected.emplace_back(numbers[arc.first], arc.second);
    CGAL_CHECK(arcs_of(some, static_cast<Index>(i)) == expected);
  }
}

void check_arcs(const Test_mesh& mesh)
{
  const Indexed_surface surface = to_surface(mesh);
  const Dual_arcs arcs(surface);
  CGAL_CHECK_EQUAL(arcs.number_of_faces(), surface.number_of_faces());
  const auto expected = surface.dual_graph();
  for (Index f = 0; f < surface.number_of_faces(); ++f)
    CGAL_CHECK(arcs_of(arcs, f) == arcs_of(expected, f));
  std::vector<Index> two_thirds;
  for (Index f = surface.number_of_faces(); f-- > 0;)
    if (f % 3 != 1)
      two_thirds.push_back(f);
  check_subset(arcs, two_thirds);
  check_subset(arcs, {});
}

int main()
{
  check_arcs(icosphere(2));
  check_arcs(single_triangle());
  check_arcs(triangulated(sheet(7, 5))); // with a border
  check_arcs(sheet(7, 5));
  check_arcs(football());
  for (std::uint_fast32_t seed = 0; seed < 50; ++seed)
    check_arcs(triangulated(random_surface(seed)));
  return check::result();
}
