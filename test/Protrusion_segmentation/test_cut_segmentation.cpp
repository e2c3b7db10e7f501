// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Segments of several components, and numbers of segments.

#include "check.h"
#include "dual_graphs.h"
#include "test_meshes.h"

#include <CGAL/Protrusion_segmentation/internal/Cut_method/Cut_segmentation.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <set>
#include <vector>

using namespace test_meshes;
using CGAL::Protrusion_segmentation::internal::Cut_segmentation;
using CGAL::Protrusion_segmentation::internal::Nested_segments;

// without a number the automatic one
Nested_segments segments_of(const Indexed_surface& surface,
                            std::optional<std::size_t> number = std::nullopt)
{
  const std::optional<CGAL::Protrusion_segmentation::internal::Any_distance> distance;
  Cut_segmentation segmentation(surface, distance, quiet_execution());
  return number ? segmentation.with_number_of_segments(*number) : segmentation.with_automatic_number();
}

std::vector<Index> parents_of(const Nested_segments& segments)
{
  std::vector<Index> result;
  for (std::size_t s = 0; s < segments.number_of_segments(); ++s)
    result.push_back(segments.parent(s));
  return result;
}

// Who asks for as many segments as are found without a number gets the same ones.
void the_automatic_number_may_be_asked_for(const Test_mesh& mesh)
{
  const Indexed_surface surface = to_surface(mesh);
  const Nested_segments automatic = segments_of(surface);
  const Nested_segments asked_for = segments_of(surface, automatic.number_of_segments());
  CGAL_CHECK(asked_for.labels() == automatic.labels());
  CGAL_CHECK(parents_of(asked_for) == parents_of(automatic));
}

// Up to the automatic number, components get the protrusions that they have on their own. One segment more is cut off
// one of them, the others stay.
void one_segment_more_changes_one_component(const Test_mesh& mesh)
{
  const Indexed_surface surface = to_surface(mesh);
  const Nested_segments automatic = segments_of(surface);
  const Nested_segments more = segments_of(surface, automatic.number_of_segments() + 1);
  CGAL_CHECK_EQUAL(more.number_of_segments(), automatic.number_of_segments() + 1);
  const Nested_segments components(surface);
  std::vector<std::set<Index>> segments(components.number_of_components()), expected = segments;
  for (std::size_t f = 0; f < components.labels().size(); ++f)
  {
    segments[components.labels()[f]].insert(more.labels()[f]);
    expected[components.labels()[f]].insert(automatic.labels()[f]);
  }
  std::size_t different = 0;
  for (std::size_t c = 0; c < segments.size(); ++c)
    different += segments[c].size() != expected[c].size();
  CGAL_CHECK_EQUAL(different, 1u);
}

Test_mesh many_tetrahedra(std::size_t number)
{
  std::vector<Test_mesh> result;
  for (std::size_t i = 0; i < number; ++i)
    result.push_back(translated(tetrahedron(), {4. * double(i % 64), 4. * double(i / 64), 0}));
  return merged(result);
}

// As many segments as faces: a component that has no more cuts is not asked again, so that the time is linear in the number
// of components.
void many_components_may_have_many_segments()
{
  constexpr std::size_t components = 4000;
  const Indexed_surface surface = to_surface(many_tetrahedra(components));
  for (const std::size_t k : {components + 1, 2 * components, 4 * components})
    CGAL_CHECK_EQUAL(segments_of(surface, k).number_of_segments(), k);
  CGAL_CHECK_EQUAL(segments_of(surface, 4 * components + 1).number_of_segments(),
              4 * components); // there are no more faces
}

int main()
{
  const Test_mesh several = merged(
    {star(3), translated(creature(), {20, 0, 0}), translated(icosphere(2), {0, 20, 0}),
     translated(scaled(star(5), 0.3), {0, 0, 20}), translated(sheet(5, 5), {0, 0, -20})});
  for (const Test_mesh& mesh : {star(1), star(5), creature(), dumbbell(), body_with_hands(3, 0.18),
                                bumpy_sphere(3, 1), icosphere(3), torus(), sheet(20, 30), tetrahedron(),
                                several, merged({star(4), translated(star(4), {0, 0, 20})})})
    the_automatic_number_may_be_asked_for(mesh);
  one_segment_more_changes_one_component(several);
  many_components_may_have_many_segments();
  return check::result();
}
