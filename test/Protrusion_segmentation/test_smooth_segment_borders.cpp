// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Smooth borders: lines whose lengths are known, and what every result has to be.

#include "check.h"
#include "test_meshes.h"

#include <CGAL/Protrusion_segmentation/segment_borders.h>
#include <CGAL/Protrusion_segmentation/smooth_segment_borders.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/helpers.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <map>
#include <random>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

using namespace test_meshes;
using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
using Labels = std::vector<std::size_t>;
using Index = CGAL::Protrusion_segmentation::Indexed_surface::Index;

struct Smoothed
{
  Mesh mesh;
  Labels segments;
  std::vector<std::size_t> old_faces;
  std::size_t number_of_fixed_segments = 0;
};

template <typename NamedParameters>
Smoothed smooth(const Test_mesh& soup, const Labels& labels, const NamedParameters& np)
{
  const Mesh mesh = to_graph<Mesh>(soup);
  Smoothed result;
  const auto segments = result.mesh.add_property_map<Mesh::Face_index, std::size_t>("f:segment").first;
  const auto old_faces = result.mesh.add_property_map<Mesh::Face_index, Mesh::Face_index>("f:old").first;
  result.number_of_fixed_segments = CGAL::Protrusion_segmentation::smooth_segment_borders(
    mesh, boost::make_iterator_property_map(labels.begin(), get(boost::face_index, mesh)), result.mesh,
    segments, old_faces, np);
  for (const auto f : faces(result.mesh))
  {
    result.segments.push_back(segments[f]);
    result.old_faces.push_back(old_faces[f]);
  }
  return result;
}

Test_mesh to_soup(const Mesh& mesh)
{
  Test_mesh soup;
  for (const auto v : vertices(mesh))
    soup.add_point({mesh.point(v).x(), mesh.point(v).y(), mesh.point(v).z()});
  for (const auto f : faces(mesh))
  {
    Face face;
    for (const auto v : vertices_around_face(mesh.halfedge(f), mesh))
      face.push_back(v);
    soup.add_face(face);
  }
  return soup;
}

using Lengths = std::map<std::array<std::size_t, 2>, double>; // of the border between any two segments

Lengths border_lengths(const Mesh& mesh, const Labels& labels)
{
  std::vector<CGAL::Protrusion_segmentation::Segment_border<Mesh::Point>> borders;
  CGAL::Protrusion_segmentation::segment_borders(
    mesh, boost::make_iterator_property_map(labels.begin(), get(boost::face_index, mesh)),
    std::back_inserter(borders));
  Lengths lengths;
  for (const auto& border : borders)
    lengths[border.segments] += border.length;
  return lengths;
}

double length_of_borders(const Mesh& mesh, const Labels& labels)
{
  double sum = 0;
  for (const auto& [segments, length] : border_lengths(mesh, labels))
    sum += length;
  return sum;
}

void check_no_border_is_worse(const Lengths& before, const Lengths& after)
{
  for (const auto& [segments, length] : after)
  {
    const auto old = before.find(segments);
    const std::string name = std::to_string(segments[0]) + "-" + std::to_string(segments[1]);
    check::report(old != before.end(), __FILE__, __LINE__, name + " did not touch before");
    if (old != before.end())
      check::report(length <= (1 + 1e-8) * old->second, __FILE__, __LINE__,
                    name + " gets longer, times " + std::to_string(length / old->second));
  }
}

// What holds for every result: the same surface, in pieces of its faces, with the same segments.
Smoothed checked(const Test_mesh& soup, const Labels& labels, unsigned int rounds = 3)
{
  const Smoothed result = smooth(soup, labels, CGAL::parameters::number_of_iterations(rounds));
  CGAL_CHECK(CGAL::is_valid_polygon_mesh(result.mesh));
  const Test_mesh pieces = to_soup(result.mesh);
  CGAL_CHECK_EQUAL(CGAL::is_closed(result.mesh), number_of_border_edges(soup) == 0);
  CGAL_CHECK_EQUAL(euler_characteristic(pieces), euler_characteristic(soup));
  std::vector<double> areas(soup.faces.size(), 0);
  for (std::size_t f = 0; f < pieces.faces.size(); ++f)
  {
    CGAL_CHECK(face_area(pieces, pieces.faces[f]) > 0);
    areas[result.old_faces[f]] += face_area(pieces, pieces.faces[f]);
    if (soup.faces[result.old_faces[f]].size() == 3)
      CGAL_CHECK_EQUAL(pieces.faces[f].size(), 3);
    CGAL_CHECK(f == 0 || result.old_faces[f - 1] <= result.old_faces[f]);
  }
  for (std::size_t f = 0; f < areas.size(); ++f)
  {
    const double old_area = face_area(soup, soup.faces[f]);
    // polygons are not quite plane, and their pieces lie in other planes
    CGAL_CHECK_CLOSE(areas[f], old_area, (soup.faces[f].size() == 3 ? 1e-12 : 1e-4) * old_area);
  }
  for (std::size_t v = 0; v < soup.points.size(); ++v)
    CGAL_CHECK(pieces.points[v] == soup.points[v]);
  CGAL_CHECK(std::set<std::size_t>(labels.begin(), labels.end()) ==
        std::set<std::size_t>(result.segments.begin(), result.segments.end()));
  CGAL_CHECK_EQUAL(number_of_pieces(pieces, result.segments), number_of_pieces(soup, labels));
  check_no_border_is_worse(border_lengths(to_graph<Mesh>(soup), labels), border_lengths(result.mesh, result.segments));
  return result;
}

// Faces above a height that is not the same everywhere.
Labels ragged_labels(const Test_mesh& soup, double height, double deviation)
{
  std::mt19937 random(7);
  std::uniform_real_distribution<double> noise(-deviation, deviation);
  Labels labels;
  for (const Face& face : soup.faces)
    labels.push_back(centroid(soup, face)[2] + noise(random) > height ? 1 : 0);
  return labels;
}

// A cylinder with a bump at its end, cut around the cylinder: the border becomes the circle that it was before faces were
// chosen at random.
void a_border_around_a_cylinder_becomes_a_circle()
{
  const double spacing = 0.1;
  const Test_mesh soup = triangulated(revolution(
    Profile(spacing).arc(1, 0, -pi / 2, 0, 0).line(1, 0, 1, 3, 0).line(1, 3, 1.4, 3.4, 0).arc(1.4, 3.4, 0, pi / 2, 0),
    slices_for(1, spacing)));
  const Labels labels = ragged_labels(soup, 1.53, 0.03);
  const double before = length_of_borders(to_graph<Mesh>(soup), labels);
  CGAL_CHECK(before > 1.2 * 2 * pi);
  double last = before;
  for (unsigned int rounds : {3, 10, 30})
  {
    const Smoothed result = checked(soup, labels, rounds);
    CGAL_CHECK_EQUAL(result.number_of_fixed_segments, 0);
    const double length = length_of_borders(result.mesh, result.segments);
    CGAL_CHECK(length < last);
    last = length;
    CGAL_CHECK_CLOSE(length, 2 * pi, (rounds == 3 ? 0.03 : 0.01) * 2 * pi);
  }
}

// On a sphere, faces are about as wide as they are high, and lie in no rows.
void a_border_around_a_ball_becomes_a_circle()
{
  const Test_mesh soup = icosphere(4);
  const Labels labels = ragged_labels(soup, 0.1, 0);
  const double circle = 2 * pi * std::sqrt(1 - 0.01);
  CGAL_CHECK(length_of_borders(to_graph<Mesh>(soup), labels) > 1.1 * circle);
  const Smoothed result = checked(soup, labels);
  CGAL_CHECK_CLOSE(length_of_borders(result.mesh, result.segments), circle, 0.03 * circle);
}

// Of equal angles around the axis.
Labels sectors(const Test_mesh& soup, int number)
{
  Labels labels;
  for (const Face& face : soup.faces)
  {
    const Point c = centroid(soup, face);
    labels.push_back(std::min<std::size_t>(std::size_t(number) - 1,
                                           std::size_t((std::atan2(c[1], c[0]) / pi + 1) / 2 * number)));
  }
  return labels;
}

// Three segments and six, which meet at the poles.
void segments_may_meet_in_a_point()
{
  for (const Test_mesh& soup : {icosphere(4), rotated(icosphere(3), {1, 2, 3}, 0.7), triangulated(uv_sphere()), uv_sphere()})
    for (const int number : {3, 6})
    {
      const Labels labels = sectors(soup, number);
      const Smoothed result = checked(soup, labels);
      const double ratio = length_of_borders(result.mesh, result.segments) /
                           length_of_borders(to_graph<Mesh>(soup), labels);
      // meridians are as short as can be
      check::report(ratio < 1.001, __FILE__, __LINE__,
                    std::to_string(number) + " segments, " + std::to_string(soup.faces.size()) +
                      " faces: borders get longer, times " + std::to_string(ratio));
    }
}

// For every face the nearest of some seeds, to which distances are wrong by up to a deviation: ragged.
Labels patches(const Test_mesh& soup, std::size_t number, double deviation, unsigned int seed)
{
  Random random(seed);
  std::vector<Point> seeds;
  while (seeds.size() < number)
    seeds.push_back(centroid(soup, soup.faces[random.index(soup.faces.size())]));
  Labels labels;
  for (const Face& face : soup.faces)
  {
    const Point c = centroid(soup, face);
    std::vector<double> distances;
    for (const Point& point : seeds)
      distances.push_back(std::hypot(c[0] - point[0], c[1] - point[1], c[2] - point[2]) +
                          random.real(-deviation, deviation));
    labels.push_back(std::size_t(std::min_element(distances.begin(), distances.end()) - distances.begin()));
  }
  return labels;
}

// Smoothing moves the points where three patches meet, and with them the ends of borders that had better stay.
void borders_of_patches_get_no_longer()
{
  for (unsigned int seed = 1; seed <= 12; ++seed)
    for (const double deviation : {0., 0.04})
      for (const unsigned int rounds : {1, 3, 20})
      {
        const Test_mesh soup = icosphere(3);
        const Labels labels = patches(soup, 4 + seed % 9, deviation, seed);
        const Smoothed result = checked(soup, labels, rounds);
        if (deviation == 0 && rounds == 3) // most of the raggedness goes all the same
          CGAL_CHECK(length_of_borders(result.mesh, result.segments) <
                0.9 * length_of_borders(to_graph<Mesh>(soup), labels));
      }
}

// Four segments meet at every inner vertex of these borders. Those across from each other must not touch.
void segments_across_a_crossing_do_not_touch()
{
  const Test_mesh soup = triangulated(sheet(20, 20));
  Labels labels;
  for (const Face& face : soup.faces)
    labels.push_back((centroid(soup, face)[0] > 10 ? 1 : 0) + (centroid(soup, face)[1] > 10 ? 2 : 0));
  checked(soup, labels);
  for (const int number : {4, 6})
    for (const unsigned int rounds : {1, 3, 20})
      checked(triangulated(uv_sphere()), sectors(triangulated(uv_sphere()), number), rounds);
}

// A straight border on which a slanting one ends: its end would be drawn along, and bend the straight one.
void a_straight_border_is_not_bent()
{
  const Test_mesh soup = triangulated(sheet(20, 20));
  Labels labels;
  for (const Face& face : soup.faces)
  {
    const Point c = centroid(soup, face);
    labels.push_back(c[1] > 10 ? 2 : 2 * c[0] > c[1] + 10 ? 1 : 0);
  }
  const Smoothed result = checked(soup, labels);
  CGAL_CHECK(length_of_borders(result.mesh, result.segments) < 0.99 * length_of_borders(to_graph<Mesh>(soup), labels));
}

void the_order_of_faces_does_not_matter()
{
  for (unsigned int seed = 1; seed <= 4; ++seed)
  {
    Test_mesh soup = icosphere(3);
    soup.parts = patches(soup, 7, 0.04, seed);
    const Test_mesh shuffled = with_face_order(soup, random_permutation(soup.faces.size(), seed));
    const Smoothed one = checked(soup, soup.parts), other = checked(shuffled, shuffled.parts);
    CGAL_CHECK_EQUAL(one.number_of_fixed_segments, other.number_of_fixed_segments);
    Lengths others = border_lengths(other.mesh, other.segments);
    for (const auto& [segments, length] : border_lengths(one.mesh, one.segments))
      CGAL_CHECK_CLOSE(others[segments], length, 1e-9 * length);
  }
}

void polygons_are_cut()
{
  for (const Test_mesh& soup : {football(), dodecahedron(), dual(icosphere(3)), box(4, 4, 4)})
    checked(soup, ragged_labels(soup, 0.1, 0));
}

void open_meshes_stay_open()
{
  const Test_mesh soup = triangulated(sheet(20, 20));
  Labels labels;
  for (const Face& face : soup.faces)
    labels.push_back(centroid(soup, face)[0] + centroid(soup, face)[1] > 20.4 ? 1 : 0);
  const Smoothed result = checked(soup, labels);
  const double length = length_of_borders(result.mesh, result.segments); // its ends bend towards the boundary
  CGAL_CHECK(length > 0.94 * 19.6 * std::sqrt(2.) && length < 1.001 * 19.6 * std::sqrt(2.));
}

// A thin leg, part 0, under a wide plate whose first ring of faces is long.
Test_mesh leg_and_plate()
{
  Profile profile(10); // one step for each line
  profile.line(0, 0, 0.2, 0, 0).line(0.2, 0, 0.2, 1, 0).line(0.2, 1, 1.5, 1, 1);
  for (double radius = 1.5; radius < 3; radius += 0.25)
    profile.line(radius, 1, radius + 0.25, 1, 1);
  return revolution(profile.line(3, 1, 3, 1.2, 1).line(3, 1.2, 0, 1.2, 1), 48);
}

// The border between leg and plate is as short as can be. Smoothed, it would go out into the plate.
void a_border_that_would_get_longer_stays()
{
  for (const Test_mesh& soup : {leg_and_plate(), triangulated(leg_and_plate())})
  {
    const Labels labels(soup.parts.begin(), soup.parts.end());
    const Smoothed result = checked(soup, labels);
    CGAL_CHECK_EQUAL(result.number_of_fixed_segments, 0);
    CGAL_CHECK(result.segments == labels);
  }
}

// The plate in two halves, with ragged borders that end at the leg: faces of the leg get the new vertices.
void a_smooth_border_may_end_at_one_that_stays()
{
  for (const Test_mesh& soup : {leg_and_plate(), triangulated(leg_and_plate())})
  {
    Labels labels;
    for (std::size_t f = 0; f < soup.faces.size(); ++f)
    {
      const Point c = centroid(soup, soup.faces[f]);
      const bool is_in_odd_ring = int(std::hypot(c[0], c[1]) / 0.25) % 2 == 1;
      labels.push_back(soup.parts[f] == 0 ? 0 : std::atan2(c[1], c[0]) > (is_in_odd_ring ? 0.14 : 0) ? 1 : 2);
    }
    const Smoothed result = checked(soup, labels);
    CGAL_CHECK_EQUAL(result.number_of_fixed_segments, 0);
    for (std::size_t f = 0; f < result.segments.size(); ++f)
      CGAL_CHECK_EQUAL(result.segments[f] == 0, labels[result.old_faces[f]] == 0);
    CGAL_CHECK(length_of_borders(result.mesh, result.segments) < 0.95 * length_of_borders(to_graph<Mesh>(soup), labels));
  }
}

// A single face, and a row of faces, are no more than a triangle wide.
void thin_segments_keep_their_faces()
{
  const Test_mesh soup = icosphere(3);
  Labels labels = ragged_labels(soup, 0.1, 0);
  const auto lowest = std::min_element(soup.faces.begin(), soup.faces.end(), [&](const Face& f, const Face& g)
                                       { return centroid(soup, f)[2] < centroid(soup, g)[2]; });
  labels[std::size_t(lowest - soup.faces.begin())] = 2;
  const Smoothed result = checked(soup, labels, 20);
  CGAL_CHECK_EQUAL(result.number_of_fixed_segments, 1);
  for (std::size_t f = 0; f < result.segments.size(); ++f)
    CGAL_CHECK_EQUAL(result.segments[f] == 2, labels[result.old_faces[f]] == 2);
  for (std::size_t f = 0; f < labels.size(); ++f)
    if (std::abs(centroid(soup, soup.faces[f])[2] + 0.6) < 0.04)
      labels[f] = 3;
  CGAL_CHECK(checked(soup, labels, 20).number_of_fixed_segments >= 2);
}

// Segments need not hang together, ids need not be consecutive, and a mesh may be in one segment.
void any_labels_are_accepted()
{
  const Test_mesh soup = merged({icosphere(3), translated(icosphere(3), {5, 0, 0})});
  Labels labels = ragged_labels(soup, 0.1, 0);
  for (std::size_t& label : labels)
    label = label == 1 ? 1000000 : 17;
  checked(soup, labels);
  const Smoothed one = checked(soup, Labels(soup.faces.size(), 5));
  CGAL_CHECK_EQUAL(one.segments.size(), soup.faces.size());
  std::mt19937 random(3);
  for (std::size_t& label : labels)
    label = random() % 3;
  checked(soup, labels);
}

void no_iteration_leaves_all_as_it_is()
{
  const Test_mesh soup = icosphere(3);
  const Labels labels = ragged_labels(soup, 0.1, 0);
  const Smoothed result = checked(soup, labels, 0);
  CGAL_CHECK(result.segments == labels);
  CGAL_CHECK_EQUAL(result.number_of_fixed_segments, 2);
}

// Faces without area, and coordinates near the ends of what a double can be.
void coordinates_may_be_awkward()
{
  Test_mesh flat = icosphere(3);
  const Labels labels = ragged_labels(flat, 0.1, 0);
  for (const double factor : {1e-300, 1e300})
  {
    const Smoothed result = smooth(scaled(flat, factor), labels, CGAL::parameters::number_of_iterations(3));
    CGAL_CHECK(CGAL::is_valid_polygon_mesh(result.mesh));
    CGAL_CHECK_EQUAL(result.number_of_fixed_segments, 0);
  }
  flat.points[3] = flat.points[flat.faces[0][0]];
  for (Point& point : flat.points)
    point[0] = 0;
  const Smoothed result = smooth(flat, labels, CGAL::parameters::default_values());
  CGAL_CHECK(CGAL::is_valid_polygon_mesh(result.mesh));
}

void bad_input_is_refused()
{
  Test_mesh soup = icosphere(1);
  const Labels labels = ragged_labels(soup, 0.1, 0);
  CGAL_CHECK_THROWS_WITH(smooth(soup, labels, CGAL::parameters::number_of_iterations(-1)), std::invalid_argument,
                    "number_of_iterations is -1");
  soup.points[2][1] = std::numeric_limits<double>::quiet_NaN();
  CGAL_CHECK_THROWS_WITH(smooth(soup, labels, CGAL::parameters::default_values()), std::invalid_argument, "not finite");
  // two triangles with an edge in the same direction
  const CGAL::Protrusion_segmentation::Indexed_surface surface(
    {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {0, 3, 6}, {0, 1, 2, 0, 1, 3}, std::vector<Index>(6, CGAL::Protrusion_segmentation::Indexed_surface::no_face()));
  CGAL_CHECK_THROWS_WITH(CGAL::Protrusion_segmentation::internal::check_edges_are_single(surface), std::invalid_argument,
                    "two edges");
}

int main()
{
  a_border_around_a_cylinder_becomes_a_circle();
  a_border_around_a_ball_becomes_a_circle();
  segments_may_meet_in_a_point();
  borders_of_patches_get_no_longer();
  segments_across_a_crossing_do_not_touch();
  a_straight_border_is_not_bent();
  the_order_of_faces_does_not_matter();
  polygons_are_cut();
  open_meshes_stay_open();
  a_border_that_would_get_longer_stays();
  a_smooth_border_may_end_at_one_that_stays();
  thin_segments_keep_their_faces();
  any_labels_are_accepted();
  no_iteration_leaves_all_as_it_is();
  coordinates_may_be_awkward();
  bad_input_is_refused();
  return check::result();
}
