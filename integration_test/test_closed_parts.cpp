// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The closed parts of the tool: every edge of a part has two faces that look the same way, and volumes add up.

#include "check.h"
#include "test_meshes.h" // Boost demands that it comes before Boost Graph
#include "writing/closed_parts.h"
#include "writing/faired_parts.h"

#include <CGAL/protrusion_segmentation.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

using tool::Polygon_soup;
using tool::Mesh;
using tool::Point;
using Labels = std::vector<std::size_t>;

namespace
{

// Six times the volume, of fans.
double volume(const Polygon_soup& part)
{
  double sum = 0;
  for (const auto& polygon : part.polygons)
    for (std::size_t i = 2; i < polygon.size(); ++i)
      sum += CGAL::determinant(part.points[polygon[0]] - CGAL::ORIGIN, part.points[polygon[i - 1]] - CGAL::ORIGIN,
                               part.points[polygon[i]] - CGAL::ORIGIN);
  return sum;
}

Polygon_soup whole(const Mesh& mesh)
{
  Polygon_soup part;
  for (const auto v : vertices(mesh))
    part.points.push_back(mesh.point(v));
  for (const auto f : faces(mesh))
  {
    part.polygons.emplace_back();
    for (const auto v : vertices_around_face(mesh.halfedge(f), mesh))
      part.polygons.back().push_back(std::size_t(v));
  }
  return part;
}

// Edges that are not once in each direction.
std::size_t number_of_open_edges(const Polygon_soup& part)
{
  std::map<std::pair<std::size_t, std::size_t>, int> uses;
  for (const auto& polygon : part.polygons)
    for (std::size_t i = 0; i < polygon.size(); ++i)
      ++uses[{polygon[i], polygon[(i + 1) % polygon.size()]}];
  std::size_t count = 0;
  for (const auto& [edge, number] : uses)
  {
    const auto back = uses.find({edge.second, edge.first});
    count += number == 1 && back != uses.end() && back->second == 1 ? 0 : 1;
  }
  return count;
}

void check_parts(const Mesh& mesh, const Labels& labels, const Labels& parents, const std::string& name)
{
  const std::vector<Polygon_soup> parts = tool::closed_parts(mesh, labels, parents);
  CHECK_EQUAL(parts.size(), parents.size());
  double sum = 0;
  std::size_t number_of_faces = 0;
  for (std::size_t s = 0; s < parts.size(); ++s)
  {
    check::report(number_of_open_edges(parts[s]) == 0, __FILE__, __LINE__,
                  name + ": part " + std::to_string(s) + " is not closed");
    sum += volume(parts[s]);
    number_of_faces += parts[s].polygons.size();
  }
  const double expected = volume(whole(mesh));
  check::report(std::abs(sum - expected) <= 1e-9 * std::abs(expected), __FILE__, __LINE__,
                name + ": volumes add up to " + std::to_string(sum) + ", not to " + std::to_string(expected));
  CHECK(parts.size() < 2 || number_of_faces > mesh.number_of_faces());
}

void test_segmentations(const Mesh& mesh, std::size_t number, const std::string& name)
{
  const auto hierarchy = CGAL::protrusion_hierarchy(mesh, number);
  Labels labels(mesh.number_of_faces()), parents;
  hierarchy.segment_ids(mesh, hierarchy.maximum_number_of_segments(),
                        boost::make_iterator_property_map(labels.begin(), get(boost::face_index, mesh)));
  for (std::size_t s = 0; s < hierarchy.maximum_number_of_segments(); ++s)
    parents.push_back(hierarchy.parent(s));
  check_parts(mesh, labels, parents, name);
}

// Three segments and more at one vertex, loops that touch themselves, segments in several pieces.
void test_random_labels(const Mesh& mesh, std::size_t number, unsigned int seed, const std::string& name)
{
  std::mt19937 random(seed);
  Labels labels(mesh.number_of_faces()), parents = {0};
  for (std::size_t s = 1; s < number; ++s)
    parents.push_back(random() % s);
  for (std::size_t& label : labels)
    label = random() % number;
  check_parts(mesh, labels, parents, name + " at random");
}

// 0 or 1 for the faces on either side of a plane across an axis.
Labels labels_of_halves(const Mesh& mesh, int axis, double position)
{
  Labels labels;
  for (const auto f : faces(mesh))
  {
    double sum = 0;
    for (const auto v : vertices_around_face(mesh.halfedge(f), mesh))
      sum += mesh.point(v)[axis] - position;
    labels.push_back(sum > 0 ? 1 : 0);
  }
  return labels;
}

// Two cubes next to each other become two cubes.
void test_box_in_halves()
{
  const auto mesh = test_meshes::to_graph<Mesh>(test_meshes::box(2, 1, 1));
  double smallest = mesh.point(*vertices(mesh).begin())[0], largest = smallest;
  for (const auto v : vertices(mesh))
  {
    smallest = (std::min)(smallest, mesh.point(v)[0]);
    largest = (std::max)(largest, mesh.point(v)[0]);
  }
  const auto parts = tool::closed_parts(mesh, labels_of_halves(mesh, 0, (smallest + largest) / 2), {0, 0});
  for (const Polygon_soup& part : parts)
  {
    CHECK_EQUAL(part.points.size(), 8);
    CHECK_EQUAL(part.polygons.size(), mesh.number_of_faces() / 2 + 2); // two triangles close a square
    CHECK_CLOSE(volume(part), volume(whole(mesh)) / 2, 1e-12);
    CHECK_EQUAL(number_of_open_edges(part), 0);
  }
}

// What is open stays so; the border between the parts is closed.
void test_open_mesh()
{
  const auto mesh = test_meshes::to_graph<Mesh>(test_meshes::open_cylinder());
  std::size_t number_of_border_edges = 0;
  for (const auto e : edges(mesh))
    number_of_border_edges += mesh.is_border(e) ? 1 : 0;
  std::size_t number_of_faces = 0, open_edges = 0;
  for (const auto& part : tool::closed_parts(mesh, labels_of_halves(mesh, 2, 2), {0, 0}))
  {
    number_of_faces += part.polygons.size();
    open_edges += number_of_open_edges(part);
  }
  CHECK(number_of_faces > mesh.number_of_faces());
  CHECK_EQUAL(open_edges, number_of_border_edges);

  // A border from one end to the other cannot be closed.
  number_of_faces = 0;
  for (const auto& part : tool::closed_parts(mesh, labels_of_halves(mesh, 0, 0), {0, 0}))
    number_of_faces += part.polygons.size();
  CHECK_EQUAL(number_of_faces, mesh.number_of_faces());
}

void check_faired_parts(const Mesh& mesh, const Labels& labels, std::size_t number, const std::string& name)
{
  const std::vector<Polygon_soup> parts = tool::faired_parts(mesh, labels, number);
  CHECK_EQUAL(parts.size(), number);
  for (std::size_t s = 0; s < parts.size(); ++s)
  {
    const std::string part = name + ": faired part " + std::to_string(s);
    const auto is_triangle = [](const auto& polygon) { return polygon.size() == 3; };
    const auto is_finite = [](const Point& p) { return std::isfinite(p.x()) && std::isfinite(p.y()) && std::isfinite(p.z()); };
    const std::vector<Point>& points = parts[s].points;
    const std::vector<tool::Polygon>& polygons = parts[s].polygons;
    check::report(number_of_open_edges(parts[s]) == 0, __FILE__, __LINE__, part + " is not closed");
    check::report(std::all_of(polygons.begin(), polygons.end(), is_triangle), __FILE__, __LINE__,
                  part + " has other faces than triangles");
    check::report(std::all_of(points.begin(), points.end(), is_finite), __FILE__, __LINE__,
                  part + " has points that are not finite");
    const std::set<Point> points_of_part(points.begin(), points.end());
    for (const auto f : faces(mesh))
      for (const auto v : vertices_around_face(mesh.halfedge(f), mesh))
        check::report(labels[f] != s || points_of_part.count(mesh.point(v)) == 1, __FILE__, __LINE__,
                      part + " lacks a point of the mesh");
  }
}

// Halves of a ball get round caps, as the ball itself is: each is larger than with a flat one.
void test_faired_parts()
{
  const auto ball = test_meshes::to_graph<Mesh>(test_meshes::icosphere(3));
  const Labels halves = labels_of_halves(ball, 2, 0);
  check_faired_parts(ball, halves, 2, "ball");
  for (const Polygon_soup& part : tool::faired_parts(ball, halves, 2))
    CHECK(volume(part) > 0.6 * volume(whole(ball)));
  const auto star = test_meshes::to_graph<Mesh>(test_meshes::star(5));
  Labels labels(star.number_of_faces());
  const std::size_t number = CGAL::segmentation_via_protrusion_tips(
    star, boost::make_iterator_property_map(labels.begin(), get(boost::face_index, star)));
  check_faired_parts(star, labels, number, "star");
  std::mt19937 random(1);
  for (std::size_t& label : labels) // that meet in single vertices, and lie in many pieces
    label = random() % 3;
  check_faired_parts(star, labels, 3, "random");
}

// The first one between two segments.
Mesh::Halfedge_index halfedge_at_border(const Mesh& mesh, const Labels& labels)
{
  const auto is_between_segments = [&](const Mesh::Halfedge_index h)
  { return labels[mesh.face(h)] != labels[mesh.face(mesh.opposite(h))]; };
  return *std::find_if(halfedges(mesh).begin(), halfedges(mesh).end(), is_between_segments);
}

// What divides by areas and lengths has none: the faces stay, and the caps are round nevertheless.
void test_faired_parts_of_degenerate_faces()
{
  for (const bool is_along_border : {true, false})
  {
    auto ball = test_meshes::to_graph<Mesh>(test_meshes::icosphere(3));
    const Labels halves = labels_of_halves(ball, 2, 0);
    const auto at_border = halfedge_at_border(ball, halves);
    const auto edge = is_along_border ? at_border : ball.next(at_border);
    ball.point(ball.source(edge)) = ball.point(ball.target(edge));
    check_faired_parts(ball, halves, 2, "edge of no length");
    for (const Polygon_soup& part : tool::faired_parts(ball, halves, 2))
      CHECK(volume(part) > 0.6 * volume(whole(ball)));
  }
}

// Polygons without a normal become triangles, too.
void test_faired_parts_of_degenerate_polygons()
{
  const std::map<std::string, test_meshes::Test_mesh> balls = {
    {"quads", test_meshes::uv_sphere()}, {"hexagons", test_meshes::dual(test_meshes::icosphere(3))}};
  const std::map<std::string, CGAL::Simple_cartesian<double>::Vector_3> steps = {
    {"point", {0, 0, 0}}, {"line along an axis", {0, 0.01, 0}}, {"line", {0.01, 0.02, 0.03}}};
  for (const auto& [name, soup] : balls)
    for (const auto& [shape, step] : steps)
    {
      auto ball = test_meshes::to_graph<Mesh>(soup);
      const Labels halves = labels_of_halves(ball, 2, 0);
      const auto corner = halfedge_at_border(ball, halves);
      Point next = ball.point(ball.target(corner));
      for (const auto v : vertices_around_face(corner, ball))
      {
        ball.point(v) = next;
        next = next + step;
      }
      check_faired_parts(ball, halves, 2, name + ", one of them a " + shape);
    }
}

// Squares of areas would be too small or too large for a number.
void test_faired_parts_of_any_size()
{
  for (const double size : {1e-300, 1e-90, 1e90, 1e300})
  {
    const auto unit_ball = test_meshes::icosphere(3);
    const auto ball = test_meshes::to_graph<Mesh>(test_meshes::scaled(unit_ball, size));
    const Labels halves = labels_of_halves(ball, 2, 0);
    check_faired_parts(ball, halves, 2, "ball of size " + check::as_text(size));
    for (Polygon_soup part : tool::faired_parts(ball, halves, 2))
    {
      for (Point& p : part.points)
        p = Point(p.x() / size, p.y() / size, p.z() / size);
      CHECK(volume(part) > 0.6 * volume(whole(test_meshes::to_graph<Mesh>(unit_ball))));
    }
  }
}

} // namespace

int main()
{
  using namespace test_meshes;
  const std::map<std::string, Test_mesh> meshes = {
    {"star", star(5)}, {"creature", creature()}, {"torus", torus()}, {"dumbbell", dumbbell()}};
  for (const auto& [name, soup] : meshes)
  {
    const auto mesh = to_graph<Mesh>(soup);
    for (const std::size_t number : {1, 2, 4, 8})
      test_segmentations(mesh, number, name);
    for (unsigned int seed = 0; seed < 3; ++seed)
      test_random_labels(mesh, 2 + seed, seed, name);
  }
  test_box_in_halves();
  test_open_mesh();
  test_faired_parts();
  test_faired_parts_of_degenerate_faces();
  test_faired_parts_of_degenerate_polygons();
  test_faired_parts_of_any_size();
  return check::result();
}
