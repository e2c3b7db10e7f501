// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The metrics of two segmentations: values found by hand, and the corner cases that the
// documentation defines.

#include "check.h"
#include "labeled_meshes.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Polyhedron_items_with_id_3.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/copy_face_graph.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <stdexcept>
#include <vector>

void check_same(const Metrics& a, const Metrics& b, double tolerance = 0)
{
  CGAL_CHECK_CLOSE(a.rand_index_error, b.rand_index_error, tolerance);
  CGAL_CHECK_CLOSE(a.hamming_distance.distance, b.hamming_distance.distance, tolerance);
  CGAL_CHECK_CLOSE(a.hamming_distance.missing_rate, b.hamming_distance.missing_rate, tolerance);
  CGAL_CHECK_CLOSE(a.hamming_distance.false_alarm_rate, b.hamming_distance.false_alarm_rate, tolerance);
  CGAL_CHECK_EQUAL(a.cut_discrepancy.has_value(), b.cut_discrepancy.has_value());
  CGAL_CHECK_CLOSE(a.cut_discrepancy.value_or(0), b.cut_discrepancy.value_or(0), tolerance);
  CGAL_CHECK_CLOSE(a.consistency_error.global, b.consistency_error.global, tolerance);
  CGAL_CHECK_CLOSE(a.consistency_error.local, b.consistency_error.local, tolerance);
  CGAL_CHECK_CLOSE(a.consistency_error.global_by_area, b.consistency_error.global_by_area, tolerance);
  CGAL_CHECK_CLOSE(a.consistency_error.local_by_area, b.consistency_error.local_by_area, tolerance);
  CGAL_CHECK_CLOSE(a.mean_best_intersection_over_union, b.mean_best_intersection_over_union, tolerance);
}

// All but the cut discrepancy, which is checked apart.
void check_no_error(const Metrics& metrics)
{
  Metrics none;
  none.cut_discrepancy = metrics.cut_discrepancy;
  check_same(metrics, none);
}

// In Release, too, where comparisons with what is no number would make segmentations equal.
void test_coordinates_that_are_not_finite()
{
  for (const double wrong : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()})
  {
    Mesh mesh = strip_of_squares(4);
    mesh.point(Vertex(5)) = Point(wrong, 0, 0);
    CGAL_CHECK_THROWS_WITH(metrics_of(mesh, {0, 1, 1, 1}, {0, 0, 1, 1}), std::invalid_argument,
                      "mesh: vertex 5 has a coordinate that is not finite");
    CGAL_CHECK_THROWS_WITH(metrics_of(mesh, {0, 0, 0, 0}, {0, 0, 1, 1}), std::invalid_argument, "vertex 5");
  }
}

// Four squares, cut after the first or after the second: worked out on paper.
void test_strip_by_hand()
{
  const Metrics m = metrics_of(strip_of_squares(4), {0, 1, 1, 1}, {0, 0, 1, 1});

  // 3 + 2 pairs within segments, 1 of them in both, of 6 pairs
  CGAL_CHECK_CLOSE(m.rand_index_error, (3 + 2 - 2 * 1) / 6., exact);
  // best covered: 1 of 2 and 2 of 2 of the reference; 1 of 1 and 2 of 3 of the segments
  CGAL_CHECK_CLOSE(m.hamming_distance.missing_rate, 1 / 4., exact);
  CGAL_CHECK_CLOSE(m.hamming_distance.false_alarm_rate, 1 / 4., exact);
  CGAL_CHECK_CLOSE(m.hamming_distance.distance, 1 / 4., exact);
  // overlaps 1 = {a}, 1 = {b}, 2 = {c, d}: of the segments 0, 2/3, 1/3 lie outside,
  // of the reference's 1/2, 1/2, 0
  CGAL_CHECK_CLOSE(m.consistency_error.global, (std::min)(2 / 3. + 2 / 3., 1 / 2. + 1 / 2.) / 4, exact);
  CGAL_CHECK_CLOSE(m.consistency_error.local, (0 + 1 / 2. + 0) / 4, exact);
  CGAL_CHECK_CLOSE(m.consistency_error.global_by_area, m.consistency_error.global, exact);
  CGAL_CHECK_CLOSE(m.consistency_error.local_by_area, m.consistency_error.local, exact);
  // of {a, b}: 1 of {a}, 1 of 4 of {b, c, d} are common; of {c, d}: 2 of 3
  CGAL_CHECK_CLOSE(m.mean_best_intersection_over_union, (1 / 2. + 2 / 3.) / 2, exact);
  // both borders have 2 points at a distance of 1; centroids at -3/2, -1/2, 1/2, 3/2 of the middle
  CGAL_CHECK_CLOSE(m.cut_discrepancy.value(), 1 / 1., exact);
}

// The best segment may be one for many parts; what has a negative id is no part; faces are counted.
void test_mean_best_intersection_over_union_by_hand()
{
  const auto mean = [](const Labels& segments, const Labels& reference)
  { return metrics_of(strip_of_squares(6), segments, reference).mean_best_intersection_over_union; };
  CGAL_CHECK_CLOSE(mean({0, 0, 0, 0, 0, 0}, {0, 0, 0, 1, 1, 2}), (3 / 6. + 2 / 6. + 1 / 6.) / 3, exact);
  CGAL_CHECK_CLOSE(mean({0, 0, 0, 1, 1, 2}, {0, 0, 0, 0, 0, 0}), 3 / 6., exact);
  CGAL_CHECK_CLOSE(mean({0, 0, 1, 1, 2, 2}, {7, 7, 7, 5, 5, 5}), 2 / 3., exact);
  CGAL_CHECK_EQUAL(mean({0, 0, 1, 1, 2, 3}, {4, 4, 9, 9, -1, -1}), 1);
  CGAL_CHECK_CLOSE(mean({0, 0, 0, 1, 1, 1}, {4, 4, -1, 9, 9, 9}), (2 / 3. + 1) / 2, exact);
  CGAL_CHECK_CLOSE(mean({-1, -1, -1, 1, 1, 1}, {4, 4, 4, 9, 9, 9}), 1, exact); // of the segments all count
  CGAL_CHECK_EQUAL(mean({0, 0, 0, 0, 0, 0}, {-1, -1, -1, -1, -1, -1}), 1);
}

// Two triangles of area 1/2 at the ends of a rectangle of area 3, which has one half of it each.
void test_areas_by_hand()
{
  Mesh mesh;
  const auto add = [&](double x, double y) { return mesh.add_vertex(Point(x, y, 0)); };
  const Vertex a = add(0, 0), b = add(1, 0), c = add(4, 0), d = add(5, 0), e = add(4, 1), f = add(1, 1);
  mesh.add_face(a, b, f);
  mesh.add_face(b, c, e, f);
  mesh.add_face(c, d, e);
  const Metrics m = metrics_of(mesh, {0, 0, 1}, {0, 1, 1});

  CGAL_CHECK_CLOSE(m.rand_index_error, 2 / 3., exact);
  CGAL_CHECK_CLOSE(m.hamming_distance.missing_rate, 0.5 / 4, exact);
  CGAL_CHECK_CLOSE(m.hamming_distance.false_alarm_rate, 0.5 / 4, exact);
  // by faces: 1/2, 1/2, 0 of the segments lie outside, 0, 1/2, 1/2 of the reference's
  CGAL_CHECK_CLOSE(m.consistency_error.global, 1 / 3., exact);
  CGAL_CHECK_CLOSE(m.consistency_error.local, (0 + 1 / 2. + 0) / 3, exact);
  // by area: 6/7, 1/7, 0 and 0, 1/7, 6/7, each counted as one face
  CGAL_CHECK_CLOSE(m.consistency_error.global_by_area, 1 / 3., exact);
  CGAL_CHECK_CLOSE(m.consistency_error.local_by_area, (0 + 1 / 7. + 0) / 3, exact);
  // all four border points are 3 away; the centroids are (2/3, 1/3), (5/2, 1/2) and (13/3, 1/3), of
  // the surface (5/2, 11/24)
  const double radius = (2 * 0.5 * std::hypot(11 / 6., 1 / 8.) + 3 * (1 / 24.)) / 4;
  CGAL_CHECK_CLOSE(m.cut_discrepancy.value(), 3 / radius, exact);
}

// What fails to compile with one line, and what is accepted.
void test_kinds_of_segment_id_maps()
{
  using CGAL::Protrusion_segmentation::internal::Is_segment_id_map;
  using Read = boost::readable_property_map_tag;
  using Write = boost::writable_property_map_tag;
  using Ids = Mesh::Property_map<Face, std::size_t>;
  CGAL_CHECK(Is_segment_id_map<Mesh, Ids, Read>::value);
  CGAL_CHECK(Is_segment_id_map<Mesh, Ids, Write>::value);
  CGAL_CHECK(Is_segment_id_map<Mesh, boost::associative_property_map<std::map<Face, char>>, Read>::value);
  CGAL_CHECK(Is_segment_id_map<Mesh, boost::static_property_map<int, Face>, Read>::value);
  CGAL_CHECK(!Is_segment_id_map<Mesh, boost::static_property_map<int, Face>, Write>::value);
  CGAL_CHECK(!Is_segment_id_map<Mesh, Mesh::Property_map<Face, double>, Read>::value);
  CGAL_CHECK(!Is_segment_id_map<Mesh, Mesh::Property_map<Vertex, int>, Read>::value);
  CGAL_CHECK(!Is_segment_id_map<Mesh, std::vector<int>, Read>::value);
  CGAL_CHECK(!Is_segment_id_map<Mesh, std::map<Face, int>, Read>::value);
  CGAL_CHECK(!Is_segment_id_map<Mesh, int, Read>::value);
}

Mesh scaled(Mesh mesh, int exponent)
{
  for (const Vertex v : vertices(mesh))
  {
    const Point& p = mesh.point(v);
    mesh.point(v) = Point(std::ldexp(p.x(), exponent), std::ldexp(p.y(), exponent),
                          std::ldexp(p.z(), exponent));
  }
  return mesh;
}

// Triangles of different sizes on a pentagon that is not plane, away from the origin.
Mesh tent()
{
  Mesh mesh;
  const auto add = [&](double x, double y, double z)
  { return mesh.add_vertex(Point(x + 3, y - 2, z + 1)); };
  const Vertex a = add(0, 0, 0), b = add(2, 0, .1), c = add(2.3, 1.1, 0), d = add(1, 2, -.2),
               e = add(-.3, 1, .1);
  const Vertex top = add(1, .9, 1.7);
  mesh.add_face(a, b, top);
  mesh.add_face(b, c, top);
  mesh.add_face(c, d, top);
  mesh.add_face(d, e, top);
  mesh.add_face(e, a, top);
  mesh.add_face(std::vector<Vertex>{a, e, d, c, b});
  return mesh;
}

// To the last bit: a power of two changes no digit.
void check_scale_does_not_matter(const Mesh& mesh, const Labels& a, const Labels& b)
{
  const Metrics expected = metrics_of(mesh, a, b);
  CGAL_CHECK(expected.hamming_distance.distance > 0);
  CGAL_CHECK(expected.consistency_error.local_by_area > 0);
  CGAL_CHECK(expected.cut_discrepancy.value_or(0) > 0);
  for (const int exponent :
       {-1000, -510, -300, -269, -267, -100, -1, 1, 100, 200, 253, 255, 300, 510, 1000})
    check_same(metrics_of(scaled(mesh, exponent), a, b), expected);
}

void test_scale_does_not_matter()
{
  check_scale_does_not_matter(strip_of_squares(4), {0, 1, 1, 1}, {0, 0, 1, 1});
  check_scale_does_not_matter(icosahedron(), {0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1},
                              {1, 1, 1, 1, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1, 1, 1});
  check_scale_does_not_matter(tent(), {0, 0, 1, 1, 1, 1}, {0, 1, 1, 0, 0, 0});
}

// The single functions, on columns against rows of four squares: worked out on paper.
void test_huge_and_tiny_squares_by_hand()
{
  for (const double side : {1., 1e80, 1e150, 1e300, 1e-90, 1e-150, 1e-300})
  {
    Mesh mesh;
    std::vector<Vertex> v;
    for (int i = 0; i < 9; ++i)
      v.push_back(mesh.add_vertex(Point(i % 3 * side, i / 3 * side, 0)));
    for (const std::size_t i : {0u, 1u, 3u, 4u})
      mesh.add_face(v[i], v[i + 1], v[i + 4], v[i + 3]);
    const Face_labels<Mesh> columns(mesh, {0, 1, 0, 1}), rows(mesh, {0, 0, 1, 1});
    CGAL_CHECK_CLOSE(
      CGAL::Protrusion_segmentation::segmentation_hamming_distance(mesh, columns.map(), rows.map())
        .distance,
      1 / 2., exact);
    const auto consistency = CGAL::Protrusion_segmentation::segmentation_consistency_error(
      mesh, columns.map(), rows.map());
    CGAL_CHECK_CLOSE(consistency.global_by_area, 1 / 2., exact);
    CGAL_CHECK_CLOSE(consistency.local_by_area, 1 / 2., exact);
    // of the three points of each border, the two at the ends are 1 from the middle of the other one; all centroids
    // are as far from the middle
    CGAL_CHECK_CLOSE(
      CGAL::Protrusion_segmentation::segmentation_cut_discrepancy(mesh, columns.map(), rows.map())
        .value_or(0),
      2 / 3. / std::sqrt(1 / 2.), exact);
  }
}

void test_same_segmentation_up_to_ids()
{
  const Mesh mesh = icosahedron();
  const Labels labels = random_labels(20, 4, 3);
  Labels renamed;
  for (const int label : labels)
    renamed.push_back(std::vector<int>{-5, (std::numeric_limits<int>::max)(), 1000, 0}[std::size_t(label)]);
  const Metrics m = metrics_of(mesh, labels, renamed);
  check_no_error(m);
  CGAL_CHECK_EQUAL(m.cut_discrepancy.value(), 0);
  check_same(metrics_of(mesh, renamed, random_labels(20, 3, 8)),
             metrics_of(mesh, labels, random_labels(20, 3, 8)));
}

void test_exchange()
{
  const Mesh mesh = icosahedron();
  const Labels a = random_labels(20, 4, 1), b = random_labels(20, 3, 2);
  Metrics exchanged = metrics_of(mesh, b, a);
  std::swap(exchanged.hamming_distance.missing_rate, exchanged.hamming_distance.false_alarm_rate);
  const Metrics metrics = metrics_of(mesh, a, b);
  exchanged.mean_best_intersection_over_union = metrics.mean_best_intersection_over_union;
  check_same(metrics, exchanged, exact);
}

void test_one_segment()
{
  const Mesh mesh = icosahedron();
  const Labels one(20, 9), halves = {0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1};
  const Metrics m = metrics_of(mesh, one, halves);
  CGAL_CHECK_CLOSE(m.rand_index_error, 100 / 190., exact);
  CGAL_CHECK_EQUAL(m.hamming_distance.missing_rate, 0);
  CGAL_CHECK_CLOSE(m.hamming_distance.false_alarm_rate, 0.5, exact);
  CGAL_CHECK(!m.cut_discrepancy.has_value());
  CGAL_CHECK_EQUAL(m.consistency_error.global, 0);
  CGAL_CHECK_EQUAL(m.consistency_error.local_by_area, 0);
  CGAL_CHECK(!metrics_of(mesh, halves, one).cut_discrepancy.has_value());
  check_no_error(metrics_of(mesh, one, one));
  CGAL_CHECK(!metrics_of(mesh, one, one).cut_discrepancy.has_value());
}

void test_as_many_segments_as_faces()
{
  const Mesh mesh = icosahedron();
  Labels all;
  for (int i = 0; i < 20; ++i)
    all.push_back(100 * i);
  const Metrics m = metrics_of(mesh, all, Labels(20, 0));
  CGAL_CHECK_EQUAL(m.rand_index_error, 1);
  CGAL_CHECK_CLOSE(m.hamming_distance.missing_rate, 19 / 20., exact);
  CGAL_CHECK_CLOSE(m.hamming_distance.false_alarm_rate, 0, exact);
  CGAL_CHECK_CLOSE(m.consistency_error.global, 0, exact);
  CGAL_CHECK(!m.cut_discrepancy.has_value());
  check_no_error(metrics_of(mesh, all, all));
}

void test_empty_mesh_and_few_faces()
{
  const Metrics empty = metrics_of(Mesh(), {}, {});
  check_no_error(empty);
  CGAL_CHECK(!empty.cut_discrepancy.has_value());
  check_no_error(metrics_of(strip_of_squares(1), {4}, {5}));
  CGAL_CHECK_EQUAL(metrics_of(strip_of_squares(2), {0, 0}, {0, 1}).rand_index_error, 1);
  check_no_error(metrics_of(strip_of_squares(2), {0, 1}, {1, 0}));
}

void test_mesh_without_area()
{
  Mesh mesh = strip_of_squares(3);
  for (const Vertex v : vertices(mesh))
    mesh.point(v) = Point(mesh.point(v).x(), 0, 0);
  const Metrics m = metrics_of(mesh, {0, 0, 1}, {0, 1, 1});
  CGAL_CHECK_CLOSE(m.rand_index_error, 2 / 3., exact);
  CGAL_CHECK_EQUAL(m.hamming_distance.distance, 0);
  CGAL_CHECK_EQUAL(m.consistency_error.local_by_area, 0);
  CGAL_CHECK_CLOSE(m.consistency_error.global, 1 / 3., exact);
  CGAL_CHECK(!m.cut_discrepancy.has_value());
}

void test_disconnected_mesh()
{
  Mesh mesh = strip_of_squares(3);
  CGAL::copy_face_graph(strip_of_squares(3), mesh);
  const Metrics both = metrics_of(mesh, {0, 1, 1, 2, 2, 3}, {0, 0, 1, 2, 3, 3});
  CGAL_CHECK(both.cut_discrepancy.has_value());
  // a border on one side only in the second component: it cannot be reached
  CGAL_CHECK(!metrics_of(mesh, {0, 1, 1, 2, 2, 3}, {0, 0, 1, 2, 2, 2}).cut_discrepancy.has_value());
  CGAL_CHECK(!metrics_of(mesh, {0, 1, 1, 2, 2, 2}, {0, 0, 0, 2, 2, 3}).cut_discrepancy.has_value());
  // no border in the second component on either side
  CGAL_CHECK(metrics_of(mesh, {0, 1, 1, 2, 2, 2}, {0, 0, 1, 2, 2, 2}).cut_discrepancy.has_value());
  // a segment may span components
  CGAL_CHECK_CLOSE(metrics_of(mesh, {0, 0, 0, 0, 0, 0}, {0, 0, 0, 1, 1, 1}).hamming_distance.false_alarm_rate,
              0.5, exact);
}

void test_isolated_vertices_and_removed_faces()
{
  Mesh mesh = strip_of_squares(5);
  const Metrics expected = metrics_of(strip_of_squares(4), {0, 1, 1, 1}, {0, 0, 1, 1});
  mesh.add_vertex(Point(100, 0, 0));
  mesh.add_vertex(Point(0, 1e300, 0)); // beside it, all else would have no area
  CGAL::Euler::remove_face(halfedge(*std::prev(faces(mesh).end()), mesh), mesh);
  check_same(metrics_of(mesh, {0, 1, 1, 1}, {0, 0, 1, 1}), expected, exact);
}

template <typename FaceGraph>
void check_mesh_type(double tolerance)
{
  FaceGraph mesh;
  CGAL::copy_face_graph(icosahedron(), mesh);
  const Labels a = random_labels(20, 4, 5), b = random_labels(20, 3, 6);
  check_same(metrics_of(mesh, a, b), metrics_of(icosahedron(), a, b), tolerance);
}

void test_mesh_types()
{
  using Exact_kernel = CGAL::Exact_predicates_exact_constructions_kernel;
  check_mesh_type<CGAL::Polyhedron_3<Kernel>>(exact);
  check_mesh_type<CGAL::Polyhedron_3<Kernel, CGAL::Polyhedron_items_with_id_3>>(exact);
  check_mesh_type<CGAL::Surface_mesh<Exact_kernel::Point_3>>(exact);
  check_mesh_type<CGAL::Surface_mesh<CGAL::Simple_cartesian<float>::Point_3>>(1e-6);
}

void test_single_functions_agree_with_all_at_once()
{
  Mesh mesh = icosahedron();
  const auto a = mesh.add_property_map<Face, std::uint8_t>("f:a", 0).first;
  const auto b = mesh.add_property_map<Face, long>("f:b", 0).first;
  for (const Face f : faces(mesh))
  {
    put(a, f, std::uint8_t(f % 3 * 100));
    put(b, f, -long(f / 7));
  }
  Metrics apart;
  apart.rand_index_error = CGAL::Protrusion_segmentation::segmentation_rand_index_error(mesh, a, b);
  apart.hamming_distance = CGAL::Protrusion_segmentation::segmentation_hamming_distance(mesh, a, b);
  apart.cut_discrepancy = CGAL::Protrusion_segmentation::segmentation_cut_discrepancy(mesh, a, b);
  apart.consistency_error = CGAL::Protrusion_segmentation::segmentation_consistency_error(mesh, a, b);
  apart.mean_best_intersection_over_union = CGAL::Protrusion_segmentation::mean_best_intersection_over_union(mesh, a, b);
  check_same(apart, CGAL::Protrusion_segmentation::segmentation_metrics(mesh, a, b));
}

void test_named_parameters()
{
  Mesh mesh = strip_of_squares(4);
  auto stretched = mesh.add_property_map<Vertex, Point>("v:stretched").first;
  auto reversed = mesh.add_property_map<Vertex, std::size_t>("v:reversed").first;
  for (const Vertex v : vertices(mesh))
  {
    const Point& p = mesh.point(v);
    put(stretched, v, Point(p.x() < 2 ? p.x() : 10 * p.x() - 18, p.y(), p.z()));
    put(reversed, v, num_vertices(mesh) - 1 - v);
  }
  const Face_labels<Mesh> a(mesh, {0, 1, 1, 1}), b(mesh, {0, 0, 1, 1});
  const Metrics m = CGAL::Protrusion_segmentation::segmentation_metrics(
    mesh, a.map(), b.map(), CGAL::parameters::vertex_point_map(stretched).vertex_index_map(reversed));
  CGAL_CHECK_CLOSE(m.hamming_distance.missing_rate, 1 / 22., exact);
  // centroids 1/2, 3/2, 7, 17 with areas 1, 1, 10, 10
  const double center = (0.5 + 1.5 + 70 + 170) / 22;
  const double radius = (center - 0.5 + center - 1.5 + 10 * (center - 7) + 10 * (17 - center)) / 22;
  CGAL_CHECK_CLOSE(m.cut_discrepancy.value(), 1 / radius, exact);
}

int main()
{
  test_coordinates_that_are_not_finite();
  test_strip_by_hand();
  test_mean_best_intersection_over_union_by_hand();
  test_areas_by_hand();
  test_kinds_of_segment_id_maps();
  test_scale_does_not_matter();
  test_huge_and_tiny_squares_by_hand();
  test_same_segmentation_up_to_ids();
  test_exchange();
  test_one_segment();
  test_as_many_segments_as_faces();
  test_empty_mesh_and_few_faces();
  test_mesh_without_area();
  test_disconnected_mesh();
  test_isolated_vertices_and_removed_faces();
  test_mesh_types();
  test_single_functions_agree_with_all_at_once();
  test_named_parameters();
  return check::result();
}
