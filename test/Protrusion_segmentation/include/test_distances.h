// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What every model of ProtrusionDistance must pass.

#ifndef CGAL_TEST_PROTRUSION_SEGMENTATION_TEST_DISTANCES_H
#define CGAL_TEST_PROTRUSION_SEGMENTATION_TEST_DISTANCES_H

#include "check.h"
#include "indexed_surfaces.h"
#include "test_meshes.h"

#include <CGAL/Protrusion_segmentation/Histogram_method.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/protrusion_segmentation.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <set>
#include <vector>

namespace test_meshes {

namespace PS = CGAL::Protrusion_segmentation;

template <typename Distance>
std::vector<std::vector<double>> distance_matrix(const Indexed_surface& surface, const Distance& distance)
{
  auto distances = distance.on(surface, quiet_execution());
  std::vector<std::vector<double>> rows(surface.number_of_faces());
  for (Index f = 0; f < surface.number_of_faces(); ++f)
    distances(f, rows[f]);
  return rows;
}

inline double largest_entry(const std::vector<std::vector<double>>& d)
{
  double largest = 0;
  for (const std::vector<double>& row : d)
    largest = (std::max)(largest, *std::max_element(row.begin(), row.end()));
  return largest;
}

// Zero on the diagonal, symmetric and with the triangle inequality, up to a share of the largest.
template <typename Distance>
void check_is_a_metric(const Distance& distance, double tolerance)
{
  for (const Test_mesh& mesh : {icosphere(1), box(3, 2, 1), random_surface(4), football()})
  {
    const auto d = distance_matrix(to_surface(mesh), distance);
    const double slack = tolerance * largest_entry(d);
    std::size_t violations = 0;
    for (std::size_t i = 0; i < d.size(); ++i)
      for (std::size_t j = 0; j < d.size(); ++j)
      {
        violations += !(d[i][j] >= 0) || (i == j && d[i][j] > slack) ||
                      std::abs(d[i][j] - d[j][i]) > slack;
        for (std::size_t k = 0; k < d.size(); ++k)
          violations += !(d[i][j] <= d[i][k] + d[k][j] + slack);
      }
    CGAL_CHECK_EQUAL(violations, 0);
  }
}

// The face of eq. (1) has the largest sum that all pairs find, up to a share of it.
template <typename Distance>
void check_search_finds_the_largest_sum(const Distance& distance, double tolerance)
{
  for (const Test_mesh& mesh : {sheet(7, 5), box(3, 2, 1), random_surface(7), bumpy_sphere(2, 3),
                                single_triangle(), thin_strip(1)})
  {
    const Indexed_surface surface = to_surface(mesh);
    std::vector<double> sums;
    for (const std::vector<double>& row : distance_matrix(surface, distance))
      sums.push_back(PS::internal::distance_sum(row));
    const double largest = *std::max_element(sums.begin(), sums.end());
    const Index face = distance.on(surface, quiet_execution()).face_of_largest_sum();
    CGAL_CHECK_CLOSE(sums[face], largest, tolerance * largest);
  }
}

inline std::vector<Test_mesh> awkward_surfaces()
{
  Test_mesh two_cones = merged({tetrahedron(), translated(tetrahedron(), {3, 0, 0})});
  for (Face& face : two_cones.faces) // joined in one vertex
    for (std::size_t& v : face)
      v = v == two_cones.points.size() - 1 ? 0 : v;
  Test_mesh with_flat_faces = icosphere(1);
  with_flat_faces.points[0] = with_flat_faces.points[with_flat_faces.faces[0][1]];
  Test_mesh with_point_face = icosphere(1);
  for (const std::size_t v : with_point_face.faces[0])
    with_point_face.points[v] = with_point_face.points[with_point_face.faces[0][0]];
  Test_mesh pillow = single_triangle();
  pillow.add_face({0, 2, 1});
  Test_mesh hub; // a polygon around which triangles hang: an eigenvalue of high multiplicity
  for (std::size_t i = 0; i < 60; ++i)
    hub.add_point({std::cos(2 * pi * double(i) / 60), std::sin(2 * pi * double(i) / 60), 0});
  Face polygon;
  for (std::size_t i = 0; i < 60; ++i)
    polygon.push_back(i);
  hub.add_face(polygon);
  for (std::size_t i = 0; i < 60; ++i)
  {
    const double angle = 2 * pi * (double(i) + 0.5) / 60;
    hub.add_face({(i + 1) % 60, i, hub.add_point({2 * std::cos(angle), 2 * std::sin(angle), 0})});
  }
  return {single_triangle(),
          thin_strip(1),
          thin_strip(1, 0),
          thin_strip(300, 1e-6),
          pillow,
          hub,
          two_cones,
          with_flat_faces,
          with_point_face,
          scaled(icosphere(1), 0),
          scaled(icosphere(1), 1, 0, 0),
          scaled(icosphere(1), 1, 1, 0),
          moebius_strip(),
          l_prism(),
          pierced_plate(2, 2),
          football()};
}

// Numbers for all faces, none negative, on borders, touching and flat faces, a surface without area ...
template <typename Distance>
void check_survives_awkward_surfaces(const Distance& distance)
{
  for (const Test_mesh& mesh : awkward_surfaces())
  {
    const Indexed_surface surface = to_surface(mesh);
    auto distances = distance.on(surface, quiet_execution());
    std::vector<double> row;
    for (Index f = 0; f < surface.number_of_faces(); f += 7)
    {
      distances(f, row);
      CGAL_CHECK_EQUAL(row.size(), surface.number_of_faces());
      CGAL_CHECK(std::all_of(row.begin(), row.end(), [](double d) { return d >= 0 && !std::isnan(d); }));
    }
    CGAL_CHECK(distances.face_of_largest_sum() < surface.number_of_faces());
    CGAL_CHECK(distances.number_of_runs() > 0);
  }
}

// The share of the faces whose segment's most frequent true part is their own.
inline double share_of_right_faces(const Test_mesh& soup, const std::vector<std::size_t>& ids)
{
  std::map<std::size_t, std::map<std::size_t, std::size_t>> overlap;
  for (std::size_t f = 0; f < ids.size(); ++f)
    ++overlap[ids[f]][soup.parts[f]];
  std::size_t right = 0;
  for (const auto& [id, counts] : overlap)
    right += std::max_element(counts.begin(), counts.end(),
                              [](const auto& a, const auto& b) { return a.second < b.second; })
               ->second;
  return double(right) / double(ids.size());
}

// One tip on each arm of a star, none on the body; and as many segments as arms and a body by either
// method, with the true borders by the one that looks at more than distances.
template <typename Distance>
void check_segments_stars(const Distance& distance, std::size_t most_arms = 6, double cell = 0.22)
{
  using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
  for (std::size_t arms = 3; arms <= most_arms; ++arms)
  {
    const Test_mesh soup = star(arms, 2, 0.25, 0.04, cell);
    const Mesh mesh = to_graph<Mesh>(soup);
    std::vector<Mesh::Face_index> tips;
    CGAL::protrusion_tips(mesh, arms, std::back_inserter(tips), distance);
    std::set<std::size_t> parts_with_tip;
    for (const Mesh::Face_index tip : tips)
      parts_with_tip.insert(soup.parts[tip]);
    CGAL_CHECK_EQUAL(parts_with_tip.size(), arms);
    CGAL_CHECK_EQUAL(parts_with_tip.count(0), 0); // the body

    std::vector<std::size_t> ids(soup.faces.size());
    const auto map = boost::make_iterator_property_map(ids.begin(), get(boost::face_index, mesh));
    CGAL_CHECK_EQUAL(
      CGAL::segmentation_via_protrusion_tips(mesh, map, arms + 1, PS::Histogram_method(distance)),
      arms + 1);
    CGAL_CHECK_EQUAL(
      CGAL::segmentation_via_protrusion_tips(mesh, map, arms + 1, PS::Minimum_cut_method(distance)),
      arms + 1);
    CGAL_CHECK(share_of_right_faces(soup, ids) > 0.95);
  }
}

} // namespace test_meshes

#endif // CGAL_TEST_PROTRUSION_SEGMENTATION_TEST_DISTANCES_H
