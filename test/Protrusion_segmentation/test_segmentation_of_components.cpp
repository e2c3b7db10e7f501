// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The default method judges every connected component by itself: whatever lies beside it, and whatever its scale,
// side and numbering are.

#include "check.h"
#include "recorder.h"
#include "segmentations.h"
#include "test_meshes.h"

#include <CGAL/Protrusion_segmentation/Segmentation_stopped.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#endif

#include <algorithm>
#include <functional>
#include <random>

using namespace test_meshes;
using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

Segmentation segmentation(const Test_mesh& soup, std::size_t k)
{
  const Mesh mesh = to_graph<Mesh>(soup);
  return checked(mesh, [&](auto ids) { return CGAL::segmentation_via_protrusion_tips(mesh, ids, k); });
}

// With arms of different lengths, so that no two cuts tie.
const Test_mesh& figure()
{
  static const Test_mesh mesh = star(5, 2, 0.25, 0.1, 0.2);
  return mesh;
}

// Beside each other, each with a scale of its own.
Test_mesh figures(const std::vector<double>& scales)
{
  std::vector<Test_mesh> result;
  double x = 0;
  for (const double scale : scales)
  {
    x += 10 * scale;
    result.push_back(translated(scaled(figure(), scale), {x, 0, 0}));
    x += 10 * scale;
  }
  return merged(result);
}

// Of the i-th of several meshes with as many faces each.
Labels partition_of_copy(const Labels& labels, std::size_t i, std::size_t number_of_faces)
{
  const auto begin = labels.begin() + std::ptrdiff_t(i * number_of_faces);
  return as_partition(Labels(begin, begin + std::ptrdiff_t(number_of_faces)));
}

void check_copies(const Segmentation& found, const Segmentation& one, std::size_t number_of_copies)
{
  const std::size_t faces = one.labels.size();
  CGAL_CHECK_EQUAL(found.number, number_of_copies * one.number);
  CGAL_CHECK_EQUAL(found.labels.size(), number_of_copies * faces);
  for (std::size_t i = 0; i < number_of_copies; ++i)
    CGAL_CHECK(partition_of_copy(found.labels, i, faces) == as_partition(one.labels));
}

void one_figure()
{
  const Segmentation found = automatic_segmentation(figure());
  check_parts(figure(), found, 0.95);
}

void copies_side_by_side_are_segmented_alike()
{
  const Segmentation one = automatic_segmentation(figure());
  check_copies(automatic_segmentation(figures({1, 1, 1})), one, 3);
  check_copies(automatic_segmentation(figures({1, 4, 0.25})), one, 3);
  check_copies(automatic_segmentation(figures({1, 10, 0.3})), one, 3);
}

// Every further segment goes to the component where it brings most.
void every_copy_gets_its_share()
{
  for (const std::size_t k : {2, 4, 6})
  {
    const Segmentation one = segmentation(figure(), k);
    check_copies(segmentation(figures({1, 1, 1}), 3 * k), one, 3);
    check_copies(segmentation(figures({1, 4, 0.25}), 3 * k), one, 3);
  }
}

void a_floor_is_one_segment_and_changes_nothing()
{
  const Segmentation one = automatic_segmentation(figure());
  const double size = 20 * 6;
  for (const std::size_t squares : {10, 40})
  {
    const Test_mesh floor = translated(
      sheet(squares, squares, size / double(squares), size / double(squares)),
      {-size / 2, -size / 2, -4});
    const Segmentation found = automatic_segmentation(merged({floor, figure()}));
    CGAL_CHECK_EQUAL(found.number, one.number + 1);
    const std::ptrdiff_t faces_of_floor = std::ptrdiff_t(floor.faces.size());
    CGAL_CHECK(as_partition(Labels(found.labels.begin(), found.labels.begin() + faces_of_floor)) ==
          Labels(floor.faces.size(), 0));
    CGAL_CHECK(as_partition(Labels(found.labels.begin() + faces_of_floor, found.labels.end())) ==
          as_partition(one.labels));
  }
}

// Wherever components lie, and whatever lies beside them, not a face changes.
void what_lies_beside_and_where_does_not_matter()
{
  std::mt19937 random(5);
  const auto coordinate = [&random]() { return 100 * (static_cast<double>(random()) / 4294967296. - 0.5); };
  for (const std::uint_fast32_t seed : {1, 2, 3})
  {
    const Test_mesh mesh = jittered(figure(), 0.02, seed);
    const Segmentation one = automatic_segmentation(mesh);
    std::vector<Test_mesh> copies;
    for (std::size_t i = 0; i < 3; ++i)
      copies.push_back(translated(mesh, {coordinate(), coordinate(), coordinate()}));
    copies.push_back(translated(sheet(7, 5, 30, 20), {coordinate(), coordinate(), coordinate()}));
    const Segmentation found = automatic_segmentation(merged(copies));
    CGAL_CHECK_EQUAL(found.number, 3 * one.number + 1);
    for (std::size_t i = 0; i < 3; ++i)
      CGAL_CHECK(partition_of_copy(found.labels, i, one.labels.size()) == as_partition(one.labels));
  }
}

// Where no frame is the only one, as for a symmetric mesh, a mirror image may have its mirrored segments.
void mirror_images_turns_and_scales_do_not_matter()
{
  for (const Test_mesh& mesh : {jittered(figure(), 0.02, 1), jittered(figures({1, 0.5}), 0.02, 2)})
  {
    const Labels expected = automatic_segmentation(mesh).labels;
    for (const Test_mesh& same :
         {with_reversed_orientation(scaled(mesh, -1, 1, 1)), scaled(mesh, 1000), scaled(mesh, 1e-3), scaled(mesh, 1024),
          scaled(mesh, std::ldexp(1., 200)), rotated(mesh, {1, 2, 3}, 1), translated(mesh, {30, -20, 10})})
      CGAL_CHECK(automatic_segmentation(same).labels == expected);
  }
}

void the_order_of_the_faces_does_not_matter()
{
  const Segmentation one = automatic_segmentation(figure());
  for (std::uint_fast32_t seed = 0; seed < 3; ++seed)
  {
    const std::vector<std::size_t> order = random_permutation(figure().faces.size(), seed);
    const Segmentation found = automatic_segmentation(with_face_order(figure(), order));
    CGAL_CHECK_EQUAL(found.number, one.number);
    for (std::size_t i = 0; i < order.size(); ++i)
      CGAL_CHECK_EQUAL(found.labels[i], one.labels[order[i]]);
  }
}

// With as many segments as components, or fewer, nothing is cut and nothing prepared for it; the largest component has the
// first id as ever.
void components_alone_take_no_search()
{
  struct Counter : CGAL::Protrusion_segmentation::Segmentation_visitor<Mesh>
  {
    int preparations = 0;
    void on_preparation_begin() { ++preparations; }
  };
  const std::size_t faces = figure().faces.size();
  const Mesh mesh = to_graph<Mesh>(figures({1, 3, 2}));
  for (const std::size_t k : {1, 2, 3, 4})
  {
    Counter counter;
    const Segmentation found = checked(
      mesh, [&](auto ids)
      { return CGAL::segmentation_via_protrusion_tips(mesh, ids, k, CGAL::parameters::visitor(std::ref(counter))); });
    CGAL_CHECK_EQUAL(found.number, (std::max)(k, std::size_t(3)));
    CGAL_CHECK_EQUAL(counter.preparations > 0, k > 3);
    const std::size_t expected[] = {2, 0, 1}; // of the bodies
    for (std::size_t i = 0; k <= 3 && i < found.labels.size(); ++i)
      CGAL_CHECK_EQUAL(found.labels[i], expected[i / faces]);
  }
}

#ifdef CGAL_LINKED_WITH_TBB
std::vector<std::size_t> tips_and_segments(const Recorder<Mesh>& record)
{
  std::vector<std::size_t> result;
  for (const auto& protrusion : record.protrusions())
    for (const std::size_t number : {std::size_t(protrusion.tip), std::size_t(protrusion.segment), std::size_t(protrusion.parent)})
      result.push_back(number);
  return result;
}

// Stops in the second component that it hears of.
struct Stopping_recorder : Recorder<Mesh>
{
  bool go_further() { return stages["preparation"] < 2; }
};

// Small components are segmented side by side, after a large one: with the same segments, protrusions and stages, and the visitor
// stops them all.
void components_side_by_side()
{
  std::vector<double> scales(20, 1);
  const Test_mesh large = translated(scaled(icosphere(5), 3), {0, 50, 0});
  const Mesh mesh = to_graph<Mesh>(merged({figures(scales), large}));
  Recorder<Mesh> expected;
  const Segmentation one = checked(
    mesh, [&](auto ids)
    { return CGAL::segmentation_via_protrusion_tips(mesh, ids, CGAL::parameters::visitor(std::ref(expected))); });
  CGAL_CHECK(one.number > 100);
  for (const std::size_t threads : {1, 2, 8})
  {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    const auto segment = [&](auto& record)
    {
      return checked(mesh,
                     [&](auto ids)
                     {
                       return CGAL::segmentation_via_protrusion_tips<CGAL::Parallel_tag>(
                         mesh, ids, CGAL::parameters::visitor(std::ref(record)));
                     });
    };
    Recorder<Mesh> record;
    Stopping_recorder stopping;
    CGAL_CHECK(segment(record).labels == one.labels);
    CGAL_CHECK(tips_and_segments(record) == tips_and_segments(expected));
    check_stages_and_progress(record);
    CGAL_CHECK_THROWS_AS(segment(stopping), CGAL::Protrusion_segmentation::Segmentation_stopped);
  }
}
#endif

int main()
{
#ifdef CGAL_LINKED_WITH_TBB
  components_side_by_side();
#endif
  one_figure();
  components_alone_take_no_search();
  copies_side_by_side_are_segmented_alike();
  every_copy_gets_its_share();
  a_floor_is_one_segment_and_changes_nothing();
  what_lies_beside_and_where_does_not_matter();
  mirror_images_turns_and_scales_do_not_matter();
  the_order_of_the_faces_does_not_matter();
  return check::result();
}
