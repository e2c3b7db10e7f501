// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Borders (Section III.D.3) in sequences of diameters made up for the purpose.

#include "check.h"
#include "test_meshes.h"

#include <CGAL/Protrusion_segmentation/internal/Histogram_method/Tip_record.h>

using test_meshes::Random;
using namespace CGAL::Protrusion_segmentation::internal;

using Diameters = std::array<double, number_of_slots>;

template <typename Diameter>
Diameters diameters(Diameter diameter_of_slot)
{
  Diameters result;
  for (std::size_t slot = 0; slot < number_of_slots; ++slot)
    result[slot] = diameter_of_slot(slot);
  return result;
}

Diameters step(std::size_t slot_of_step, double factor)
{
  return diameters([=](std::size_t slot) { return slot < slot_of_step ? 1. : factor; });
}

void a_step_is_one_inflection_at_its_foot()
{
  for (const std::size_t slot : {20, 50, 90})
  {
    const std::vector<Inflection> inflections = inflection_points(step(slot, 4));
    CGAL_CHECK_EQUAL(inflections.size(), 1);
    CGAL_CHECK(inflections.at(0).slot + 2 >= slot && inflections.at(0).slot <= slot);
    CGAL_CHECK_CLOSE(inflections.at(0).prominence, std::log(4.), 1e-12);
  }
}

void the_most_prominent_inflection_comes_first()
{
  const std::vector<Inflection> inflections = inflection_points(
    diameters([](std::size_t slot) { return slot < 30 ? 1. : slot < 50 ? 1.5 : slot < 70 ? 6. : 7.; }));
  CGAL_CHECK_EQUAL(inflections.size(), 3);
  CGAL_CHECK_CLOSE(inflections.at(0).prominence, std::log(4.), 1e-12);
  CGAL_CHECK_CLOSE(inflections.at(1).prominence, std::log(1.5), 1e-12);
  CGAL_CHECK_CLOSE(inflections.at(2).prominence, std::log(7. / 6), 1e-12);
  CGAL_CHECK_CLOSE(double(inflections.at(0).slot), 49., 1.);
  CGAL_CHECK_CLOSE(double(inflections.at(1).slot), 29., 1.);
  CGAL_CHECK_CLOSE(double(inflections.at(2).slot), 69., 1.);
}

// The ratio matters, not the difference: a small body has borders as clear as a large one.
void prominence_does_not_depend_on_the_size()
{
  for (const double size : {1e-200, 1e-3, 1e5, 1e200})
  {
    const std::vector<Inflection> inflections = inflection_points(
      diameters([=](std::size_t slot) { return slot < 40 ? size : 3 * size; }));
    CGAL_CHECK_EQUAL(inflections.size(), 1);
    CGAL_CHECK_CLOSE(inflections.at(0).prominence, std::log(3.), 1e-12);
  }
}

void even_and_falling_diameters_have_no_inflection()
{
  CGAL_CHECK(inflection_points(step(50, 1)).empty());
  CGAL_CHECK(inflection_points(step(50, 0.2)).empty());
  CGAL_CHECK(inflection_points(diameters([](std::size_t) { return 0.; })).empty());
  CGAL_CHECK(inflection_points(diameters([](std::size_t s) { return 100. - double(s); })).empty());
}

void the_cap_of_a_protrusion_is_no_inflection()
{
  const std::vector<Inflection> inflections = inflection_points(
    diameters([](std::size_t slot) { return slot < 10 ? 0.1 * double(slot) : 1.; }));
  CGAL_CHECK(inflections.empty());
}

// A section that misses: growth from nothing is none, and the ends of the histogram are no trouble.
void missing_sections_are_no_trouble()
{
  CGAL_CHECK(inflection_points(diameters([](std::size_t s) { return s < 60 ? 0. : 1.; })).size() <= 1);
  for (const Inflection& inflection :
       inflection_points(diameters([](std::size_t s) { return s % 7 == 0 ? 0. : 1.; })))
    CGAL_CHECK(std::isfinite(inflection.prominence) && inflection.slot < number_of_slots);
  for (const std::size_t slot : {0, 1, 11, 12, 13, 94, 95, 98, 99})
    CGAL_CHECK(inflection_points(step(slot, 2)).size() <= 1);
}

void intervals_contain_their_ends()
{
  const std::vector<Slot_interval> intervals = {{23, 68}, {71, 80}};
  for (const std::size_t slot : {23, 40, 68, 71, 80})
    CGAL_CHECK(contains(intervals, slot));
  for (const std::size_t slot : {0, 22, 69, 70, 81, 99})
    CGAL_CHECK(!contains(intervals, slot));
  CGAL_CHECK(!contains({}, 5));
}

// A tip whose slots hold 10 faces up to `slot_of_change` and 30 from there on.
Tip_record tip_record(const Diameters& diameters_of_tip, std::size_t slot_of_change)
{
  Tip_record record = {0, true, {}, {}, diameters_of_tip, number_of_slots};
  record.histogram.range = 100;
  for (std::size_t slot = 0; slot < number_of_slots; ++slot)
    record.histogram.counts[slot] = slot < slot_of_change ? 10 : 30;
  return record;
}

constexpr Border_conditions usual = {0.3, true, false};

void a_border_lies_in_a_candidate_interval()
{
  const Diameters two_steps = diameters([](std::size_t slot)
                                        { return slot < 30 ? 1. : slot < 70 ? 2. : 8.; });
  const auto slot_of_border = [&](std::size_t slot_of_change, const Border_conditions& conditions)
  {
    const auto border = border_of_tip({tip_record(two_steps, slot_of_change)}, 0, conditions);
    return border ? int(border->slot) : -1;
  };
  CGAL_CHECK_CLOSE(slot_of_border(70, usual), 69, 1); // the most prominent
  CGAL_CHECK_CLOSE(slot_of_border(30, usual), 29, 1); // the next one, if it is where faces change
  CGAL_CHECK_EQUAL(slot_of_border(50, usual), -1);
  CGAL_CHECK_CLOSE(slot_of_border(50, {0.3, false, false}), 69, 1);
}

void a_border_is_prominent_enough()
{
  const Tip_records records = {tip_record(step(50, 1.5), 50)};
  CGAL_CHECK(border_of_tip(records, 0, {0.4, true, false}).has_value());
  CGAL_CHECK(!border_of_tip(records, 0, {0.41, true, false}).has_value());
}

void a_border_does_not_lie_beyond_another_tip()
{
  Tip_records records = {tip_record(step(50, 4), 50), tip_record(step(50, 4), 50)};
  for (const double distance : {40., 60.})
  {
    records[1].to_earlier_tips = {distance};
    CGAL_CHECK_EQUAL(border_of_tip(records, 0, usual).has_value(), distance > 50);
    CGAL_CHECK_EQUAL(border_of_tip(records, 1, usual).has_value(), distance > 50);
  }
  records[1].to_earlier_tips = {40.};
  records[1].is_plausible = false; // then it is no tip, unless they are accepted
  CGAL_CHECK(border_of_tip(records, 0, usual).has_value());
  CGAL_CHECK(!border_of_tip(records, 1, usual).has_value());
  CGAL_CHECK(!border_of_tip(records, 0, {0.3, true, true}).has_value());
}

// Diameters that grow and shrink by chance.
Diameters random_diameters(Random& random)
{
  double diameter = 1;
  return diameters([&](std::size_t) { return diameter *= random.real(0.7, 1.5); });
}

Diameters first_of(const Diameters& all, std::size_t number)
{
  Diameters result{};
  std::copy(all.begin(), all.begin() + std::ptrdiff_t(number), result.begin());
  return result;
}

// Of the inflection points those that the first diameters decide on.
void a_window_needs_the_slots_that_it_says(std::uint_fast32_t seed)
{
  Random random(seed);
  const Diameters all = random_diameters(random);
  const std::vector<Inflection> expected = inflection_points(all);
  for (std::size_t number = 0; number <= number_of_slots; ++number)
  {
    const std::vector<Inflection> found = inflection_points(first_of(all, number), number);
    std::size_t i = 0;
    for (const Inflection& inflection : expected)
    {
      // it may lie as many slots behind the begin of its window as this is wide
      const bool is_known = Inflection_windows::slots_for(inflection.slot) <= number;
      if (i < found.size() && found[i].slot == inflection.slot && found[i].prominence == inflection.prominence)
        ++i;
      else
        CGAL_CHECK(!is_known);
    }
    CGAL_CHECK_EQUAL(i, found.size());
  }
}

// The diameters of the slots that matter give the border that all of them give, whatever they are compared with.
void the_slots_that_matter_decide(std::uint_fast32_t seed)
{
  Random random(seed);
  Tip_records all;
  for (std::size_t tip = 0; tip < 4; ++tip)
  {
    Tip_record record = tip_record(random_diameters(random), random.index(number_of_slots));
    for (std::size_t earlier = 0; earlier < tip; ++earlier)
      record.to_earlier_tips.push_back(random.real(5, 110));
    record.is_plausible = random.index(3) > 0;
    all.push_back(record);
  }
  std::size_t left_out = 0;
  for (const bool uses_candidate_intervals : {true, false})
    for (const bool accepts_implausible_tips : {true, false})
      for (const double largest_share : {1., 0.5})
        for (std::size_t tip = 0; tip < all.size(); ++tip)
        {
          const Border_conditions conditions = {0.1, uses_candidate_intervals, accepts_implausible_tips, largest_share};
          const std::size_t number = Border_range(all, tip, conditions).slots_that_matter();
          Tip_records first = all;
          first[tip].diameters = first_of(all[tip].diameters, number);
          first[tip].number_of_diameters = number;
          left_out += number_of_slots - number;
          const auto found = border_of_tip(first, tip, conditions), expected = border_of_tip(all, tip, conditions);
          CGAL_CHECK_EQUAL(found.has_value(), expected.has_value());
          if (found && expected)
          {
            CGAL_CHECK_EQUAL(found->slot, expected->slot);
            CGAL_CHECK_EQUAL(found->prominence, expected->prominence);
          }
        }
  CGAL_CHECK(left_out > 0);
}

int main()
{
  for (std::uint_fast32_t seed = 0; seed < 50; ++seed)
  {
    a_window_needs_the_slots_that_it_says(seed);
    the_slots_that_matter_decide(seed);
  }
  a_step_is_one_inflection_at_its_foot();
  the_most_prominent_inflection_comes_first();
  prominence_does_not_depend_on_the_size();
  even_and_falling_diameters_have_no_inflection();
  the_cap_of_a_protrusion_is_no_inflection();
  missing_sections_are_no_trouble();
  intervals_contain_their_ends();
  a_border_lies_in_a_candidate_interval();
  a_border_is_prominent_enough();
  a_border_does_not_lie_beyond_another_tip();
  return check::result();
}
