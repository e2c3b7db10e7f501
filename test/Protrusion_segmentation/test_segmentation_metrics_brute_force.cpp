// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The metrics of random segmentations against brute force: all pairs of faces, of segments, and of
// vertices.

#include "check.h"
#include "labeled_meshes.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <set>
#include <utility>
#include <vector>

double brute_force_rand_index_error(const Labels& a, const Labels& b)
{
  double disagreements = 0, pairs = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t j = i + 1; j < a.size(); ++j, ++pairs)
      disagreements += (a[i] == a[j]) != (b[i] == b[j]);
  return disagreements / pairs;
}

// What `property(i, j)` adds up to over the faces j of the segment of face i.
double sum_over_segment(const Labels& labels,
                        std::size_t i,
                        const std::function<double(std::size_t)>& property)
{
  double sum = 0;
  for (std::size_t j = 0; j < labels.size(); ++j)
    sum += labels[i] == labels[j] ? property(j) : 0;
  return sum;
}

// Part of the segment of face i in `a` outside its segment in `b`.
double outside(const Labels& a,
               const Labels& b,
               std::size_t i,
               const std::function<double(std::size_t)>& measure)
{
  const double whole = sum_over_segment(a, i, measure);
  return sum_over_segment(a, i, [&](std::size_t j) { return b[i] == b[j] ? 0. : measure(j); }) / whole;
}

std::pair<double, double> brute_force_consistency(const Labels& a,
                                                  const Labels& b,
                                                  const std::function<double(std::size_t)>& measure)
{
  double of_a = 0, of_b = 0, of_smaller = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
  {
    of_a += outside(a, b, i, measure);
    of_b += outside(b, a, i, measure);
    of_smaller += (std::min)(outside(a, b, i, measure), outside(b, a, i, measure));
  }
  return {(std::min)(of_a, of_b) / double(a.size()), of_smaller / double(a.size())};
}

// Area of all faces but those in the best match of their segment in `a` among the segments of `b`.
double brute_force_unmatched(const Labels& a,
                             const Labels& b,
                             const std::function<double(std::size_t)>& area)
{
  double total = 0, matched = 0;
  for (const int segment : std::set<int>(a.begin(), a.end()))
  {
    double best = 0;
    for (const int other : std::set<int>(b.begin(), b.end()))
    {
      double common = 0;
      for (std::size_t i = 0; i < a.size(); ++i)
        common += a[i] == segment && b[i] == other ? area(i) : 0;
      best = (std::max)(best, common);
    }
    matched += best;
  }
  for (std::size_t i = 0; i < a.size(); ++i)
    total += area(i);
  return (total - matched) / total;
}

// Lengths of the shortest paths between all pairs of vertices, after Floyd and Warshall.
std::vector<std::vector<double>> all_pairs_distances(const Mesh& mesh)
{
  const std::size_t n = num_vertices(mesh);
  std::vector<std::vector<double>> d(n, std::vector<double>(n, std::numeric_limits<double>::infinity()));
  for (const auto h : halfedges(mesh))
    d[source(h, mesh)][target(h, mesh)] = std::sqrt(
      CGAL::squared_distance(mesh.point(source(h, mesh)), mesh.point(target(h, mesh))));
  for (std::size_t i = 0; i < n; ++i)
    d[i][i] = 0;
  for (std::size_t k = 0; k < n; ++k)
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < n; ++j)
        d[i][j] = (std::min)(d[i][j], d[i][k] + d[k][j]);
  return d;
}

// Vertices around which there are two segments; for a closed mesh the ends of border edges.
std::vector<std::size_t> brute_force_border(const Mesh& mesh, const Labels& labels)
{
  std::vector<std::size_t> result;
  for (const Vertex v : vertices(mesh))
  {
    std::set<int> around;
    for (const Face f : CGAL::faces_around_target(halfedge(v, mesh), mesh))
      around.insert(labels[f]);
    if (around.size() > 1)
      result.push_back(v);
  }
  return result;
}

// For meshes of triangles of one size whose center is the mean of their centroids.
double brute_force_cut_discrepancy(const Mesh& mesh, const Labels& a, const Labels& b)
{
  const auto d = all_pairs_distances(mesh);
  const auto border_a = brute_force_border(mesh, a), border_b = brute_force_border(mesh, b);
  double sum = 0;
  for (const std::size_t v : border_a)
    sum += d[v][*std::min_element(border_b.begin(), border_b.end(),
                                  [&](auto x, auto y) { return d[v][x] < d[v][y]; })];
  for (const std::size_t v : border_b)
    sum += d[v][*std::min_element(border_a.begin(), border_a.end(),
                                  [&](auto x, auto y) { return d[v][x] < d[v][y]; })];
  std::vector<Point> centroids;
  for (const Face f : faces(mesh))
  {
    std::vector<Point> corners;
    for (const Vertex v : CGAL::vertices_around_face(halfedge(f, mesh), mesh))
      corners.push_back(mesh.point(v));
    centroids.push_back(CGAL::centroid(corners[0], corners[1], corners[2]));
  }
  CGAL::Vector_3<Kernel> center(0, 0, 0);
  for (const Point& p : centroids)
    center = center + (p - CGAL::ORIGIN) / double(centroids.size());
  double radius = 0;
  for (const Point& p : centroids)
    radius += std::sqrt((p - CGAL::ORIGIN - center).squared_length()) / double(centroids.size());
  return sum / double(border_a.size() + border_b.size()) / radius;
}

void check_against_brute_force(const Mesh& mesh, const Labels& a, const Labels& b)
{
  const auto area_map = [&](std::size_t i)
  {
    std::vector<Point> corners;
    for (const Vertex v : CGAL::vertices_around_face(halfedge(Face(unsigned(i)), mesh), mesh))
      corners.push_back(mesh.point(v));
    return std::sqrt(CGAL::squared_area(corners[0], corners[1], corners[2]));
  };
  const auto one = [](std::size_t) { return 1.; };
  const Metrics m = metrics_of(mesh, a, b);
  CGAL_CHECK_CLOSE(m.rand_index_error, brute_force_rand_index_error(a, b), exact);
  CGAL_CHECK_CLOSE(m.hamming_distance.missing_rate, brute_force_unmatched(b, a, area_map), exact);
  CGAL_CHECK_CLOSE(m.hamming_distance.false_alarm_rate, brute_force_unmatched(a, b, area_map), exact);
  CGAL_CHECK_CLOSE(m.consistency_error.global, brute_force_consistency(a, b, one).first, exact);
  CGAL_CHECK_CLOSE(m.consistency_error.local, brute_force_consistency(a, b, one).second, exact);
}

// All triangles have one size, so what is weighted by area equals what is counted.
void test_icosahedron()
{
  const Mesh mesh = icosahedron();
  for (unsigned int seed = 0; seed < 50; ++seed)
  {
    const Labels a = random_labels(20, 2 + int(seed % 7), seed);
    const Labels b = random_labels(20, 2 + int(seed % 5), seed + 1000);
    check_against_brute_force(mesh, a, b);
    const Metrics m = metrics_of(mesh, a, b);
    CGAL_CHECK_CLOSE(m.cut_discrepancy.value(), brute_force_cut_discrepancy(mesh, a, b), exact);
    CGAL_CHECK_CLOSE(m.consistency_error.global_by_area, m.consistency_error.global, exact);
    CGAL_CHECK_CLOSE(m.consistency_error.local_by_area, m.consistency_error.local, exact);
  }
}

Mesh pyramid(std::size_t base)
{
  Mesh mesh;
  CGAL::make_pyramid(base, mesh, Point(0.3, 0, 0), 2., 1.5, false);
  return mesh;
}

void test_triangles_of_many_sizes()
{
  Mesh mesh = pyramid(16);
  std::mt19937 random(7);
  for (const Vertex v : vertices(mesh))
    mesh.point(v) = mesh.point(v) +
                    Kernel::Vector_3(double(random() % 100) / 200, double(random() % 100) / 200, 0);
  for (unsigned int seed = 0; seed < 20; ++seed)
    check_against_brute_force(mesh, random_labels(num_faces(mesh), 4, seed),
                              random_labels(num_faces(mesh), 3, seed + 50));
}

int main()
{
  test_icosahedron();
  test_triangles_of_many_sizes();
  return check::result();
}
