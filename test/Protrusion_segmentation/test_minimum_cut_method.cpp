// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The default method as a whole: borders by minimum cuts, and the hierarchy.

#include "check.h"
#include "segmentations.h"
#include "test_meshes.h"

#include <CGAL/Protrusion_segmentation/Segmentation_record.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <set>

using namespace test_meshes;
using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
namespace PS = CGAL::Protrusion_segmentation;

Segmentation default_segmentation(const Test_mesh& soup, std::size_t k)
{
  const Mesh mesh = to_graph<Mesh>(soup);
  return checked(mesh, [&](auto ids) { return CGAL::segmentation_via_protrusion_tips(mesh, ids, k); });
}

void check_parts(const Test_mesh& mesh, double least_share)
{
  check_parts(mesh, default_segmentation(mesh, number_of_parts(mesh)), least_share);
}

void true_parts_are_found()
{
  for (const std::size_t arms : {3, 5, 8})
    check_parts(star(arms), 0.9);
  check_parts(capsule_with_ball(), 0.9);
  check_parts(dumbbell(), 0.9);
  check_parts(body_with_hands(), 0.85);
}

// Of more than 80,000 faces: pairs, groups of faces and borders on them come before the faces.
void true_parts_of_a_large_surface_are_found()
{
  const Test_mesh mesh = star(4, 2, 0.25, 0.04, 0.045);
  CGAL_CHECK(mesh.faces.size() > 80000);
  check_parts(mesh, 0.9);
  CGAL_CHECK_EQUAL(automatic_segmentation(mesh).number, 5);
}

void evident_protrusions_are_counted_without_a_number()
{
  for (const std::size_t arms : {3, 8})
    CGAL_CHECK_EQUAL(automatic_segmentation(star(arms)).number, arms + 1);
  // Cells half as wide as an arm: of such as wide as an arm, five arms leave a scrap of the ball that counts.
  constexpr double length = 2, radius = 0.25, length_step = 0.04, cell = 0.16;
  for (std::size_t arms = 1; arms <= 12; ++arms)
    CGAL_CHECK_EQUAL(automatic_segmentation(star(arms, length, radius, length_step, cell)).number, arms + 1);
  CGAL_CHECK_EQUAL(automatic_segmentation(icosphere(3)).number, 1);
}

// None of them keeps the core.
void equal_arms_are_counted_without_a_number()
{
  for (const std::size_t arms : {3, 4, 5, 6, 8})
    CGAL_CHECK_EQUAL(automatic_segmentation(star_of_equal_arms(arms, 2)).number, arms + 1);
  for (const std::size_t arms : {3, 4, 8})
    CGAL_CHECK_EQUAL(automatic_segmentation(star_of_equal_arms(arms, 1.2)).number, arms + 1);
}

// However long they are: nothing but a short cut speaks for a border.
void smooth_tubes_are_whole()
{
  CGAL_CHECK_EQUAL(automatic_segmentation(capsule(0.2, 20, 0.15)).number, 1);
  CGAL_CHECK_EQUAL(automatic_segmentation(torus(4, 0.2, 200, 12)).number, 1);
}

// A rod of radius `radius` along `curve(s)`, which is as long as it.
template <typename Curve>
Test_mesh rod_along(Curve curve, double length, double radius)
{
  constexpr double step = 1e-4;
  const auto unit = [](const Point& p) { return (1 / std::sqrt(dot(p, p))) * p; };
  return transformed(capsule(radius, length - 2 * radius, radius / 3),
                     [&](const Point& p)
                     {
                       const Point centre = curve(p[2]),
                                   tangent = unit(curve(p[2] + step) - curve(p[2] - step));
                       const Point across = unit(cross(tangent, {0.1, 0.2, 1})), up = cross(across, tangent);
                       return centre + p[0] * across + p[1] * up;
                     });
}

// Rough ones, too.
void bent_tubes_are_whole()
{
  const auto arch = [](double s) { return Point{std::cos(s / 1.3), 1.5 * std::sin(s / 1.3), 0}; };
  const auto wave = [](double s) { return Point{s, 0.4 * std::sin(3.5 * s), 0}; };
  const auto spring = [](double s) { return Point{std::cos(s), std::sin(s), 0.16 * s}; };
  const auto spiral = [](double s) { return Point{(1 + 0.05 * s) * std::cos(s), (1 + 0.05 * s) * std::sin(s), 0}; };
  for (const Test_mesh& tube : {rod_along(arch, 4, 0.2), rod_along(wave, 4, 0.2), rod_along(spring, 18, 0.16),
                                rod_along(spiral, 20, 0.12), torus(1.5, 0.1, 120, 12)})
    for (std::uint_fast32_t seed = 1; seed <= 6; ++seed)
      CGAL_CHECK_EQUAL(automatic_segmentation(jittered(tube, 0.02, seed)).number, 1);
}

Test_mesh table(int length, int width, int thickness, int height_of_legs)
{
  Cubes cubes;
  add_cubes(cubes, {0, 0, height_of_legs}, {length, width, height_of_legs + thickness});
  for (const int x : {1, length - 3})
    for (const int y : {1, width - 3})
      add_cubes(cubes, {x, y, 0}, {x + 2, y + 2, height_of_legs});
  return voxels(cubes);
}

// A leg that is cut off a row or two of faces below its top leaves a ring, around which the same seam would be cut again.
void a_seam_is_cut_once()
{
  for (const int length : {24, 32, 40})
    for (const int height_of_legs : {10, 14, 17, 20, 24, 30})
      CGAL_CHECK_EQUAL(automatic_segmentation(table(length, 20, 2, height_of_legs)).number, 5);
  for (const int length : {28, 36, 40})
    for (const int height_of_legs : {10, 12, 14, 20, 24})
      for (const int thickness : {2, 3})
        CGAL_CHECK_EQUAL(automatic_segmentation(table(length, 26, thickness, height_of_legs)).number, 5);
}

// A square plate with four pegs, without its underside.
Test_mesh open_plate(int width_of_pegs, int edge, int height)
{
  constexpr int size = 30, thickness = 2;
  Cubes cubes;
  add_cubes(cubes, {0, 0, 0}, {size, size, thickness});
  for (const int x : {edge, size - edge - width_of_pegs})
    for (const int y : {edge, size - edge - width_of_pegs})
      add_cubes(cubes, {x, y, thickness}, {x + width_of_pegs, y + width_of_pegs, height});
  Test_mesh mesh = voxels(cubes);
  mesh.faces.erase(std::remove_if(mesh.faces.begin(), mesh.faces.end(), [&](const Face& face) { return centroid(mesh, face)[2] == 0; }),
                   mesh.faces.end());
  return mesh;
}

// The plate between a peg and the edge is narrow, but goes on below the peg: 26 of 30 plates have no segment in a corner.
void pegs_leave_no_holes_in_an_open_plate()
{
  int right = 0;
  for (const int width_of_pegs : {4, 5, 6})
    for (const int edge : {2, 3, 4, 5, 6})
      for (const int height : {15, 25})
        right += automatic_segmentation(open_plate(width_of_pegs, edge, height)).number == 5;
  CGAL_CHECK(right >= 26);
}

// A trunk, part 0, with four legs, which are parts, and with spines, which are not.
Test_mesh trunk_with_spines(std::size_t pairs_of_spines)
{
  std::vector<Stick> sticks = {{{-2, 0, 0}, {2, 0, 0}, 0.6, 0.6, 0}};
  std::size_t part = 1;
  for (double x : {-1.5, 1.5})
    for (double y : {-0.4, 0.4})
    {
      sticks.push_back({{x, y, -0.3}, {x, 1.3 * y, -1.6 - 0.02 * double(part)}, 0.35, 0.28, part});
      ++part;
    }
  for (std::size_t i = 0; i < pairs_of_spines; ++i)
    for (double y : {-0.35, 0.35})
    {
      const double x = -2 + 4 * double(i) / double(pairs_of_spines - 1);
      sticks.push_back({{x, y, 0.4}, {x, 2 * y, 1 + 0.02 * double(i) + (y > 0 ? 0.01 : 0)}, 0.1, 0.1, 0});
    }
  return implicit_mesh(Implicit_body(sticks, 0.04), 0.12);
}

// The search sees spines first, of which each is a sure part. Of few segments, legs are worth more.
void spines_do_not_keep_legs_from_being_found()
{
  const Test_mesh soup = trunk_with_spines(9);
  check_parts(soup, 0.95);
  const Mesh mesh = to_graph<Mesh>(soup);
  const Segmentation of_hierarchy = checked(mesh,
                                            [&](auto ids)
                                            {
                                              CGAL::protrusion_hierarchy(mesh, 23).segment_ids(mesh, 5, ids);
                                              return std::size_t(5);
                                            });
  check_parts(soup, of_hierarchy, 0.95);
}

// Also where its cuts are the most valuable ones of the automatic segmentation.
void tips_of_a_result_give_it_again()
{
  const Mesh mesh = to_graph<Mesh>(trunk_with_spines(8));
  for (const std::size_t k : {5, 7})
  {
    PS::Segmentation_record<Mesh> record;
    const Segmentation found = checked(
      mesh, [&](auto ids)
      { return CGAL::segmentation_via_protrusion_tips(mesh, ids, k, CGAL::parameters::visitor(std::ref(record))); });
    std::vector<Mesh::Face_index> tips;
    for (const auto& protrusion : record.protrusions())
      tips.push_back(protrusion.tip);
    CGAL_CHECK_EQUAL(tips.size() + 1, k);
    const Segmentation again =
      checked(mesh, [&](auto ids) { return CGAL::segmentation_from_protrusion_tips(mesh, tips, ids); });
    CGAL_CHECK(as_partition(again.labels) == as_partition(found.labels));
  }
}

// A face keeps its segment, or gets the nearest ancestor of it that is left: the segments nest.
void check_coarser(const PS::Segment_hierarchy& hierarchy,
                   std::size_t k,
                   const Labels& finest,
                   const Labels& found)
{
  for (std::size_t f = 0; f < found.size(); ++f)
  {
    std::size_t expected = finest[f];
    while (expected >= k)
      expected = hierarchy.parent(expected);
    CGAL_CHECK_EQUAL(found[f], expected);
  }
}

// Cuts are chosen together: the one call's segmentation for the largest number is that of a direct call, those for
// smaller numbers nest in it.
void the_hierarchy_holds_nested_segmentations()
{
  const Mesh mesh = to_graph<Mesh>(merged({creature(), star(3)}));
  const PS::Segment_hierarchy hierarchy = CGAL::protrusion_hierarchy(mesh, 12);
  CGAL_CHECK_EQUAL(hierarchy.minimum_number_of_segments(), 2);
  CGAL_CHECK_EQUAL(hierarchy.maximum_number_of_segments(), 12);
  const Labels direct =
    checked(mesh, [&](auto map) { return CGAL::segmentation_via_protrusion_tips(mesh, map, 12); }).labels;
  for (std::size_t k = 2; k <= 12; ++k)
  {
    const Segmentation found = checked(mesh,
                                       [&](auto map)
                                       {
                                         hierarchy.segment_ids(mesh, k, map);
                                         return k;
                                       });
    check_coarser(hierarchy, k, direct, found.labels);
  }
  Segment_ids<Mesh> ids(mesh);
  CGAL_CHECK_THROWS_WITH(hierarchy.segment_ids(mesh, 1, ids.map()), std::invalid_argument,
                    "number_of_segments");
  CGAL_CHECK_THROWS_WITH(hierarchy.segment_ids(mesh, 13, ids.map()), std::invalid_argument,
                    "number_of_segments");
  CGAL_CHECK_THROWS_WITH(hierarchy.segment_ids(to_graph<Mesh>(tetrahedron()), 2, ids.map()),
                    std::invalid_argument, "pmesh");
}

// The last component has no fewer protrusions than an equal one before it.
void components_share_the_segments_of_a_hierarchy()
{
  const Test_mesh one = star(3);
  const Mesh mesh = to_graph<Mesh>(merged({one, one}));
  const PS::Segment_hierarchy hierarchy = CGAL::protrusion_hierarchy(mesh, 8);
  for (std::size_t k = 2; k <= 8; k += 2)
  {
    const Labels found = checked(mesh,
                                 [&](auto map)
                                 {
                                   hierarchy.segment_ids(mesh, k, map);
                                   return k;
                                 }).labels;
    const auto middle = found.begin() + static_cast<std::ptrdiff_t>(one.faces.size());
    CGAL_CHECK_EQUAL(std::set<std::size_t>(found.begin(), middle).size(), k / 2);
    CGAL_CHECK_EQUAL(std::set<std::size_t>(middle, found.end()).size(), k / 2);
  }
}

void tips_of_a_user_are_cut_off()
{
  const Test_mesh soup = star(5);
  const Mesh mesh = to_graph<Mesh>(soup);
  std::vector<Mesh::Face_index> tips;
  CGAL::protrusion_tips(mesh, 5, std::back_inserter(tips), PS::Geodesic_distance());
  tips.resize(3);
  const Segmentation found = checked(
    mesh, [&](auto ids)
    { return CGAL::segmentation_from_protrusion_tips(mesh, tips, ids, PS::Minimum_cut_method()); });
  CGAL_CHECK_EQUAL(found.number, 4);
  std::set<std::size_t> segments;
  for (const auto tip : tips)
    segments.insert(found.labels[tip]);
  CGAL_CHECK(segments == std::set<std::size_t>({1, 2, 3}));
}

// Any distance gives fields to search along.
void other_distances_serve_the_search()
{
  const Test_mesh soup = star(4);
  const Mesh mesh = to_graph<Mesh>(soup);
  const Segmentation found = checked(mesh,
                                     [&](auto ids)
                                     {
                                       return CGAL::segmentation_via_protrusion_tips(
                                         mesh, ids, 5,
                                         PS::Minimum_cut_method(PS::Landmark_geodesic_distance(0.05)));
                                     });
  CGAL_CHECK_EQUAL(found.number, 5);
  CGAL_CHECK(share_in_true_parts(soup, found.labels) > 0.85);
}

void scale_position_and_orientation_do_not_matter()
{
  const Test_mesh mesh = star(4);
  const Labels expected = default_segmentation(mesh, 5).labels;
  for (const double factor : {std::ldexp(1., -900), 4., std::ldexp(1., 900)})
    CGAL_CHECK(default_segmentation(scaled(mesh, factor), 5).labels == expected);
  for (const Test_mesh& moved :
       {rotated(mesh, {1, 2, 3}, 1), translated(mesh, {10, -20, 5}), with_reversed_orientation(mesh)})
    CGAL_CHECK(as_partition(default_segmentation(moved, 5).labels) == as_partition(expected));
}

// Whatever the mesh, the result is valid; it may have fewer segments than asked for.
void odd_meshes_are_segmented()
{
  const std::vector<Test_mesh> meshes = {
    single_triangle(),     tetrahedron(),
    box(1, 1, 1),          sheet(10, 20),
    thin_strip(20, 0.001), torus(),
    open_cylinder(),       scaled(tetrahedron(), 0),
    scaled(star(3), 0),    dodecahedron(),
    dual(icosphere(3)),    merged({icosphere(2), tetrahedron(), sheet(3, 3)}),
    bumpy_sphere(3, 5)};
  for (const Test_mesh& mesh : meshes)
    for (const std::size_t k : {std::size_t(1), std::size_t(2), std::size_t(5), mesh.faces.size()})
      if (k <= mesh.faces.size())
      {
        const Segmentation found = default_segmentation(mesh, k);
        CGAL_CHECK(found.number >= 1);
        CGAL_CHECK(found.number <= (std::max)(k, number_of_components(mesh)));
      }
  for (unsigned int seed = 0; seed < 40; ++seed)
    CGAL_CHECK(default_segmentation(random_surface(seed), 4).number >= 1);
}

int main()
{
  true_parts_are_found();
  true_parts_of_a_large_surface_are_found();
  evident_protrusions_are_counted_without_a_number();
  equal_arms_are_counted_without_a_number();
  smooth_tubes_are_whole();
  bent_tubes_are_whole();
  a_seam_is_cut_once();
  pegs_leave_no_holes_in_an_open_plate();
  spines_do_not_keep_legs_from_being_found();
  tips_of_a_result_give_it_again();
  the_hierarchy_holds_nested_segmentations();
  components_share_the_segments_of_a_hierarchy();
  tips_of_a_user_are_cut_off();
  other_distances_serve_the_search();
  scale_position_and_orientation_do_not_matter();
  odd_meshes_are_segmented();
  return check::result();
}
