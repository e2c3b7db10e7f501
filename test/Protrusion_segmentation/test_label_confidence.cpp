// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// How sure borders and labels are: on trees written down by hand, and what the methods tell.

#include "check.h"
#include "recorder.h"
#include "test_meshes.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/protrusion_segmentation.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <vector>

using namespace test_meshes;
using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
namespace PS = CGAL::Protrusion_segmentation;

constexpr double infinity = std::numeric_limits<double>::infinity();

PS::Protrusion<int> protrusion(std::size_t segment, std::size_t parent, double value, std::optional<double> probability)
{
  PS::Protrusion<int> result{};
  result.segment = segment;
  result.parent = parent;
  result.value = value;
  result.probability = probability;
  return result;
}

// A body with an arm, which has a hand, and a leg; and a body without anything.
void the_least_value_on_the_way_counts()
{
  const std::vector<PS::Protrusion<int>> protrusions = {
    protrusion(2, 0, 0.3, 0.9), protrusion(3, 0, 0.1, 0.8), protrusion(4, 2, 0.2, 0.7)};
  const PS::Border_values borders(protrusions);
  CHECK_EQUAL(borders.value(0, 2), 0.3);
  CHECK_EQUAL(borders.value(2, 0), 0.3);
  CHECK_EQUAL(borders.value(4, 0), 0.2);
  CHECK_EQUAL(borders.value(4, 3), 0.1);
  CHECK_EQUAL(borders.value(2, 2), infinity);
  CHECK_EQUAL(borders.value(1, 2), infinity);
  CHECK_EQUAL(borders.probability(4, 3).value(), 0.7);
  CHECK_EQUAL(borders.probability(0, 3).value(), 0.8);
  CHECK(!borders.probability(1, 3));
  CHECK(!borders.probability(3, 3));
  CHECK_EQUAL(borders.least_value(0), 0.1);
  CHECK_EQUAL(borders.least_value(1), infinity);
  CHECK_EQUAL(borders.least_value(2), 0.2);
  CHECK_EQUAL(borders.least_value(4), 0.2);
  CHECK_EQUAL(borders.least_probability(2).value(), 0.7);
  CHECK(!borders.least_probability(1));
}

void there_may_be_no_borders_and_no_probabilities()
{
  const PS::Border_values none;
  CHECK_EQUAL(none.least_value(0), infinity);
  CHECK_EQUAL(none.value(0, 1), infinity);
  const PS::Border_values borders(std::vector<PS::Protrusion<int>>{protrusion(1, 0, 0.5, std::nullopt)});
  CHECK_EQUAL(borders.value(0, 1), 0.5);
  CHECK(!borders.probability(0, 1));
  CHECK(!borders.least_probability(1));
}

struct Found
{
  Mesh mesh;
  std::vector<std::size_t> segments;
  Recorder<Mesh> recorder;
};

template <typename Method>
Found segmented(const Test_mesh& soup, std::size_t k, const Method& method)
{
  Found found;
  found.mesh = to_graph<Mesh>(soup);
  found.segments.resize(found.mesh.number_of_faces());
  CGAL::segmentation_via_protrusion_tips(
    found.mesh, boost::make_iterator_property_map(found.segments.begin(), get(boost::face_index, found.mesh)), k, method,
    CGAL::parameters::visitor(std::ref(found.recorder)));
  return found;
}

// The value of a cut comes from its probability, so the two have the same sign; and no value is above the root of a
// quarter.
void the_default_method_tells_probabilities()
{
  const Found found = segmented(creature(), 7, PS::Minimum_cut_method());
  CHECK(found.recorder.protrusions.size() > 2);
  for (const auto& protrusion : found.recorder.protrusions)
  {
    CHECK(protrusion.probability.has_value());
    CHECK(*protrusion.probability > 0 && *protrusion.probability < 1);
    CHECK_EQUAL(protrusion.value > 0, *protrusion.probability > 0.5);
    CHECK(std::abs(protrusion.value) <= std::abs(*protrusion.probability - 0.5));
  }
}

void the_method_of_the_paper_tells_values_only()
{
  const Found found = segmented(star(5), 6, PS::Histogram_method());
  CHECK_EQUAL(found.recorder.protrusions.size(), 5);
  for (const auto& protrusion : found.recorder.protrusions)
  {
    CHECK(protrusion.value > 0);
    CHECK(!protrusion.probability);
  }
}

void every_face_gets_the_least_value_of_its_segment()
{
  const Found found = segmented(creature(), 7, PS::Minimum_cut_method());
  const PS::Border_values borders(found.recorder.protrusions);
  std::vector<double> confidence(found.segments.size(), -1);
  CGAL::Protrusion_segmentation::label_confidence(
    found.mesh,
    boost::make_iterator_property_map(found.segments.begin(), get(boost::face_index, found.mesh)),
    borders, boost::make_iterator_property_map(confidence.begin(), get(boost::face_index, found.mesh)));
  for (std::size_t f = 0; f < confidence.size(); ++f)
  {
    double least = infinity;
    for (const auto& protrusion : found.recorder.protrusions)
      if (protrusion.segment == found.segments[f] || protrusion.parent == found.segments[f])
        least = (std::min)(least, protrusion.value);
    CHECK_EQUAL(confidence[f], least);
  }
}

int main()
{
  the_least_value_on_the_way_counts();
  there_may_be_no_borders_and_no_probabilities();
  the_default_method_tells_probabilities();
  the_method_of_the_paper_tells_values_only();
  every_face_gets_the_least_value_of_its_segment();
  return check::result();
}
