// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The sectional-diameter histogram (Section III.D.2) on bodies whose sections are known circles.

#include "check.h"
#include "indexed_surfaces.h"
#include "test_meshes.h"

#include <CGAL/Protrusion_segmentation/internal/Distances/Shortest_distances.h>
#include <CGAL/Protrusion_segmentation/internal/Histogram_method/histograms.h>

using namespace test_meshes;
using namespace CGAL::Protrusion_segmentation::internal;

// The histograms of a body around the z-axis, seen from the face at its lowest end.
class Seen_from_below
{
public:
  explicit Seen_from_below(const Test_mesh& mesh)
    : m_surface(to_surface(mesh)),
      m_distances(distances_from_lowest(m_surface)),
      m_slots(m_distances),
      m_diameters(histogram(m_surface, m_distances, m_slots))
  {}

  double diameter(std::size_t slot) const { return m_diameters[slot]; }

  // The mean height of the faces in a slot.
  double height(std::size_t slot) const
  {
    double sum = 0;
    for (const Index f : m_slots.faces(slot))
      sum += m_surface.centroid(f).z();
    return sum / double(m_slots.faces(slot).size());
  }

  Section_plane plane(std::size_t slot) const
  {
    return plane_of_slot(m_surface, m_distances, m_slots, slot);
  }

  Distance_histogram counts() const { return Distance_histogram(m_distances); }

  // The same, if only the first slots are looked at.
  std::array<double, number_of_slots> first_diameters(std::size_t number) const
  {
    return histogram(m_surface, m_distances, Slots(m_distances, counts(), number));
  }

private:
  static std::vector<double> distances_from_lowest(const Indexed_surface& surface)
  {
    Index lowest = 0;
    for (Index f = 0; f < surface.number_of_faces(); ++f)
      if (surface.centroid(f).z() < surface.centroid(lowest).z())
        lowest = f;
    std::vector<double> distances;
    Shortest_distances shortest(surface);
    shortest(lowest, distances);
    return distances;
  }

  static std::array<double, number_of_slots> histogram(const Indexed_surface& surface,
                                                       const std::vector<double>& distances,
                                                       const Slots& tip_slots)
  {
    Plane_section section(surface);
    return sectional_diameter_histogram(surface, distances, tip_slots, section, quiet_execution());
  }

  Indexed_surface m_surface;
  std::vector<double> m_distances;
  Slots m_slots;
  std::array<double, number_of_slots> m_diameters;
};

// Away from the caps every section of a capsule is a circle of its radius, a few degrees tilted.
void diameters_along_a_capsule_are_even()
{
  const double radius = 0.5;
  const Seen_from_below seen(capsule(radius, 8, 0.08));
  std::size_t slots_on_wall = 0;
  for (std::size_t slot = 0; slot < number_of_slots; ++slot)
    if (seen.counts().counts[slot] > 0 && std::abs(seen.height(slot)) < 3.5)
    {
      CGAL_CHECK_CLOSE(seen.diameter(slot), 2 * radius, 0.05);
      const Indexed_surface::Vector_3 normal = seen.plane(slot).normal;
      CGAL_CHECK(normal.z() > 0.95 * std::sqrt(normal.squared_length())); // points away from the tip
      ++slots_on_wall;
    }
  CGAL_CHECK(slots_on_wall > 60);
}

// The circle at the height of the slot: narrow on the stick, wide in the middle of the ball.
void diameters_grow_from_the_stick_to_the_ball()
{
  const double stick = 0.3, ball = 1, stick_length = 3;
  const double center = stick_length + std::sqrt(ball * ball - stick * stick);
  const Seen_from_below seen(capsule_with_ball(stick, stick_length, ball, 0.06));
  std::size_t slots_on_stick = 0, slots_on_ball = 0;
  for (std::size_t slot = 0; slot < number_of_slots; ++slot)
  {
    if (seen.counts().counts[slot] == 0)
      continue;
    const double z = seen.height(slot);
    if (z > 0.2 && z < stick_length - 0.2)
    {
      CGAL_CHECK_CLOSE(seen.diameter(slot), 2 * stick, 0.06);
      ++slots_on_stick;
    }
    else if (std::abs(z - center) < 0.7)
    {
      CGAL_CHECK_CLOSE(seen.diameter(slot), 2 * std::sqrt(ball * ball - (z - center) * (z - center)), 0.1);
      ++slots_on_ball;
    }
  }
  CGAL_CHECK(slots_on_stick > 30);
  CGAL_CHECK(slots_on_ball > 15);
}

// Two sticks side by side on one ball: the section of the one that is looked from does not reach
// over to the other.
void only_the_component_at_the_slot_counts()
{
  const Test_mesh mesh = implicit_mesh(Implicit_body({ball({0, 0, 3}, 1.2, 0),
                                                      {{-0.7, 0, 0}, {-0.7, 0, 3}, 0.25, 0.25, 1},
                                                      {{0.7, 0, 0.1}, {0.7, 0, 3}, 0.25, 0.25, 2}},
                                                     0.03),
                                       0.2);
  const Seen_from_below seen(mesh);
  for (std::size_t slot = 0; slot < number_of_slots; ++slot)
    if (seen.counts().counts[slot] > 0 && seen.height(slot) > 0.2 && seen.height(slot) < 1.4)
      CGAL_CHECK(seen.diameter(slot) < 0.7);
}

void a_slot_without_a_section_repeats_the_one_before()
{
  const Seen_from_below row(sheet(30, 1)); // 30 faces in 100 slots
  for (std::size_t slot = 1; slot < number_of_slots; ++slot)
    if (row.counts().counts[slot] == 0)
      CGAL_CHECK_EQUAL(row.diameter(slot), row.diameter(slot - 1));
  const Seen_from_below point(scaled(icosphere(1), 0));
  for (std::size_t slot = 0; slot < number_of_slots; ++slot)
    CGAL_CHECK_EQUAL(point.diameter(slot), 0);
  const Seen_from_below triangle(single_triangle());
  CGAL_CHECK_EQUAL(triangle.diameter(99), 0);
}

void no_diameter_is_below_zero_or_beyond_the_body()
{
  for (std::uint_fast32_t seed = 0; seed < 40; ++seed)
  {
    const Test_mesh mesh = random_surface(seed);
    double largest = 0;
    for (const Point& p : mesh.points)
      for (const Point& q : mesh.points)
        largest = (std::max)(largest, length(p - q));
    const Seen_from_below seen(mesh);
    for (std::size_t slot = 0; slot < number_of_slots; ++slot)
      CGAL_CHECK(seen.diameter(slot) >= 0 && seen.diameter(slot) <= largest * (1 + 1e-12));
  }
}

void first_slots_have_the_diameters_that_they_have_among_all()
{
  const Seen_from_below seen(creature(0.2));
  for (const std::size_t number : {0, 1, 37, 99, 100})
  {
    const auto first = seen.first_diameters(number);
    for (std::size_t slot = 0; slot < number_of_slots; ++slot)
      CGAL_CHECK_EQUAL(first[slot], slot < number ? seen.diameter(slot) : 0);
  }
}

int main()
{
  first_slots_have_the_diameters_that_they_have_among_all();
  diameters_along_a_capsule_are_even();
  diameters_grow_from_the_stick_to_the_ball();
  only_the_component_at_the_slot_counts();
  a_slot_without_a_section_repeats_the_one_before();
  no_diameter_is_below_zero_or_beyond_the_body();
  return check::result();
}
