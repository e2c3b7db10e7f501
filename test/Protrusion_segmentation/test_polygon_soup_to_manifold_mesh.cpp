// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Meshes of polygon soups: small ones of which the answer is known, and what holds for every soup.

#include "check.h"
#include "test_meshes.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Protrusion_segmentation/polygon_soup_to_manifold_mesh.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/property_map.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <list>
#include <map>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

using namespace test_meshes;
using Point_3 = CGAL::Simple_cartesian<double>::Point_3;
using Mesh = CGAL::Surface_mesh<Point_3>;
using Polyhedron = CGAL::Polyhedron_3<CGAL::Exact_predicates_inexact_constructions_kernel>;
using Repairs = CGAL::Protrusion_segmentation::Polygon_soup_repairs;

template <typename FaceGraph>
using Correspondence = CGAL::Protrusion_segmentation::Polygon_soup_correspondence<FaceGraph>;

std::vector<Point_3> points_of(const Test_mesh& soup)
{
  std::vector<Point_3> result;
  for (const Point& p : soup.points)
    result.emplace_back(p[0], p[1], p[2]);
  return result;
}

template <typename FaceGraph>
Correspondence<FaceGraph> repair(const Test_mesh& soup, FaceGraph& mesh)
{
  return CGAL::Protrusion_segmentation::polygon_soup_to_manifold_mesh(points_of(soup), soup.faces, mesh);
}

Repairs repairs_of(const Test_mesh& soup)
{
  Mesh mesh;
  return repair(soup, mesh).repairs;
}

Repairs repairs(std::size_t degenerate,
                std::size_t duplicates,
                std::size_t edges,
                std::size_t reversed,
                std::size_t small_components,
                std::size_t components)
{
  Repairs result;
  result.degenerate_polygons = degenerate;
  result.duplicate_polygons = duplicates;
  result.non_manifold_edges = edges;
  result.reversed_polygons = reversed;
  result.small_components = small_components;
  result.components = components;
  return result;
}

std::string as_text(const Repairs& r)
{
  std::string result;
  for (const std::size_t count : {r.degenerate_polygons, r.duplicate_polygons, r.non_manifold_edges,
                                  r.reversed_polygons, r.small_components, r.components})
    result += std::to_string(count) + " ";
  return result;
}

// Every polygon becomes a face of a manifold, or is labelled by one.
template <typename FaceGraph>
void check_correspondence(const Test_mesh& soup, const FaceGraph& mesh, const Correspondence<FaceGraph>& found)
{
  CGAL_CHECK(CGAL::is_valid_polygon_mesh(mesh));
  CGAL_CHECK_EQUAL(found.face_of_polygon.size(), soup.faces.size());
  CGAL_CHECK_EQUAL(found.faces.size(), num_faces(mesh));
  CGAL_CHECK_EQUAL(found.vertices.size(), num_vertices(mesh));
  CGAL_CHECK_EQUAL(found.polygon_of_face.size(), found.faces.size());
  CGAL_CHECK_EQUAL(found.point_of_vertex.size(), found.vertices.size());
  CGAL_CHECK(std::equal(found.faces.begin(), found.faces.end(), faces(mesh).begin(), faces(mesh).end()));
  CGAL_CHECK(std::is_sorted(found.polygon_of_face.begin(), found.polygon_of_face.end()));
  CGAL_CHECK(std::is_sorted(found.point_of_vertex.begin(), found.point_of_vertex.end()));

  const std::set<typename boost::graph_traits<FaceGraph>::face_descriptor> all(faces(mesh).begin(),
                                                                               faces(mesh).end());
  for (const auto f : found.face_of_polygon)
    CGAL_CHECK(all.count(f) == 1);
  for (std::size_t i = 0; i < found.faces.size(); ++i)
    CGAL_CHECK(found.face_of_polygon.at(found.polygon_of_face[i]) == found.faces[i]);
}

// The mesh with its vertices as corners.
template <typename FaceGraph>
Test_mesh to_soup(const FaceGraph& mesh, const Correspondence<FaceGraph>& found)
{
  std::map<typename boost::graph_traits<FaceGraph>::vertex_descriptor, std::size_t> numbers;
  Test_mesh result;
  const auto points = get(CGAL::vertex_point, mesh);
  for (const auto v : found.vertices)
  {
    const auto& p = get(points, v);
    numbers[v] = result.add_point({p.x(), p.y(), p.z()});
  }
  for (const auto f : found.faces)
  {
    Face face;
    for (const auto v : vertices_around_face(halfedge(f, mesh), mesh))
      face.push_back(numbers.at(v));
    result.add_face(face);
  }
  return result;
}


// Of every point the first one at the same place.
std::vector<std::size_t> places_of_points(const Test_mesh& soup)
{
  std::map<Point, std::size_t> first;
  std::vector<std::size_t> result;
  for (std::size_t i = 0; i < soup.points.size(); ++i)
    result.push_back(first.emplace(soup.points[i], i).first->second);
  return result;
}

// Each face has its corners where its polygon has them, in the same order or reversed; vertices have the points of the soup
// and one fan of faces each.
template <typename FaceGraph>
void check_faces(const Test_mesh& soup, const FaceGraph& mesh, const Correspondence<FaceGraph>& found)
{
  const Test_mesh faces = to_soup(mesh, found);
  const std::vector<std::size_t> places = places_of_points(soup);
  for (std::size_t v = 0; v < faces.points.size(); ++v)
    CGAL_CHECK(faces.points[v] == soup.points.at(found.point_of_vertex[v]));
  std::vector<std::size_t> corners_at(faces.points.size(), 0);
  std::size_t number_of_reversed = 0, number_of_symmetric = 0; // the second read the same either way
  for (std::size_t f = 0; f < faces.faces.size(); ++f)
  {
    Face points;
    for (const std::size_t v : faces.faces[f])
    {
      points.push_back(places[found.point_of_vertex[v]]);
      ++corners_at[v];
    }
    Face polygon = soup.faces[found.polygon_of_face[f]];
    polygon.erase(std::unique(polygon.begin(), polygon.end()), polygon.end());
    while (polygon.front() == polygon.back())
      polygon.pop_back();
    for (std::size_t& corner : polygon)
      corner = places[corner];
    Face reversed(polygon.rbegin(), polygon.rend());
    const auto is_same = [&](const Face& face)
    {
      for (std::size_t turn = 0; turn < face.size(); ++turn)
      {
        if (points == face)
          return true;
        std::rotate(points.begin(), points.begin() + 1, points.end());
      }
      return false;
    };
    const bool is_turned = !is_same(polygon);
    number_of_reversed += is_turned ? 1 : 0;
    number_of_symmetric += !is_turned && is_same(reversed) ? 1 : 0;
    CGAL_CHECK(!is_turned || is_same(reversed));
  }
  if (std::all_of(soup.faces.begin(), soup.faces.end(), [](const Face& face) { return face.size() == 3; }))
  {
    CGAL_CHECK(number_of_reversed <= found.repairs.reversed_polygons);
    CGAL_CHECK(found.repairs.reversed_polygons <= number_of_reversed + number_of_symmetric);
  }
  for (std::size_t v = 0; v < found.vertices.size(); ++v)
  {
    const auto around = halfedges_around_target(halfedge(found.vertices[v], mesh), mesh);
    const auto corners =
      std::count_if(around.begin(), around.end(), [&](const auto h) { return !is_border(h, mesh); });
    CGAL_CHECK_EQUAL(corners, corners_at[v]);
  }
  CGAL_CHECK_EQUAL(number_of_components(faces), found.repairs.components);
}

template <typename FaceGraph>
void check_mesh(const Test_mesh& soup, const FaceGraph& mesh, const Correspondence<FaceGraph>& found)
{
  check_correspondence(soup, mesh, found);
  check_faces(soup, mesh, found);
}

// The repairs are those that are expected; the faces that label `polygons` are those of `givers`.
template <typename FaceGraph = Mesh>
void check_repairs(const Test_mesh& soup,
                   const Repairs& expected,
                   const std::vector<std::pair<std::size_t, std::size_t>>& givers = {})
{
  FaceGraph mesh;
  const auto found = repair(soup, mesh);
  check_mesh(soup, mesh, found);
  CGAL_CHECK_EQUAL(as_text(found.repairs), as_text(expected));
  for (const auto& [polygon, giver] : givers)
    CGAL_CHECK(found.face_of_polygon.at(polygon) == found.face_of_polygon.at(giver));
}

std::size_t number_of_border_edges_of(const Test_mesh& soup)
{
  Mesh mesh;
  const auto found = repair(soup, mesh);
  return number_of_border_edges(to_soup(mesh, found));
}

Test_mesh with_faces(Test_mesh mesh, const std::vector<Face>& faces)
{
  for (const Face& face : faces)
    mesh.add_face(face);
  return mesh;
}

void clean_meshes_are_unchanged()
{
  for (const Test_mesh& soup : {box(), triangulated(box(2, 3, 1)), icosphere(2), football(), sheet(4, 3), torus()})
  {
    Mesh mesh;
    const auto found = repair(soup, mesh);
    check_mesh(soup, mesh, found);
    CGAL_CHECK(found.repairs.is_nothing());
    CGAL_CHECK_EQUAL(found.repairs.components, 1);
    const Mesh same = to_graph<Mesh>(soup);
    CGAL_CHECK_EQUAL(mesh.number_of_halfedges(), same.number_of_halfedges());
    for (const auto h : halfedges(same))
    {
      CGAL_CHECK(source(h, mesh) == source(h, same) && target(h, mesh) == target(h, same));
      CGAL_CHECK(face(h, mesh) == face(h, same));
    }
    for (const auto v : vertices(same))
      CGAL_CHECK(mesh.point(v) == same.point(v));
  }
}

void duplicates_have_the_label_of_the_first()
{
  const Test_mesh cube = box();
  Face other_start = cube.faces[2], reversed = cube.faces[4];
  std::rotate(other_start.begin(), other_start.begin() + 1, other_start.end());
  std::reverse(reversed.begin(), reversed.end());
  check_repairs(with_faces(cube, {cube.faces[3]}), repairs(0, 1, 0, 0, 0, 1), {{6, 3}});
  const Test_mesh soup = with_faces(cube, {other_start, reversed, cube.faces[2]});
  check_repairs(soup, repairs(0, 3, 0, 0, 0, 1), {{6, 2}, {7, 4}, {8, 2}});
  check_repairs<Polyhedron>(soup, repairs(0, 3, 0, 0, 0, 1), {{6, 2}, {7, 4}, {8, 2}});
  CGAL_CHECK_EQUAL(number_of_border_edges_of(soup), 0);
}

void turned_faces_are_turned_back()
{
  for (std::size_t turned = 0; turned < 6; ++turned)
  {
    Test_mesh cube = box();
    std::reverse(cube.faces[turned].begin(), cube.faces[turned].end());
    check_repairs(cube, repairs(0, 0, 0, 1, 0, 1));
    CGAL_CHECK_EQUAL(number_of_border_edges_of(cube), 0);
  }
  check_repairs(with_reversed_orientation(box()), repairs(0, 0, 0, 0, 0, 1)); // which is right is not known
}

void bow_ties_get_a_vertex_for_each_fan()
{
  Test_mesh soup = tetrahedron();
  for (const Point& p : {Point{2, 2, 2}, Point{3, 1, 1}, Point{1, 1, 4}})
    soup.add_point(p);
  soup = with_faces(soup, {{0, 4, 5}, {0, 5, 6}, {0, 6, 4}, {4, 6, 5}});
  check_repairs(soup, repairs(0, 0, 0, 0, 0, 2));
  check_repairs<Polyhedron>(soup, repairs(0, 0, 0, 0, 0, 2));
  Mesh mesh;
  const auto found = repair(soup, mesh);
  CGAL_CHECK_EQUAL(mesh.number_of_vertices(), 8);
  CGAL_CHECK_EQUAL(std::count(found.point_of_vertex.begin(), found.point_of_vertex.end(), 0u), 2);
}

void edges_of_three_faces_join_the_two_that_go_on()
{
  Test_mesh soup;
  soup.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}};
  for (const Face& fin : {Face{0, 1, 4}, Face{1, 0, 4}})
    for (std::size_t place = 0; place < 3; ++place)
    {
      std::vector<Face> flat = {{0, 1, 2}, {1, 0, 3}};
      flat.insert(flat.begin() + std::ptrdiff_t(place), fin);
      const Test_mesh three = with_faces(soup, flat);
      check_repairs(three, repairs(0, 0, 1, 0, 0, 2));
      Mesh mesh;
      const auto found = repair(three, mesh);
      const std::vector<std::size_t> two = place == 0 ? std::vector<std::size_t>{1, 2}
                                           : place == 1 ? std::vector<std::size_t>{0, 2}
                                                        : std::vector<std::size_t>{0, 1};
      const auto around = faces_around_face(halfedge(found.faces[two[0]], mesh), mesh);
      CGAL_CHECK(std::find(around.begin(), around.end(), found.faces[two[1]]) != around.end());
    }
}

// The two cubes of two voxels have the wall twice; both are left out.
void walls_between_solids_are_specks()
{
  Test_mesh soup = box(1, 1, 2);
  CGAL_CHECK_EQUAL(soup.faces.size(), 10);
  Face wall;
  for (std::size_t v = 0; v < soup.points.size(); ++v)
    if (soup.points[v][2] == 1)
      wall.push_back(v);
  CGAL_CHECK_EQUAL(wall.size(), 4);
  if (soup.points[wall[1]][0] != soup.points[wall[2]][0] && soup.points[wall[1]][1] != soup.points[wall[2]][1])
    std::swap(wall[2], wall[3]);
  check_repairs(with_faces(soup, {wall, wall}), repairs(0, 1, 4, 0, 1, 1));
  CGAL_CHECK_EQUAL(number_of_border_edges_of(with_faces(soup, {wall, wall})), 0);
}

void degenerate_polygons_have_the_label_of_a_neighbor()
{
  const Test_mesh cube = box();
  const Face& some = cube.faces[4];
  const std::size_t corner = some[0], next = some[1];
  std::vector<std::size_t> beside; // the first face with this edge, and with this corner
  for (std::size_t f = 0; f < 6; ++f)
    if (std::count(cube.faces[f].begin(), cube.faces[f].end(), corner) == 1)
      if (std::count(cube.faces[f].begin(), cube.faces[f].end(), next) == 1)
        beside.push_back(f);
  std::size_t at_corner = 0;
  while (std::count(cube.faces[at_corner].begin(), cube.faces[at_corner].end(), corner) == 0)
    ++at_corner;
  CGAL_CHECK_EQUAL(beside.size(), 2);
  const Test_mesh soup =
    with_faces(cube, {{corner, corner, next}, {corner, next}, {next, corner, next}, {corner}, {}});
  const std::vector<std::pair<std::size_t, std::size_t>> givers = {
    {6, beside[0]}, {7, beside[0]}, {8, beside[0]}, {9, at_corner}, {10, 5}};
  check_repairs(soup, repairs(5, 0, 0, 0, 0, 1), givers);
  check_repairs<Polyhedron>(soup, repairs(5, 0, 0, 0, 0, 1), givers);
  check_repairs(with_faces(with_faces(cube, {{0, 0}}), {cube.faces[0]}), repairs(1, 1, 0, 0, 0, 1));

  Test_mesh repeated = cube; // a corner that follows itself is one
  repeated.faces[1].push_back(repeated.faces[1].front());
  repeated.faces[2].insert(repeated.faces[2].begin(), repeated.faces[2].front());
  check_repairs(repeated, repairs(0, 0, 0, 0, 0, 1));
}

// A large sheet, and a small triangle that touches it at a corner or not.
Test_mesh sheet_and_triangle(bool touches, double edge)
{
  Test_mesh soup = sheet(5, 5);
  const Point corner = touches ? Point{2, 2, 0} : Point{2, 2, 1};
  const std::size_t a = soup.add_point(corner);
  const std::size_t b = soup.add_point(corner + Point{edge, 0, edge});
  const std::size_t c = soup.add_point(corner + Point{0, edge, edge});
  soup.add_face({a, b, c});
  return soup;
}

void specks_that_touch_are_left_out()
{
  // The first face with the point 2, 2 is that of row 1, column 1.
  check_repairs(sheet_and_triangle(true, .1), repairs(0, 0, 0, 0, 1, 1), {{25, 6}});
  check_repairs(sheet_and_triangle(true, .5), repairs(0, 0, 0, 0, 0, 2)); // not that small
  check_repairs(sheet_and_triangle(false, .1), repairs(0, 0, 0, 0, 0, 2));
  // A double of a speck has the label of the same neighbor.
  Test_mesh twice = sheet_and_triangle(true, .1);
  twice.add_face(twice.faces.back());
  check_repairs(twice, repairs(0, 1, 0, 0, 1, 1), {{25, 6}, {26, 6}});
}

void units_do_not_matter()
{
  for (const double unit : {1e-200, 1e-3, 1e200})
  {
    check_repairs(scaled(sheet_and_triangle(true, .1), unit), repairs(0, 0, 0, 0, 1, 1), {{25, 6}});
    check_repairs(scaled(box(), unit), repairs(0, 0, 0, 0, 0, 1));
  }
  // Beside a far point of no polygon, nothing becomes tiny.
  Test_mesh soup = sheet_and_triangle(true, .1);
  soup.add_point({1e200, 0, 0});
  check_repairs(soup, repairs(0, 0, 0, 0, 1, 1), {{25, 6}});
}

void soups_without_shared_points_hang_together()
{
  for (const Test_mesh& mesh : {icosphere(2), box(), football(), torus()})
  {
    const Test_mesh soup = exploded(mesh);
    check_repairs(soup, repairs(0, 0, 0, 0, 0, 1));
    check_repairs<Polyhedron>(soup, repairs(0, 0, 0, 0, 0, 1));
    Mesh found;
    repair(soup, found);
    CGAL_CHECK_EQUAL(found.number_of_vertices(), mesh.points.size());
    CGAL_CHECK_EQUAL(number_of_border_edges_of(soup), 0);
  }
}

// It cannot be oriented: one edge is cut.
void moebius_strips_are_cut()
{
  const Test_mesh strip = moebius_strip(12);
  Repairs expected = repairs(0, 0, 0, repairs_of(strip).reversed_polygons, 0, 1);
  expected.unorientable_edges = 1;
  check_repairs(strip, expected);
  CGAL_CHECK(!repairs_of(strip).is_nothing());
  CGAL_CHECK_EQUAL(number_of_border_edges_of(strip), 2 * 12 + 2);
}

template <typename Points, typename Polygons>
void check_refused(const Points& points, const Polygons& polygons, const std::string& message)
{
  Mesh mesh = to_graph<Mesh>(tetrahedron());
  CGAL_CHECK_THROWS_WITH(CGAL::Protrusion_segmentation::polygon_soup_to_manifold_mesh(points, polygons, mesh),
                    std::invalid_argument, message);
  CGAL_CHECK_EQUAL(mesh.number_of_vertices(), 4);
  CGAL_CHECK_EQUAL(mesh.number_of_faces(), 4);
}

void bad_input_is_refused()
{
  using Polygons = std::vector<std::vector<int>>;
  const std::vector<Point_3> points = points_of(box());
  check_refused(points, Polygons{{0, 1, 2}, {0, 1, 8}}, "polygons: polygon 1 has the corner 8, but there are 8 points");
  check_refused(points, Polygons{{0, -1, 2}}, "polygons: polygon 0 has the corner -1, but there are 8 points");
  check_refused(points, std::vector<std::array<signed char, 3>>{{0, -1, 2}}, "polygon 0 has the corner -1");
  check_refused(std::vector<Point_3>(), Polygons{{0, 0, 0}}, "but there are 0 points");
  check_refused(points, Polygons(), "polygons: there are none");
  check_refused(points, Polygons{{0, 0, 1}, {}, {2}, {3, 4}, {5, 6, 5}}, "polygons: none has three different corners");
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()})
    for (int c = 0; c < 3; ++c)
    {
      std::vector<Point_3> wrong = points;
      wrong[5] = Point_3(c == 0 ? bad : 1, c == 1 ? bad : 1, c == 2 ? bad : 1);
      check_refused(wrong, Polygons{{0, 1, 2}, {0, 1, 5}}, "points: point 5 has a coordinate that is not finite");
      Mesh mesh; // of which the point is no part
      CGAL::Protrusion_segmentation::polygon_soup_to_manifold_mesh(wrong, Polygons{{0, 1, 2}}, mesh);
      CGAL_CHECK_EQUAL(mesh.number_of_vertices(), 3);
    }
}

void faces_are_added()
{
  Mesh mesh = to_graph<Mesh>(tetrahedron());
  const auto found = CGAL::Protrusion_segmentation::polygon_soup_to_manifold_mesh(points_of(box()),
                                                                                  box().faces, mesh);
  CGAL_CHECK_EQUAL(mesh.number_of_faces(), 10);
  CGAL_CHECK_EQUAL(mesh.number_of_vertices(), 12);
  CGAL_CHECK_EQUAL(found.faces.size(), 6);
  CGAL_CHECK(found.faces.front() == Mesh::Face_index(4));
}

void any_ranges_do()
{
  const Test_mesh soup = with_faces(triangulated(box()), {{0, 0, 1}});
  const std::vector<Point_3> points = points_of(soup);
  std::list<std::array<short, 3>> polygons;
  for (const Face& face : soup.faces)
    polygons.push_back({short(face[0]), short(face[1]), short(face[2])});
  std::vector<std::pair<int, Point_3>> pairs;
  for (const Point_3& p : points)
    pairs.emplace_back(7, p);

  Mesh of_list, of_pairs;
  CGAL::Protrusion_segmentation::polygon_soup_to_manifold_mesh(
    std::list<Point_3>(points.begin(), points.end()), polygons, of_list);
  const auto found = CGAL::Protrusion_segmentation::polygon_soup_to_manifold_mesh(
    pairs, soup.faces, of_pairs,
    CGAL::parameters::point_map(CGAL::Second_of_pair_property_map<std::pair<int, Point_3>>()));
  check_mesh(soup, of_pairs, found);
  CGAL_CHECK_EQUAL(of_list.number_of_faces(), 12);
  for (const auto v : vertices(of_list))
    CGAL_CHECK(of_list.point(v) == points[v] && of_pairs.point(v) == points[v]);

  Mesh other;
  const auto doubled = other.add_property_map<Mesh::Vertex_index, Point_3>("v:other").first;
  CGAL::Protrusion_segmentation::polygon_soup_to_manifold_mesh(
    points, soup.faces, other, CGAL::parameters::default_values(),
    CGAL::parameters::vertex_point_map(doubled));
  for (const auto v : vertices(other))
    CGAL_CHECK(doubled[v] == points[v]);
}

void labels_come_back_to_the_polygons()
{
  const Test_mesh cube = box();
  const Test_mesh soup = with_faces(cube, {cube.faces[3], {0, 0, 1}, cube.faces[1]});
  Mesh mesh;
  const auto found = repair(soup, mesh);
  const auto labels = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:label").first;
  for (const auto f : faces(mesh))
    labels[f] = 10 + std::size_t(f);
  std::vector<std::size_t> result;
  found.labels_of_polygons(labels, std::back_inserter(result));
  CGAL_CHECK_EQUAL(result.size(), 9);
  for (std::size_t polygon = 0; polygon < 6; ++polygon)
    CGAL_CHECK_EQUAL(result[polygon], 10 + polygon);
  CGAL_CHECK_EQUAL(result[6], 13);
  CGAL_CHECK_EQUAL(result[8], 11);
}

// A surface with some polygons twice, some turned and some without area, in random order.
Test_mesh damaged(const Test_mesh& mesh, std::uint_fast32_t seed, std::array<std::size_t, 3>& counts)
{
  Random random(seed);
  counts = {random.index(9), random.index(9), random.index(9)};
  Test_mesh result = mesh;
  for (std::size_t i = 0; i < counts[0]; ++i)
    result.add_face({mesh.faces[random.index(mesh.faces.size())][0], random.index(mesh.points.size())});
  for (std::size_t i = 0; i < counts[1]; ++i)
    result.add_face(mesh.faces[random.index(mesh.faces.size())]);
  const std::set<Face> duplicates(result.faces.begin() + std::ptrdiff_t(mesh.faces.size()), result.faces.end());
  std::set<std::size_t> turned;
  while (turned.size() < counts[2])
    if (const std::size_t f = random.index(mesh.faces.size()); duplicates.count(mesh.faces[f]) == 0)
      turned.insert(f);
  for (const std::size_t f : turned)
    std::reverse(result.faces[f].begin(), result.faces[f].end());
  return result;
}

void damages_are_counted_in_any_order()
{
  for (std::uint_fast32_t seed = 0; seed < 40; ++seed)
  {
    std::array<std::size_t, 3> counts;
    const Test_mesh surface = random_surface(seed);
    const Test_mesh soup = damaged(surface, seed, counts);
    const Repairs expected = repairs(counts[0], counts[1], 0, counts[2], 0, 1);
    check_repairs(soup, expected);
    for (std::uint_fast32_t order = 0; order < 3; ++order)
      check_repairs(with_face_order(soup, random_permutation(soup.faces.size(), 3 * seed + order)), expected);
    check_repairs(exploded(surface), repairs(0, 0, 0, 0, 0, 1));
  }
}

// Polygons at random among few points, in every other soup some at the same place.
Test_mesh wild_soup(std::uint_fast32_t seed)
{
  Random random(seed);
  Test_mesh soup;
  const std::size_t n = 4 + random.index(12);
  for (std::size_t i = 0; i < n; ++i)
    soup.add_point(seed % 2 == 1 && i > 3 && random.index(4) == 0 ? soup.points[random.index(i)]
                                                 : Point{random.real(-1, 1), random.real(-1, 1), random.real(-1, 1)});
  soup.add_face({0, 1, 2});
  const std::size_t number = random.index(60);
  for (std::size_t i = 0; i < number; ++i)
  {
    Face face(random.index(8) == 0 ? random.index(7) : 3);
    for (std::size_t& corner : face)
      corner = random.index(n);
    soup.add_face(face);
  }
  return soup;
}

void wild_soups_become_manifolds()
{
  for (std::uint_fast32_t seed = 0; seed < 2000; ++seed)
  {
    const Test_mesh soup = wild_soup(seed);
    Mesh mesh;
    const auto found = repair(soup, mesh);
    check_mesh(soup, mesh, found);
    // What does not depend on which polygons are joined.
    const Test_mesh other = with_face_order(soup, random_permutation(soup.faces.size(), seed));
    const Repairs of_other = repairs_of(other);
    CGAL_CHECK_EQUAL(of_other.degenerate_polygons, found.repairs.degenerate_polygons);
    CGAL_CHECK_EQUAL(of_other.duplicate_polygons, found.repairs.duplicate_polygons);
    if (seed % 2 == 0) // polygons that name the same points are joined before others come to lie there
      CGAL_CHECK_EQUAL(of_other.non_manifold_edges, found.repairs.non_manifold_edges);
  }
  for (std::uint_fast32_t seed = 0; seed < 200; ++seed)
  {
    Polyhedron mesh;
    const Test_mesh soup = wild_soup(seed);
    const auto found = repair(soup, mesh);
    check_mesh(soup, mesh, found);
  }
}

int main()
{
  clean_meshes_are_unchanged();
  duplicates_have_the_label_of_the_first();
  turned_faces_are_turned_back();
  bow_ties_get_a_vertex_for_each_fan();
  edges_of_three_faces_join_the_two_that_go_on();
  walls_between_solids_are_specks();
  degenerate_polygons_have_the_label_of_a_neighbor();
  specks_that_touch_are_left_out();
  units_do_not_matter();
  soups_without_shared_points_hang_together();
  moebius_strips_are_cut();
  bad_input_is_refused();
  faces_are_added();
  any_ranges_do();
  labels_come_back_to_the_polygons();
  damages_are_counted_in_any_order();
  wild_soups_become_manifolds();
  return check::result();
}
