// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Connected components that are too small for segments of their own change nothing, and have the segment of what is
// nearest.

#include "check.h"
#include "segmentations.h"
#include "test_meshes.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iterator>
#include <limits>
#include <vector>

using namespace test_meshes;
using namespace CGAL::Protrusion_segmentation;
using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

struct Found
{
  Segmentation segmentation;
  std::size_t number_of_small_components = 0;
};

template <typename Method, typename... Number>
Found segment(const Test_mesh& soup, const Method& method, Number... k)
{
  const Mesh mesh = to_graph<Mesh>(soup);
  Segmentation_record<Mesh> record;
  const auto np = CGAL::parameters::visitor(std::ref(record));
  Found result;
  result.segmentation = checked(
    mesh, [&](auto ids) { return CGAL::segmentation_via_protrusion_tips(mesh, ids, k..., method, np); });
  result.number_of_small_components = record.number_of_small_components();
  return result;
}

const Test_mesh& figure()
{
  static const Test_mesh mesh = star(5, 2, 0.25, 0.1, 0.2);
  return mesh;
}

// Two components beside each other, and specks: one near the first, one near the second.
const Test_mesh& bodies()
{
  static const Test_mesh mesh = merged({figure(), translated(capsule(0.5, 4, 0.3), {6, 0, 0})});
  return mesh;
}

Test_mesh with_specks(const Test_mesh& mesh)
{
  const Test_mesh speck = scaled(icosahedron(), 0.01);
  return merged({mesh, translated(speck, {-3, 0, 0}), translated(speck, {7, 0.3, 0})});
}

Labels first_labels(const Segmentation& segmentation, std::size_t number)
{
  return Labels(segmentation.labels.begin(), segmentation.labels.begin() + std::ptrdiff_t(number));
}

// Of the first faces of `mesh` the one nearest to one of those from `begin` to `end`.
std::size_t nearest_face(const Test_mesh& mesh, std::size_t number_of_first, std::size_t begin, std::size_t end)
{
  std::size_t nearest = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t f = begin; f < end; ++f)
    for (std::size_t g = 0; g < number_of_first; ++g)
    {
      const double distance = length(centroid(mesh, mesh.faces[f]) - centroid(mesh, mesh.faces[g]));
      if (distance < least)
        nearest = g;
      least = (std::min)(least, distance);
    }
  return nearest;
}

template <typename Method, typename... Number>
void check_specks(const Method& method, Number... k)
{
  const Test_mesh mesh = with_specks(bodies());
  const std::size_t faces = bodies().faces.size(), of_speck = icosahedron().faces.size();
  const Found without = segment(bodies(), method, k...), with = segment(mesh, method, k...);
  CGAL_CHECK_EQUAL(without.number_of_small_components, 0);
  CGAL_CHECK_EQUAL(with.number_of_small_components, 2);
  CGAL_CHECK_EQUAL(with.segmentation.number, without.segmentation.number);
  CGAL_CHECK(first_labels(with.segmentation, faces) == without.segmentation.labels);
  for (const std::size_t begin : {faces, faces + of_speck})
  {
    const std::size_t nearest = nearest_face(mesh, faces, begin, begin + of_speck);
    for (std::size_t f = begin; f < begin + of_speck; ++f)
      CGAL_CHECK_EQUAL(with.segmentation.labels[f], with.segmentation.labels[nearest]);
  }
  CGAL_CHECK(with.segmentation.labels[faces] != with.segmentation.labels[faces + of_speck]);
}

void specks_change_nothing()
{
  check_specks(Minimum_cut_method());
  check_specks(Minimum_cut_method(), 2);
  check_specks(Minimum_cut_method(), 5);
  check_specks(Histogram_method());
  check_specks(Histogram_method(), 2);
  check_specks(Histogram_method(), 5);
}

void a_speck_takes_no_segment_from_the_number()
{
  CGAL_CHECK_EQUAL(segment(with_specks(bodies()), Minimum_cut_method(), 2).segmentation.number, 2);
  CGAL_CHECK_EQUAL(segment(with_specks(bodies()), Minimum_cut_method(), 1).segmentation.number, 2);
  CGAL_CHECK_EQUAL(segment(with_specks(figure()), Minimum_cut_method(), 1).segmentation.number, 1);
}

void the_order_of_the_faces_does_not_matter()
{
  const Test_mesh mesh = with_specks(bodies());
  const Segmentation one = segment(mesh, Minimum_cut_method(), 6).segmentation;
  for (std::uint_fast32_t seed = 0; seed < 3; ++seed)
  {
    const std::vector<std::size_t> order = random_permutation(mesh.faces.size(), seed);
    const Segmentation found = segment(with_face_order(mesh, order), Minimum_cut_method(), 6).segmentation;
    CGAL_CHECK_EQUAL(found.number, one.number);
    for (std::size_t i = 0; i < order.size(); ++i)
      CGAL_CHECK_EQUAL(found.labels[i], one.labels[order[i]]);
  }
}

void units_do_not_matter()
{
  const Test_mesh mesh = with_specks(bodies());
  const Segmentation one = segment(mesh, Minimum_cut_method(), 6).segmentation;
  for (const double unit : {std::ldexp(1., -600), std::ldexp(1., 600)})
    CGAL_CHECK(segment(scaled(mesh, unit), Minimum_cut_method(), 6).segmentation.labels == one.labels);
}

void components_that_are_alike_are_no_specks()
{
  std::vector<Test_mesh> links;
  for (int i = 0; i < 2000; ++i)
    links.push_back(translated(tetrahedron(), {3. * i, 0, 0}));
  const Found found = segment(merged(links), Minimum_cut_method(), 1);
  CGAL_CHECK_EQUAL(found.segmentation.number, 2000);
  CGAL_CHECK_EQUAL(found.number_of_small_components, 0);
}

// It is small beside the floor, but has more faces.
void a_figure_on_a_large_floor_is_no_speck()
{
  const Test_mesh floor = translated(sheet(3, 3, 300, 300), {-450, -450, -4});
  const Found found = segment(merged({figure(), floor}), Minimum_cut_method());
  const Found alone = segment(figure(), Minimum_cut_method());
  CGAL_CHECK_EQUAL(found.segmentation.number, alone.segmentation.number + 1);
  CGAL_CHECK_EQUAL(found.number_of_small_components, 0);
}

void hierarchies_have_no_segments_for_specks()
{
  const Mesh without = to_graph<Mesh>(bodies()), with = to_graph<Mesh>(with_specks(bodies()));
  const Segment_hierarchy expected = CGAL::protrusion_hierarchy(without, 6), found = CGAL::protrusion_hierarchy(with, 6);
  CGAL_CHECK_EQUAL(found.minimum_number_of_segments(), 2);
  CGAL_CHECK_EQUAL(found.maximum_number_of_segments(), expected.maximum_number_of_segments());
  for (std::size_t k = 2; k <= expected.maximum_number_of_segments(); ++k)
  {
    Segment_ids<Mesh> ids(with), expected_ids(without);
    found.segment_ids(with, k, ids.map());
    expected.segment_ids(without, k, expected_ids.map());
    const Labels labels = ids.labels();
    CGAL_CHECK(Labels(labels.begin(), labels.begin() + std::ptrdiff_t(bodies().faces.size())) == expected_ids.labels());
    CGAL_CHECK(*std::max_element(labels.begin(), labels.end()) == k - 1);
  }
}

std::vector<std::size_t> tips_of(const Test_mesh& soup, std::size_t number)
{
  const Mesh mesh = to_graph<Mesh>(soup);
  std::vector<Mesh::Face_index> tips;
  CGAL::protrusion_tips(mesh, number, std::back_inserter(tips));
  return std::vector<std::size_t>(tips.begin(), tips.end());
}

void specks_have_no_tips()
{
  CGAL_CHECK(tips_of(with_specks(bodies()), 8) == tips_of(bodies(), 8));
  CGAL_CHECK_EQUAL(tips_of(bodies(), 8).size(), 8);
}

// A tip on a speck is one on the face that is nearest to it: here, at the tip of a protrusion.
template <typename Method>
void check_tip_on_speck(const Method& method)
{
  const std::size_t faces = bodies().faces.size();
  const Point tip = centroid(bodies(), bodies().faces[tips_of(bodies(), 1).front()]);
  const Test_mesh speck = translated(scaled(icosahedron(), 0.001), tip);
  const Test_mesh soup = merged({bodies(), speck});
  const Mesh mesh = to_graph<Mesh>(soup);
  const auto segment_from = [&](std::size_t face)
  {
    const std::vector<Mesh::Face_index> tips = {Mesh::Face_index(static_cast<Mesh::size_type>(face))};
    return checked(mesh, [&](auto ids) { return CGAL::segmentation_from_protrusion_tips(mesh, tips, ids, method); });
  };
  const Segmentation found = segment_from(faces);
  CGAL_CHECK_EQUAL(found.number, 3);
  CGAL_CHECK_EQUAL(found.labels[faces], 2);
  CGAL_CHECK(found.labels == segment_from(nearest_face(soup, faces, faces, soup.faces.size())).labels);
}

void tips_on_specks_are_tips_beside_them()
{
  check_tip_on_speck(Minimum_cut_method());
  check_tip_on_speck(Histogram_method());
}

int main()
{
  specks_change_nothing();
  a_speck_takes_no_segment_from_the_number();
  the_order_of_the_faces_does_not_matter();
  units_do_not_matter();
  components_that_are_alike_are_no_specks();
  a_figure_on_a_large_floor_is_no_speck();
  hierarchies_have_no_segments_for_specks();
  specks_have_no_tips();
  tips_on_specks_are_tips_beside_them();
  return check::result();
}
