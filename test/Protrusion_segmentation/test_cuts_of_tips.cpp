// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Protrusions that are cut off for picked tips.

#include "check.h"
#include "components.h"
#include "segments_of_graphs.h"
#include "test_meshes.h"

#include <CGAL/Protrusion_segmentation/internal/Cut_method/Search/cuts_of_tips.h>

#include <algorithm>
#include <cstddef>
#include <set>
#include <vector>

using namespace test_meshes;
using internal::Cut_set;
using internal::Nodes;

// Of every part but the first the face that is farthest from the origin.
std::vector<Index> tips_of_parts(const Test_mesh& mesh)
{
  std::vector<Index> tips(number_of_parts(mesh) - 1, 0);
  std::vector<double> farthest(tips.size(), -1);
  for (std::size_t f = 0; f < mesh.faces.size(); ++f)
    if (const std::size_t part = mesh.parts[f];
        part > 0 && length(centroid(mesh, mesh.faces[f])) > farthest[part - 1])
    {
      farthest[part - 1] = length(centroid(mesh, mesh.faces[f]));
      tips[part - 1] = Index(f);
    }
  return tips;
}

bool contains(const Nodes& nodes, Index node)
{
  return std::binary_search(nodes.begin(), nodes.end(), node);
}

// The inner side of every cut has one of the tips only, and at most half of the surface.
void check_cuts(const internal::Component& component, const Cut_set& set, const std::vector<Index>& tips)
{
  for (const Cut_set::Made_cut& cut : set.cuts)
  {
    const internal::Segment& inner = component.memo()[cut.inner].segment;
    CGAL_CHECK(inner.area <= 0.5 + 1e-9);
    std::size_t count = 0;
    for (const Index tip : tips)
      count += contains(inner.nodes, component.node_at(tip));
    CGAL_CHECK_EQUAL(count, 1u);
  }
  check_segments(component.graphs().coarse, labels_of_nodes(component, set), set.segments.size());
}

// One arm for each tip, whichever are picked.
void arms_are_cut_off(const Test_mesh& mesh)
{
  Component_of_mesh of_mesh(mesh);
  const std::vector<Index> all_tips = tips_of_parts(mesh);
  for (std::size_t number = 0; number <= all_tips.size(); ++number)
  {
    const std::vector<Index> tips(all_tips.begin(), all_tips.begin() + std::ptrdiff_t(number));
    const Cut_set set = of_mesh.component.cuts_of_tips(tips);
    CGAL_CHECK_EQUAL(set.segments.size(), number + 1);
    check_cuts(of_mesh.component, set, tips);
    const std::vector<Index> labels = labels_of_faces(of_mesh.component, set);
    for (std::size_t t = 0; t < number; ++t)
    {
      double common = 0, both = 0;
      for (std::size_t f = 0; f < labels.size(); ++f)
      {
        const bool is_in_part = mesh.parts[f] == t + 1, is_in_segment = labels[f] == labels[tips[t]];
        common += is_in_part && is_in_segment ? of_mesh.surface.area(Index(f)) : 0;
        both += is_in_part || is_in_segment ? of_mesh.surface.area(Index(f)) : 0;
      }
      CGAL_CHECK(common > 0.8 * both);
    }
  }
}

// Any faces may be picked, also neighbours and all of them, and on what has no protrusion.
void any_faces_may_be_tips(const Test_mesh& mesh)
{
  Component_of_mesh of_mesh(mesh);
  const std::vector<std::size_t> order = random_permutation(mesh.faces.size(), 1);
  for (const std::size_t number : {1, 2, 5, 12})
  {
    const std::vector<Index> tips(order.begin(),
                                  order.begin() + std::ptrdiff_t((std::min)(number, order.size())));
    const Cut_set set = of_mesh.component.cuts_of_tips(tips);
    CGAL_CHECK(set.segments.size() <= tips.size() + 1);
    for (const Cut_set::Made_cut& cut : set.cuts)
      CGAL_CHECK(of_mesh.component.memo()[cut.inner].segment.area <= 0.5 + 1e-9);
    check_segments(of_mesh.component.graphs().coarse, labels_of_nodes(of_mesh.component, set),
                   set.segments.size());
  }
}

std::vector<Index> tips_of(const internal::Component& component,
                           const Cut_set& set)
{
  std::vector<Index> tips;
  for (const auto& protrusion : component.describe(component.segments(set)))
    tips.push_back(protrusion.tip);
  return tips;
}

// The tips of the best segmentation into any number of segments give that, in any order.
void tips_of_a_result_give_the_result(const Test_mesh& mesh, std::size_t largest_number)
{
  Component_of_mesh of_mesh(mesh);
  for (std::size_t number = 1; number <= largest_number && of_mesh.component.best(number); ++number)
  {
    const Cut_set set = *of_mesh.component.best(number);
    std::vector<Index> tips = tips_of(of_mesh.component, set);
    std::reverse(tips.begin(), tips.end());
    CGAL_CHECK(of_mesh.component.cuts_of_tips(tips).segments == set.segments);
  }
}

// Of the tips of the automatic segmentation some are picked: each gets its segment there, with what sticks out of it and has no
// tip that is picked, and the other segments are part of the body.
void some_tips_of_the_automatic_result(const Test_mesh& mesh, bool is_star)
{
  Component_of_mesh of_mesh(mesh);
  const Cut_set automatic = *of_mesh.component.best(of_mesh.component.automatic_number());
  const std::vector<Index> all_tips = tips_of(of_mesh.component, automatic);
  CGAL_CHECK(all_tips.size() >= 4);
  const std::vector<Index> old_labels = labels_of_faces(of_mesh.component, automatic);
  for (unsigned int seed = 1; seed <= 20; ++seed)
  {
    const std::vector<std::size_t> order = random_permutation(all_tips.size(), seed);
    std::vector<Index> tips;
    for (std::size_t i = 0; i < 1 + seed % 3; ++i)
      tips.push_back(all_tips[order[i]]);
    const Cut_set set = of_mesh.component.cuts_of_tips(tips);
    CGAL_CHECK_EQUAL(set.segments.size(), tips.size() + 1);
    const std::vector<Index> labels = labels_of_faces(of_mesh.component, set);
    std::set<Index> labels_of_tips;
    for (const Index tip : tips)
    {
      labels_of_tips.insert(labels[tip]);
      for (std::size_t f = 0; f < labels.size(); ++f)
        if (old_labels[f] == old_labels[tip])
          CGAL_CHECK_EQUAL(labels[f], labels[tip]);
        else if (is_star)
          CGAL_CHECK(labels[f] != labels[tip]);
    }
    if (is_star)
      CGAL_CHECK_EQUAL(labels_of_tips.size(), tips.size());
  }
}

// A tip that is added to those of a result leaves their protrusions as they are, but for what the new one is cut from.
void a_further_tip_adds_a_protrusion()
{
  const Test_mesh mesh = star(5);
  Component_of_mesh of_mesh(mesh);
  const Cut_set set = *of_mesh.component.best(4); // three arms
  std::vector<Index> tips = tips_of(of_mesh.component, set);
  const std::vector<Index> labels = labels_of_faces(of_mesh.component, set);
  for (const Index tip : tips_of_parts(mesh))
    if (std::none_of(tips.begin(), tips.end(), [&](Index t) { return labels[t] == labels[tip]; }))
    {
      tips.insert(tips.begin(), tip);
      break;
    }
  CGAL_CHECK_EQUAL(tips.size(), 4u);
  const Cut_set larger = of_mesh.component.cuts_of_tips(tips);
  CGAL_CHECK_EQUAL(larger.segments.size(), 5u);
  CGAL_CHECK(std::count_if(set.segments.begin(), set.segments.end(),
                      [&](Index s) {
                        return std::count(larger.segments.begin(), larger.segments.end(), s) > 0;
                      }) == 3);
}

int main()
{
  for (const std::size_t arms : {1, 4})
    arms_are_cut_off(star(arms));
  tips_of_a_result_give_the_result(star(6), 9);
  tips_of_a_result_give_the_result(creature(), 9);
  a_further_tip_adds_a_protrusion();
  for (const std::size_t arms : {8, 11})
    some_tips_of_the_automatic_result(star(arms), true);
  some_tips_of_the_automatic_result(creature(), false);
  for (const Test_mesh& mesh : {creature(), icosphere(3), torus(), tetrahedron(), sheet(20, 30)})
    any_faces_may_be_tips(mesh);
  return check::result();
}
