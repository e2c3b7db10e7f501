// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// How sure borders and labels are: on trees written down by hand, and what the methods tell.

#include "check.h"
#include "test_meshes.h"

#include <CGAL/Protrusion_segmentation/Histogram_method.h>
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

using Record = PS::Segmentation_record<Mesh>;
using Protrusion = PS::Protrusion<Mesh::Face_index>;

Protrusion protrusion(std::size_t segment, std::size_t parent, double value, std::optional<double> probability)
{
  Protrusion result;
  result.segment = segment;
  result.parent = parent;
  result.value = value;
  result.probability = probability;
  return result;
}

Record record_of(const std::vector<Protrusion>& protrusions)
{
  Record record;
  for (const Protrusion& found : protrusions)
    record.on_protrusion(found);
  return record;
}

// A body with an arm, which has a hand, and a leg; and a body without anything.
void the_least_value_on_the_way_counts()
{
  const Record borders =
    record_of({protrusion(2, 0, 0.3, 0.9), protrusion(3, 0, 0.1, 0.8), protrusion(4, 2, 0.2, 0.7)});
  CGAL_CHECK_EQUAL(borders.value(0, 2).value(), 0.3);
  CGAL_CHECK_EQUAL(borders.value(2, 0).value(), 0.3);
  CGAL_CHECK_EQUAL(borders.value(4, 0).value(), 0.2);
  CGAL_CHECK_EQUAL(borders.value(4, 3).value(), 0.1);
  CGAL_CHECK(!borders.value(2, 2));
  CGAL_CHECK(!borders.value(1, 2));
  CGAL_CHECK_EQUAL(borders.probability(4, 3).value(), 0.7);
  CGAL_CHECK_EQUAL(borders.probability(0, 3).value(), 0.8);
  CGAL_CHECK(!borders.probability(1, 3));
  CGAL_CHECK(!borders.probability(3, 3));
  CGAL_CHECK_EQUAL(borders.least_value(0).value(), 0.1);
  CGAL_CHECK(!borders.least_value(1));
  CGAL_CHECK_EQUAL(borders.least_value(2).value(), 0.2);
  CGAL_CHECK_EQUAL(borders.least_value(4).value(), 0.2);
  CGAL_CHECK_EQUAL(borders.least_probability(2).value(), 0.7);
  CGAL_CHECK(!borders.least_probability(1));
}

void there_may_be_no_borders_and_no_probabilities()
{
  const Record none;
  CGAL_CHECK(!none.least_value(0));
  CGAL_CHECK(!none.value(0, 1));
  const Record borders = record_of({protrusion(1, 0, 0.5, std::nullopt)});
  CGAL_CHECK_EQUAL(borders.value(0, 1).value(), 0.5);
  CGAL_CHECK(!borders.probability(0, 1));
  CGAL_CHECK(!borders.least_probability(1));
}

struct Found
{
  Mesh mesh;
  std::vector<std::size_t> segments;
  Record record;
};

template <typename Method>
Found segmented(const Test_mesh& soup, std::size_t k, const Method& method)
{
  Found found;
  found.mesh = to_graph<Mesh>(soup);
  found.segments.resize(found.mesh.number_of_faces());
  CGAL::segmentation_via_protrusion_tips(
    found.mesh, boost::make_iterator_property_map(found.segments.begin(), get(boost::face_index, found.mesh)), k, method,
    CGAL::parameters::visitor(std::ref(found.record)));
  return found;
}

// The value of a cut comes from its probability, so the two have the same sign; and no value is above the root of a
// quarter.
void the_default_method_tells_probabilities()
{
  const Found found = segmented(creature(), 7, PS::Minimum_cut_method());
  CGAL_CHECK(found.record.protrusions().size() > 2);
  for (const auto& protrusion : found.record.protrusions())
  {
    CGAL_CHECK(protrusion.probability.has_value());
    CGAL_CHECK(*protrusion.probability > 0 && *protrusion.probability < 1);
    CGAL_CHECK_EQUAL(protrusion.value > 0, *protrusion.probability > 0.5);
    CGAL_CHECK(std::abs(protrusion.value) <= std::abs(*protrusion.probability - 0.5));
  }
}

void the_method_of_the_paper_tells_values_only()
{
  const Found found = segmented(star(5), 6, PS::Histogram_method());
  CGAL_CHECK_EQUAL(found.record.protrusions().size(), 5);
  for (const auto& protrusion : found.record.protrusions())
  {
    CGAL_CHECK(protrusion.value > 0);
    CGAL_CHECK(!protrusion.probability);
  }
}

std::vector<double> confidence_of(const Found& found)
{
  std::vector<double> confidence(found.segments.size(), -1);
  const auto index = get(boost::face_index, found.mesh);
  PS::label_confidence(found.mesh, boost::make_iterator_property_map(found.segments.begin(), index), found.record,
                       boost::make_iterator_property_map(confidence.begin(), index));
  return confidence;
}

// The least of `sureness(protrusion)` of the borders of its segment.
template <typename Sureness>
void check_confidence(const Found& found, Sureness sureness)
{
  const std::vector<double> confidence = confidence_of(found);
  for (std::size_t f = 0; f < confidence.size(); ++f)
  {
    double least = infinity;
    for (const auto& protrusion : found.record.protrusions())
      if (protrusion.segment == found.segments[f] || protrusion.parent == found.segments[f])
        least = (std::min)(least, sureness(protrusion));
    CGAL_CHECK_EQUAL(confidence[f], least);
  }
}

void confidence_is_the_least_probability_of_the_segment()
{
  check_confidence(segmented(creature(), 7, PS::Minimum_cut_method()),
                   [](const Protrusion& protrusion) { return protrusion.probability.value(); });
}

void confidence_is_the_least_value_without_probabilities()
{
  check_confidence(segmented(star(5), 6, PS::Histogram_method()),
                   [](const Protrusion& protrusion) { return protrusion.value; });
}

void a_segment_without_a_border_is_beyond_doubt()
{
  for (const double confidence : confidence_of(segmented(star(5), 1, PS::Minimum_cut_method())))
    CGAL_CHECK_EQUAL(confidence, infinity);
}

// The value of the weakest arm falls with their number; its probability does not.
void equal_arms_are_equally_sure()
{
  const Found found = segmented(star(8), 9, PS::Minimum_cut_method());
  const std::vector<double> confidence = confidence_of(found);
  CGAL_CHECK(*std::min_element(confidence.begin(), confidence.end()) > 0.5);
}

int main()
{
  the_least_value_on_the_way_counts();
  there_may_be_no_borders_and_no_probabilities();
  the_default_method_tells_probabilities();
  the_method_of_the_paper_tells_values_only();
  confidence_is_the_least_probability_of_the_segment();
  confidence_is_the_least_value_without_probabilities();
  a_segment_without_a_border_is_beyond_doubt();
  equal_arms_are_equally_sure();
  return check::result();
}
