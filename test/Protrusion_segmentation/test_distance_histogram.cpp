// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The distance histogram and its candidate intervals (Section III.D.1).

#include "check.h"
#include "indexed_surfaces.h"
#include "test_meshes.h"

#include <CGAL/Protrusion_segmentation/internal/Distances/Shortest_distances.h>
#include <CGAL/Protrusion_segmentation/internal/Histogram_method/histograms.h>

using namespace test_meshes;
using namespace CGAL::Protrusion_segmentation::internal;

// `count(slot)` faces in each slot.
template <typename Count>
Distance_histogram histogram_with_counts(Count count)
{
  Distance_histogram histogram;
  histogram.range = 1;
  for (std::size_t slot = 0; slot < number_of_slots; ++slot)
    histogram.counts[slot] = count(slot);
  return histogram;
}

void slots_hold_the_faces_at_their_distances()
{
  for (std::uint_fast32_t seed = 0; seed < 50; ++seed)
  {
    const Indexed_surface surface = to_surface(random_surface(seed));
    std::vector<double> distances;
    Shortest_distances shortest(surface);
    shortest(Index(seed % 40), distances);
    const Slots tip_slots(distances);
    const Distance_histogram histogram(distances);
    const std::size_t few = seed % 20;
    const Slots first_slots(distances, histogram, few);
    CGAL_CHECK_EQUAL(tip_slots.number(), number_of_slots);
    CGAL_CHECK_EQUAL(first_slots.number(), few);
    CGAL_CHECK_EQUAL(histogram.range, *std::max_element(distances.begin(), distances.end()));
    CGAL_CHECK_EQUAL(histogram.slot(0), 0);
    CGAL_CHECK_EQUAL(histogram.slot(histogram.range), 99);

    std::size_t total = 0;
    const double rounding = 1e-12 * histogram.range;
    for (std::size_t slot = 0; slot < number_of_slots; ++slot)
    {
      CGAL_CHECK_EQUAL(tip_slots.faces(slot).size(), histogram.counts[slot]);
      CGAL_CHECK(std::is_sorted(tip_slots.faces(slot).begin(), tip_slots.faces(slot).end()));
      CGAL_CHECK(slot >= few || tip_slots.faces(slot) == first_slots.faces(slot));
      for (const Index f : tip_slots.faces(slot))
      {
        CGAL_CHECK(distances[f] >= histogram.slot_begin(slot) - rounding);
        CGAL_CHECK(distances[f] < histogram.slot_begin(slot + 1) + (slot == 99 ? 1 : rounding));
      }
      total += histogram.counts[slot];
    }
    CGAL_CHECK_EQUAL(total, distances.size());
  }
}

// Along a thin cylinder wall of 400 rings, seen from a face at its end: 4 rings a slot.
void counts_on_a_cylinder_are_even()
{
  const std::size_t slices = 12;
  const Test_mesh mesh = revolution(Profile(0.01).line(1e-3, 0, 1e-3, 4, 0), slices);
  const Indexed_surface surface = to_surface(mesh);
  CGAL_CHECK_EQUAL(surface.number_of_faces(), 400 * slices);
  std::vector<double> distances;
  Shortest_distances shortest(surface);
  shortest(0, distances);
  const Distance_histogram histogram(distances);
  CGAL_CHECK_CLOSE(histogram.range, 3.99, 0.01);
  for (const Index count : histogram.counts)
    CGAL_CHECK_CLOSE(double(count), 4. * slices, 1. * slices);
}

void one_distance_fills_one_slot()
{
  const Distance_histogram single(std::vector<double>(7, 0));
  CGAL_CHECK_EQUAL(single.range, 0);
  CGAL_CHECK_EQUAL(single.counts[0], 7);
  CGAL_CHECK_EQUAL(single.counts[99], 0);
  const Distance_histogram tiny({0, 1e-310, 2e-310}); // not normal numbers
  CGAL_CHECK_EQUAL(tiny.counts[0], 1);
  CGAL_CHECK_EQUAL(tiny.counts[50], 1);
  CGAL_CHECK_EQUAL(tiny.counts[99], 1);
}

// The smoothed contour of a step at slot 40 rises from slot 37 to slot 42; 5 slots around are taken.
void a_step_is_one_candidate_interval()
{
  const std::vector<Slot_interval> intervals = candidate_intervals(
    histogram_with_counts([](std::size_t slot) { return slot < 40 ? 10u : 30u; }));
  CGAL_CHECK_EQUAL(intervals.size(), 1);
  CGAL_CHECK_EQUAL(intervals.at(0).first, 32);
  CGAL_CHECK_EQUAL(intervals.at(0).last, 47);
}

void candidate_intervals_end_with_the_histogram()
{
  const std::vector<Slot_interval> intervals = candidate_intervals(
    histogram_with_counts([](std::size_t slot) { return slot < 3 || slot > 96 ? 50u : 10u; }));
  CGAL_CHECK_EQUAL(intervals.size(), 2);
  CGAL_CHECK_EQUAL(intervals.at(0).first, 0);
  CGAL_CHECK_EQUAL(intervals.at(1).last, 99);
}

void a_narrow_bump_is_one_interval_and_a_wide_one_two()
{
  const auto intervals_of_bump = [](std::size_t first, std::size_t end)
  {
    return candidate_intervals(
      histogram_with_counts([=](std::size_t slot) { return slot >= first && slot < end ? 50u : 10u; }));
  };
  CGAL_CHECK_EQUAL(intervals_of_bump(30, 45).size(), 1); // slots 22 to 37 and 37 to 52
  CGAL_CHECK_EQUAL(intervals_of_bump(30, 46).size(), 1); // slots 22 to 37 and 38 to 53
  CGAL_CHECK_EQUAL(intervals_of_bump(30, 47).size(), 2);

  const std::vector<Slot_interval> wide = intervals_of_bump(30, 60);
  CGAL_CHECK_EQUAL(wide.size(), 2);
  CGAL_CHECK_EQUAL(wide.at(0).first, 22);
  CGAL_CHECK_EQUAL(wide.at(0).last, 37);
  CGAL_CHECK_EQUAL(wide.at(1).first, 52);
  CGAL_CHECK_EQUAL(wide.at(1).last, 67);
}

void even_counts_have_no_candidate_interval()
{
  CGAL_CHECK(candidate_intervals(histogram_with_counts([](std::size_t) { return 10u; })).empty());
}

void moving_averages_shrink_at_the_ends()
{
  std::array<double, number_of_slots> values;
  for (std::size_t s = 0; s < number_of_slots; ++s)
    values[s] = double(s * s);
  const auto average = moving_average(values, 2);
  CGAL_CHECK_CLOSE(average[0], (0 + 1 + 4) / 3., 1e-12);
  CGAL_CHECK_CLOSE(average[1], (0 + 1 + 4 + 9) / 4., 1e-12);
  CGAL_CHECK_CLOSE(average[50], 50 * 50 + 2, 1e-12);
  CGAL_CHECK_CLOSE(average[99], (97 * 97 + 98 * 98 + 99 * 99) / 3., 1e-12);
  CGAL_CHECK(moving_average(values, 0) == values);
}

int main()
{
  slots_hold_the_faces_at_their_distances();
  counts_on_a_cylinder_are_even();
  one_distance_fills_one_slot();
  a_step_is_one_candidate_interval();
  candidate_intervals_end_with_the_histogram();
  a_narrow_bump_is_one_interval_and_a_wide_one_two();
  even_counts_have_no_candidate_interval();
  moving_averages_shrink_at_the_ends();
  return check::result();
}
