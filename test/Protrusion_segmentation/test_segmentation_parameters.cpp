// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Named parameters, options, several components, and what is refused.

#include "segmentations.h"
#include "star_mesh.h"

#include <boost/property_map/function_property_map.hpp>

using namespace test_meshes;
using namespace CGAL::Protrusion_segmentation;
namespace parameters = CGAL::parameters;

// Automatic number of segments.
template <typename FaceGraph>
Segmentation evident_protrusions(const FaceGraph& mesh,
                                 const Histogram_method& method = Histogram_method())
{
  return checked(mesh,
                 [&](auto ids) { return CGAL::segmentation_via_protrusion_tips(mesh, ids, method); });
}

Segmentation landmark_segmentation(
  const Mesh& mesh,
  std::size_t k,
  unsigned int seed,
  const Landmark_geodesic_distance& distance = Landmark_geodesic_distance())
{
  return checked(mesh,
                 [&](auto ids)
                 {
                   return CGAL::segmentation_via_protrusion_tips(mesh, ids, k, Histogram_method(distance),
                                                                 parameters::random_seed(seed));
                 });
}

// All arms are evident, and what it finds in them when it goes on ends somewhere.
void the_method_stops_by_itself()
{
  const Segmentation found = evident_protrusions(star_mesh());
  CGAL_CHECK(found.number >= 5 && found.number < star_soup().faces.size());
  CGAL_CHECK(share_in_true_parts(star_soup(), found.labels) > 0.9);
  CGAL_CHECK_EQUAL(evident_protrusions(to_graph<Mesh>(open_cylinder(1, 1))).number, 1);
  CGAL_CHECK_EQUAL(evident_protrusions(to_graph<Mesh>(regular_prism(40))).number, 1);
}

void the_same_seed_gives_the_same_landmarks()
{
  const Segmentation first = landmark_segmentation(star_mesh(), 5, 7);
  CGAL_CHECK_EQUAL(first.number, 5);
  CGAL_CHECK(share_in_true_parts(star_soup(), first.labels) > 0.95);
  CGAL_CHECK(landmark_segmentation(star_mesh(), 5, 7).labels == first.labels);
  for (const double fraction : {0.01, 0.1})
    CGAL_CHECK_EQUAL(landmark_segmentation(star_mesh(), 5, 1, Landmark_geodesic_distance(fraction)).number, 5);
  // with few landmarks another seed gives another segmentation, sooner or later
  const auto two = Landmark_geodesic_distance::with_number_of_landmarks(2);
  bool differs = false;
  for (unsigned int seed = 1; seed < 20; ++seed)
    differs = differs || landmark_segmentation(star_mesh(), 5, seed, two).labels !=
                           landmark_segmentation(star_mesh(), 5, 0, two).labels;
  CGAL_CHECK(differs);
}

void points_are_read_from_the_map()
{
  const Test_mesh& soup = star_soup();
  const Mesh flat = to_graph<Mesh>(scaled(soup, 1, 1, 0));
  std::vector<Kernel::Point_3> points;
  for (const Point& p : soup.points)
    points.emplace_back(p[0], p[1], p[2]);
  const auto map = boost::make_function_property_map<Mesh::Vertex_index>([&](Mesh::Vertex_index v)
                                                                         { return points[v]; });
  CGAL_CHECK(paper_segmentation(flat, 5, parameters::vertex_point_map(map)).labels ==
        paper_segmentation(star_mesh(), 5).labels);
}

void borders_are_the_edges_between_segments()
{
  const Mesh& mesh = star_mesh();
  std::map<Mesh::Edge_index, bool> is_border;
  const auto map = boost::make_assoc_property_map(is_border);
  const Segmentation found = paper_segmentation(mesh, 5, parameters::edge_is_constrained_map(map));
  CGAL_CHECK_EQUAL(is_border.size(), num_edges(mesh));
  std::size_t number = 0;
  for (const auto& item : is_border)
  {
    const auto h = halfedge(item.first, mesh);
    CGAL_CHECK_EQUAL(item.second, found.labels[face(h, mesh)] != found.labels[face(opposite(h, mesh), mesh)]);
    number += item.second;
  }
  CGAL_CHECK(number > 4 * 10);
}

// The sheet's own border is none between segments.
void edges_with_one_face_are_no_borders()
{
  const Mesh mesh = to_graph<Mesh>(sheet(4, 4));
  std::map<Mesh::Edge_index, bool> is_border;
  paper_segmentation(mesh, 1,
                     parameters::edge_is_constrained_map(boost::make_assoc_property_map(is_border)));
  CGAL_CHECK_EQUAL(is_border.size(), num_edges(mesh));
  for (const auto& item : is_border)
    CGAL_CHECK(!item.second);
}

void every_component_is_a_segment_at_least()
{
  const Test_mesh one = star_soup();
  const Test_mesh soup = merged(
    {icosphere(2), translated(one, {8, 0, 0}), translated(sheet(3, 3), {0, 8, 0})});
  const Mesh mesh = to_graph<Mesh>(soup);
  for (const std::size_t k : {1, 2, 3})
  {
    const Segmentation found = paper_segmentation(mesh, k);
    CGAL_CHECK_EQUAL(found.number, 3);
    CGAL_CHECK_EQUAL(found.labels.front(), 1); // components have the first ids, the largest, in the middle of the faces, 0
    CGAL_CHECK_EQUAL(found.labels[icosphere(2).faces.size()], 0);
    CGAL_CHECK_EQUAL(found.labels.back(), 2);
  }
  const Segmentation found = paper_segmentation(mesh, 7);
  CGAL_CHECK_EQUAL(found.number, 7);
  CGAL_CHECK(share_in_true_parts(soup, found.labels) > 0.98);
}

void impossible_numbers_of_segments_are_refused()
{
  const Mesh mesh = to_graph<Mesh>(icosphere(1));
  Segment_ids<Mesh> ids(mesh);
  const auto segment = [&](std::size_t k)
  { return CGAL::segmentation_via_protrusion_tips(mesh, ids.map(), k, Histogram_method()); };
  CGAL_CHECK_THROWS_WITH(segment(0), std::invalid_argument, "number_of_segments is 0");
  CGAL_CHECK_THROWS_WITH(segment(81), std::invalid_argument,
                    "number_of_segments is 81, but it must be from 1 to 80, the number of faces of pmesh");
  CGAL_CHECK(is_untouched({0, ids.labels()}));
  CGAL_CHECK_EQUAL(segment(1), 1);
  const std::size_t most = segment(80); // all that can be found
  CGAL_CHECK(most >= 1 && most <= 80);
}

void impossible_options_are_refused()
{
  for (const double value : {0., -1., std::nan(""), HUGE_VAL})
    CGAL_CHECK_THROWS_WITH(Histogram_method().minimum_prominence(value), std::invalid_argument,
                      "minimum_prominence");
  CGAL_CHECK_EQUAL(Histogram_method().minimum_prominence(0.5).minimum_prominence(), 0.5);
  CGAL_CHECK(!Histogram_method().uses_candidate_intervals(false).uses_candidate_intervals());
}

void options_decide_what_is_evident()
{
  const Mesh mesh = to_graph<Mesh>(capsule_with_ball(0.15));
  CGAL_CHECK_EQUAL(evident_protrusions(mesh, Histogram_method().minimum_prominence(5)).number, 1);
  CGAL_CHECK(evident_protrusions(mesh).number > 1);
  CGAL_CHECK(evident_protrusions(mesh, Histogram_method().uses_candidate_intervals(false)).number > 1);
  // however small or large it is, a number of segments that was asked for is tried for
  for (const double prominence : {1e-3, 0.01, 5.})
    CGAL_CHECK_EQUAL(checked(mesh,
                        [&](auto ids)
                        {
                          return CGAL::segmentation_via_protrusion_tips(
                            mesh, ids, 2, Histogram_method().minimum_prominence(prominence));
                        })
                  .number,
                2);
}

int main()
{
  the_method_stops_by_itself();
  the_same_seed_gives_the_same_landmarks();
  points_are_read_from_the_map();
  borders_are_the_edges_between_segments();
  edges_with_one_face_are_no_borders();
  every_component_is_a_segment_at_least();
  impossible_numbers_of_segments_are_refused();
  impossible_options_are_refused();
  options_decide_what_is_evident();
  return check::result();
}
