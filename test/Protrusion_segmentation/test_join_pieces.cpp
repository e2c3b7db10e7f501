// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Loose pieces become one shape.

#include "check.h"
#include "test_meshes.h"

#include <CGAL/Protrusion_segmentation/join_pieces.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/protrusion_segmentation.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <optional>
#include <set>
#include <stdexcept>
#include <utility>
#include <vector>

using namespace test_meshes;
using Point_3 = CGAL::Simple_cartesian<double>::Point_3;
using Mesh = CGAL::Surface_mesh<Point_3>;
using Labels = std::vector<std::size_t>;
namespace PS = CGAL::Protrusion_segmentation;

PS::Joined_pieces<Mesh> joined(const Test_mesh& soup,
                               Mesh& mesh,
                               std::optional<double> gap = std::nullopt)
{
  std::vector<Point_3> points;
  for (const Point& p : soup.points)
    points.emplace_back(p[0], p[1], p[2]);
  return PS::join_pieces(points, soup.faces, mesh, gap);
}

std::size_t number_of_shapes(const Test_mesh& soup, std::optional<double> gap = std::nullopt)
{
  Mesh mesh;
  joined(soup, mesh, gap);
  CGAL_CHECK(mesh.is_valid(false));
  CGAL_CHECK(CGAL::is_closed(mesh));
  std::vector<std::size_t> labels(mesh.number_of_faces());
  return CGAL::segmentation_via_protrusion_tips(
    mesh, boost::make_iterator_property_map(labels.begin(), get(boost::face_index, mesh)), 1);
}

Labels segment(const Test_mesh& soup,
               std::optional<std::size_t> k = std::nullopt,
               std::optional<double> gap = std::nullopt)
{
  Mesh mesh;
  const auto pieces = joined(soup, mesh, gap);
  std::vector<std::size_t> ids(mesh.number_of_faces()), patches(mesh.number_of_faces());
  const auto map = boost::make_iterator_property_map(ids.begin(), get(boost::face_index, mesh));
  const auto patch_map = boost::make_iterator_property_map(patches.begin(), get(boost::face_index, mesh));
  pieces.pieces_of_faces(patch_map);
  const auto np = CGAL::parameters::face_patch_map(patch_map);
  const std::size_t number = k ? CGAL::segmentation_via_protrusion_tips(mesh, map, *k, np)
                               : CGAL::segmentation_via_protrusion_tips(mesh, map, np);
  Labels labels;
  pieces.labels_of_polygons(map, std::back_inserter(labels));
  CGAL_CHECK_EQUAL(labels.size(), soup.faces.size());
  CGAL_CHECK_EQUAL(std::set<std::size_t>(labels.begin(), labels.end()).size(), number);
  return labels;
}

Test_mesh two_boxes(double distance)
{
  return merged({box(), translated(box(), {1 + distance, 0, 0})});
}

void pieces_that_are_near_are_one()
{
  for (const double distance : {-.5, 0., .03})
    CGAL_CHECK_EQUAL(number_of_shapes(two_boxes(distance), .1), 1);
  CGAL_CHECK_EQUAL(number_of_shapes(two_boxes(.2), .1), 2);
  CGAL_CHECK_EQUAL(number_of_shapes(two_boxes(.2), .4), 1);
  CGAL_CHECK_EQUAL(number_of_shapes(two_boxes(.01)), 1); // a fortieth of the size is more
  CGAL_CHECK_EQUAL(number_of_shapes(two_boxes(1)), 2);
}

// With few faces, so that gaps are narrower than what the surfaces resolve. What is not nearer than the gap stays apart.
PS::internal::Wrapped_pieces coarsely_joined(const Test_mesh& mesh, double gap)
{
  PS::internal::Polygon_soup soup;
  for (const Point& p : mesh.points)
    soup.points.emplace_back(p[0], p[1], p[2]);
  for (const Face& face : mesh.faces)
    soup.polygons.add(face);
  constexpr double few_faces = 2000;
  auto result = PS::internal::wrap_pieces(std::move(soup), gap, few_faces);
  CGAL_CHECK(result.surface.faces.size() < 3 * few_faces);
  return result;
}

void pieces_of_narrow_gaps()
{
  for (const double gap : {1e-9, 1e-3, 1e-2})
  {
    const auto number_of_shapes = [&](double distance)
    { return coarsely_joined(two_boxes(distance), gap).surface.repairs.components; };
    for (const double distance : {-.5, 0., gap / 2})
      CGAL_CHECK_EQUAL(number_of_shapes(distance), 1);
    for (const double distance : {gap * 2, .2})
      CGAL_CHECK_EQUAL(number_of_shapes(distance), 2);
  }
  // two pairs of boxes, and another one in the first
  const Test_mesh pair = two_boxes(.001), hidden = translated(scaled(box(), .1), {.4, .4, .4});
  Test_mesh all = merged({pair, translated(pair, {0, 1.1, 0}), hidden});
  all.add_face({all.add_point({-9, 0, 0}), all.add_point({0, -9, 0}), all.add_point({9, -18, 0})}); // without area
  const auto shapes = coarsely_joined(all, 2e-3);
  CGAL_CHECK_EQUAL(shapes.surface.repairs.components, 2);
  const std::vector<std::size_t> components = PS::internal::clusters_of_polygons(
    shapes.surface.faces, shapes.surface.point_of_vertex);
  const auto shape = [&](std::size_t polygon) { return components[shapes.surface.face_of_polygon[polygon]]; };
  for (std::size_t i = 0; i < shapes.surface.face_of_polygon.size(); ++i)
    CGAL_CHECK_EQUAL(shape(i), shape(i >= 12 && i < 24 ? 12 : 0));
  CGAL_CHECK(shape(0) != shape(12));
}

// A long box of two pieces that meet in a plane: the surface is smooth there.
void borders_are_where_pieces_meet()
{
  const Labels labels = segment(merged({scaled(box(), 3, 1, 1), translated(scaled(box(), 2, 1, 1), {3, 0, 0})}), 2);
  const std::size_t size = box().faces.size();
  for (std::size_t i = 0; i < labels.size(); ++i)
    CGAL_CHECK_EQUAL(labels[i], labels[i < size ? 0 : size]);
  CGAL_CHECK(labels[0] != labels[size]);
}

// A ball with six arms, each a piece, and things inside.
Test_mesh creature_of_pieces()
{
  std::vector<Test_mesh> pieces = {icosphere(3)};
  for (int axis = 0; axis < 3; ++axis)
    for (const double sign : {-1., 1.})
    {
      Point center = {0, 0, 0};
      center[std::size_t(axis)] = sign * 1.6;
      const Point stretch = {axis == 0 ? 1. : .2, axis == 1 ? 1. : .2, axis == 2 ? 1. : .2};
      pieces.push_back(translated(scaled(icosphere(2), stretch[0], stretch[1], stretch[2]), center));
    }
  pieces.push_back(scaled(icosphere(1), .3));
  return merged(pieces);
}

void parts_are_counted_and_not_pieces()
{
  const Test_mesh soup = creature_of_pieces();
  const std::size_t body = icosphere(3).faces.size(), arm = icosphere(2).faces.size();
  for (const std::optional<std::size_t> k : {std::optional<std::size_t>(), std::optional<std::size_t>(7)})
  {
    const Labels labels = segment(soup, k);
    CGAL_CHECK_EQUAL(std::set<std::size_t>(labels.begin(), labels.end()).size(), 7);
    std::set<std::size_t> of_arms;
    for (std::size_t a = 0; a < 6; ++a)
    {
      const auto first = labels.begin() + std::ptrdiff_t(body + a * arm);
      std::vector<std::size_t> counts(7, 0);
      for (auto label = first; label != first + std::ptrdiff_t(arm); ++label)
        ++counts[*label];
      const auto largest = std::max_element(counts.begin() + 1, counts.end());
      CGAL_CHECK(*largest > arm / 2);
      of_arms.insert(std::size_t(largest - counts.begin()));
    }
    CGAL_CHECK_EQUAL(of_arms.size(), 6);
    CGAL_CHECK(std::all_of(labels.begin(), labels.begin() + std::ptrdiff_t(body),
                      [](std::size_t label) { return label == 0; }));
    CGAL_CHECK_EQUAL(labels.back(), 0); // hidden inside
  }
  const Labels one = segment(soup, 1);
  CGAL_CHECK_EQUAL(*std::max_element(one.begin(), one.end()), 0);
}

void orientations_do_not_matter()
{
  CGAL_CHECK_EQUAL(
    number_of_shapes(merged({box(), with_reversed_orientation(translated(box(), {.5, .2, .3}))})), 1);
  CGAL_CHECK_EQUAL(number_of_shapes(sheet(3, 3)), 1);
}

void units_do_not_matter()
{
  for (const double unit : {std::ldexp(1., -400), std::ldexp(1., 400)})
  {
    CGAL_CHECK_EQUAL(number_of_shapes(scaled(two_boxes(.03), unit), .1 * unit), 1);
    CGAL_CHECK_EQUAL(number_of_shapes(scaled(two_boxes(.2), unit), .1 * unit), 2);
  }
}

void bad_input_is_refused()
{
  Mesh mesh;
  for (const double gap : {-1., 0., 100., std::numeric_limits<double>::quiet_NaN()})
    CGAL_CHECK_THROWS_WITH(joined(box(), mesh, gap), std::invalid_argument, "gap");
  Test_mesh line;
  line.points = {{0, 0, 0}, {1, 1, 1}, {2, 2, 2}};
  line.add_face({0, 1, 2});
  CGAL_CHECK_THROWS_WITH(joined(line, mesh), std::invalid_argument, "polygons: none has an area");
  CGAL_CHECK_EQUAL(mesh.number_of_vertices(), 0);
}

int main()
{
  pieces_that_are_near_are_one();
  pieces_of_narrow_gaps();
  borders_are_where_pieces_meet();
  parts_are_counted_and_not_pieces();
  orientations_do_not_matter();
  units_do_not_matter();
  bad_input_is_refused();
  return check::result();
}
