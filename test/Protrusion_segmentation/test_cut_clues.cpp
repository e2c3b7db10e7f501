// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The clues of cuts through boxes, cylinders, dumbbells and tori, where they are known.

#include "check.h"
#include "cut_mesh.h"
#include "test_meshes.h"

#include <cmath>
#include <cstddef>
#include <vector>

using namespace test_meshes;
using namespace CGAL::Protrusion_segmentation;
using internal::Cut_clues;

// Lengths are stored in single precision.
constexpr double precision = 1e-5;
// Diffused normals are solved for to four digits.
constexpr double precision_of_costs = 1e-3;

auto below(std::size_t axis, double value)
{
  return [axis, value](const Point& p) { return p[axis] < value; };
}

double roundness(double opening, double length)
{
  return std::log(4 * pi * opening / (length * length) + 0.05);
}

double thickness(double volume, double area, double opening)
{
  return std::log(4 * volume / (area * std::sqrt(opening + 0.02 * area)));
}

// A bar of unit cubes, cut across in the middle.
void a_straight_bar(int length, int width, int height)
{
  const double half_area = length * (width + height) + width * height;
  const double girth = 2 * (width + height), opening = width * height;
  const Cut_clues clues = Cut_mesh(box(length, width, height)).clues(below(0, length / 2));
  CGAL_CHECK_EQUAL(clues.concave_share, 0);
  CGAL_CHECK_CLOSE(clues.relative_length, std::log(girth / std::sqrt(half_area)), precision);
  CGAL_CHECK_CLOSE(clues.segment_size, 0, precision);
  CGAL_CHECK_CLOSE(clues.roundness, roundness(opening, girth), precision);
  CGAL_CHECK_EQUAL(clues.neighbors, 0);
  CGAL_CHECK_CLOSE(clues.thickness, thickness(opening * length / 2, half_area, opening), precision);
  CGAL_CHECK_EQUAL(clues.several_loops, 0);
  CGAL_CHECK_CLOSE(clues.flatness, opening / half_area, precision); // the end of the bar alone has no opposite
  // nothing changes along the bar: the strip is measured from the centres of the first squares on
  const double strip = 0.4 * std::sqrt(half_area);
  CGAL_CHECK_CLOSE(clues.widening, std::log((strip + 0.5) / strip), precision);
  CGAL_CHECK_CLOSE(clues.larger_shoulder, 0, precision);
  CGAL_CHECK_CLOSE(clues.smaller_shoulder, 0, precision);
  CGAL_CHECK_CLOSE(clues.mean_cost, std::log(1 + 0.02), precision_of_costs);
}

// Not cut in the middle: the smaller side counts, whichever is the inner one.
void sides_may_be_exchanged()
{
  const Cut_mesh bar(box(12, 2, 2));
  const Cut_clues clues = bar.clues(below(0, 4));
  CGAL_CHECK_CLOSE(clues.relative_length, std::log(8 / std::sqrt(4 * 8 + 4)), precision);
  CGAL_CHECK_CLOSE(clues.thickness, thickness(4 * 4, 4 * 8 + 4, 4), precision);
  const Cut_clues exchanged = bar.clues([](const Point& p) { return p[0] > 4; });
  CGAL_CHECK_CLOSE(clues.relative_length, exchanged.relative_length, precision);
  CGAL_CHECK_CLOSE(clues.thickness, exchanged.thickness, precision);
  CGAL_CHECK_CLOSE(clues.roundness, exchanged.roundness, precision);
  CGAL_CHECK_CLOSE(clues.widening, exchanged.widening, precision);
  CGAL_CHECK_CLOSE(clues.larger_shoulder, exchanged.larger_shoulder, precision);
  CGAL_CHECK_CLOSE(clues.smaller_shoulder, exchanged.smaller_shoulder, precision);
}

void round_openings_are_rounder_than_flat_ones()
{
  constexpr double slices = 31;
  const double girth = 2 * slices * std::sin(pi / slices);
  const double disk = slices / 2 * std::sin(2 * pi / slices), height = 8;
  const Cut_clues clues = Cut_mesh(closed_cylinder(1, height, 0.2)).clues(below(2, height / 2));
  const double half_area = girth * height / 2 + disk;
  CGAL_CHECK_CLOSE(clues.roundness, roundness(disk, girth), precision);
  CGAL_CHECK_CLOSE(clues.roundness, std::log(1.05), 0.01);
  CGAL_CHECK_CLOSE(clues.relative_length, std::log(girth / std::sqrt(half_area)), precision);
  CGAL_CHECK_CLOSE(clues.thickness, thickness(disk * height / 2, half_area, disk), precision);
  CGAL_CHECK_CLOSE(Cut_mesh(box(16, 8, 1)).clues(below(0, 8)).roundness,
              std::log(4 * pi * 8 / (18. * 18) + 0.05), precision);
}

// Both cuts, and both openings, count together.
void a_ring_is_cut_in_two_places()
{
  const Test_mesh ring = torus(2, 0.5, 48, 16);
  const double girth = 16 * std::sin(pi / 16), disk = 2 * std::sin(2 * pi / 16);
  const Cut_clues clues = Cut_mesh(ring).clues(below(1, 0));
  CGAL_CHECK_EQUAL(clues.several_loops, 1);
  CGAL_CHECK_CLOSE(clues.relative_length, std::log(2 * girth / std::sqrt(area(ring) / 2)), precision);
  CGAL_CHECK_CLOSE(clues.roundness, roundness(2 * disk, 2 * girth), precision);
  CGAL_CHECK_CLOSE(clues.thickness, thickness(volume(ring) / 2, area(ring) / 2, 2 * disk), precision);
  CGAL_CHECK_EQUAL(clues.neighbors, 0);
}

// Without a quarter of it, the ring is a tube, whose end is an earlier border as long as the cut.
void a_cut_ring_is_a_tube()
{
  const Test_mesh ring = torus(2, 0.5, 48, 16);
  Cut_mesh tube(ring);
  tube.cut_off([](const Point& p) { return p[0] > 0 && p[1] > 0; });
  const Cut_clues clues = tube.clues([](const Point& p) { return p[0] < 0 && p[1] > 0; });
  CGAL_CHECK_EQUAL(clues.several_loops, 0);
  CGAL_CHECK_CLOSE(clues.neighbors, std::log(2.), precision);
  CGAL_CHECK_CLOSE(clues.segment_size, std::log(0.75), precision);
  CGAL_CHECK_CLOSE(clues.relative_length, std::log(16 * std::sin(pi / 16) / std::sqrt(area(ring) / 4)),
              precision);
  // its middle is not cut out, as the rest is not connected: it stays with one of the ends
  const Cut_clues end = tube.clues([](const Point& p) { return p[0] < 0 && p[1] < 0; });
  CGAL_CHECK_EQUAL(end.several_loops, 0);
  CGAL_CHECK_CLOSE(end.neighbors, std::log(2.), precision);
}

// Triangles along a cut do not all share edges with each other.
void triangles_along_one_loop_are_one_loop()
{
  const Test_mesh cylinder = triangulated(closed_cylinder(1, 8, 0.2)), ring = triangulated(torus(2, 0.5, 48, 16));
  CGAL_CHECK_EQUAL(Cut_mesh(cylinder).clues(below(2, 4)).several_loops, 0);
  CGAL_CHECK_EQUAL(Cut_mesh(triangulated(sheet(20, 8))).clues(below(0, 10)).several_loops, 0);
  CGAL_CHECK_EQUAL(Cut_mesh(ring).clues(below(1, 0)).several_loops, 1);
}

// Where a ball begins there is a seam, behind which the surface widens; on the bar there is neither.
void a_dumbbell()
{
  constexpr double bar = 0.3, spacing = 0.1;
  const Test_mesh mesh = dumbbell(1, 1, bar, 3, spacing);
  const double ball = area_of_part(mesh, 1), girth = 63 * 2 * bar * std::sin(pi / 63);
  const Cut_mesh cut_mesh(mesh);
  const Cut_clues neck = cut_mesh.clues(below(2, 0)), middle = cut_mesh.clues(below(2, 1.5));
  CGAL_CHECK_CLOSE(neck.concave_share, 1, precision);
  CGAL_CHECK_EQUAL(middle.concave_share, 0);
  CGAL_CHECK_CLOSE(neck.relative_length, std::log(girth / std::sqrt(ball)), precision);
  CGAL_CHECK(neck.mean_cost < middle.mean_cost - 1);
  // strips on a sphere and on the bar, up to a ring
  const double strip = 0.4 * std::sqrt(ball), from = std::asin(bar);
  const double zone = 2 * pi * (std::cos(from) - std::cos(from + strip));
  CGAL_CHECK_CLOSE(neck.widening, std::log(zone / (2 * pi * bar * strip)), spacing / strip);
  // of the zone on the sphere, what it shows along the axis: a ring between the two circles
  const double growth = pi * (std::pow(std::sin(from + strip), 2) - std::pow(bar, 2));
  CGAL_CHECK_CLOSE(neck.larger_shoulder, growth / zone, spacing / strip);
  CGAL_CHECK_CLOSE(neck.smaller_shoulder, 0, precision);
}

// A rod of `width` * `width` * `length` cubes on a plate that is wider than a strip around it.
Test_mesh rod_on_plate(int width, int length)
{
  const int margin = 3 * width;
  Cubes cubes;
  add_cubes(cubes, {-margin, -margin, -1}, {width + margin, width + margin, 0});
  add_cubes(cubes, {0, 0, 0}, {width, width, length});
  return voxels(cubes);
}

// The plate is seen from the tip as it is, the walls of the rod not at all.
void a_rod_on_a_plate()
{
  const Cut_mesh rod(rod_on_plate(3, 12));
  const auto above = [](double z)
  { return [z](const Point& p) { return p[2] > z + 0.1; }; }; // not the plate itself
  const Cut_clues foot = rod.clues(above(0)), middle = rod.clues(above(6));
  CGAL_CHECK_CLOSE(foot.larger_shoulder, 1, precision);
  CGAL_CHECK_CLOSE(foot.smaller_shoulder, 0, precision);
  CGAL_CHECK_CLOSE(middle.smaller_shoulder, 0, precision);
  // A ring of twelve squares is left of the walls, and of the end eight squares and a share of the one in the middle, which
  // is a step over the edge and another one away.
  const double strip = 0.4 * std::sqrt(12. + 9), centre = strip - (std::sqrt(0.5) + 1) + 0.5;
  CGAL_CHECK_CLOSE(rod.clues(above(11)).smaller_shoulder, -(8 + centre) / (12 + 8 + centre), precision);
}

// What sticks out of a trunk across its axis makes it wider, but is no shoulder of a cut through the trunk.
void a_bump_is_no_shoulder()
{
  Cubes cubes;
  add_cubes(cubes, {0, 0, 0}, {24, 3, 3});
  cubes.insert({11, 1, 3});
  const Cut_clues with_bump = Cut_mesh(voxels(cubes)).clues(below(0, 10)),
                  clues = Cut_mesh(box(24, 3, 3)).clues(below(0, 10));
  CGAL_CHECK(with_bump.widening > clues.widening + 0.05);
  CGAL_CHECK_CLOSE(with_bump.larger_shoulder, 0, precision);
  CGAL_CHECK_CLOSE(with_bump.smaller_shoulder, 0, precision);
}

// A trough is cut from border to border: its opening is that of the cut, wherever the trough lies.
void a_trough_may_lie_anywhere()
{
  constexpr std::size_t rows = 12;
  const Test_mesh trough = transformed(
    sheet(30, rows),
    [](const Point& p) {
      return Point{p[0], 4 * std::cos(pi * p[1] / rows), 4 * std::sin(pi * p[1] / rows)};
    });
  const Cut_clues clues = Cut_mesh(trough).clues(below(0, 12));
  constexpr double chords = 0.01; // are shorter than their arc
  CGAL_CHECK_CLOSE(clues.larger_shoulder, 0, chords);
  CGAL_CHECK_CLOSE(clues.smaller_shoulder, 0, chords);
  CGAL_CHECK_CLOSE(clues.roundness, roundness(1, 2 * std::sqrt(pi)), precision); // of half a circle, as of a circle
  const Cut_clues moved = Cut_mesh(translated(trough, {5, -30, 2})).clues(below(0, 17));
  CGAL_CHECK_CLOSE(moved.roundness, clues.roundness, precision);
  CGAL_CHECK_CLOSE(moved.thickness, clues.thickness, precision);
  CGAL_CHECK_CLOSE(moved.larger_shoulder, 0, chords);
}

// A block on a large plate, cut off along the plate: its walls face all ways, its top one.
void a_low_block_is_flat()
{
  for (const int height : {1, 3, 12})
  {
    Cubes cubes;
    add_cubes(cubes, {-12, -12, -1}, {18, 18, 0});
    add_cubes(cubes, {0, 0, 0}, {6, 6, height});
    const Cut_mesh block(voxels(cubes));
    const Cut_clues clues = block.clues([](const Point& p) { return p[2] > 0.1; });
    CGAL_CHECK_CLOSE(clues.flatness, 36. / (36 + 24 * height), precision);
  }
}

// What goes in has a volume below 0, whichever way the faces look; what goes out, and what goes through, has none.
void pockets_go_in()
{
  Cubes cubes, hole;
  add_cubes(cubes, {-12, -12, -12}, {18, 18, 0});
  add_cubes(hole, {0, 0, -6}, {6, 6, 0});
  for (const auto& cube : hole)
    cubes.erase(cube);
  const auto is_in_hole = [](const Point& p)
  { return p[0] > -0.1 && p[0] < 6.1 && p[1] > -0.1 && p[1] < 6.1 && p[2] > -6.1 && p[2] < -0.1; };
  const Cut_clues clues = Cut_mesh(voxels(cubes)).clues(is_in_hole);
  const double opening = 36, area = 36 + 24 * 6, volume = 36 * 6;
  CGAL_CHECK_CLOSE(clues.pocket, 4 * volume / (area * std::sqrt(opening + 0.02 * area)), precision);
  CGAL_CHECK_CLOSE(clues.thickness, std::log(clues.pocket), precision);
  CGAL_CHECK_CLOSE(Cut_mesh(with_reversed_orientation(voxels(cubes))).clues(is_in_hole).pocket, clues.pocket, precision);
  CGAL_CHECK_EQUAL(Cut_mesh(star(4)).clues_of_part(1).pocket, 0);
}

// A sheet as narrow as its cut, and one that sticks out of a wide one.
void a_flat_sheet()
{
  const Test_mesh wide = sheet(40, 41);
  Test_mesh with_arm = wide;
  with_arm.faces.clear();
  with_arm.parts.clear();
  for (const Face& face : wide.faces)
    if (centroid(wide, face)[0] > 12 || std::abs(centroid(wide, face)[1] - 20.5) < 2)
      with_arm.add_face(face);
  const Cut_clues foot = Cut_mesh(with_arm).clues(below(0, 12)),
                  middle = Cut_mesh(sheet(40, 4)).clues(below(0, 20));
  CGAL_CHECK(foot.larger_shoulder > 0.5 && foot.larger_shoulder <= 1);
  CGAL_CHECK_EQUAL(middle.flatness, 0);
  CGAL_CHECK(std::abs(middle.larger_shoulder) < 0.1 && std::abs(middle.smaller_shoulder) < 0.1);
}

std::vector<double> values(const Cut_clues& c)
{
  return {c.concave_share, c.relative_length, c.segment_size,    c.widening,         c.roundness, c.neighbors, c.mean_cost,
          c.thickness,     c.several_loops,   c.larger_shoulder, c.smaller_shoulder, c.flatness,  c.pocket};
}

std::vector<double> values_of_first_arm(const Test_mesh& mesh)
{
  return values(Cut_mesh(mesh).clues_of_part(1));
}

void scale_position_and_orientation_do_not_matter()
{
  const Test_mesh mesh = star(4);
  const std::vector<double> expected = values_of_first_arm(mesh);
  for (const double factor : {std::ldexp(1., -10), 64.})
    CGAL_CHECK(values_of_first_arm(scaled(mesh, factor)) == expected);
  for (const Test_mesh& moved : {scaled(mesh, 1000), scaled(mesh, 1e-3), rotated(mesh, {1, 2, 3}, 1),
                                 with_reversed_orientation(mesh), translated(mesh, {1, -2, 3})})
  {
    const std::vector<double> found = values_of_first_arm(moved);
    for (std::size_t i = 0; i < expected.size(); ++i)
      CGAL_CHECK_CLOSE(found[i], expected[i], precision_of_costs);
  }
}

int main()
{
  a_straight_bar(10, 2, 2);
  a_straight_bar(40, 3, 3);
  a_straight_bar(30, 8, 1);
  sides_may_be_exchanged();
  round_openings_are_rounder_than_flat_ones();
  a_ring_is_cut_in_two_places();
  a_cut_ring_is_a_tube();
  triangles_along_one_loop_are_one_loop();
  a_dumbbell();
  a_rod_on_a_plate();
  a_bump_is_no_shoulder();
  a_trough_may_lie_anywhere();
  a_low_block_is_flat();
  pockets_go_in();
  a_flat_sheet();
  scale_position_and_orientation_do_not_matter();
  return check::result();
}
