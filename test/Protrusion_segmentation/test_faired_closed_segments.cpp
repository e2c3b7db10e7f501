// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Segments with rounded caps.

#include "closed_parts.h"

#include <CGAL/Protrusion_segmentation/closed_segments.h>
#include <CGAL/Protrusion_segmentation/faired_closed_segments.h>
#include <CGAL/protrusion_segmentation.h>

#include <algorithm>
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

namespace {

std::vector<Part> faired_parts(const Mesh& mesh, const Labels& labels, std::size_t number)
{
  std::vector<Part> parts;
  CGAL::Protrusion_segmentation::faired_closed_segments(
    mesh, map_of(labels, mesh), record_of(Labels(number, 0)), std::back_inserter(parts));
  return parts;
}

void check_faired_parts(const Mesh& mesh,
                        const Labels& labels,
                        std::size_t number,
                        const std::string& name)
{
  const std::vector<Part> parts = faired_parts(mesh, labels, number);
  CGAL_CHECK_EQUAL(parts.size(), number);
  for (std::size_t s = 0; s < parts.size(); ++s)
  {
    const std::string part = name + ": faired part " + std::to_string(s);
    const auto is_triangle = [](const auto& polygon) { return polygon.size() == 3; };
    const auto is_finite = [](const Mesh::Point& p)
    { return std::isfinite(p.x()) && std::isfinite(p.y()) && std::isfinite(p.z()); };
    const std::vector<Mesh::Point>& points = parts[s].points;
    const std::vector<std::vector<std::size_t>>& polygons = parts[s].polygons;
    check::report(number_of_open_edges(parts[s]) == 0, __FILE__, __LINE__, part + " is not closed");
    check::report(std::all_of(polygons.begin(), polygons.end(), is_triangle), __FILE__, __LINE__,
                  part + " has other faces than triangles");
    check::report(std::all_of(points.begin(), points.end(), is_finite), __FILE__, __LINE__,
                  part + " has points that are not finite");
    const std::set<Mesh::Point> points_of_part(points.begin(), points.end());
    for (const auto f : faces(mesh))
      for (const auto v : vertices_around_face(mesh.halfedge(f), mesh))
        check::report(labels[f] != s || points_of_part.count(mesh.point(v)) == 1, __FILE__, __LINE__,
                      part + " lacks a point of the mesh");
  }
}

// Halves of a ball get round caps, as the ball itself is: each is larger than with a flat one.
void test_faired_parts()
{
  const auto ball = to_graph<Mesh>(icosphere(3));
  const Labels halves = labels_of_halves(ball, 2, 0);
  check_faired_parts(ball, halves, 2, "ball");
  for (const Part& part : faired_parts(ball, halves, 2))
    CGAL_CHECK(volume(part) > 0.6 * volume(whole(ball)));
  const auto arms = to_graph<Mesh>(star(5));
  Labels labels(arms.number_of_faces());
  const std::size_t number = CGAL::segmentation_via_protrusion_tips(
    arms, boost::make_iterator_property_map(labels.begin(), get(boost::face_index, arms)));
  check_faired_parts(arms, labels, number, "star");
  std::mt19937 random(1);
  for (std::size_t& label : labels) // that meet in single vertices, and lie in many pieces
    label = random() % 3;
  check_faired_parts(arms, labels, 3, "random");
}

// A number that no face has is that of an empty part, in either kind of caps.
void test_parts_without_faces()
{
  const auto ball = to_graph<Mesh>(icosphere(2));
  Labels labels = labels_of_halves(ball, 2, 0);
  for (std::size_t& label : labels)
    label *= 2; // 0 and 2
  check_faired_parts(ball, labels, 3, "ball without segment 1");
  CGAL_CHECK(faired_parts(ball, labels, 3)[1].polygons.empty());
  std::vector<Part> flat_parts;
  CGAL::Protrusion_segmentation::closed_segments(ball, map_of(labels, ball), record_of(Labels(3, 0)),
                                                 std::back_inserter(flat_parts));
  CGAL_CHECK_EQUAL(flat_parts.size(), 3u);
  CGAL_CHECK(flat_parts[1].polygons.empty());
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
    auto ball = to_graph<Mesh>(icosphere(3));
    const Labels halves = labels_of_halves(ball, 2, 0);
    const auto at_border = halfedge_at_border(ball, halves);
    const auto edge = is_along_border ? at_border : ball.next(at_border);
    ball.point(ball.source(edge)) = ball.point(ball.target(edge));
    check_faired_parts(ball, halves, 2, "edge of no length");
    for (const Part& part : faired_parts(ball, halves, 2))
      CGAL_CHECK(volume(part) > 0.6 * volume(whole(ball)));
  }
}

// Polygons without a normal become triangles, too.
void test_faired_parts_of_degenerate_polygons()
{
  const std::map<std::string, Test_mesh> balls = {{"quads", uv_sphere()},
                                                  {"hexagons", dual(icosphere(3))}};
  const std::map<std::string, CGAL::Simple_cartesian<double>::Vector_3> steps = {
    {"point", {0, 0, 0}}, {"line along an axis", {0, 0.01, 0}}, {"line", {0.01, 0.02, 0.03}}};
  for (const auto& [name, soup] : balls)
    for (const auto& [shape, step] : steps)
    {
      auto ball = to_graph<Mesh>(soup);
      const Labels halves = labels_of_halves(ball, 2, 0);
      const auto corner = halfedge_at_border(ball, halves);
      Mesh::Point next = ball.point(ball.target(corner));
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
    const auto unit_ball = icosphere(3);
    const auto ball = to_graph<Mesh>(scaled(unit_ball, size));
    const Labels halves = labels_of_halves(ball, 2, 0);
    check_faired_parts(ball, halves, 2, "ball of size " + check::as_text(size));
    for (Part part : faired_parts(ball, halves, 2))
    {
      for (Mesh::Point& p : part.points)
        p = Mesh::Point(p.x() / size, p.y() / size, p.z() / size);
      CGAL_CHECK(volume(part) > 0.6 * volume(whole(to_graph<Mesh>(unit_ball))));
    }
  }
}

} // namespace

int main()
{
  test_faired_parts();
  test_parts_without_faces();
  test_faired_parts_of_degenerate_faces();
  test_faired_parts_of_degenerate_polygons();
  test_faired_parts_of_any_size();
  return check::result();
}
