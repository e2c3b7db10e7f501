// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The segments of the faces that sets of cuts make, and their tree.

#include "check.h"
#include "components.h"
#include "segments_of_graphs.h"
#include "test_meshes.h"

#include <CGAL/Protrusion_segmentation/internal/Cut_method/Result/Component_segments.h>

#include <algorithm>
#include <cstddef>
#include <set>
#include <utility>
#include <vector>

using namespace test_meshes;
using internal::Component_segments;
using internal::Cut_set;

Component_segments segments_of(Component_of_mesh& of_mesh, std::size_t number)
{
  return of_mesh.component.segments(*of_mesh.component.best(number));
}

// Every segment but the body sticks out of one before or after it, without circles, and out of one that it touches on the
// coarse graph. Its area is that of its faces and of what sticks out of it.
void check_tree(const Component_segments& segments, const internal::Seam_graph& graph)
{
  const std::size_t number = segments.number_of_segments();
  std::vector<double> area(number, 0), beyond(number, 0);
  for (Index f = 0; f < graph.number_of_nodes(); ++f)
    area[segments.labels()[f]] += graph.area[f];
  CGAL_CHECK_EQUAL(segments.parents().size(), number);
  CGAL_CHECK_EQUAL(segments.parents()[0], 0u);
  for (std::size_t s = 0; s < number; ++s)
  {
    std::size_t t = s, steps = 0;
    for (beyond[t] += area[s]; t != 0 && steps <= number; ++steps)
    {
      t = segments.parents()[t];
      beyond[t] += area[s];
    }
    CGAL_CHECK(steps < number);
  }
  for (std::size_t s = 0; s < number; ++s)
    CGAL_CHECK_CLOSE(segments.areas_beyond()[s], beyond[s], 1e-9);
}

// The body has no cut; the others have all cuts, each once, the most valuable one first.
void check_cuts(const Component_segments& segments, const Cut_set& set)
{
  CGAL_CHECK(segments.cut(0) == nullptr);
  std::set<const Cut_set::Made_cut*> cuts;
  for (std::size_t s = 1; s < segments.number_of_segments(); ++s)
  {
    CGAL_CHECK(segments.cut(s) >= &set.cuts.front() && segments.cut(s) <= &set.cuts.back());
    CGAL_CHECK(s == 1 || segments.cut(s - 1)->value >= segments.cut(s)->value);
    cuts.insert(segments.cut(s));
  }
  CGAL_CHECK_EQUAL(cuts.size(), set.cuts.size());
}

void check_segments_of_sets(const Test_mesh& mesh, std::size_t largest_number, bool moves_borders)
{
  Cut_options options;
  options.moves_borders_on_faces = moves_borders;
  Component_of_mesh of_mesh(mesh, options);
  for (std::size_t k = 1; k <= largest_number && of_mesh.component.best(k); ++k)
  {
    const Component_segments segments = segments_of(of_mesh, k);
    CGAL_CHECK_EQUAL(segments.number_of_segments(), k);
    check_segments(of_mesh.component.graph_of_faces(), segments.labels(), k);
    check_tree(segments, of_mesh.component.graph_of_faces());
    check_cuts(segments, *of_mesh.component.best(k));
  }
}

// Without moving borders, segments are those of the nodes.
void borders_may_stay_on_nodes(const Test_mesh& mesh, std::size_t number)
{
  Cut_options options;
  options.moves_borders_on_faces = false;
  Component_of_mesh of_mesh(mesh, options);
  const std::vector<Index> labels = segments_of(of_mesh, number).labels();
  const std::vector<Index> expected = labels_of_faces(of_mesh.component, *of_mesh.component.best(number));
  std::set<std::pair<Index, Index>> pairs;
  for (std::size_t f = 0; f < labels.size(); ++f)
    pairs.emplace(labels[f], expected[f]);
  CGAL_CHECK_EQUAL(pairs.size(), number);
}

// Of a star, every arm sticks out of the ball.
void arms_stick_out_of_the_ball(std::size_t arms)
{
  Component_of_mesh of_mesh(star(arms));
  const Component_segments segments = segments_of(of_mesh, arms + 1);
  for (const Index parent : segments.parents())
    CGAL_CHECK_EQUAL(parent, 0u);
  CGAL_CHECK_CLOSE(segments.areas_beyond()[0], 1, 1e-6);
}

// Of an octopus, whose arms begin side by side, every arm sticks out of the head.
void arms_that_touch_stick_out_of_the_head()
{
  constexpr std::size_t arms = 8;
  std::vector<Stick> sticks = {{{0, 0, 0.2}, {0, 0, 1.5}, 0.6, 0.8, 0}};
  for (std::size_t i = 0; i < arms; ++i)
  {
    const double turn = 2 * CGAL_PI * double(i) / arms, reach = 3 + 0.1 * double(i);
    const Point along = {std::cos(turn), std::sin(turn), 0};
    sticks.push_back({0.3 * along, reach * along + Point{0, 0, -0.5}, 0.38, 0.15, 1 + i});
  }
  Component_of_mesh of_mesh(implicit_mesh(Implicit_body(sticks, 0.03), 0.12));
  CGAL_CHECK(segments_of(of_mesh, arms + 1).parents() == std::vector<Index>(arms + 1, 0));
}

// Of a ball with two arms, palms and three fingers each.
void fingers_stick_out_of_their_palms()
{
  Component_of_mesh of_mesh(body_with_hands(3));
  const std::vector<Index> parents = segments_of(of_mesh, 11).parents();
  std::vector<std::ptrdiff_t> children;
  for (Index s = 0; s < parents.size(); ++s)
    children.push_back(std::count(parents.begin(), parents.end(), s));
  std::sort(children.begin(), children.end());
  CGAL_CHECK(children == (std::vector<std::ptrdiff_t>{0, 0, 0, 0, 0, 0, 1, 1, 3, 3, 3})); // the body is its own parent
}

int main()
{
  for (const bool moves_borders : {true, false})
    for (const Test_mesh& mesh :
         {star(5), creature(), torus(), bumpy_sphere(3, 1), sheet(20, 30), tetrahedron()})
      check_segments_of_sets(mesh, 10, moves_borders);
  borders_may_stay_on_nodes(creature(), 6);
  for (const std::size_t arms : {3, 6})
    arms_stick_out_of_the_ball(arms);
  arms_that_touch_stick_out_of_the_head();
  fingers_stick_out_of_their_palms();
  return check::result();
}
