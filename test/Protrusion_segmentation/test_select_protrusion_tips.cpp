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

std::unique_ptr<internal::Distances_on_surface> distances_on(const Indexed_surface& surface)
{
  return internal::Any_distance(Geodesic_distance()).on(surface, quiet_execution());
}

const auto all_plausible = [](Index) { return true; };

// All that are visited.
template <typename Plausible>
std::vector<Index> tips_of(const Indexed_surface& surface,
                           internal::Distances_on_surface& distances,
                           std::size_t count,
                           Plausible is_plausible)
{
  std::vector<Index> tips;
  internal::select_protrusion_tips(surface, distances, count, is_plausible,
                                   [&](Index tip, const std::vector<double>&) { tips.push_back(tip); });
  return tips;
}

std::vector<Index> tips_of(const Indexed_surface& surface, std::size_t count)
{
  return tips_of(surface, *distances_on(surface), count, all_plausible);
}

// Each tip reaches the maximum of its equation, in the distances of all pairs.
void check_equations(const Indexed_surface& surface, std::size_t count)
{
  const auto d = all_pairs_distances(surface);
  const std::vector<Index> tips = tips_of(surface, count);
  CGAL_CHECK_EQUAL(tips.size(), count);

  std::vector<double> value; // of every face, in the equation that selects the next tip
  for (const std::vector<double>& row : d)
    value.push_back(internal::distance_sum(row));
  bool first = true;
  for (const Index tip : tips)
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
    for (const Index tip : tips_of(surface, arms))
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
  CGAL_CHECK_EQUAL(tips_of(to_surface(single_triangle()), 5).size(), 1);
  CGAL_CHECK_EQUAL(tips_of(to_surface(tetrahedron()), 9).size(), 4);
  CGAL_CHECK_EQUAL(tips_of(to_surface(scaled(tetrahedron(), 0)), 4).size(), 1);
  CGAL_CHECK_EQUAL(tips_of(to_surface(tetrahedron()), 0).size(), 0);
}

void implausible_tips_are_eliminated_and_do_not_count()
{
  const Indexed_surface surface = to_surface(bumpy_sphere(3, 4));
  const std::vector<Index> all = tips_of(surface, 7);
  const auto is_plausible = [&](Index face)
  { return (std::find(all.begin(), all.end(), face) - all.begin()) % 2 == 0; };
  const auto distances = distances_on(surface);
  // four are plausible, and three are not; an eliminated face still keeps the next ones away
  CGAL_CHECK(tips_of(surface, *distances, 4, is_plausible) == all);
  // the fourth one that is eliminated is the last
  CGAL_CHECK_EQUAL(tips_of(surface, *distances, 4, [](Index) { return false; }).size(), 4);
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
  internal::select_protrusion_tips(surface, *distances, 5, all_plausible, visit);
  CGAL_CHECK(visited == tips_of(surface, 5));
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
  CGAL_CHECK(tips_of(surface, *plain, 3, all_plausible) == tips_of(surface, 3));
  CGAL_CHECK_EQUAL(plain->number_of_runs(), surface.number_of_faces() + 3);
}

int main()
{
  tips_maximize_both_equations();
  tips_of_a_star_are_at_the_ends_of_its_arms();
  selection_ends_where_no_face_is_left();
  implausible_tips_are_eliminated_and_do_not_count();
  each_tip_is_visited_with_its_distances();
  distances_without_a_search_take_all_pairs();
  return check::result();
}
