// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The walls of cavities belong to the segments around them and are no segments of their own.

#include "check.h"
#include "test_meshes.h"

#include <CGAL/Protrusion_segmentation/Histogram_method.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/protrusion_segmentation.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <set>
#include <vector>

using namespace test_meshes;
using namespace CGAL::Protrusion_segmentation;
using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
using Labels = std::vector<std::size_t>;

template <typename Method, typename... Number>
Labels segment(const Test_mesh& soup, const Method& method, Number... k)
{
  const Mesh mesh = to_graph<Mesh>(soup);
  Labels labels(mesh.number_of_faces());
  const auto ids = boost::make_iterator_property_map(labels.begin(), get(boost::face_index, mesh));
  const std::size_t number = CGAL::segmentation_via_protrusion_tips(mesh, ids, k..., method);
  CGAL_CHECK_EQUAL(std::set<std::size_t>(labels.begin(), labels.end()).size(), number);
  CGAL_CHECK_EQUAL(*std::max_element(labels.begin(), labels.end()) + 1, number);
  return labels;
}

Labels segment(const Test_mesh& soup)
{
  return segment(soup, Minimum_cut_method());
}

std::size_t number_of_segments(const Test_mesh& soup)
{
  const Labels labels = segment(soup);
  return *std::max_element(labels.begin(), labels.end()) + 1;
}

Test_mesh ball(double radius, const Point& center = {0, 0, 0})
{
  return translated(scaled(icosphere(3), radius), center);
}

Test_mesh cavity(double radius, const Point& center = {0, 0, 0})
{
  return with_reversed_orientation(ball(radius, center));
}

// Arms along the axes, and the same inside, all around with the same thickness of the wall in proportion.
const Test_mesh& figure()
{
  static const Test_mesh mesh = star(5, 2, 0.25, 0.1, 0.2);
  return mesh;
}

Test_mesh hollow_figure()
{
  return merged({figure(), with_reversed_orientation(scaled(figure(), .85))});
}

// Squared, from the centroid of face `f` to a triangle, sampled.
double distance_to_face(const Test_mesh& mesh, std::size_t f, std::size_t other)
{
  const Point p = centroid(mesh, mesh.faces[f]);
  const Face& face = mesh.faces[other];
  constexpr int n = 8;
  double least = 1e300;
  for (int i = 0; i <= n; ++i)
    for (int j = 0; i + j <= n; ++j)
    {
      const double u = double(i) / n, v = double(j) / n;
      least = (std::min)(least, length((1 - u - v) * mesh.points[face[0]] + u * mesh.points[face[1]] +
                                       v * mesh.points[face[2]] - p));
    }
  return least;
}

template <typename Method, typename... Number>
void check_hollow_figure(const Method& method, Number... k)
{
  const std::size_t n = figure().faces.size();
  const Labels outer = segment(figure(), method, k...), all = segment(hollow_figure(), method, k...);
  CGAL_CHECK(Labels(all.begin(), all.begin() + std::ptrdiff_t(n)) == outer);
  // Each face of the inner wall has the label of a face that is about as near as any.
  const Test_mesh mesh = hollow_figure();
  for (std::size_t f = n; f < all.size(); f += 37)
  {
    double least = 1e300, least_of_label = 1e300;
    for (std::size_t g = 0; g < n; ++g)
    {
      const double distance = distance_to_face(mesh, f, g);
      least = (std::min)(least, distance);
      if (all[g] == all[f])
        least_of_label = (std::min)(least_of_label, distance);
    }
    CGAL_CHECK(least_of_label < least + .05);
  }
}

void inner_walls_have_the_labels_of_the_outer_ones()
{
  check_hollow_figure(Minimum_cut_method());
  check_hollow_figure(Minimum_cut_method(), 6);
  check_hollow_figure(Minimum_cut_method(), 3);
  check_hollow_figure(Histogram_method());
  check_hollow_figure(Histogram_method(), 6);
}

void cavities_are_not_counted()
{
  CGAL_CHECK_EQUAL(number_of_segments(merged({ball(2), cavity(1)})), 1);
  CGAL_CHECK_EQUAL(
    number_of_segments(merged({ball(4), cavity(1), cavity(.5, {2, 0, 0}), cavity(.3, {0, 2, 1})})), 1);
  const Labels labels = segment(merged({ball(2), cavity(1), ball(2, {5, 0, 0}), cavity(1, {5, 0, 0})}),
                                Minimum_cut_method(), 2);
  const std::size_t n = icosphere(3).faces.size();
  for (std::size_t f = 0; f < labels.size(); ++f)
    CGAL_CHECK_EQUAL(labels[f], labels[f / (2 * n) * (2 * n)]);
  CGAL_CHECK(labels.front() != labels.back());
}

// Solids in cavities, which may be hollow again.
void solids_in_cavities_are_segments()
{
  const Labels labels = segment(merged({cavity(1), ball(2), cavity(3), ball(4)}));
  const std::size_t n = icosphere(3).faces.size();
  for (std::size_t f = 0; f < labels.size(); ++f)
    CGAL_CHECK_EQUAL(labels[f], labels[f / (2 * n) * (2 * n)]);
  CGAL_CHECK(labels.front() != labels.back());
  CGAL_CHECK_EQUAL(number_of_segments(merged({ball(4), cavity(3), ball(1, {1, 0, 0}), ball(.5, {-1, 0, 0})})),
              3);
}

// As a whole, however it looks.
void hollow_bodies_may_be_turned_inside_out()
{
  const Test_mesh mesh = merged(
    {cavity(1), ball(2), cavity(3), ball(4), ball(2, {9, 0, 0}), cavity(1, {9, 0, 0})});
  CGAL_CHECK(segment(with_reversed_orientation(mesh)) == segment(mesh));
  CGAL_CHECK_EQUAL(number_of_segments(mesh), 3);
}

// Turned against each other, but not inside; inside, but not turned against each other; inside, but open.
void other_components_are_no_cavities()
{
  CGAL_CHECK_EQUAL(number_of_segments(merged({ball(2), cavity(1, {4, 0, 0})})), 2);
  CGAL_CHECK_EQUAL(number_of_segments(merged({ball(2), cavity(1, {2, 0, 0})})), 2);
  CGAL_CHECK_EQUAL(number_of_segments(merged({ball(2), ball(1)})), 2);
  CGAL_CHECK_EQUAL(number_of_segments(merged({ball(4), cavity(3), cavity(2)})), 2);
  Test_mesh open = cavity(1);
  open.faces.pop_back();
  CGAL_CHECK_EQUAL(number_of_segments(merged({ball(2), open})), 2);
}

void the_order_of_the_faces_does_not_matter()
{
  const Test_mesh mesh = merged({hollow_figure(), translated(ball(.1), {0, 0, 0})});
  const Labels labels = segment(mesh);
  for (std::uint_fast32_t seed = 0; seed < 3; ++seed)
  {
    const std::vector<std::size_t> order = random_permutation(mesh.faces.size(), seed);
    const Labels other = segment(with_face_order(mesh, order));
    for (std::size_t i = 0; i < order.size(); ++i)
      CGAL_CHECK_EQUAL(other[i], labels[order[i]]);
  }
}

void units_do_not_matter()
{
  const Labels labels = segment(hollow_figure());
  for (const double unit : {std::ldexp(1., -600), std::ldexp(1., 600)})
    CGAL_CHECK(segment(scaled(hollow_figure(), unit)) == labels);
}

// A wall of polygons, not all of them convex, and with faces without area.
void walls_may_have_any_faces()
{
  const Test_mesh outer = scaled(translated(l_prism(), {-.5, -.5, -.5}), 2);
  const Test_mesh inner = with_reversed_orientation(scaled(translated(box(), {-.5, -.5, -.5}), .1));
  const Test_mesh solid = scaled(translated(box(2, 2, 2), {-1, -1, -1}), 5);
  CGAL_CHECK_EQUAL(number_of_segments(merged({solid, inner})), 1);
  CGAL_CHECK_EQUAL(number_of_segments(merged({solid, with_reversed_orientation(outer)})), 1);
}

// A tip on an inner wall is one on the nearest face.
void tips_may_be_in_cavities()
{
  const Mesh mesh = to_graph<Mesh>(hollow_figure()), outer = to_graph<Mesh>(figure());
  std::vector<Mesh::Face_index> tips;
  CGAL::protrusion_tips(mesh, 5, std::back_inserter(tips));
  std::vector<Mesh::Face_index> of_outer;
  CGAL::protrusion_tips(outer, 5, std::back_inserter(of_outer));
  CGAL_CHECK(tips == of_outer);
  const std::size_t n = figure().faces.size();
  const std::vector<Mesh::Face_index> inside = {Mesh::Face_index(Mesh::size_type(n + tips.front()))};
  Labels labels(mesh.number_of_faces());
  const auto ids = boost::make_iterator_property_map(labels.begin(), get(boost::face_index, mesh));
  CGAL_CHECK_EQUAL(CGAL::segmentation_from_protrusion_tips(mesh, inside, ids), 2);
  CGAL_CHECK_EQUAL(labels[tips.front()], 1);
  CGAL_CHECK_EQUAL(labels[inside.front()], 1);
}

// A hole through which the hollow can be drained makes one surface of both walls: the inner one goes in and is no protrusion.
void hollows_may_have_holes()
{
  Cubes cubes, hollow;
  add_cubes(cubes, {-15, -15, -15}, {15, 15, 15});
  add_cubes(cubes, {15, -4, -4}, {40, 4, 4});
  add_cubes(hollow, {-13, -13, -13}, {13, 13, 13});
  add_cubes(hollow, {-1, -1, -15}, {1, 1, -13});
  for (const auto& cube : hollow)
    cubes.erase(cube);
  const Test_mesh mesh = voxels(cubes);
  const Labels labels = segment(mesh);
  for (std::size_t f = 0; f < labels.size(); ++f)
  {
    const double x = centroid(mesh, mesh.faces[f])[0];
    if (x < 13 || x > 17)
      CGAL_CHECK_EQUAL(labels[f], x < 13 ? 0u : 1u);
  }
}

int main()
{
  hollows_may_have_holes();
  inner_walls_have_the_labels_of_the_outer_ones();
  cavities_are_not_counted();
  solids_in_cavities_are_segments();
  hollow_bodies_may_be_turned_inside_out();
  other_components_are_no_cavities();
  the_order_of_the_faces_does_not_matter();
  units_do_not_matter();
  walls_may_have_any_faces();
  tips_may_be_in_cavities();
  return check::result();
}
