// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Protrusion tips (Section III.C) are the faces of eq. (1) and eq. (2).

#include "check.h"
#include "indexed_surfaces.h"
#include "test_meshes.h"

#include <CGAL/Protrusion_segmentation/Geodesic_distance.h>
#include <CGAL/Protrusion_segmentation/internal/Tips/select_protrusion_tips.h>

using namespace test_meshes;
using namespace CGAL::Protrusion_segmentation;
using internal::Tip_selection;

std::unique_ptr<internal::Distances_on_surface> distances_on(const Indexed_surface& surface)
{
  return internal::Any_distance(Geodesic_distance()).on(surface, quiet_execution());
}

const auto all_plausible = [](Index) { return true; };
const auto no_visit = [](Index, const std::vector<double>&) {};

Tip_selection tips_of(const Indexed_surface& surface, std::size_t count)
{
  const auto distances = distances_on(surface);
  return internal::select_protrusion_tips(surface, *distances, count, all_plausible, no_visit);
}

// Each tip reaches the maximum of its equation, in the distances of all pairs.
void check_equations(const Indexed_surface& surface, std::size_t count)
{
  const auto d = all_pairs_distances(surface);
  const Tip_selection selection = tips_of(surface, count);
  CGAL_CHECK_EQUAL(selection.tips.size(), count);
  CGAL_CHECK_EQUAL(selection.number_of_eliminated, 0);

  std::vector<double> value; // of every face, in the equation that selects the next tip
  for (const std::vector<double>& row : d)
    value.push_back(internal::distance_sum(row));
  bool first = true;
  for (const Index tip : selection.tips)
  {
    CGAL_CHECK(value[tip] >= *std::max_element(value.begin(), value.end()) * (1 - 1e-12));
    for (std::size_t f = 0; f < value.size(); ++f)
      value[f] = first ? d[tip][f] : (std::min)(value[f], d[tip][f]);
    first = false;
  }
}

void tips_maximize_both_equations()
{
  for (std::uint_fast32_t seed = 0; seed < 60; ++seed)
    check_equations(to_surface(random_surface(seed)), 1 + seed % 12);
  check_equations(to_surface(icosahedron()), 20);
  check_equations(to_surface(sheet(5, 4)), 20);
}

void tips_of_a_star_are_at_the_ends_of_its_arms()
{
  for (const std::size_t arms : {3, 6, 9})
  {
    const Test_mesh mesh = star(arms);
    const Indexed_surface surface = to_surface(mesh);
    std::set<std::size_t> parts;
    for (const Index tip : tips_of(surface, arms).tips)
    {
      const std::size_t arm = mesh.parts[tip];
      parts.insert(arm);
      CGAL_CHECK(arm > 0);
      // arms reach 1 + 2 (1 + 0.04 i) from the centre
      const double reach = 3 + 0.08 * double(arm - 1);
      CGAL_CHECK(length(centroid(mesh, mesh.faces[tip])) > reach - 0.2);
    }
    CGAL_CHECK_EQUAL(parts.size(), arms);
  }
}

void selection_ends_where_no_face_is_left()
{
  CGAL_CHECK_EQUAL(tips_of(to_surface(single_triangle()), 5).tips.size(), 1);
  CGAL_CHECK_EQUAL(tips_of(to_surface(tetrahedron()), 9).tips.size(), 4);
  CGAL_CHECK_EQUAL(tips_of(to_surface(scaled(tetrahedron(), 0)), 4).tips.size(), 1);
  CGAL_CHECK_EQUAL(tips_of(to_surface(tetrahedron()), 0).tips.size(), 0);
}

void implausible_tips_are_eliminated_and_counted()
{
  const Indexed_surface surface = to_surface(bumpy_sphere(3, 4));
  const std::vector<Index> all = tips_of(surface, 7).tips;
  const auto is_plausible = [&](Index face)
  { return (std::find(all.begin(), all.end(), face) - all.begin()) % 2 == 0; };
  std::vector<Index> visited;
  const auto visit = [&](Index face, const std::vector<double>&) { visited.push_back(face); };
  const auto distances = distances_on(surface);
  const Tip_selection selection = internal::select_protrusion_tips(surface, *distances, 4, is_plausible,
                                                                   visit);
  CGAL_CHECK(visited == all); // an eliminated face still keeps the next ones away
  CGAL_CHECK(selection.tips == (std::vector<Index>{all[0], all[2], all[4], all[6]}));
  CGAL_CHECK_EQUAL(selection.number_of_eliminated, 3);

  const Tip_selection none = internal::select_protrusion_tips(
    surface, *distances, 4, [](Index) { return false; }, no_visit);
  CGAL_CHECK(none.tips.empty());
  CGAL_CHECK_EQUAL(none.number_of_eliminated, 4);
}

void each_tip_is_visited_with_its_distances()
{
  const Indexed_surface surface = to_surface(bumpy_sphere(3, 5));
  const auto distances = distances_on(surface);
  distances->face_of_largest_sum();
  const std::size_t runs_of_search = distances->number_of_runs();
  std::vector<Index> visited;
  const auto visit = [&](Index tip, const std::vector<double>& from_tip)
  {
    visited.push_back(tip);
    CGAL_CHECK_EQUAL(from_tip.size(), surface.number_of_faces());
    CGAL_CHECK_EQUAL(from_tip[tip], 0);
  };
  const Tip_selection selection = internal::select_protrusion_tips(surface, *distances, 5, all_plausible,
                                                                   visit);
  CGAL_CHECK(visited == selection.tips);
  // one run a tip after eq. (1), which leaves the distances of the first one
  CGAL_CHECK_EQUAL(distances->number_of_runs(), 2 * runs_of_search + 4);
}

// A distance that has no way of its own to the face of eq. (1).
struct Plain_distance
{
  struct On_surface
  {
    void operator()(Index source, std::vector<double>& distances) { shortest(source, distances); }
    internal::Shortest_distances shortest;
  };
  On_surface on(const Indexed_surface& surface, Execution&) const
  {
    return {internal::Shortest_distances(surface)};
  }
};

void distances_without_a_search_take_all_pairs()
{
  const Indexed_surface surface = to_surface(random_surface(11));
  const auto plain = internal::Any_distance(Plain_distance()).on(surface, quiet_execution());
  const Tip_selection selection = internal::select_protrusion_tips(surface, *plain, 3, all_plausible,
                                                                   no_visit);
  CGAL_CHECK(selection.tips == tips_of(surface, 3).tips);
  CGAL_CHECK_EQUAL(plain->number_of_runs(), surface.number_of_faces() + 3);
}

int main()
{
  tips_maximize_both_equations();
  tips_of_a_star_are_at_the_ends_of_its_arms();
  selection_ends_where_no_face_is_left();
  implausible_tips_are_eliminated_and_counted();
  each_tip_is_visited_with_its_distances();
  distances_without_a_search_take_all_pairs();
  return check::result();
}
