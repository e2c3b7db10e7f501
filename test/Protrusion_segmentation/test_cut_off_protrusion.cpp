// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Labels and refill (Section III.A, Fig. 2): cutting off protrusions keeps every segment connected;
// segments become surfaces of their own; nested segments know where each was cut from.

#include "check.h"
#include "indexed_surfaces.h"
#include "test_meshes.h"

#include <CGAL/Protrusion_segmentation/internal/Histogram_method/cut_off_protrusion.h>
#include <CGAL/Protrusion_segmentation/internal/Segments/Nested_segments.h>
#include <CGAL/Protrusion_segmentation/internal/Surface/extract_segment.h>
#include <CGAL/Protrusion_segmentation/internal/Surface/connected_faces.h>

using namespace test_meshes;
using namespace CGAL::Protrusion_segmentation::internal;
using Labels = std::vector<Index>;

std::size_t number_of_pieces(const Test_mesh& mesh, const Labels& labels)
{
  return test_meshes::number_of_pieces(mesh, std::vector<std::size_t>(labels.begin(), labels.end()));
}

void components_of_labels()
{
  // A 4 x 3 sheet, labels row by row.
  const Indexed_surface surface = to_surface(sheet(4, 3));
  const Labels labels = {0, 0, 1, 0, //
                         2, 1, 1, 0, //
                         2, 2, 0, 0};
  const Label_components components = label_components(surface, labels);
  CGAL_CHECK(components.component == (Labels{0, 0, 1, 2, 3, 1, 1, 2, 3, 3, 2, 2}));
  CGAL_CHECK(components.label == (Labels{0, 1, 0, 2}));
  CGAL_CHECK(components.area == (std::vector<double>{2, 3, 4, 3}));
}

void lengths_of_borders()
{
  const Indexed_surface surface = to_surface(sheet(4, 3, 2, 1));
  const Labels labels = {0, 0, 1, 0, //
                         2, 1, 1, 0, //
                         2, 2, 0, 0};
  CGAL_CHECK_CLOSE(border_length(surface, labels, 2), 2 + 1 + 2 + 1, 1e-14); // the sheet's edge is no border
  CGAL_CHECK_CLOSE(border_length(surface, labels, 1), 1 + 1 + 2 + 1 + 1 + 2 + 2, 1e-14);
  CGAL_CHECK_EQUAL(border_length(surface, labels, 7), 0);
}

// Of the faces that are near only those connected to the tip.
void a_protrusion_is_the_piece_of_its_tip()
{
  const Indexed_surface surface = to_surface(sheet(9, 1));
  Labels labels(9, 0);
  const double area = cut_off_protrusion(
    surface, labels, 0, [](Index f) { return f < 3 || f > 6; }, 5);
  CGAL_CHECK(labels == (Labels{5, 5, 5, 0, 0, 0, 0, 0, 0}));
  CGAL_CHECK_CLOSE(area, 3, 1e-14);
}

// What is cut off from the largest rest goes with the protrusion.
void islands_go_with_the_protrusion()
{
  const Indexed_surface surface = to_surface(sheet(5, 3));
  Labels labels(15, 0);
  const auto is_ring = [](Index f) { return f == 1 || f == 6 || f == 11; }; // a column
  const double area = cut_off_protrusion(surface, labels, 6, is_ring, 1);
  CGAL_CHECK(labels == (Labels{1, 1, 0, 0, 0, 1, 1, 0, 0, 0, 1, 1, 0, 0, 0}));
  CGAL_CHECK_CLOSE(area, 6, 1e-14);
}

void among_equal_rests_the_one_with_the_lowest_face_stays()
{
  const Indexed_surface surface = to_surface(sheet(5, 1));
  Labels labels(5, 3);
  cut_off_protrusion(
    surface, labels, 2, [](Index f) { return f == 2; }, 4);
  CGAL_CHECK(labels == (Labels{3, 3, 4, 4, 4}));
}

void other_segments_are_left_alone()
{
  const Indexed_surface surface = to_surface(sheet(6, 1));
  Labels labels = {1, 0, 0, 0, 0, 2};
  cut_off_protrusion(
    surface, labels, 1, [](Index f) { return f <= 2 || f == 5; }, 3);
  CGAL_CHECK(labels == (Labels{1, 3, 3, 0, 0, 2}));
}

// Protrusions cut off at random from random surfaces, some with several borders.
void both_segments_are_connected()
{
  Random random(5);
  for (std::uint_fast32_t seed = 0; seed < 200; ++seed)
  {
    const Test_mesh mesh = random_surface(seed);
    const Indexed_surface surface = to_surface(mesh);
    Labels labels(surface.number_of_faces(), 0);
    std::size_t segments = 1;
    for (Index id = 1; id < 5; ++id)
    {
      const Index tip = Index(random.index(surface.number_of_faces()));
      const double share = random.real(0, 0.6);
      std::vector<bool> is_near;
      for (Index f = 0; f < surface.number_of_faces(); ++f)
        is_near.push_back(random.real(0, 1) < share || f == tip);
      const Labels before = labels;
      const double area = cut_off_protrusion(
        surface, labels, tip, [&](Index f) { return bool(is_near[f]); }, id);
      double expected_area = 0;
      for (Index f = 0; f < surface.number_of_faces(); ++f)
      {
        CGAL_CHECK(labels[f] == before[f] || (labels[f] == id && before[f] == before[tip]));
        expected_area += labels[f] == id ? surface.area(f) : 0;
      }
      CGAL_CHECK_CLOSE(area, expected_area, 1e-12);
      CGAL_CHECK_EQUAL(labels[tip], id);
      // the rest is gone only if the tip was all that the segment had
      segments += std::count(labels.begin(), labels.end(), before[tip]) > 0 ? 1 : 0;
      CGAL_CHECK_EQUAL(number_of_pieces(mesh, labels), segments);
    }
  }
}

void extracted_segments_are_the_surface_of_their_faces()
{
  const Indexed_surface surface = to_surface(sheet(4, 3));
  Face_selector<Indexed_surface> select(surface);
  for (int repetition = 0; repetition < 2; ++repetition) // the work arrays are left clean
  {
    const Labels faces = {1, 2, 5, 6, 7};
    const Indexed_surface extracted = select(faces).to_surface();
    CGAL_CHECK_EQUAL(extracted.number_of_faces(), 5);
    CGAL_CHECK_EQUAL(extracted.number_of_vertices(), 11);
    CGAL_CHECK_EQUAL(num_edges(extracted.dual_graph()), 2 * 5);
    for (Index f = 0; f < 5; ++f)
    {
      CGAL_CHECK(extracted.centroid(f) == surface.centroid(faces[f]));
      CGAL_CHECK_EQUAL(extracted.area(f), surface.area(faces[f]));
    }
  }
  Labels all(12);
  std::iota(all.begin(), all.end(), Index(0));
  CGAL_CHECK_EQUAL(num_edges(select(all).to_surface().dual_graph()), num_edges(surface.dual_graph()));
}

Labels faces_on_border(const Nested_segments& segments, const Indexed_surface& surface)
{
  Labels result;
  for (Index f = 0; f < surface.number_of_faces(); ++f)
    if (segments.is_on_border(surface, f))
      result.push_back(f);
  return result;
}

// The border of the surface is none of a segment.
void only_faces_beside_other_segments_are_on_the_border()
{
  const Indexed_surface surface = to_surface(sheet(5, 2));
  Nested_segments segments(surface);
  CGAL_CHECK(faces_on_border(segments, surface).empty());
  segments.cut_off(0, {0, 1, 2, 5, 6, 7});
  CGAL_CHECK(faces_on_border(segments, surface) == (Labels{2, 3, 7, 8}));
  const Indexed_surface small = to_surface(sheet(4, 3));
  Nested_segments middle(small);
  middle.cut_off(0, {1, 2, 5, 6, 7});
  CGAL_CHECK(faces_on_border(middle, small) == (Labels{0, 1, 2, 3, 4, 5, 6, 7, 9, 10, 11}));
}

void extraction_keeps_the_order_that_is_asked_for()
{
  const Indexed_surface surface = to_surface(bumpy_sphere(2, 3));
  const Indexed_surface reversed = Face_selector<Indexed_surface>(surface)({9, 3, 5}).to_surface();
  CGAL_CHECK(reversed.centroid(0) == surface.centroid(9));
  CGAL_CHECK(reversed.centroid(2) == surface.centroid(5));
}

Labels parents_of(const Nested_segments& segments)
{
  Labels result;
  for (std::size_t s = 0; s < segments.number_of_segments(); ++s)
    result.push_back(segments.parent(s));
  return result;
}

void segments_begin_with_the_components()
{
  const Test_mesh one = icosphere(1);
  const Nested_segments segments(
    to_surface(merged({one, translated(one, {3, 0, 0}), translated(one, {6, 0, 0})})));
  CGAL_CHECK_EQUAL(segments.number_of_segments(), 3);
  CGAL_CHECK_EQUAL(segments.number_of_components(), 3);
  CGAL_CHECK(parents_of(segments) == (Labels{0, 1, 2}));
  for (std::size_t f = 0; f < segments.labels().size(); ++f)
    CGAL_CHECK_EQUAL(segments.labels()[f], f / one.faces.size());
  CGAL_CHECK_EQUAL(segments.faces(1).size(), one.faces.size());
  CGAL_CHECK_EQUAL(segments.faces(1).front(), one.faces.size());
  CGAL_CHECK_EQUAL(Nested_segments(Indexed_surface()).number_of_segments(), 0);
}

void what_is_cut_off_gets_the_next_number()
{
  const Indexed_surface surface = to_surface(sheet(5, 1));
  Nested_segments segments(surface);
  CGAL_CHECK_EQUAL(segments.cut_off(0, {2, 3, 4}), 1);
  CGAL_CHECK_EQUAL(segments.cut_off(1, {2}), 2);
  CGAL_CHECK(parents_of(segments) == (Labels{0, 0, 1}));
  CGAL_CHECK(segments.labels() == (Labels{0, 0, 2, 1, 1}));
  CGAL_CHECK(segments.faces(0) == (Labels{0, 1}));
  CGAL_CHECK(segments.faces(1) == (Labels{3, 4}));
  CGAL_CHECK(segments.faces(2) == (Labels{2}));
  CGAL_CHECK_EQUAL(segments.area(surface, 1), 2);
  CGAL_CHECK_EQUAL(segments.number_of_segments(), 3);
  CGAL_CHECK_EQUAL(segments.number_of_components(), 1);
}

int main()
{
  components_of_labels();
  lengths_of_borders();
  a_protrusion_is_the_piece_of_its_tip();
  islands_go_with_the_protrusion();
  among_equal_rests_the_one_with_the_lowest_face_stays();
  other_segments_are_left_alone();
  both_segments_are_connected();
  extracted_segments_are_the_surface_of_their_faces();
  only_faces_beside_other_segments_are_on_the_border();
  extraction_keeps_the_order_that_is_asked_for();
  segments_begin_with_the_components();
  what_is_cut_off_gets_the_next_number();
  return check::result();
}
